#include "programs/gl_calls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/numbers.h"
#include "models/scene_file/scene_file.h"
#include "programs/model_text.h"
#include "programs/scene_tables.h"
#include "programs/texts.h"

namespace glint {
namespace {

using Variables = std::vector<Variable>;

const Variables& scene_variables() {
    static const Variables all{
        {"aspect", "", 0, "(double)width / height"},   {"global_ambient", "/global_ambient", 3},
        {"fov_y_deg", "/camera/projection/fov_y_deg"}, {"view_height", "/camera/projection/height"},
        {"left", "/camera/projection/left"},           {"right", "/camera/projection/right"},
        {"bottom", "/camera/projection/bottom"},       {"top", "/camera/projection/top"},
        {"near", "/camera/projection/near"},           {"far", "/camera/projection/far"},
        {"eye.x, eye.y, eye.z", "/camera/eye", 3},     {"target.x, target.y, target.z", "/camera/target", 3},
        {"up.x, up.y, up.z", "/camera/up", 3},
    };
    return all;
}

/// `word`: OpenGL's name for the light.
Variables light_variables(std::string_view word) {
    return {
        {"light", "", 0, word},
        {"position", "/position", 4},
        {"direction", "/spot/direction", 3},
        {"l->intensity", "/intensity"},
        {"l->ambient", "/ambient", 3},
        {"l->diffuse", "/diffuse", 3},
        {"l->specular", "/specular", 3},
        {"l->constant", "/falloff/constant"},
        {"l->linear", "/falloff/linear"},
        {"l->quadratic", "/falloff/quadratic"},
        {"l->kind == spot ? l->cutoff_deg : 180", "/spot/cutoff_deg"},
        {"l->kind == spot ? l->exponent : 0", "/spot/exponent"},
    };
}

/// `mesh`: its display list.
Variables object_variables(const Transform& transform, std::string_view mesh) {
    const glm::vec3& s = transform.scale;
    return {
        {"black", "", 0, "0, 0, 0"},
        {"m->emission", "/material/emission", 3},
        {"m->ambient", "/material/ambient", 3},
        {"m->diffuse", "/material/diffuse", 3},
        {"m->specular", "/material/specular", 3},
        {"m->shininess", "/material/shininess"},
        {"o->translate.x, o->translate.y, o->translate.z", "/transform/translate", 3},
        {"o->rotate_deg.x", "/transform/rotate_deg/0"},
        {"o->rotate_deg.y", "/transform/rotate_deg/1"},
        {"o->rotate_deg.z", "/transform/rotate_deg/2"},
        {"o->scale.x, o->scale.y, o->scale.z", "/transform/scale", 3},
        {"o->scale.x * o->scale.y * o->scale.z < 0 ? GL_CW : GL_CCW", "", 0,
         s.x * s.y * s.z < 0 ? "GL_CW" : "GL_CCW"},
        {"first_list + (GLuint)i", "", 0, mesh},
    };
}

GlCall remark(std::string text) {
    GlCall call;
    call.pieces.push_back({"// " + std::move(text), ""});
    call.is_remark = true;
    return call;
}

bool can_be_called(const Light& light) { return light.enabled && light.kind != LightKind::Area; }

/// Returns OpenGL's name for a light, such as "GL_LIGHT2". Only lights that OpenGL calls can express are
/// numbered, and only the first eight have a name.
std::string light_word(const Scene& scene, std::size_t index) {
    const auto end = scene.lights.begin() + static_cast<std::ptrdiff_t>(index);
    const auto number = std::count_if(scene.lights.begin(), end, can_be_called);
    return fmt::format("GL_LIGHT{}{}", number < 8 ? "" : "0 + ", number);
}

/// Returns the first reflection model of the scene that the program does not support.
std::optional<Reflection> lacking_model(const Scene& scene) {
    static const Flags can = mentioned_flags(gl1_main_c);
    for (const Reflection model : models_of(scene))
        if (!can.contains(fmt::format("reflection.{}", name_of(model)))) return model;
    return {};
}

/// The scene's flags, but without mistakes, and with every term whose numbers the user may want to edit.
/// Ignores meshes, because processing a large one would take longer than a frame.
Flags flags_for_calls(Scene scene) {
    static const auto no_mesh = std::make_shared<const Mesh>();
    for (Object& object : scene.objects) object.mesh = no_mesh;
    scene.shading.mistakes = {};
    Flags flags = flags_of(scene);
    const Shading& shading = scene.shading;
    if (shading.terms.emission) flags.insert("terms.emission");
    const bool has_highlight = info_of(shading.reflection).uses_shininess() || lacking_model(scene);
    if (has_highlight && shading.terms.specular) flags.insert("uses.shininess");
    return flags;
}

class CallWriter {
  public:
    explicit CallWriter(const Scene& scene)
        : scene_(scene),
          flags_(flags_for_calls(scene)),
          object_(statements("object", flags_)),
          material_(statements("material", flags_)) {
        for (const SceneNumber& number : numbers_of(scene))
            numbers_[number.pointer] = static_cast<float>(number.value);
    }

