#include "programs/scene_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "models/fields/choices.h"
#include "models/numbers.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "programs/model_text.h"

namespace glint {
namespace {

constexpr std::size_t line_length = 110;  // characters

Reflection model_of(const Object& object, const Scene& scene) {
    return reflection_of(object.material, scene.shading.reflection);
}

/// One column of a row: its name, which Python writes, and its value.
struct Column {
    std::string name, value;
};
using Row = std::vector<Column>;

/// Joins parts with commas, and breaks lines that would be too long.
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

/// The definition of a type with a row's columns. Only for Python, whose template does not define the types.
std::string columns_of(const std::string& type, const Row& row) {
    std::vector<std::string> names;
    for (const Column& c : row) names.push_back(c.name);
    return fmt::format("{} = namedtuple(\"{}\", \"{}\")\n", type, type, fmt::join(names, " "));
}

/// The definition of a list of objects by their names.
std::string list_of(const std::string& type, const std::string& name, std::vector<std::string> names,
                    Language language) {
    const bool python = language == Language::Python, c = language == Language::Gl1;
    if (c) {  // a C array does not know its length
        for (std::string& one : names) one.insert(0, "&");
        names.emplace_back("NULL");
    }
    const std::string start = python                        ? name + " = ["
                              : language == Language::Webgl ? "const " + name + " = ["
                              : c ? fmt::format("const {}* const {}[] = {{", type, name)
                                  : fmt::format("const std::vector<{}> {} = {{", type, name);
    const char* const end = python ? "]" : language == Language::Webgl ? "];" : "};";
    return start + joined(names, start.size(), "    ") + end;
}

std::string word_in_program(std::string_view word, Language language) {
    return language == Language::Python ? fmt::format("\"{}\"", word) : std::string(word);
}

std::string camera_text(const Camera& camera, Language language) {
    const bool python = language == Language::Python, page = language == Language::Webgl;
    const auto vector = [&](const glm::vec3& v) { return vector_in_program(v, language); };
    const std::string eye = vector(camera.eye), target = vector(camera.target), up = vector(camera.up);
    std::string text;
    if (python)
        text = fmt::format("eye, target, up = {}, {}, {}\n", eye, target, up);
    else if (language == Language::Cpp)
        text = fmt::format("const vec3 eye = {}, target = {}, up = {};  // world coordinates\n", eye, target,
                           up);
    else
        text = fmt::format(
            "{} eye = {};  // world coordinates; moves with the mouse\nconst {}target = {}, up = {};\n",
            page ? "let" : "vec3", eye, page ? "" : "vec3 ", target, up);
    std::vector<std::pair<const char*, float>> numbers;
    const float near = near_of(camera.projection), far = far_of(camera.projection);
    if (const auto* p = std::get_if<Perspective>(&camera.projection))
        numbers = {{"fov_y_deg", p->fov_y_deg}, {"near", near}, {"far", far}};
    else if (const auto* o = std::get_if<Orthographic>(&camera.projection))
        numbers = {{"view_height", o->height}, {"near", near}, {"far", far}};
    else if (const auto* f = std::get_if<Frustum>(&camera.projection))
        numbers = {{"left", f->left}, {"right", f->right}, {"bottom", f->bottom},
                   {"top", f->top},   {"near", near},      {"far", far}};
    std::vector<std::string> parts;
    parts.reserve(numbers.size());
    for (const auto& [name, value] : numbers)
        parts.push_back(fmt::format("{} = {}", name, number_in_program(value)));
    if (python) return text + fmt::format("{}", fmt::join(parts, "; "));
    return text + fmt::format("const {}{};", page ? "" : "double ", fmt::join(parts, ", "));
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

/// `model`: the reflection model of an object with this material.
Row material_row(const Material& m, Reflection model, Language language, const Flags& flags) {
    const auto vector = [language](const glm::vec3& v) { return vector_in_program(v, language); };
    const auto has = [&flags](const char* flag) { return flags.contains(flag); };
    Row row{{"ambient", vector(m.ambient)}, {"diffuse", vector(m.diffuse)}, {"specular", vector(m.specular)}};
    if (has("terms.emission")) row.push_back({"emission", vector(m.emission)});
    if (has("uses.shininess")) row.push_back({"shininess", number_in_program(m.shininess)});
    if (has("uses.roughness")) row.push_back({"roughness", number_in_program(m.roughness)});
    if (has("uses.f0")) row.push_back({"f0", vector(m.f0)});
    if (has("models.several")) row.push_back({"model", word_in_program(identifier_of(model), language)});
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

std::string objects_text(const Scene& scene, const std::vector<std::string>& mesh_files, Language language,
                         const Flags& flags, Identifiers& identifiers) {
    const std::vector<Object> objects = shown(scene);
    std::string text;
    std::vector<std::string> names;
    const bool lit = flags.contains("reflection.lit");
    if (language == Language::Python) {
        if (lit) text += columns_of("Material", material_row({}, {}, language, flags));
        Row columns = object_row({}, "", language, flags);
        if (lit) columns.push_back({"material", ""});
        text += columns_of("Object", columns);
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const Object& o = objects[i];
        names.push_back(identifiers.of(o.name, "object"));
        text += object_text(names.back(), object_row(o, mesh_files[i], language, flags),
                            lit ? material_row(o.material, model_of(o, scene), language, flags) : Row{},
                            language);
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

/// Whether the name could clash with a function or macro of an included library: those are in lower case
/// (free), in upper case (NULL, RAND_MAX), or have a prefix of OpenGL or C (M_PIf).
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
    // The program reads the number as a double. Above 2^24, the shortest text of a float may denote a
    // different integer when read as a double, which matters for an angle. With an exponent the text is not
    // an integer literal, whose size some languages limit.
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
            objects_text(scene, mesh_files, language, flags, identifiers)};
}

namespace {

constexpr float fixed_function_most = 128;  // OpenGL 2.1: shininess and a spot's exponent
constexpr std::size_t fixed_function_lights = 8,
                      shader_lights = 32;  // the maximum numbers of lights, which are listed one by one

/// Properties of a scene that are computed once because they are used often.
struct Facts {
    const Scene& scene;
    std::vector<Light> lights = shining(scene);
    std::vector<Object> objects = shown(scene);
    const Shading& shading = scene.shading;
    const Mistakes& wrong = scene.shading.mistakes;

    [[nodiscard]] bool is_lit() const { return shading.reflection != Reflection::None; }
    [[nodiscard]] bool lit_in(ShadingMode mode) const { return is_lit() && shading.mode == mode; }
    [[nodiscard]] bool provoking() const { return flat_at_provoking_corner(shading); }
    /// Whether colours of corners are interpolated.
    [[nodiscard]] bool blends_corners() const {
        return shading.mode != ShadingMode::Flat && (!is_lit() || shading.mode == ShadingMode::Gouraud);
    }
    [[nodiscard]] bool interpolates() const { return blends_corners() || lit_in(ShadingMode::Phong); }
    [[nodiscard]] bool interpolates_by(Interpolation by) const {
        return interpolates() && shading.interpolation == by;
    }
    [[nodiscard]] bool any_light(LightKind kind) const {
        return is_lit() &&
               std::any_of(lights.begin(), lights.end(), [kind](const Light& l) { return l.kind == kind; });
    }
    [[nodiscard]] bool any_falloff() const {
        const auto has = [](const Light& l) { return l.falloff != Falloff{} && l.kind != LightKind::Area; };
        return is_lit() && (wrong.falloff_of_directional || wrong.falloff_without_constant ||
                            wrong.falloff_inverted || std::any_of(lights.begin(), lights.end(), has));
    }
    [[nodiscard]] bool uses_shininess() const {
        return any_shininess([](float) { return true; });
    }
    template <class Test> [[nodiscard]] bool any_shininess(const Test& test) const {
        return shading.terms.specular && std::any_of(objects.begin(), objects.end(), [&](const Object& o) {
                   return info_of(model_of(o, scene)).uses_shininess() && test(o.material.shininess);
               });
    }
    /// Whether any corner's normal is zero: points there use the facet's normal.
    [[nodiscard]] bool any_normal_missing() const {
        std::set<NormalsKey> looked_at;  // checks each mesh once: many objects may share a large one
        return std::any_of(objects.begin(), objects.end(), [&looked_at](const Object& o) {
            if (!looked_at.insert(normals_key(o)).second) return false;
            const std::vector<glm::vec3> normals = corner_normals(*o.mesh, o.normals).normals;
            return std::find(normals.begin(), normals.end(), glm::vec3(0)) != normals.end();
        });
    }
    [[nodiscard]] bool infinite_viewer() const {
        const bool orthographic = is_orthographic(scene.camera.projection);
        return !shading.local_viewer || (orthographic && !wrong.perspective_view_in_ortho);
    }
};

struct NeedRow {
    const char *flag, *pointer, *what;
    bool (*is_needed)(const Facts&);
};

bool blends_screen(const Facts& f) { return f.interpolates_by(Interpolation::Screen); }
bool blends_scanline(const Facts& f) { return f.interpolates_by(Interpolation::Scanline); }
bool has_large_exponent(const Facts& f) {
    return f.is_lit() && std::any_of(f.lights.begin(), f.lights.end(), [](const Light& l) {
               return l.kind == LightKind::Spot && l.spot.exponent > fixed_function_most;
           });
}
bool has_soft_edge(const Facts& f) {
    return f.is_lit() && std::any_of(f.lights.begin(), f.lights.end(), [](const Light& l) {
               return l.kind == LightKind::Spot && l.spot.inner_deg < l.spot.cutoff_deg;
           });
}
bool is_capped(const Facts& f) {
    return f.shading.rules == Rules::OpenGL2 &&
           f.any_shininess([](float s) { return s > fixed_function_most; });
}

/// Whether anything extends behind the near plane, where points have no position on the screen.
bool near_plane_cuts(const Facts& f) {
    if (!blends_screen(f) && !blends_scanline(f)) return false;
    const glm::dmat4 clip_from_world =
        clip_from_view(f.scene.camera.projection, {}) * view_from_world(f.scene.camera);
    return std::any_of(f.objects.begin(), f.objects.end(), [&clip_from_world](const Object& o) {
        const glm::dmat4 m = clip_from_world * world_from_object(o.transform);
        const auto is_behind = [&m](const glm::dvec3& p) {
            const glm::dvec4 c = m * glm::dvec4(p, 1);
            return c.z < -c.w;
        };
        const auto any_behind = [&is_behind](const auto& places) {
            return std::any_of(places.begin(), places.end(), is_behind);
        };
        // No part of a mesh is behind the plane if no corner of its bounding box is.
        return any_behind(corners_of(o.mesh->bounds)) && any_behind(o.mesh->positions);
    });
}

/// Without a reflection model, mistakes in lighting have no effect, and programs omit these mistakes.
bool shows(const MistakeName& mistake, const Facts& f) {
    return f.is_lit() || mistake.stage == MistakeStage::Faces || mistake.stage == MistakeStage::Display;
}

/// The features that a language may lack.
constexpr std::array need_rows{
    NeedRow{"transport", "/transport/model", "light is blocked or bounces off other surfaces",
            [](const Facts& f) { return f.scene.transport.model != TransportModel::Local && f.is_lit(); }},
    NeedRow{"mistakes.form", "/shading/mistakes/form", "a different form of a mistake is made",
            [](const Facts& f) { return f.wrong.form != 0 || f.wrong.highlight_form != 0; }},
    NeedRow{"mistakes.only", "/shading/mistakes", "mistakes are made in only part of the picture",
            [](const Facts& f) { return !f.wrong.only.is_all(); }},
    NeedRow{"mode.phong", "/shading/mode", "normals are interpolated and lit at each pixel",
            [](const Facts& f) { return f.lit_in(ShadingMode::Phong); }},
    NeedRow{"mode.facet", "/shading/mode", "each pixel is lit",
            [](const Facts& f) { return f.lit_in(ShadingMode::Facet); }},
    NeedRow{"mode.flat", "/shading/mode", "each polygon has one colour",
            [](const Facts& f) { return f.shading.mode == ShadingMode::Flat; }},
    NeedRow{"flat.centroid", "/shading/flat_point", "each polygon is lit at its centroid",
            [](const Facts& f) { return f.lit_in(ShadingMode::Flat) && !f.provoking(); }},
    NeedRow{"interpolation.screen", "/shading/interpolation", "interpolation is linear on the screen",
            blends_screen},
    NeedRow{"interpolation.scanline", "/shading/interpolation", "interpolation runs along scanlines",
            blends_scanline},
    NeedRow{"near_cut", "/shading/interpolation", "the near plane cuts polygons interpolated on the screen",
            near_plane_cuts},
    NeedRow{"light.area", "/lights", "an area light shines",
            [](const Facts& f) { return f.any_light(LightKind::Area); }},
    NeedRow{"light.spot", "/lights", "a spot shines",
            [](const Facts& f) { return f.any_light(LightKind::Spot); }},
    NeedRow{"light.falloff", "/lights", "light falls off", [](const Facts& f) { return f.any_falloff(); }},
    NeedRow{"exponent.large", "/lights", "a spot's exponent is above 128", has_large_exponent},
    NeedRow{"spot.soft", "/lights", "a spot has a soft edge", has_soft_edge},
    NeedRow{"spot.soft_mistaken", "/shading/mistakes", "the angles of a soft edge are wrong",
            [](const Facts& f) {
                return has_soft_edge(f) && (f.wrong.cutoff_as_full_angle || f.wrong.degrees_for_radians);
            }},
    NeedRow{"lights.above_8", "/lights", "more than 8 lights shine",
            [](const Facts& f) { return f.is_lit() && f.lights.size() > fixed_function_lights; }},
    NeedRow{"lights.above_32", "/lights", "more than 32 lights shine",
            [](const Facts& f) { return f.is_lit() && f.lights.size() > shader_lights; }},
    NeedRow{"shininess.capped", "/shading/rules", "a shininess above 128 is used as 128", is_capped},
    NeedRow{"shininess.large", "/objects", "a shininess is above 128",
            [](const Facts& f) {
                return !is_capped(f) && f.any_shininess([](float s) { return s > fixed_function_most; });
            }},
    NeedRow{"shininess.zero", "/objects", "a shininess is 0, where drivers differ",
            [](const Facts& f) { return f.any_shininess([](float s) { return s == 0; }); }},
    NeedRow{"corners.clamped", "/shading/rules", "colours of corners are clamped",
            [](const Facts& f) {
                return f.shading.rules == Rules::OpenGL2 &&
                       (f.lit_in(ShadingMode::Gouraud) || f.lit_in(ShadingMode::Flat));
            }},
    NeedRow{"two_sided", "/shading/two_sided", "both sides of a face are lit",
            [](const Facts& f) { return f.is_lit() && f.shading.two_sided; }},
    NeedRow{"cull.back", "/shading/cull", "back faces are left out",
            [](const Facts& f) { return f.shading.cull == Cull::Back; }},
    NeedRow{"cull.front", "/shading/cull", "front faces are left out",
            [](const Facts& f) { return f.shading.cull == Cull::Front; }},
    NeedRow{"cull.some", "/objects", "an object's back faces are kept while others are left out",
            [](const Facts& f) {
                return f.shading.cull != Cull::None &&
                       std::any_of(f.objects.begin(), f.objects.end(),
                                   [](const Object& o) { return o.double_sided; });
            }},
    NeedRow{"power_table", "/shading/power_table", "powers are looked up in a table",
            [](const Facts& f) { return f.shading.power_table > 0 && f.uses_shininess(); }},
    NeedRow{"tone", "/npr/cool_to_warm", "surfaces are shaded from cool to warm",
            [](const Facts& f) { return f.scene.npr.cool_to_warm && f.is_lit(); }},
    NeedRow{"strokes", "/npr", "silhouettes or creases are drawn",
            [](const Facts& f) { return f.scene.npr.silhouettes || f.scene.npr.creases; }},
    NeedRow{"transfer.srgb", "/display/transfer", "colours are encoded for the display",
            [](const Facts& f) { return f.scene.display.transfer == Transfer::Srgb; }},
    NeedRow{"exposure", "/display/exposure", "colours are multiplied by the exposure",
            [](const Facts& f) { return f.scene.display.exposure != 1; }},
    NeedRow{"culled.unlit", "/shading/mistakes/culled_by_light",
            "faces are culled by a light's direction although nothing is lit",
            [](const Facts& f) { return f.wrong.culled_by_light && !f.is_lit(); }},
    NeedRow{"normals.flip", "/objects", "an object's normals are flipped",
            [](const Facts& f) {
                return f.is_lit() && std::any_of(f.objects.begin(), f.objects.end(),
                                                 [](const Object& o) { return o.normals.flip; });
            }},
};

void add_derived(Flags& flags, const Facts& f) {
    const auto add = [&flags](const char* flag, bool on) {
        if (on) flags.insert(flag);
    };
    const Terms& terms = f.shading.terms;
    const bool tone = f.scene.npr.cool_to_warm;
    add("reflection.lit", f.is_lit());
    add("models.several", models_of(f.scene).size() > 1);
    add("flat.provoking", f.shading.mode == ShadingMode::Flat && f.provoking());
    add("corners", f.blends_corners());
    add("needs.blend", f.interpolates());
    add("needs.weights", f.interpolates() || f.lit_in(ShadingMode::Facet));
    add("viewer.infinite", f.infinite_viewer());
    add("projection.orthographic", is_orthographic(f.scene.camera.projection));
    add("projection.frustum", std::holds_alternative<Frustum>(f.scene.camera.projection));
    const bool emission = std::any_of(f.objects.begin(), f.objects.end(),
                                      [](const Object& o) { return o.material.emission != glm::vec3(0); });
    add("terms.emission", terms.emission && !tone && emission);
    add("terms.ambient", terms.ambient && !tone);
    add("terms.diffuse", terms.diffuse && !tone);
    add("terms.specular", terms.specular);
    const bool two_sided = f.is_lit() && f.shading.two_sided;
    add("turned", two_sided || (f.is_lit() && f.wrong.some_faces_flipped));
    add("sides", two_sided || f.shading.cull != Cull::None);
    add("facet_normals",
        (f.lit_in(ShadingMode::Phong) && f.any_normal_missing()) || f.lit_in(ShadingMode::Facet) ||
            (f.lit_in(ShadingMode::Flat) && !f.provoking()) || (f.is_lit() && f.wrong.culled_by_light));
    add("lights_pixels", f.lit_in(ShadingMode::Phong) || f.lit_in(ShadingMode::Facet));
    const bool whole_faces = f.shading.mode == ShadingMode::Flat && !f.provoking();
    add("flat_centroid", whole_faces);
    add("facet_normals_alone", f.is_lit() && (whole_faces || f.shading.mode == ShadingMode::Facet));
    add("lights.any", f.is_lit() && !f.lights.empty());
    add("first_light", f.is_lit() && (tone || f.wrong.culled_by_light));
    add("cosine.above_1", f.wrong.unnormalized_light || f.wrong.unnormalized_view ||
                              f.wrong.reflect_of_difference || f.wrong.unnormalized_normals);
    add("clamped_highlight", !(f.wrong.no_clamp_of_cosine && f.uses_shininess()));
    add("mirrored", std::any_of(f.objects.begin(), f.objects.end(), [](const Object& o) {
            const glm::vec3& s = o.transform.scale;
            return s.x * s.y * s.z < 0;
        }));
    const bool flips =
        std::any_of(f.objects.begin(), f.objects.end(), [](const Object& o) { return o.normals.flip; });
    add("turned_normals",
        f.is_lit() && (flips || f.wrong.normals_flipped || f.wrong.mirror_turns_inside_out));
    const bool mesh_colors = std::any_of(f.objects.begin(), f.objects.end(),
                                         [](const Object& o) { return !o.mesh->colors.empty(); });
    add("mesh.colors", !f.is_lit() && mesh_colors);
    add("light.world", std::any_of(f.lights.begin(), f.lights.end(),
                                   [](const Light& l) { return l.space == LightSpace::World; }));
    add("light.camera", std::any_of(f.lights.begin(), f.lights.end(),
                                    [](const Light& l) { return l.space == LightSpace::Camera; }));
    add("light.directional", f.any_light(LightKind::Directional));
    add("light.place", f.any_light(LightKind::Point) || f.any_light(LightKind::Spot) ||
                           f.any_light(LightKind::Area) || f.wrong.direction_is_position);
}

}  // namespace

std::vector<Light> shining(const Scene& scene) {
    std::vector<Light> lights;
    for (Light light : scene.lights) {
        if (!light.enabled) continue;
        if (light.kind == LightKind::Spot && light.spot.cutoff_deg == 180) light.kind = LightKind::Point;
        if (light.kind != LightKind::Directional) light.position /= light.position.w;
        lights.push_back(light);
    }
    return lights;
}

std::vector<Object> shown(const Scene& scene) {
    std::vector<Object> objects;
    std::copy_if(scene.objects.begin(), scene.objects.end(), std::back_inserter(objects),
                 [](const Object& o) { return o.visible; });
    return objects;
}

std::vector<Reflection> models_of(const Scene& scene) {
    std::set<Reflection> models;
    for (const Object& o : scene.objects)
        if (o.visible) models.insert(model_of(o, scene));
    if (models.empty()) models.insert(scene.shading.reflection);
    return {models.begin(), models.end()};
}

std::vector<Need> needs_of(const Scene& scene) {
    const Facts facts{scene};
    std::vector<Need> needs;
    for (const NeedRow& row : need_rows)
        if (row.is_needed(facts)) needs.push_back({row.flag, row.pointer, row.what});
    for (const Reflection model : models_of(scene)) {
        std::string pointer = "/shading/reflection";
        for (std::size_t i = 0; model != scene.shading.reflection && i < scene.objects.size(); ++i)
            if (scene.objects[i].visible && model_of(scene.objects[i], scene) == model)
                pointer = fmt::format("/objects/{}/material/reflection", i);
        const std::string name(name_of(model));
        needs.push_back({"reflection." + name, std::move(pointer), "the model is " + name});
    }
    for (const MistakeName& mistake : mistake_names())
        if (scene.shading.mistakes.*mistake.flag && shows(mistake, facts))
            needs.push_back({fmt::format("wrong.{}", mistake.name),
                             fmt::format("/shading/mistakes/{}", mistake.name), "this mistake is made"});
    return needs;
}

Flags flags_of(const Scene& scene) {
    Flags flags;
    for (const Need& need : needs_of(scene)) flags.insert(need.flag);
    const Facts facts{scene};
    add_derived(flags, facts);
    if (blends_scanline(facts) || near_plane_cuts(facts)) flags.insert("needs.xy");
    return flags;
}

}  // namespace glint
