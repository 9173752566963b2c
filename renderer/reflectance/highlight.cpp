#include "renderer/reflectance/highlight.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <optional>

#include "models/scene/reflection.h"
#include "renderer/lighting/illuminate.h"
#include "renderer/reflectance/lobes.h"
#include "renderer/shade/light_sources.h"
#include "renderer/simd/glm_vec3.h"

namespace glint {
namespace {

using Vec = Vec3<float>;

Material mirror_like(Material material) {
    material.specular = glm::vec3(1);
    return material;
}
Material mirror_like(const Scene& scene, int object) {
    return mirror_like(scene.objects[static_cast<std::size_t>(object)].material);
}

/// The sum of the highlight over all samples and channels.
double highlight_of(const LightAlone& lit, const SeenPoint& point) {
    const PointAt<float> at = lit.seen(point.position, point.normal);
    double sum = 0;
    for (const LightSource& source : lit.sources()) {
        const Vec term = lit.terms(source, at).specular;
        sum += static_cast<double>(term.x) + static_cast<double>(term.y) + static_cast<double>(term.z);
    }
    return sum;
}

}  // namespace

std::vector<double> highlight_at(const Scene& scene, PictureSize size, const Light& light,
                                 std::span<const SeenPoint> points) {
    std::vector<double> highlights;
    highlights.reserve(points.size());
    std::optional<LightAlone> lit;  // for the previous point's object
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!lit || points[i].object != points[i - 1].object)
            lit.emplace(scene, size, light, mirror_like(scene, points[i].object));
        highlights.push_back(highlight_of(*lit, points[i]));
    }
    return highlights;
}

std::vector<double> highlight_at(const Scene& scene, PictureSize size, const Light& light,
                                 std::span<const SeenPoint> points, const Material& material) {
    const LightAlone lit(scene, size, light, mirror_like(material));
    std::vector<double> highlights;
    highlights.reserve(points.size());
    for (const SeenPoint& point : points) highlights.push_back(highlight_of(lit, point));
    return highlights;
}

double cosine_at(const Scene& scene, PictureSize size, const Light& light, const SeenPoint& point) {
    const LightAlone lit(scene, size, light, mirror_like(scene, point.object));
    return static_cast<double>(lit.middle(lit.seen(point.position, point.normal)).directions.n_dot_l);
}

glm::vec3 peak_direction(const Scene& scene, PictureSize size, const SeenPoint& point) {
    const LightAlone any(scene, size, {}, mirror_like(scene, point.object));
    const PointAt<float> at = any.seen(point.position, point.normal);
    if (!(dot(at.n, at.v) > 0)) return glm::vec3(0);
    const Material& material = scene.objects[static_cast<std::size_t>(point.object)].material;
    const Reflection model = reflection_of(material, scene.shading.reflection);
    const bool back = info_of(model).peak == HighlightPeak::Light;
    return to_glm(back ? at.v : directions_for(at.v, at).r);
}

namespace {

constexpr double most = 10'000;  // the maximum shininess of a scene

double misfit(Reflection reflection, double shininess, std::span<const glm::dvec2> points) {
    double sum = 0;
    for (const glm::dvec2 p : points) {
        const double away = highlight_at(reflection, static_cast<float>(shininess), p.x) - p.y;
        sum += away * away;
    }
    return sum;
}

}  // namespace

double half_angle_deg(double n) { return n > 0 ? glm::degrees(std::acos(std::exp2(-1 / n))) : 90; }

std::vector<glm::dvec2> highlight_shape(HighlightShape shape, double n, int steps) {
    const double half = half_angle_deg(n);
    std::vector<glm::dvec2> curve;
    for (int i = 0; i <= steps; ++i) {
        const double deg = 90.0 * i / steps, share = deg / half;
        curve.emplace_back(deg, shape == HighlightShape::Gaussian ? std::exp2(-share * share)
                                                                  : std::max(1 - share / 2, 0.0));
    }
    return curve;
}

std::optional<HighlightFit> fitted_highlight(Reflection reflection, std::span<const glm::dvec2> points) {
    if (points.size() < 2) return {};
    // The error for points drawn by hand may have several minima. First searches the entire range in steps of
    // a tenth of a decade, then refines the interval around the best step by ternary search.
    const auto step = [](int i) { return i < 0 ? 0 : std::min(std::pow(10, -1 + 0.1 * i), most); };
    constexpr int last = 50;
    int best = -1;
    double least = misfit(reflection, 0, points);
    for (int i = 0; i <= last; ++i) {
        const double here = misfit(reflection, step(i), points);
        if (here >= least) continue;
        least = here;
        best = i;
    }
    double low = step(best - 1), high = step(std::min(best + 1, last));
    for (int i = 0; i < 60; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (misfit(reflection, a, points) < misfit(reflection, b, points))
            high = b;
        else
            low = a;
    }
    const double shininess = (low + high) / 2;
    return HighlightFit{
        shininess, std::sqrt(misfit(reflection, shininess, points) / static_cast<double>(points.size()))};
}

double blinn_shininess_like(float shininess) {
    std::vector<glm::dvec2> phong;
    for (int deg = 0; deg <= 90; ++deg)
        phong.emplace_back(deg, highlight_at(Reflection::Phong, shininess, deg));
    return fitted_highlight(Reflection::BlinnPhong, phong)->shininess;
}

MirrorSteps mirror_steps(glm::vec3 n, glm::vec3 l) {
    const PointAt<float> at{{}, to_vec(n), {}};
    const Directions<float> d = directions_for(to_vec(l), at);
    MirrorSteps steps;
    steps.n_dot_l = d.n_dot_l;
    steps.r = to_glm(d.r);
    steps.twice_p = steps.r + l;  // computed from r, so that the formula is written only once
    steps.p = 0.5f * steps.twice_p;
    return steps;
}

namespace {

/// The light in the form that the equation uses, as if it were enabled. Returns nullopt for an area light,
/// which has many samples.
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
