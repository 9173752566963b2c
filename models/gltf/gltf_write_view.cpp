#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

#include "models/gltf/gltf_buffer.h"
#include "models/gltf/gltf_items.h"
#include "models/problem.h"
#include "models/range.h"

namespace glint {
namespace {

/// The rotation that turns (0, 0, 1) into the unit vector `to`.
glm::dquat turn_from_z(const glm::dvec3& to) {
    if (to.z < -1 + 1e-12) return {0, 1, 0, 0};  // half a turn about x
    return glm::normalize(glm::dquat(1 + to.z, -to.y, to.x, 0));
}

Json planes_json(const Projection& projection) {
    return {{"znear", number_json(near_of(projection))}, {"zfar", number_json(far_of(projection))}};
}

/// The vertical angle in radians, clamped so that it stays above 0 and below pi as a float.
double yfov_of(const Projection& projection, GltfUnsaid& unsaid) {
    double angle = 0;
    if (const auto* f = std::get_if<Frustum>(&projection)) {
        const double height = std::abs(static_cast<double>(f->top) - static_cast<double>(f->bottom));
        angle = 2 * std::atan(height / (2 * static_cast<double>(f->near)));
        unsaid.frustum = true;
        unsaid.mirroring = f->left > f->right || f->bottom > f->top;
    } else {
        angle = glm::radians(static_cast<double>(std::get<Perspective>(projection).fov_y_deg));
    }
    constexpr double least = std::numeric_limits<float>::denorm_min();
    const double most = std::nextafter(std::numbers::pi_v<float>, 0.0f);
    unsaid.angle = angle < least || angle > most;
    return std::clamp(angle, least, most);
}

/// The divisor of a light's colour and the factor of its intensity: colours in glTF are at most 1.
float color_scale(const Light& light) {
    return std::max({light.diffuse.x, light.diffuse.y, light.diffuse.z, 1.0f});
}

/// The intensity that makes a glTF light as bright as this light at the camera's target. A glTF light falls
/// off with the square of the distance.
double intensity_of(const Light& light, const Camera& camera, GltfUnsaid& unsaid) {
    const double i =
        static_cast<double>(light.intensity) * static_cast<double>(color_scale(light)) * std::numbers::pi;
    if (light.kind == LightKind::Directional) return i;
    const auto& f = light.falloff;
    if (f.constant == 0 && f.linear == 0) return i / static_cast<double>(f.quadratic);
    ++unsaid.falloffs;
    const glm::dvec4 place(light.position);
    const glm::dvec3 in_world(light.space == LightSpace::World ? place : world_from_view(camera) * place);
    const double r = std::max(glm::distance(in_world, glm::dvec3(camera.target)), 1e-3);
    return i * r * r /
           (static_cast<double>(f.constant) +
            r * (static_cast<double>(f.linear) + r * static_cast<double>(f.quadratic)));
}

}  // namespace

Json camera_json(const Projection& projection, GltfUnsaid& unsaid) {
    Json lens = planes_json(projection);
    const auto* o = std::get_if<Orthographic>(&projection);
    if (o == nullptr) {
        lens["yfov"] = yfov_of(projection, unsaid);
        return {{"type", "perspective"}, {"perspective", lens}};
    }
    const float half = std::max(o->height / 2, std::numeric_limits<float>::denorm_min());
    lens["xmag"] = number_json(half * 16 / 9);
    lens["ymag"] = number_json(half);
    return {{"type", "orthographic"}, {"orthographic", lens}};
}

Json camera_matrix(const Camera& camera) {
    const glm::dmat4 m = world_from_view(camera);
    Json matrix = Json::array();
    for (int i = 0; i < 12; ++i) matrix.push_back(m[i / 4][i % 4]);
    for (int i = 0; i < 3; ++i) matrix.push_back(number_json(camera.eye[i]));
    matrix.push_back(1);
    return matrix;
}

Json light_json(const Light& light, const Camera& camera, const std::string& pointer, GltfUnsaid& unsaid) {
    // Without a cone a spot shines everywhere, as a point light does.
    const bool is_spot = light.kind == LightKind::Spot && light.spot.cutoff_deg < 180;
    const double intensity = intensity_of(light, camera, unsaid);
    if (!at_least_zero.contains(intensity))
        throw ProblemFound({"", pointer, fmt::format("in glTF's units its intensity is {:.3g}", intensity),
                            "at most 1e7: a light that is dimmer, or nearer to the camera's target"});
    Json out{{"name", light.name},
             {"type", light.kind == LightKind::Directional ? "directional"
                      : is_spot                            ? "spot"
                                                           : "point"},
             {"color", numbers_json(light.diffuse / color_scale(light))},
             {"intensity", intensity}};
    if (is_spot) {
        const GltfCone cone = cone_of(light.spot);
        out["spot"] = {{"innerConeAngle", cone.inner}, {"outerConeAngle", cone.outer}};
        unsaid.cones += light.spot.exponent > 0 ? 1 : 0;
    }
    unsaid.ambients += light.ambient != glm::vec3(0) ? 1 : 0;
    unsaid.speculars += light.specular != light.diffuse ? 1 : 0;
    return out;
}

Json light_node(const Light& light, std::size_t index) {
    const bool is_sun = light.kind == LightKind::Directional;
    const glm::dvec3 back =
        glm::normalize(glm::dvec3(is_sun ? glm::vec3(light.position) : -light.spot.direction));
    const glm::dquat q = turn_from_z(back);
    Json node{{"name", light.name},
              {"rotation", {q.x, q.y, q.z, q.w}},
              {"extensions", {{"KHR_lights_punctual", {{"light", index}}}}}};
    if (!is_sun) node["translation"] = numbers_json(glm::vec3(light.position));
    return node;
}

}  // namespace glint
