#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "tests/gl/program.h"
#include "tests/oracle/gl_parts.h"

namespace glint::oracle {
namespace {

void change(std::string& text, const TextChange& change) {
    for (std::size_t at = text.find(change.from); at != text.npos; at = text.find(change.from, at)) {
        text.replace(at, change.from.size(), change.to);
        at += change.to.size();
    }
}

test::ShaderSource source(const std::string& name, const char* interpolated,
                          const std::vector<TextChange>& changes) {
    std::string text =
        test::shader_text("oracle/glsl/equation.glsl") + test::shader_text("oracle/glsl/" + name);
    for (const TextChange& c : changes) change(text, c);
    return {name,
            std::string("#version 450 compatibility\n#define INTERPOLATED ") + interpolated + "\n" + text};
}

/// Sets uniforms of the current program by name; skips those that the program does not use.
struct Uniforms {
    GLuint program;
    std::string prefix;

    [[nodiscard]] GLint at(const char* name) const {
        return glGetUniformLocation(program, (prefix + name).c_str());
    }
    void set(const char* name, const glm::vec3& v) const { glUniform3f(at(name), v.x, v.y, v.z); }
    void set(const char* name, float v) const { glUniform1f(at(name), v); }
    void set(const char* name, int v) const { glUniform1i(at(name), v); }
};

void set_light(const Uniforms& u, const Light& light, const glm::dmat4& to_camera) {
    const bool directional = light.kind == LightKind::Directional;
    const glm::dvec4 p = to_camera * glm::dvec4(light.position);
    const glm::dmat3 turn(to_camera);
    const double cutoff = glm::radians(static_cast<double>(light.spot.cutoff_deg));
    u.set("kind", static_cast<int>(light.kind));
    u.set("position", glm::vec3(directional ? glm::dvec3(p) : glm::dvec3(p) / p.w));
    u.set("ambient", light.intensity * light.ambient);
    u.set("diffuse", light.intensity * light.diffuse);
    u.set("specular", light.intensity * light.specular);
    u.set("falloff", glm::vec3(light.falloff.constant, light.falloff.linear, light.falloff.quadratic));
    u.set("axis", glm::vec3(glm::normalize(turn * glm::dvec3(light.spot.direction))));
    u.set("cos_cutoff", static_cast<float>(std::cos(cutoff)));
    u.set("exponent", light.spot.exponent);
    u.set("has_cone", light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90 ? 1 : 0);
    u.set("edge_u", glm::vec3(turn * glm::dvec3(light.area.edge_u)));
    u.set("edge_v", glm::vec3(turn * glm::dvec3(light.area.edge_v)));
    u.set("cells", static_cast<int>(std::lround(std::sqrt(light.area.samples))));
}

}  // namespace

unsigned make_program(const char* stage, const char* interpolated, const std::vector<TextChange>& changes) {
    const std::string name = stage;
    return test::link_program(source(name + ".vert.glsl", interpolated, changes),
                              source(name + ".frag.glsl", interpolated, changes));
}

void set_shader_lights(unsigned program, const Scene& scene, const glm::dmat4& view) {
    int count = 0;
    for (const Light& light : scene.lights) {
        if (!light.enabled) continue;
        const bool world = light.space == LightSpace::World;
        set_light({program, "lights[" + std::to_string(count++) + "]."}, light, world ? view : glm::dmat4(1));
    }
    const Uniforms u{program, ""};
    u.set("light_count", count);
    u.set("global_ambient", scene.global_ambient);
    u.set("local_viewer", scene.shading.local_viewer && !is_orthographic(scene.camera.projection));
    u.set("two_sided", scene.shading.two_sided);
    u.set("clamped", scene.shading.rules == Rules::OpenGL2);
}

void set_shader_material(unsigned program, const Scene& scene, const Material& given) {
    const Material m = seen_material(given, scene.shading);
    const Uniforms u{program, ""};
    u.set("model", static_cast<int>(reflection_of(given, scene.shading.reflection)));
    u.set("k_e", m.emission);
    u.set("k_a", m.ambient);
    u.set("k_d", m.diffuse);
    u.set("k_s", m.specular);
    u.set("f0", m.f0);
    u.set("roughness", m.roughness);
    u.set("cool_to_warm", scene.npr.cool_to_warm);
    u.set("cool", scene.npr.cool + scene.npr.alpha * given.diffuse);  // independent of the terms
    u.set("warm", scene.npr.warm + scene.npr.beta * given.diffuse);
    u.set("shininess", scene.shading.rules == Rules::OpenGL2 ? std::min(m.shininess, 128.0f) : m.shininess);
}

}  // namespace glint::oracle
