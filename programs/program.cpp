#include "programs/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "models/fields/choices.h"
#include "models/gltf/gltf.h"
#include "models/utf8.h"
#include "programs/model_text.h"
#include "programs/scene_tables.h"
#include "programs/shader_scene.h"
#include "programs/texts.h"

namespace glint {
namespace {

/// A language's files, the program first. `most_lines`: the maximum number of lines of the program; 0: no
/// limit.
struct LanguageTexts {
    struct File {
        std::string_view name, text;
    };
    std::vector<File> files;
    std::string_view comment;  // the start of a comment
    std::size_t most_lines = 0;
};

LanguageTexts texts_of(Language language) {
    switch (language) {
    case Language::Gl1:
        return {{{"main.c", gl1_main_c}}, "//"};
    case Language::Glsl:
        return {{{"main.cpp", glsl_main_cpp},
                 {"lighting.glsl", glsl_lighting_glsl},
                 {"scene.vert", glsl_scene_vert},
                 {"scene.frag", glsl_scene_frag}},
                "//"};
    case Language::Cpp:
        return {{{"main.cpp", cpp_main_cpp}}, "//", 400};
    case Language::Python:
        return {{{"main.py", python_main_py}}, "#", 250};
    case Language::Webgl:
        return {{{"index.html", webgl_main_html},
                 {"lighting.glsl", glsl_lighting_glsl},
                 {"scene.vert", glsl_scene_vert},
                 {"scene.frag", glsl_scene_frag}},
                "//"};
    }
    return {};
}

/// A language supports the flags that its texts mention. Support for a reflection model is read from the
/// model's table row.
bool can(Language language, const Need& need) {
    for (const LanguageTexts::File& file : texts_of(language).files) {
        // The page's corner data never contains mistakes, and neither do its shaders for corners and pixels.
        if (language == Language::Webgl && need.flag.starts_with("wrong.") && file.name.starts_with("scene."))
            continue;
        if (mentioned_flags(file.text).contains(need.flag)) return true;
        if (need.flag.starts_with("reflection.") && file.text.find("@model@") != file.text.npos) return true;
    }
    return false;
}

/// Returns the first of the scene's needs that the language does not meet.
std::optional<Need> lacking_in(Language language, const Scene& scene) {
    const std::vector<Need> needs = needs_of(scene);
    const auto lacking =
        std::find_if(needs.begin(), needs.end(), [&](const Need& need) { return !can(language, need); });
    return lacking == needs.end() ? std::nullopt : std::optional(*lacking);
}

/// The words that names from the scene must not use: all words of a text, and the mixed-case words of the
/// languages. The class Identifiers already avoids the languages' other words.
Flags words_of(std::string_view text) {
    Flags words{"Light", "Material", "Object", "False", "None", "True"};
    std::string word;
    for (const char c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
            word += c;
            continue;
        }
        if (!word.empty()) words.insert(word);
        word.clear();
    }
    return words;
}

/// The mesh files of shown() objects: objects with the same mesh and kind of normals share a file.
struct MeshFiles {
    std::vector<ProgramMesh> files;
    std::vector<std::string> of_object;
};
MeshFiles mesh_files(const Scene& scene) {
    constexpr std::size_t longest_stem = 60;  // a file's name may have 255 bytes, and a suffix follows
    std::map<NormalsKey, std::string> known;
    Identifiers names({});
    MeshFiles out;
    for (const Object& o : shown(scene)) {
        std::string& file = known[normals_key(o)];
        if (file.empty()) {
            const std::string source =
                source_name(o.source);  // one glTF file may contain the meshes of several objects
            const std::string stem = std::filesystem::path(source).stem().string();
            const std::string name = in_letters(is_gltf_path(source) ? o.name : stem, "mesh");
            file = names.once(name.substr(0, longest_stem)) + ".mesh";
            out.files.push_back({file, o});
        }
        out.of_object.push_back(file);
    }
    return out;
}

std::string wrapped(const std::vector<ProgramMesh>& files, const std::string& comment) {
    std::string text;
    std::size_t column = 60;
    for (const ProgramMesh& file : files) {
        if (column + file.name.size() > 100) {
            if (!text.empty()) text.pop_back();
            text += "\n" + comment + " ";
            column = 4;
        }
        text += file.name + " ";
        column += file.name.size() + 1;
    }
    if (!text.empty()) text.pop_back();
    return text.empty() ? "(no mesh)" : text;
}

/// The clear colour: the background in displayed colours, because it does not pass through a shader.
std::string clear_call(const Display& display, const Flags& flags, Language language) {
    const bool is_page = language == Language::Webgl;
    std::string text = is_page ? "gl.clearColor(" : "glClearColor(";
    for (int c = 0; c < 3; ++c) {
        double x =
            std::min(1.0, static_cast<double>(display.exposure) * static_cast<double>(display.background[c]));
        const auto srgb = [](double y) {
            return y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1 / 2.4) - 0.055;
        };
        if (display.transfer == Transfer::Srgb) x = srgb(x);
        if (flags.contains("wrong.encoded_twice")) x = srgb(x);
        const std::string number = fmt::format("{:.7g}", x);
        const char* const suffix = number.find_first_of(".e") == number.npos ? ".0f, " : "f, ";
        text += number + (is_page ? ", " : suffix);
    }
    return text + "1);  // the background";
}