    [[nodiscard]] GlCallGroup places() const {
        GlCallGroup group{"Camera and light positions", "", {}};
        for (const std::string& statement : statements("camera", flags_)) {
            if (statement == "place_lights(camera);") {
                add_places(group.calls, LightSpace::Camera);
            } else if (statement == "place_lights(world);") {
                add_places(group.calls, LightSpace::World);
            } else {
                group.calls.push_back(call_of(statement, scene_variables(), "", numbers_));
                group.calls.back().is_look_at = statement.starts_with("gluLookAt(");
            }
        }
        return group;
    }

    [[nodiscard]] GlCallGroup light(std::size_t i) const {
        const Light& light = scene_.lights[i];
        GlCallGroup group{light.name, fmt::format("/lights/{}", i), {}};
        if (can_be_called(light)) group.calls = light_calls("light", i);
        if (light.kind == LightKind::Area) group.calls.push_back(remark("An area light needs a shader."));
        if (light.kind == LightKind::Spot && light.spot.inner_deg < light.spot.cutoff_deg)
            group.calls.push_back(remark("OpenGL 1 gives the cone a hard edge; a soft one needs a shader."));
        return group;
    }

    [[nodiscard]] GlCallGroup shading() const {
        const Shading& s = scene_.shading;
        GlCallGroup group{"Shading", "/shading", {}};
        std::vector<GlCall>& calls = group.calls;
        for (const std::string& statement : statements("shading", flags_))
            calls.push_back(call_of(statement, scene_variables(), "", numbers_));
        if (s.mode == ShadingMode::Phong || s.mode == ShadingMode::Facet)
            calls.push_back(remark("OpenGL 1 lights corners only; lighting each pixel needs a shader."));
        if (const auto model = lacking_model(scene_))
            calls.push_back(remark(
                fmt::format("OpenGL 1 has Blinn-Phong only; {} needs a shader.", choice_of(*model).label)));
        return group;
    }

    [[nodiscard]] GlCallGroup object(std::size_t i) const {
        const Object& object = scene_.objects[i];
        const std::string mesh = fmt::format("mesh[{}]", i);
        const Variables variables = object_variables(object.transform, mesh);
        GlCallGroup group{object.name, fmt::format("/objects/{}", i), {}};
        const auto add = [&](const std::string& statement) {
            group.calls.push_back(call_of(statement, variables, group.about, numbers_));
            group.calls.back().about = group.about;
        };
        for (const std::string& statement : object_) {
            if (statement != "use_material(&o->material);") {
                add(statement);
                continue;
            }
            for (const std::string& of_material : material_) add(of_material);
            if (object.material.shininess > 128 && !flags_.contains("shininess.capped"))
                group.calls.push_back(remark("OpenGL 1 has exponents up to 128; larger ones need a shader."));
        }
        return group;
    }

  private:
    /// Returns the program's statements in the section `//@calls name`.
    static std::vector<std::string> statements(std::string_view name, const Flags& flags) {
        const std::string text = filled(lines_of_calls(gl1_main_c, name), flags, {});
        std::vector<std::string> all;
        for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
            end = text.find('\n', at);
            if (const auto statement = statement_of(std::string_view(text).substr(at, end - at));
                !statement.empty())
                all.emplace_back(statement);
        }
        return all;
    }

    void add_places(std::vector<GlCall>& calls, LightSpace space) const {
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            if (!can_be_called(scene_.lights[i]) || scene_.lights[i].space != space) continue;
            for (GlCall& call : light_calls("light_place", i)) {
                call.place_of_light = static_cast<int>(i);
                calls.push_back(std::move(call));
            }
        }
    }

    [[nodiscard]] std::vector<GlCall> light_calls(std::string_view name, std::size_t i) const {
        const Light& light = scene_.lights[i];
        Flags flags = flags_;
        flags.erase("light.falloff");
        flags.erase("light.spot");
        if (light.kind != LightKind::Directional) flags.insert("light.falloff");
        if (light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90) flags.insert("light.spot");
        const std::string word = light_word(scene_, i), below = fmt::format("/lights/{}", i);
        std::vector<GlCall> calls;
        for (const std::string& statement : statements(name, flags)) {
            calls.push_back(call_of(statement, light_variables(word), below, numbers_));
            calls.back().about = below;
        }
        return calls;
    }

    const Scene& scene_;
    Flags flags_;
    std::vector<std::string> object_, material_;  // the same for all objects
    NumbersByPointer numbers_;
};

}  // namespace

