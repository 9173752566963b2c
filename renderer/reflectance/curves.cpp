#include "renderer/reflectance/curves.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <optional>

#include "renderer/lighting/shade_point.h"
#include "renderer/reflectance/lobes.h"
#include "renderer/shade/light_sources.h"

namespace glint {
namespace {

/// The light in the equation's form, enabled. Returns nullopt for an area light, which has many samples.
std::optional<LightAt<float>> equation_light(const Scene& scene, int light) {
    const Light& asked = scene.lights[static_cast<std::size_t>(light)];
    if (asked.kind == LightKind::Area) return std::nullopt;
    return light_at<float>(light_sources(alone(scene, asked)).front());
}

}  // namespace

std::vector<glm::dvec2> falloff_curve(const Scene& scene, int light, double farthest, int steps) {
    std::vector<glm::dvec2> curve;
    const auto source = equation_light(scene, light);
    if (!source || !(source->w > 0)) return curve;
    for (int i = 0; i <= steps; ++i) {
        const double r = farthest * i / steps;
        curve.emplace_back(r, source->has_falloff ? double(falloff(*source, static_cast<float>(r))) : 1.0);
    }
    return curve;
}

std::vector<glm::dvec2> spot_curve(const Scene& scene, int light, int steps) {
    std::vector<glm::dvec2> curve;
    const auto source = equation_light(scene, light);
    if (!source || !source->has_cone) return curve;
    std::vector<double> angles;
    for (int i = 0; i <= steps; ++i) angles.push_back(-90 + 180.0 * i / steps);
    const double cutoff = glm::degrees(std::acos(double(source->cos_cutoff)));
    for (const double edge : {cutoff - 1e-3, cutoff + 1e-3})
        if (edge < 90) angles.insert(angles.end(), {-edge, edge});
    std::sort(angles.begin(), angles.end());
    const Vec3<float> side = any_perpendicular(source->axis);
    for (const double deg : angles) {
        const double angle = glm::radians(deg);
        const Vec3<float> ray =
            static_cast<float>(std::cos(angle)) * source->axis + static_cast<float>(std::sin(angle)) * side;
        curve.emplace_back(deg, double(spot_factor(*source, -1.0f * ray)));
    }
    return curve;
}

std::vector<glm::dvec2> highlight_curve(Reflection reflection, float shininess, int steps) {
    std::vector<glm::dvec2> curve;
    for (int i = 0; i <= steps; ++i) {
        const double deg = -90 + 180.0 * i / steps;
        curve.emplace_back(deg, highlight_at(reflection, shininess, deg));
    }
    return curve;
}

double highlight_at(Reflection reflection, float shininess, double view_deg) {
    Reflector reflector;
    reflector.reflection = reflection;
    reflector.material.specular = glm::vec3(1);
    reflector.material.shininess = shininess;
    return double(reflected(reflector, {0, 0, 1}, in_plane(view_deg)).specular.x);
}

}  // namespace glint