/// The scene's name and its description, for the program's first comment.
std::string title_of(const ProgramOf& of, Language language) {
    std::string title =
        for_comment(of.name) + (of.scene.about.empty() ? "" : ": " + for_comment(of.scene.about));
    if (language == Language::Webgl)  // two dashes end a comment
        for (std::size_t at; (at = title.find("--")) != title.npos;) title.insert(at + 1, " ");
    return title;
}

/// The numbers of each mesh's corners, as members of a JavaScript object.
std::string mesh_numbers(const ProgramOf& of, const std::vector<ProgramMesh>& meshes, const Flags& flags) {
    const std::size_t used = flags.contains("lights_pixels") ? numbers_per_corner / 2 : numbers_per_corner;
    std::string text;
    for (const ProgramMesh& mesh : meshes) {
        const CornerNumbers all = CornerCache().of(mesh.object, of.scene.shading);
        std::string bytes;
        for (std::size_t i = 0; i < all->size(); i += numbers_per_corner)
            bytes.append(reinterpret_cast<const char*>(&(*all)[i]), used * sizeof(float));
        text += fmt::format("\"{}\": \"{}\",\n", mesh.name, base64(bytes));
    }
    if (!text.empty()) text.pop_back();
    return text;
}

/// "Phong", or "m.model: Lambert, Phong".
std::string model_names(const Scene& scene) {
    const std::vector<Reflection> models = models_of(scene);
    std::string names = models.size() > 1 ? "m.model: " : "";
    for (const Reflection model : models)
        names += (model == models.front() ? "" : ", ") + std::string(choice_of(model).label);
    return names;
}

/// Declares the numbers that Material::model uses for the models, without a type.
std::string model_numbers(const Scene& scene) {
    std::string numbers;
    for (const Reflection model : models_of(scene))
        numbers += fmt::format("{}{} = {}", numbers.empty() ? "" : ", ", identifier_of(model),
                               static_cast<int>(model));
    return numbers;
}