std::vector<GlCallGroup> gl_calls(const Scene& scene) {
    const CallWriter writer(scene);
    std::vector<GlCallGroup> groups{writer.places()};
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].enabled) groups.push_back(writer.light(i));
    groups.push_back(writer.shading());
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (scene.objects[i].visible) groups.push_back(writer.object(i));
    return groups;
}

std::string call_text(const GlCall& call) {
    std::string text;
    for (const CallPiece& piece : call.pieces) text += piece.text;
    if (call.is_remark || text.find("fv(") == text.npos) return text;
    // The array argument follows the last GL_ constant.
    const std::size_t begin = text.find(", ", text.rfind("GL_")) + 2, end = text.rfind(");");
    std::string numbers = text.substr(begin, end - begin);
    if (const std::size_t rgb = numbers.find("rgb("); rgb != numbers.npos) {
        const std::string factor = numbers.substr(0, rgb), comma = ", ";
        numbers = numbers.substr(rgb + 4, numbers.size() - rgb - 5);
        for (std::size_t at = 0; (at = numbers.find(comma, at)) != numbers.npos;)
            numbers.insert(at += comma.size(), factor);
        numbers = factor + numbers + ", 1";
    }
    return fmt::format("{{ const GLfloat v[] = {{{}}}; {}v); }}", numbers, text.substr(0, begin));
}

std::string calls_text(const std::vector<GlCallGroup>& groups) {
    std::string text =
        "// mesh: the display lists of the objects. width, height: the picture's size in pixels.\n"
        "#define GL_GLEXT_PROTOTYPES\n#include <GL/gl.h>\n#include <GL/glu.h>\n#include <math.h>\n\n"
        "void draw(const GLuint* mesh, int width, int height) {\n";
    for (const GlCallGroup& group : groups) {
        text += fmt::format("    // {}\n", for_comment(group.title));
        for (const GlCall& call : group.calls) text += fmt::format("    {}\n", call_text(call));
    }
    return text + "}\n";
}

namespace {

constexpr std::string_view rgb = "rgb(";

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class CallReader {
  public:
    CallReader(std::span<const Variable> variables, const std::string& below, const NumbersByPointer& numbers)
        : variables_(variables), below_(below), numbers_(numbers) {}

    GlCall read(std::string_view statement) {
        add(statement);
        return std::move(call_);
    }

  private:
    void text(std::string_view text) {
        if (call_.pieces.empty() || !call_.pieces.back().pointer.empty()) call_.pieces.emplace_back();
        call_.pieces.back().text += text;
    }

    void add(std::string_view statement) {
        bool in_name = false;  // the previous character belongs to a name
        while (!statement.empty()) {
            const Variable* variable = in_name ? nullptr : variable_at(statement);
            if (variable != nullptr) {
                value_of(*variable);
                statement.remove_prefix(variable->name.size());
            } else if (!in_name && statement.starts_with(rgb)) {
                const std::size_t comma = statement.find(", ");
                const std::string_view factor = statement.substr(rgb.size(), comma - rgb.size());
                if (factor != "1") {
                    add(factor);
                    text(" * ");
                }
                text(rgb);
                statement.remove_prefix(comma + 2);
            } else {
                in_name = is_of_name(statement.front());
                text(statement.substr(0, 1));
                statement.remove_prefix(1);
            }
        }
    }

    /// Returns the longest variable at the beginning of `statement`.
    [[nodiscard]] const Variable* variable_at(std::string_view statement) const {
        const Variable* longest = nullptr;
        for (const Variable& v : variables_) {
            if (!statement.starts_with(v.name)) continue;
            if (statement.size() > v.name.size() && is_of_name(statement[v.name.size()])) continue;
            if (longest == nullptr || v.name.size() > longest->name.size()) longest = &v;
        }
        return longest;
    }

    void value_of(const Variable& variable) {
        if (variable.count == 0) return text(variable.text);
        if (call_.about.empty()) call_.about = fmt::format("{}{}", below_, variable.key);
        for (int i = 0; i < variable.count; ++i) {
            if (i > 0) text(", ");
            std::string pointer = fmt::format("{}{}", below_, variable.key);
            if (variable.count > 1) pointer += fmt::format("/{}", i);
            call_.pieces.push_back({number_text(numbers_.find(pointer)->second), pointer});
        }
    }

    std::span<const Variable> variables_;
    const std::string& below_;
    const NumbersByPointer& numbers_;
    GlCall call_;
};

}  // namespace

std::string_view statement_of(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    const std::size_t name =
        static_cast<std::size_t>(std::find_if_not(line.begin(), line.end(), is_of_name) - line.begin());
    if (name == 0 || line.substr(name, 1) != "(") return {};
    line = line.substr(0, line.find("//"));
    return line.substr(0, line.rfind(';') + 1);
}

GlCall call_of(std::string_view statement, std::span<const Variable> variables, const std::string& below,
               const NumbersByPointer& numbers) {
    return CallReader(variables, below, numbers).read(statement);
}

}  // namespace glint
