#include "tests/oracle/left_out.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

namespace glint::oracle {
namespace {

// How much a cosine of unit vectors may differ between two float computations: several roundings of 2^-24 in
// positions and normals of a few units.
constexpr double cosine_rounding = 2e-6;
// h = (l + v)/|l + v| magnifies rounding by 1/|l + v|. The steepest highlight, (n.h)^128, amplifies an angle
// by 6.9, so a rounding of 1e-7 stays below the bound's 1.5e-5 for |l + v| of 0.05 or more.
constexpr double shortest_half = 0.05;

LeftOut left_out_by(const Scene& scene, const ExplainedLight& light, const ExplainedPoint& at) {
    const Reflection model = scene.shading.reflection;
    const bool shines = scene.shading.terms.specular && model != Reflection::Lambert &&
                        model != Reflection::OrenNayar && light.falloff * light.spot > 0;
    if (shines && std::abs(light.n_dot_l) < cosine_rounding) return LeftOut::GrazingLight;
    const bool by_half = model == Reflection::BlinnPhong || model == Reflection::CookTorrance;
    if (shines && by_half && light.n_dot_l > 0 &&
        glm::length(light.l.camera + at.view.camera) < shortest_half)
        return LeftOut::LightBehind;
    const double n_dot_v = glm::dot(at.normal.camera, at.view.camera);
    if (shines && model == Reflection::CookTorrance && std::abs(n_dot_v) < cosine_rounding)
        return LeftOut::GrazingView;
    const Light& source = scene.lights[static_cast<std::size_t>(light.index)];
    if (source.kind == LightKind::Spot && source.spot.cutoff_deg <= 90) {
        const double edge = std::cos(glm::radians(double{source.spot.cutoff_deg}));
        if (std::abs(std::cos(glm::radians(double{light.spot_angle_deg})) - edge) < cosine_rounding)
            return LeftOut::SpotEdge;
    }
    return LeftOut::None;
}

LeftOut left_out_by(const Scene& scene, const ExplainedPoint& at) {
    for (const ExplainedLight& light : at.lights) {
        if (light.samples.empty())
            if (const LeftOut rule = left_out_by(scene, light, at); rule != LeftOut::None) return rule;
        for (const ExplainedLight& sample : light.samples)
            if (const LeftOut rule = left_out_by(scene, sample, at); rule != LeftOut::None) return rule;
    }
    return LeftOut::None;
}

/// The effect of clipping on the pixel's triangle under screen-linear interpolation.
LeftOut cut_at(const Scene& scene, PictureSize size, const Explanation& e) {
    const Object& object = scene.objects[static_cast<std::size_t>(e.object_index)];
    const glm::dmat4 clip_from_object = clip_from_view(scene.camera.projection, size) *
                                        view_from_world(scene.camera) * world_from_object(object.transform);
    std::bitset<6> crossed;
    for (const std::uint32_t position : e.corner) {
        const glm::dvec4 c = clip_from_object * glm::dvec4(glm::dvec3(object.mesh->positions[position]), 1);
        for (int axis = 0; axis < 3; ++axis) {
            if (c[axis] < -c.w) crossed.set(static_cast<std::size_t>(axis));
            if (c[axis] > c.w) crossed.set(static_cast<std::size_t>(axis) + 3);
        }
    }
    if (crossed[2]) return LeftOut::CutByNear;
    return crossed.count() > 1 ? LeftOut::CutTwice : LeftOut::None;
}

}  // namespace

LeftOut left_out_at(const Scene& scene, PictureSize size, const Explanation& e) {
    const bool on_screen = scene.shading.interpolation == Interpolation::Screen &&
                           scene.shading.mode != ShadingMode::Flat &&
                           scene.shading.mode != ShadingMode::Facet;
    if (on_screen)
        if (const LeftOut cut = cut_at(scene, size, e); cut != LeftOut::None) return cut;
    return left_out_by_lighting(scene, e);
}

LeftOut left_out_by_lighting(const Scene& scene, const Explanation& e) {
    if (scene.shading.reflection == Reflection::None) return LeftOut::None;
    if (!e.lit_per_corner) return left_out_by(scene, e.at);
    for (const ExplainedCorner& corner : e.corners)
        if (const LeftOut rule = left_out_by(scene, corner.at); rule != LeftOut::None) return rule;
    return LeftOut::None;
}

}  // namespace glint::oracle