/// The values that all files of the program derive from the scene and the size.
Values values_of(const ProgramOf& of, Language language, const Flags& flags) {
    const Scene& s = of.scene;
    const auto vector = [language](const glm::vec3& v) { return vector_in_program(v, language); };
    const bool is_shader = language == Language::Glsl || language == Language::Webgl;
    return {{"title", title_of(of, language)},
            {"width", fmt::format("{}", of.size.width)},
            {"height", fmt::format("{}", of.size.height)},
            {"background", vector(s.display.background)},
            {"global_ambient", vector(s.global_ambient)},
            {"exposure", number_in_program(s.display.exposure)},
            {"power_table", fmt::format("{}", s.shading.power_table)},
            {"model_name", model_names(s)},
            {"model_numbers", model_numbers(s)},
            {"cool", is_shader ? vector_in_program(s.npr.cool, Language::Python) : vector(s.npr.cool)},
            {"warm", is_shader ? vector_in_program(s.npr.warm, Language::Python) : vector(s.npr.warm)},
            {"alpha", number_in_program(s.npr.alpha)},
            {"beta", number_in_program(s.npr.beta)},
            // Factors that are 1 or never change are omitted.
            {"clear_color", clear_call(s.display, flags, language)},
            {"window_title", in_letters(of.name, "scene")},
            {"const_n", flags.contains("wrong.no_normals_given") || flags.contains("wrong.some_faces_flipped")
                            ? ""
                            : "const "},
            {"over_w", flags.contains("interpolation.screen") ? " * gl_FragCoord.w" : ""},
            {"max_loop_runs", fmt::format("{}", max_loop_runs)},
            {"light_count", fmt::format("{}", shining(s).size())},
            {"blending", flags.contains("mode.flat") ? "flat" : "smooth"},
            {"turn", flags.contains("turned") ? "turn * " : ""},
            {"side", flags.contains("turned_normals") ? "side * " : ""},
            {"xy", flags.contains("needs.xy") ? ", x, y" : ""},
            {"const_frame", flags.contains("wrong.light_moved_twice") ? "" : "const "},
            {"const_v", flags.contains("wrong.view_reversed") ? "" : "const "}};
}

/// The program, without a limit on its length. Precondition: the language lacks nothing that the scene needs.
Program program_of(const ProgramOf& of, Language language, bool is_measured = false) {
    const LanguageTexts texts = texts_of(language);
    Flags flags = flags_of(of.scene);
    if (of.blank) flags.insert("blank");
    if (is_measured) flags.insert("measured");  // by shader_stages()
    const std::vector<Reflection> models = models_of(of.scene);
    const ModelText model =
        model_text(of.scene.shading, models, flags.contains("terms.diffuse"), language, "    ");
    flags.insert(model.uses.begin(), model.uses.end());
    // A highlight requires testing which side of the surface the light is on.
    if (flags.contains("uses.S") && flags.contains("clamped_highlight") &&
        !flags.contains("wrong.specular_behind_surface"))
        flags.insert("uses.n_l");
    if (language == Language::Glsl || language == Language::Webgl)
        flags.insert("shader");  // a shader computes the samples of an area light itself
    for (const char* of_light : {"uses.l", "uses.n_l", "uses.l_v", "uses.S", "light.spot", "light.area"})
        if (flags.contains(of_light)) flags.insert("needs.l");
    MeshFiles meshes = mesh_files(of.scene);
    Values values = values_of(of, language, flags);
    values["model"] = model.text;
    values["mesh_files"] = wrapped(meshes.files, std::string(texts.comment));
    std::string all;
    for (const LanguageTexts::File& file : texts.files) all += file.text;
    Flags words = words_of(all);
    for (const Reflection m : models) words.insert(identifier_of(m));
    const SceneTables tables = scene_tables(of.scene, language, flags, meshes.of_object, std::move(words));
    values["camera"] = tables.camera;
    values["lights"] = tables.lights;
    values["objects"] = tables.objects;

    if (language == Language::Webgl) {  // the page contains the other files
        for (const auto& [name, text] : {std::pair{"lighting", glsl_lighting_glsl},
                                         {"vertex", glsl_scene_vert},
                                         {"fragment", glsl_scene_frag}})
            values[name] = filled(text, flags, values);
        values["mesh_numbers"] = mesh_numbers(of, meshes.files, flags);
        return {{{std::string(texts.files[0].name), filled(texts.files[0].text, flags, values)}}, {}};
    }
    Program program{{}, std::move(meshes.files)};
    for (const LanguageTexts::File& file : texts.files)
        program.texts.push_back({std::string(file.name), filled(file.text, flags, values)});
    return program;
}

