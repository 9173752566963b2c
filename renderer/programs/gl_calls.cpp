#include "renderer/programs/gl_calls.h"

#include <fmt/format.h>

#include <utility>

#include "models/fields/choices.h"
#include "models/scene_file/scene_file.h"

namespace glint {
namespace {

/// A call that is being written: text and numbers in turn.
class Writer {
  public:
    explicit Writer(std::string about) { call_.about = std::move(about); }

    Writer& text(std::string text) {
        call_.pieces.push_back({std::move(text), ""});
        return *this;
    }
    Writer& number(float value, std::string pointer) {
        call_.pieces.push_back({number_text(value), std::move(pointer)});
        return *this;
    }
    /// The first `count` components of a vector, commas between.
    template <class Vector> Writer& vector(const Vector& v, const std::string& pointer, int count) {
        for (int i = 0; i < count; ++i) {
            if (i > 0) text(", ");
            number(v[i], fmt::format("{}/{}", pointer, i));
        }
        return *this;
    }
    /// "rgb(r, g, b)".
    Writer& colour(const glm::vec3& c, const std::string& pointer) {
        return text("rgb(").vector(c, pointer, 3).text(")");
    }
    GlCall end(const char* text_after) {
        text(text_after);
        return std::move(call_);
    }

  private:
    GlCall call_;
};

GlCall plain(const char* text) { return Writer("").end(text); }

GlCall remark(std::string text) {
    GlCall call;
    call.pieces.push_back({"// " + std::move(text), ""});
    call.is_remark = true;
    return call;
}

struct ProjectionCall {
    GlCall operator()(const Perspective& p) const {
        return writer("gluPerspective(")
            .number(p.fov_y_deg, at("fov_y_deg"))
            .text(", width / height, ")
            .number(p.near, at("near"))
            .text(", ")
            .number(p.far, at("far"))
            .end(");");
    }
    GlCall operator()(const Orthographic& p) const {
        Writer w = writer("h = ");
        w.number(p.height, at("height"))
            .text(" / 2; glOrtho(-h * width / height, h * width / height, -h, h, ");
        return w.number(p.near, at("near")).text(", ").number(p.far, at("far")).end(");");
    }
    GlCall operator()(const Frustum& p) const {
        Writer w = writer("glFrustum(");
        for (const auto& [value, key] :
             {std::pair(p.left, "left"), std::pair(p.right, "right"), std::pair(p.bottom, "bottom"),
              std::pair(p.top, "top"), std::pair(p.near, "near")})
            w.number(value, at(key)).text(", ");
        return w.number(p.far, at("far")).end(");");
    }

