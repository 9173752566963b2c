#include "renderer/shade/light_mistakes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "renderer/geometry/not_too_far.h"
#include "renderer/lighting/light_source.h"
#include "renderer/shade/light_sources.h"

namespace glint {
namespace {

LightJob::Projection projection_of(const glm::dmat4& m) {  // m[column][row]
    const auto f = [&m](int row, int column) {             // products with places have to fit a float
        return static_cast<float>(std::clamp(m[column][row], -max_distance, max_distance));
    };
    return {f(0, 0), f(0, 2), f(0, 3), f(1, 1), f(1, 2), f(1, 3), f(2, 2), f(2, 3), f(3, 2), f(3, 3)};
}

}  // namespace

void apply_source_mistakes(const Mistakes& wrong, const Light& light, LightSource& source) {
    if (wrong.falloff_without_constant && light.kind != LightKind::Directional) {
        source.constant = 0;
        source.has_falloff = true;
    }
    if (wrong.falloff_of_directional && light.kind == LightKind::Directional) {
        const float r = glm::length(glm::vec3(light.position));
        const Falloff& f = light.falloff;
        source.has_falloff = true;
        source.constant =
            falloff_polynomial(f.constant, f.linear, f.quadratic, r);  // the same wherever the point is
        source.linear = source.quadratic = 0;
    }
    if (!source.has_cone || !(wrong.degrees_for_radians || wrong.cutoff_as_full_angle)) return;
    const double angle = wrong.cutoff_as_full_angle ? light.spot.cutoff_deg / 2.0 : light.spot.cutoff_deg;
    source.cos_cutoff =
        static_cast<float>(wrong.degrees_for_radians ? std::cos(angle) : cos_of_cutoff(angle));
}

void apply_job_mistakes(const Scene& scene, PictureSize size, LightJob& job) {
    const Mistakes& wrong = scene.shading.mistakes;
    job.mistakes = wrong;
    job.power_table = scene.shading.power_table;
    job.any_mistake = wrong != Mistakes{} || job.power_table > 0;
    if (wrong.shininess_as_fraction) job.material.shininess /= 128;
    if (wrong.viewer_at_origin_of_world) {
        const glm::dvec3 origin = not_too_far(glm::dvec3(view_from_world(scene.camera)[3]));
        job.eye = {static_cast<float>(origin.x), static_cast<float>(origin.y), static_cast<float>(origin.z)};
    }
    if (wrong.lit_after_projection)
        job.projection = projection_of(clip_from_view(scene.camera.projection, size));
}

}  // namespace glint