/// Returns the program's number of lines if it exceeds the language's maximum.
std::optional<std::size_t> too_many_lines(const Program& program, Language language) {
    const std::string& text = program.texts.front().text;
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    const std::size_t most = texts_of(language).most_lines;
    return most > 0 && lines > most ? std::optional(lines) : std::nullopt;
}

/// Returns languages_for() as text, such as "--language cpp or python"; empty if there is none.
std::string able_words(const ProgramOf& of) {
    std::string able;
    for (const Language language : languages_for(of))
        able += (able.empty() ? "--language " : " or ") + std::string(name_of(language));
    return able;
}

constexpr const char* smaller_scene = "fewer lights and objects";

/// Returns advice for a language that lacks something that the scene needs.
std::string ways_around(const ProgramOf& of, const Need& need) {
    if (std::string able = able_words(of); !able.empty()) return able;
    std::string in_part;  // a language that has this feature, but lacks a different one
    for (const Language other : enumerators<Language>) {
        const std::optional<Need> lacking = lacking_in(other, of.scene);
        if (!lacking) return fmt::format("{}, and --language {}", smaller_scene, name_of(other));
        if (in_part.empty() && can(other, need))
            in_part = fmt::format("a scene without it, or --language {} and a scene without {}",
                                  name_of(other), lacking->pointer);
    }
    return in_part.empty() ? "a scene without it: no language supports it" : in_part;
}

std::optional<Problem> why_not_written(const ProgramOf& of, Language language) {
    const std::optional<Need> need = lacking_in(language, of.scene);
    if (!need) return {};
    return Problem{"", need->pointer,
                   fmt::format("{}, which {} does not support", need->what, name_of(language)),
                   ways_around(of, *need)};
}

}  // namespace

std::vector<Language> languages_for(const ProgramOf& of) {
    std::vector<Language> able;
    for (const Language language : enumerators<Language>) {
        const bool any_length = texts_of(language).most_lines == 0;
        if (!lacking_in(language, of.scene) &&
            (any_length || !too_many_lines(program_of(of, language), language)))
            able.push_back(language);
    }
    return able;
}

Result<Program> write_program(const ProgramOf& of, Language language) {
    if (const std::optional<Problem> problem = why_not_written(of, language)) return *problem;
    Program program = program_of(of, language);
    if (const auto lines = too_many_lines(program, language)) {
        const std::string able = able_words(of);
        return Problem{"", "", fmt::format("the program would have {} lines", *lines),
                       fmt::format("at most {}: {}{}", texts_of(language).most_lines, smaller_scene,
                                   able.empty() ? "" : ", or " + able)};
    }
    return program;
}

Result<ShaderStages> shader_stages(const ProgramOf& of) {
    if (of.scene.shading.reflection == Reflection::None)
        return Problem{"", "/shading/reflection", "nothing is lit", "a reflection model such as phong"};
    if (const std::optional<Problem> problem = why_not_written(of, Language::Glsl)) return *problem;
    ShaderStages stages;
    for (const ProgramFile& file : program_of(of, Language::Glsl, true).texts) {
        if (file.name == "scene.vert") stages.vertex = file.text;
        if (file.name == "scene.frag") stages.fragment = file.text;
    }
    stages.before =
        fmt::format("int loop_runs_so_far = 0;\nbool loop_runs() {{ return ++loop_runs_so_far <= {}; }}\n",
                    max_loop_runs);
    stages.lights_pixels = flags_of(of.scene).contains("lights_pixels");
    return stages;
}

}  // namespace glint