  private:
    static std::string at(const char* key) { return fmt::format("/camera/projection/{}", key); }
    static Writer writer(const char* begin) {
        Writer w("/camera/projection");
        w.text(begin);
        return w;
    }
};

bool can_be_called(const Light& light) { return light.enabled && light.kind != LightKind::Area; }

/// "GL_LIGHT2": OpenGL has eight at least, and counts those that are on.
std::string light_word(const Scene& scene, std::size_t index) {
    int number = 0;
    for (std::size_t i = 0; i < index; ++i) number += can_be_called(scene.lights[i]) ? 1 : 0;
    return fmt::format("GL_LIGHT{}", number);
}

bool has_cone(const Light& light) { return light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90; }

void add_place(std::vector<GlCall>& calls, const Scene& scene, std::size_t i) {
    const Light& light = scene.lights[i];
    const std::string at = fmt::format("/lights/{}", i), word = light_word(scene, i);
    const auto add = [&](Writer& w) {
        GlCall call = w.end(");");
        call.place_of_light = static_cast<int>(i);
        calls.push_back(std::move(call));
    };
    Writer place(at);
    place.text("glLightfv(" + word + ", GL_POSITION, ").vector(light.position, at + "/position", 4);
    add(place);
    if (!has_cone(light)) return;
    Writer aim(at);
    aim.text("glLightfv(" + word + ", GL_SPOT_DIRECTION, ")
        .vector(light.spot.direction, at + "/spot/direction", 3);
    add(aim);
}

GlCallGroup places(const Scene& scene) {
    GlCallGroup group{"Camera, and the lights' places", "", {}};
    std::vector<GlCall>& calls = group.calls;
    calls.push_back(plain("glMatrixMode(GL_PROJECTION);"));
    calls.push_back(plain("glLoadIdentity();"));
    calls.push_back(std::visit(ProjectionCall{}, scene.camera.projection));
    calls.push_back(plain("glMatrixMode(GL_MODELVIEW);"));
    calls.push_back(plain("glLoadIdentity();"));
    const auto add_lights = [&](LightSpace space) {
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            if (can_be_called(scene.lights[i]) && scene.lights[i].space == space) add_place(calls, scene, i);
    };
    add_lights(LightSpace::Camera);
    const Camera& camera = scene.camera;
    Writer look("/camera");
    look.text("gluLookAt(").vector(camera.eye, "/camera/eye", 3).text(", ");
    look.vector(camera.target, "/camera/target", 3).text(", ").vector(camera.up, "/camera/up", 3);
    calls.push_back(look.end(");"));
    calls.back().is_look_at = true;
    add_lights(LightSpace::World);
    return group;
}

GlCallGroup light_group(const Scene& scene, std::size_t i) {
    const Light& light = scene.lights[i];
    const std::string at = fmt::format("/lights/{}", i), word = light_word(scene, i);
    GlCallGroup group{light.name, at, {}};
    std::vector<GlCall>& calls = group.calls;
    if (light.kind == LightKind::Area) {
        calls.push_back(remark("An area light needs a shader."));
        return group;
    }
    const auto colour = [&](const char* what, const glm::vec3& value, const char* key) {
        Writer w(at);
        w.text(fmt::format("glLightfv({}, {}, ", word, what)).number(light.intensity, at + "/intensity");
        calls.push_back(w.text(" * ").colour(value, fmt::format("{}/{}", at, key)).end(");"));
    };
    const auto number = [&](const char* what, float value, const char* key) {
        Writer w(at);
        w.text(fmt::format("glLightf({}, {}, ", word, what));
        calls.push_back(w.number(value, fmt::format("{}/{}", at, key)).end(");"));
    };
    colour("GL_AMBIENT", light.ambient, "ambient");
    colour("GL_DIFFUSE", light.diffuse, "diffuse");
    colour("GL_SPECULAR", light.specular, "specular");
    if (light.kind != LightKind::Directional) {
        number("GL_CONSTANT_ATTENUATION", light.falloff.constant, "falloff/constant");
        number("GL_LINEAR_ATTENUATION", light.falloff.linear, "falloff/linear");
        number("GL_QUADRATIC_ATTENUATION", light.falloff.quadratic, "falloff/quadratic");
    }
    if (has_cone(light)) {
        number("GL_SPOT_CUTOFF", light.spot.cutoff_deg, "spot/cutoff_deg");
        number("GL_SPOT_EXPONENT", light.spot.exponent, "spot/exponent");
    }
    calls.push_back(plain(fmt::format("glEnable({});", word).c_str()));
    return group;
}

GlCallGroup shading_group(const Scene& scene) {
    const Shading& s = scene.shading;
    GlCallGroup group{"Shading", "/shading", {}};
    std::vector<GlCall>& calls = group.calls;
    for (const char* what : {"glEnable(GL_DEPTH_TEST);", "glEnable(GL_NORMALIZE);", "glEnable(GL_LIGHTING);"})
        calls.push_back(plain(what));
    Writer ambient("/global_ambient");
    calls.push_back(ambient.text("glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ")
                        .colour(scene.global_ambient, "/global_ambient")
                        .end(");"));
    calls.push_back(plain(s.local_viewer ? "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);"
                                         : "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_FALSE);"));
    calls.push_back(plain(s.two_sided ? "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);"
                                      : "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_FALSE);"));
    if (s.cull != Cull::None)
        calls.push_back(plain(s.cull == Cull::Back ? "glEnable(GL_CULL_FACE); glCullFace(GL_BACK);"
                                                   : "glEnable(GL_CULL_FACE); glCullFace(GL_FRONT);"));
    calls.push_back(
        plain(s.mode == ShadingMode::Flat ? "glShadeModel(GL_FLAT);" : "glShadeModel(GL_SMOOTH);"));
    if (s.mode == ShadingMode::Phong || s.mode == ShadingMode::Facet)
        calls.push_back(remark("It lights corners only; light at every pixel needs a shader."));
    if (s.reflection != Reflection::BlinnPhong)
        calls.push_back(remark(
            fmt::format("It has Blinn-Phong only; {} needs a shader.", choice_of(s.reflection).label)));
    return group;
}

GlCallGroup object_group(const Scene& scene, std::size_t i) {
    const Object& object = scene.objects[i];
    const Material& m = object.material;
    const std::string at = fmt::format("/objects/{}", i), t = at + "/transform", k = at + "/material";
    GlCallGroup group{object.name, at, {}};
    std::vector<GlCall>& calls = group.calls;
    const auto material = [&](const char* what, const glm::vec3& colour, const char* key) {
        Writer w(k);
        w.text(fmt::format("glMaterialfv(GL_FRONT_AND_BACK, {}, ", what));
        calls.push_back(w.colour(colour, fmt::format("{}/{}", k, key)).end(");"));
    };
    material("GL_EMISSION", m.emission, "emission");
    material("GL_AMBIENT", m.ambient, "ambient");
    material("GL_DIFFUSE", m.diffuse, "diffuse");
    material("GL_SPECULAR", m.specular, "specular");
    Writer shininess(k);
    shininess.text("glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, ").number(m.shininess, k + "/shininess");
    calls.push_back(shininess.end(");"));
    if (m.shininess > 128) calls.push_back(remark("It has exponents up to 128; more needs a shader."));
    calls.push_back(plain("glPushMatrix();"));
    Writer translate(t);
    translate.text("glTranslatef(").vector(object.transform.translate, t + "/translate", 3);
    calls.push_back(translate.end(");"));
    // The last call is applied first: about x, then y, then z.
    constexpr const char* axes[] = {", 1, 0, 0);", ", 0, 1, 0);", ", 0, 0, 1);"};
    for (int axis = 2; axis >= 0; --axis) {
        Writer w(t);
        w.text("glRotatef(")
            .number(object.transform.rotate_deg[axis], fmt::format("{}/rotate_deg/{}", t, axis));
        calls.push_back(w.end(axes[axis]));
    }
    Writer scale(t);
    scale.text("glScalef(").vector(object.transform.scale, t + "/scale", 3);
    calls.push_back(scale.end(");"));
    calls.push_back(plain("draw_mesh();"));
    calls.push_back(plain("glPopMatrix();"));
    return group;
}

}  // namespace

std::vector<GlCallGroup> gl_calls(const Scene& scene) {
    std::vector<GlCallGroup> groups{places(scene)};
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].enabled) groups.push_back(light_group(scene, i));
    groups.push_back(shading_group(scene));
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (scene.objects[i].visible) groups.push_back(object_group(scene, i));
    return groups;
}

std::string call_text(const GlCall& call) {
    std::string text;
    for (const CallPiece& piece : call.pieces) text += piece.text;
    return text;
}

}  // namespace glint
