#include "renderer/inspect/reflectance/highlight.h"

#include "models/fields/reflection_info.h"
#include "renderer/inspect/light_alone.h"
#include "renderer/lighting/shade_point.h"
#include "renderer/shade/light_sources.h"
#include "renderer/simd/glm_vec3.h"

namespace glint {
namespace {

using Vec = Vec3<float>;

Material mirror_like(const Scene& scene, const SeenPoint& point) {
    Material material = scene.objects[static_cast<std::size_t>(point.object)].material;
    material.specular = glm::vec3(1);
    return material;
}

/// What of a scene the highlight of one light depends on, the objects aside.
Scene with_light_alone(const Scene& scene, const Light& light) {
    Scene s = alone(scene, white(light));
    s.shading.terms.specular = true;
    return s;
}

}  // namespace

std::vector<double> highlight_at(const Scene& scene, PictureSize size, const Light& light,
                                 std::span<const SeenPoint> points) {
    const Scene lit = with_light_alone(scene, light);
    const std::vector<LightSource> sources = light_sources(lit);
    std::vector<double> highlights;
    highlights.reserve(points.size());
    for (const SeenPoint& point : points) {
        const LightJob job = light_job(lit, size, mirror_like(scene, point), sources, false);
        const MaterialAt<float> material = material_at<float>(job.material);
        const PointAt<float> at = seen_from_eye(job, to_vec(point.place), to_vec(point.normal));
        double sum = 0;
        for (const LightSource& source : sources) {
            const Vec term = illuminate(equation_of(job), light_at<float>(source), material, at).specular;
            sum += static_cast<double>(term.x) + static_cast<double>(term.y) + static_cast<double>(term.z);
        }
        highlights.push_back(sum);
    }
    return highlights;
}

double cosine_at(const Scene& scene, PictureSize size, const Light& light, const SeenPoint& point) {
    const Scene lit = with_light_alone(scene, light);
    const std::vector<LightSource> sources = light_sources(lit);
    if (sources.empty()) return 0;
    const LightJob job = light_job(lit, size, mirror_like(scene, point), sources, false);
    const PointAt<float> at = seen_from_eye(job, to_vec(point.place), to_vec(point.normal));
    const LightSource& middle = sources[sources.size() / 2];
    const auto terms =
        illuminate(equation_of(job), light_at<float>(middle), material_at<float>(job.material), at);
    return static_cast<double>(terms.directions.n_dot_l);
}

glm::vec3 peak_direction(const Scene& scene, PictureSize size, const SeenPoint& point) {
    const LightJob job = light_job(with_light_alone(scene, {}), size, mirror_like(scene, point), {}, false);
    const PointAt<float> at = seen_from_eye(job, to_vec(point.place), to_vec(point.normal));
    if (!(dot(at.n, at.v) > 0)) return glm::vec3(0);
    const bool back = info_of(scene.shading.reflection).peak == HighlightPeak::Light;
    const Vec l = back ? at.v : directions_for(at.v, at).r;
    return {l.x, l.y, l.z};
}

}  // namespace glint
