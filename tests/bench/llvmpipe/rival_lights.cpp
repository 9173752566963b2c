#include "tests/bench/llvmpipe/rival_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

namespace glint::bench {
namespace {

constexpr std::array<LightKind, 3> order{LightKind::Point, LightKind::Directional, LightKind::Spot};

ShaderLight shader_light(const Light& light, const Material& material, const glm::mat4& to_camera) {
    ShaderLight s{};
    s.place = to_camera * light.position;
    if (light.kind == LightKind::Directional) s.place = glm::vec4(glm::normalize(glm::vec3(s.place)), 0);
    s.falloff = {light.falloff.constant, light.falloff.linear, light.falloff.quadratic, 0};
    s.axis = glm::vec4(glm::normalize(glm::mat3(to_camera) * light.spot.direction),
                       std::cos(glm::radians(light.spot.cutoff_deg)));
    s.diffuse = glm::vec4(light.intensity * light.diffuse * material.diffuse, light.spot.exponent);
    s.specular = glm::vec4(light.intensity * light.specular * material.specular, material.shininess);
    return s;
}

}  // namespace

std::string light_counts(const Scene& scene) {
    std::array<int, 3> count{};
    for (const Light& light : scene.lights) {
        const auto found = std::find(order.begin(), order.end(), light.kind);
        if (found == order.end() || !light.enabled || light.ambient != glm::vec3(0))
            throw std::runtime_error(
                "the rival only draws enabled point, directional and spot lights without an "
                "ambient term");
        ++count[static_cast<std::size_t>(found - order.begin())];
    }
    return "#define POINTS " + std::to_string(count[0]) + "\n#define SUNS " + std::to_string(count[1]) +
           "\n#define SPOTS " + std::to_string(count[2]) + "\n";
}

void fill_lights(std::vector<glm::vec4>& block, const Scene& scene, const glm::mat4& view) {
    const Material& material = scene.objects.front().material;
    block.clear();
    for (const LightKind kind : order)
        for (const Light& light : scene.lights) {
            if (light.kind != kind) continue;
            const glm::mat4 to_camera = light.space == LightSpace::World ? view : glm::mat4(1);
            const ShaderLight s = shader_light(light, material, to_camera);
            block.insert(block.end(), {s.place, s.falloff, s.axis, s.diffuse, s.specular});
        }
    block.emplace_back(material.emission + material.ambient * scene.global_ambient, 0);
}

}  // namespace glint::bench
