#include "programs/scene_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "models/fields/choices.h"
#include "models/numbers.h"
#include "models/scene_file/scene_file.h"
#include "programs/scene_flags.h"

namespace glint {
namespace {

constexpr std::size_t line_length = 110;  // characters

/// One column of a row: its name, which Python writes, and its value.
struct Column {
    std::string name, value;
};
using Row = std::vector<Column>;

/// Joins parts by commas, and breaks lines that would be too long.
std::string joined(const std::vector<std::string>& parts, std::size_t start, const std::string& indent) {
    std::string text;
    std::size_t at = start;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool last = i + 1 == parts.size();
        if (i > 0 && at + parts[i].size() + 3 > line_length) {
            text.back() = '\n';
            text += indent;
            at = indent.size();
        }
        text += parts[i] + (last ? "" : ", ");
        at += parts[i].size() + 2;
    }
    return text;
}

/// The values of a row; in JavaScript with their names.
std::vector<std::string> values_of(const Row& row, Language language) {
    std::vector<std::string> parts;
    for (const Column& c : row)
        parts.push_back(language == Language::Webgl ? c.name + ": " + c.value : c.value);
    return parts;
}

/// A definition: `const TYPE NAME = {...};`, in Python `NAME = TYPE(...)`, in JavaScript `const NAME =
/// {...};`.
std::string definition(const std::string& type, const std::string& name, const Row& row, Language language) {
    const std::vector<std::string> parts = values_of(row, language);
    if (language == Language::Python) {
        const std::string start = name + " = " + type + "(";
        return start + joined(parts, start.size(), "    ") + ")\n";
    }
    const std::string start = "const " + (language == Language::Webgl ? "" : type + " ") + name + " = {";
    return start + joined(parts, start.size(), "    ") + "};\n";
}

/// The names of a row's columns, if the language has no text for them.
std::string columns_of(const std::string& type, const Row& row) {
    std::vector<std::string> names;
    for (const Column& c : row) names.push_back(c.name);
    return fmt::format("{} = namedtuple(\"{}\", \"{}\")\n", type, type, fmt::join(names, " "));
}

std::string list_of(const std::string& type, const std::string& name, const std::vector<std::string>& names,
                    Language language) {
    if (language == Language::Python) {
        const std::string start = name + " = [";
        return start + joined(names, start.size(), "    ") + "]";
    }
    if (language == Language::Webgl) {
        const std::string start = fmt::format("const {} = [", name);
        return start + joined(names, start.size(), "    ") + "];";
    }
    if (language == Language::Gl1) {  // C has no list that knows its length
        std::vector<std::string> pointers;
        pointers.reserve(names.size() + 1);
        for (const std::string& one : names) pointers.push_back("&" + one);
        pointers.emplace_back("NULL");
        const std::string start = fmt::format("const {}* const {}[] = {{", type, name);
        return start + joined(pointers, start.size(), "    ") + "};";
    }
    const std::string start = fmt::format("const std::vector<{}> {} = {{", type, name);
    return start + joined(names, start.size(), "    ") + "};";
}

std::string word_in_program(std::string_view word, Language language) {
    return language == Language::Python ? fmt::format("\"{}\"", word) : std::string(word);
}

std::string camera_text(const Camera& camera, Language language) {
    const bool python = language == Language::Python;
    const auto vector = [&](const glm::vec3& v) { return vector_in_program(v, language); };
    const auto numbers = [&](const std::vector<std::pair<std::string, float>>& all) {
        std::vector<std::string> parts;
        parts.reserve(all.size());
        for (const auto& [name, value] : all) parts.push_back(name + " = " + number_in_program(value));
        const std::string start = python                        ? ""
                                  : language == Language::Webgl ? "const "
                                                                : "const double ",
                          separator = python ? "; " : ", ";
        return start + fmt::format("{}", fmt::join(parts, separator)) + (python ? "" : ";");
    };
    std::string text;
    if (python)
        text = fmt::format("eye, target, up = {}, {}, {}\n", vector(camera.eye), vector(camera.target),
                           vector(camera.up));
    else if (language == Language::Cpp)
        text = fmt::format("const vec3 eye = {}, target = {}, up = {};  // world coordinates\n",
                           vector(camera.eye), vector(camera.target), vector(camera.up));
    else if (language == Language::Webgl)
        text = fmt::format(
            "let eye = {};  // world coordinates; moves with the mouse\nconst target = {}, up = {};\n",
            vector(camera.eye), vector(camera.target), vector(camera.up));
    else
        text = fmt::format(
            "vec3 eye = {};  // world coordinates; moves with the mouse\nconst vec3 target = {}, up = {};\n",
            vector(camera.eye), vector(camera.target), vector(camera.up));
    const float near = near_of(camera.projection), far = far_of(camera.projection);
    if (const auto* p = std::get_if<Perspective>(&camera.projection))
        return text + numbers({{"fov_y_deg", p->fov_y_deg}, {"near", near}, {"far", far}});
    if (const auto* o = std::get_if<Orthographic>(&camera.projection))
        return text + numbers({{"view_height", o->height}, {"near", near}, {"far", far}});
    const auto& f = std::get<Frustum>(camera.projection);
    return text + numbers({{"left", f.left},
                           {"right", f.right},
                           {"bottom", f.bottom},
                           {"top", f.top},
                           {"near", near},
                           {"far", far}});
}

/// Directional lights and area lights have no falloff, except with a mistake.
bool has_falloff(const Light& light, const Flags& flags) {
    if (light.kind == LightKind::Directional) return flags.contains("wrong.falloff_of_directional");
    return light.kind != LightKind::Area;
}

Row light_row(const Light& light, Language language, const Flags& flags) {
    const auto vector = [language](const glm::vec3& v) { return vector_in_program(v, language); };
    const auto has = [&flags](const char* flag) { return flags.find(flag) != flags.end(); };
    Row row{{"kind", word_in_program(name_of(light.kind), language)},
            {"space", word_in_program(name_of(light.space), language)},
            {"position", vector(glm::vec3(light.position))},
            {"ambient", vector(light.ambient)},
            {"diffuse", vector(light.diffuse)},
            {"specular", vector(light.specular)},
            {"intensity", number_in_program(light.intensity)}};
    const auto add = [&row](const char* name, const std::string& value) { row.push_back({name, value}); };
    if (has("light.falloff")) {
        const Falloff falloff = has_falloff(light, flags) ? light.falloff : Falloff{};
        add("constant", number_in_program(falloff.constant));
        add("linear", number_in_program(falloff.linear));
        add("quadratic", number_in_program(falloff.quadratic));
    }
    if (has("light.spot")) {
        add("direction", vector(light.spot.direction));
        add("cutoff_deg", number_in_program(light.spot.cutoff_deg));
        add("exponent", number_in_program(light.spot.exponent));
        if (has("spot.soft")) add("inner_deg", number_in_program(light.spot.inner_deg));
    }
    if (has("light.area")) {
        add("edge_u", vector(light.area.edge_u));
        add("edge_v", vector(light.area.edge_v));
        add("cells", fmt::format("{}", std::lround(std::sqrt(light.area.samples))));
    }
    return row;
}

Row material_row(const Material& m, Language language, const Flags& flags) {
    const auto vector = [language](const glm::vec3& v) { return vector_in_program(v, language); };
    const auto has = [&flags](const char* flag) { return flags.contains(flag); };
    Row row{{"ambient", vector(m.ambient)}, {"diffuse", vector(m.diffuse)}, {"specular", vector(m.specular)}};
    if (has("terms.emission")) row.push_back({"emission", vector(m.emission)});
    if (has("uses.shininess")) row.push_back({"shininess", number_in_program(m.shininess)});
    if (has("uses.roughness")) row.push_back({"roughness", number_in_program(m.roughness)});
    if (has("uses.f0")) row.push_back({"f0", vector(m.f0)});
    return row;
}

/// The material as a value, on separate lines.
std::string material_text(const Row& row, Language language) {
    const std::vector<std::string> parts = values_of(row, language);
    const bool python = language == Language::Python;
    const std::string start = python                        ? "    Material("
                              : language == Language::Webgl ? "    material: {"
                                                            : "    {";
    return "\n" + start + joined(parts, start.size(), "     ") + (python ? ")" : "}");
}

Row object_row(const Object& object, const std::string& mesh_file, Language language, const Flags& flags) {
    const auto vector = [language](const glm::vec3& v) { return vector_in_program(v, language); };
    const auto has = [&flags](const char* flag) { return flags.find(flag) != flags.end(); };
    Row row{{"mesh", fmt::format("\"{}\"", mesh_file)},
            {"translate", vector(object.transform.translate)},
            {"rotate_deg", vector(object.transform.rotate_deg)},
            {"scale", vector(object.transform.scale)}};
    if (has("normals.flip")) row.push_back({"side", object.normals.flip ? "-1" : "1"});
    return row;
}

/// The row's definition with the material, if there is one, as its last column.
std::string object_text(const std::string& name, const Row& object, const Row& material, Language language) {
    std::string text = definition("Object", name, object, language);
    if (material.empty()) return text;
    const std::size_t end = text.rfind(language == Language::Python ? ")" : "}");
    return text.substr(0, end) + "," + material_text(material, language) + text.substr(end);
}

std::string objects_text(const std::vector<Object>& objects, const std::vector<std::string>& mesh_files,
                         Language language, const Flags& flags, Identifiers& identifiers) {
    std::string text;
    std::vector<std::string> names;
    const bool lit = flags.contains("reflection.lit");
    if (language == Language::Python) {
        if (lit) text += columns_of("Material", material_row({}, language, flags));
        Row columns = object_row({}, "", language, flags);
        if (lit) columns.push_back({"material", ""});
        text += columns_of("Object", columns);
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const Object& o = objects[i];
        names.push_back(identifiers.of(o.name, "object"));
        text += object_text(names.back(), object_row(o, mesh_files[i], language, flags),
                            lit ? material_row(o.material, language, flags) : Row{}, language);
    }
    return text + list_of("Object", "objects", names, language);
}

std::string lights_text(const std::vector<Light>& lights, Language language, const Flags& flags,
                        Identifiers& identifiers) {
    std::string text;
    std::vector<std::string> names;
    if (language == Language::Python) text += columns_of("Light", light_row({}, language, flags));
    for (const Light& light : lights) {
        names.push_back(identifiers.of(light.name, "light"));
        text += definition("Light", names.back(), light_row(light, language, flags), language);
    }
    return text + list_of("Light", "lights", names, language);
}

/// Whether the name could clash with a function or macro of an included library: those are in small letters
/// (free), in capitals (NULL, RAND_MAX), or have a prefix of OpenGL or C (M_PIf).
bool may_be_a_library_name(const std::string& name) {
    const auto is_in = [](char low, char high) {
        return [low, high](char c) { return c >= low && c <= high; };
    };
    const bool small = std::any_of(name.begin(), name.end(), is_in('a', 'z'));
    const bool capital = std::any_of(name.begin(), name.end(), is_in('A', 'Z'));
    constexpr std::array<std::string_view, 6> beginnings{"GL", "gl", "OSMesa", "M_", "L_", "P_"};
    return !small || !capital ||
           std::any_of(beginnings.begin(), beginnings.end(),
                       [&name](std::string_view begin) { return name.starts_with(begin); });
}

}  // namespace

