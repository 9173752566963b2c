// Where the picked point lies on the plots.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "ui/plots/plots_tab.h"

namespace glint {
namespace {

double degrees_of(double cosine) { return glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))); }

const ExplainedPoint& heaviest(const Explanation& explanation) {
    if (!explanation.lit_per_corner || explanation.corners.empty()) return explanation.at;
    const auto lighter = [](const ExplainedCorner& a, const ExplainedCorner& b) {
        return a.weight < b.weight;
    };
    return std::max_element(explanation.corners.begin(), explanation.corners.end(), lighter)->at;
}

}  // namespace

PlotPoint plot_point(const std::optional<Explanation>& explanation, int light) {
    PlotPoint point;
    if (!explanation || !explanation->hit) return point;
    point.at = &heaviest(*explanation);
    point.material = &explanation->material;
    for (const ExplainedLight& each : point.at->lights)
        if (each.index == light)
            point.light = each.samples.empty() ? &each : &each.samples[each.samples.size() / 2];
    return point;
}

glm::dvec2 falloff_mark(const PlotPoint& point) { return {point.light->distance, point.light->falloff}; }

glm::dvec2 spot_mark(const PlotPoint& point) { return {point.light->spot_angle_deg, point.light->spot}; }

glm::dvec2 highlight_mark(const PlotPoint& point, Reflection reflection) {
    const double deg = reflection == Reflection::BlinnPhong ? 2 * degrees_of(double(point.light->n_dot_h))
                                                            : degrees_of(double(point.light->r_dot_v));
    return {deg, point.light->specular_factor.x};
}

LocalDirections local_directions(const PlotPoint& point) {
    LocalDirections local;
    if (point.light == nullptr) return local;
    const glm::dvec3 n = point.at->normal.camera, l = point.light->l.camera, v = point.at->view.camera;
    glm::dvec3 x = n * glm::dot(n, l) - l;
    if (glm::length(x) < 1e-6) x = v - n * glm::dot(n, v);  // light along n: any plane; that of v
    if (glm::length(x) < 1e-6)
        x = glm::cross(n, std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    x = glm::normalize(x);
    const glm::dvec3 y = glm::cross(n, x);
    local.l = glm::vec3(glm::dot(l, x), glm::dot(l, y), glm::dot(l, n));
    local.v = glm::vec3(glm::dot(v, x), glm::dot(v, y), glm::dot(v, n));
    local.light_deg = degrees_of(double(local.l.z));
    local.view_deg = degrees_of(double(local.v.z)) * (local.v.x < 0 ? -1 : 1);
    return local;
}

}  // namespace glint