std::string for_comment(const std::string& text) {
    std::string out;
    for (const char c : on_one_line(text)) {
        if (c == '?' && out.ends_with('?')) out += ' ';  // a C compiler takes "??/" for a backslash
        out += c == '\\' ? '/' : c;
    }
    return out;
}

std::string in_letters(const std::string& name, const std::string& otherwise) {
    std::string base;
    for (const char c : name) {
        const bool usable =
            static_cast<unsigned char>(c) < 128 && std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (usable) base += c;
        if (!usable && !base.empty() && base.back() != '_') base += '_';
    }
    while (!base.empty() && base.back() == '_') base.pop_back();
    if (base.empty()) base = otherwise;
    if (std::isdigit(static_cast<unsigned char>(base[0])) != 0) base = otherwise + "_" + base;
    return base;
}

std::string Identifiers::of(const std::string& name, const std::string& otherwise) {
    std::string base = in_letters(name, otherwise);
    if (base.find(otherwise) == std::string::npos && may_be_a_library_name(base)) base += "_" + otherwise;
    return once(base);
}

std::string Identifiers::once(const std::string& base) {
    std::string unique = base;
    for (int& i = next_.try_emplace(base, 2).first->second; !taken_.insert(unique).second; ++i)
        unique = fmt::format("{}_{}", base, i);
    return unique;
}

std::string number_in_program(float x) {
    // The program reads the number as a double. Above 2^24, the shortest text of a float may be a different
    // integer as a double, which matters for an angle. With an exponent the text is not an integer literal,
    // whose size some languages limit.
    constexpr float last_whole = 1 << 24;
    if (std::abs(x) > last_whole) return fmt::format("{:.16e}", x);
    std::string text = number_text(x);
    if (text.ends_with(".0")) text.resize(text.size() - 2);
    return text == "-0" ? "0" : text;
}

std::string vector_in_program(const glm::vec3& v, Language language) {
    const char* const brackets = language == Language::Python  ? "()"
                                 : language == Language::Webgl ? "[]"
                                                               : "{}";
    return fmt::format("{}{}, {}, {}{}", brackets[0], number_in_program(v.x), number_in_program(v.y),
                       number_in_program(v.z), brackets[1]);
}

SceneTables scene_tables(const Scene& scene, Language language, const Flags& flags,
                         const std::vector<std::string>& mesh_files, Flags words) {
    Identifiers identifiers(std::move(words));
    const std::string lights = lights_text(shining(scene), language, flags, identifiers);
    return {camera_text(scene.camera, language), lights,
            objects_text(shown(scene), mesh_files, language, flags, identifiers)};
}

}  // namespace glint
