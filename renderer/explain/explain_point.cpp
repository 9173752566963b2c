// The lighting equation at one point with all intermediate numbers, by the picture's own functions on one
// lane.
#include "renderer/explain/explain_point.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "renderer/lighting/shade_point.h"
#include "renderer/simd/glm_vec3.h"

namespace glint {
namespace {

using Vec = Vec3<float>;

ExplainedLight explain_light(const LightTerms<float>& t, const LightSource& source, const Frames& frames) {
    ExplainedLight e;
    e.index = source.light;
    e.l = frames.direction(t.directions.l);
    e.r = frames.direction(t.directions.r);
    e.h = frames.direction(t.directions.h);
    e.n_dot_l = t.directions.n_dot_l;
    e.r_dot_v = t.directions.r_dot_v;
    e.n_dot_h = t.directions.n_dot_h;
    e.l_dot_v = t.directions.l_dot_v;
    e.distance = source.w > 0 ? t.distance : 0;
    e.falloff = t.falloff;
    e.spot = t.spot;
    if (source.has_cone) {
        const float cosine = along_axis(light_at<float>(source), t.directions.l);
        e.spot_angle_deg = glm::degrees(std::acos(std::clamp(cosine, -1.0f, 1.0f)));
    }
    e.diffuse_factor = t.response.diffuse;
    e.specular_factor = to_glm(t.response.specular);
    e.ambient = to_glm(t.ambient);
    e.diffuse = to_glm(t.diffuse);
    e.specular = to_glm(t.specular);
    return e;
}

ExplainedFacets explain_facets(const LightTerms<float>& t, const LightJob& job, const PointAt<float>& at) {
    const FacetTerms<float> f = facet_terms(t.directions, material_at<float>(job.material), at);
    return {f.d, f.g, at.n_dot_v, to_glm(f.f)};
}

/// Groups the samples of an area light under one entry with their sums and its name.
void join_samples(ExplainedLight& joined, const std::string& name, const ExplainedLight& sample) {
    if (joined.samples.empty()) {
        joined.name = name;
        joined.index = sample.index;
        joined.falloff = 0;
    }
    joined.samples.push_back(sample);
    joined.falloff += sample.falloff;
    joined.ambient += sample.ambient;
    joined.diffuse += sample.diffuse;
    joined.specular += sample.specular;
}

ExplainedTone explain_tone(const LightJob& job, const PointAt<float>& at) {
    const CoolToWarmTerms<float> t = cool_to_warm(job.tone, broadcast<float>(job.material.k_d), at);
    return {true, t.n_dot_l, t.k_w, to_glm(t.cool), to_glm(t.warm), to_glm(t.color)};
}

}  // namespace

ExplainedPoint explain_point(const Lighting& lighting, const LightJob& job, const PositionNormal& place,
                             const Frames& frames, bool lit) {
    const PointAt<float> at = seen_from_eye(job, to_vec(place.p), to_vec(place.n));
    ExplainedPoint e;
    e.point = frames.position(at.p);
    e.normal = frames.direction(at.n);
    e.view = frames.direction(at.v);
    if (!lit) return e;
    if (job.terms.emission) e.emission = to_glm(broadcast<float>(job.material.emission));
    if (job.terms.ambient) e.global_ambient = to_glm(broadcast<float>(job.material.global_ambient));
    if (job.tone.on) e.cool_to_warm = explain_tone(job, at);
    e.base = to_glm(begin_sum(job, at));
    e.sum = to_glm(shade_point(job, at, [&](std::size_t i, const LightTerms<float>& t, const Vec& share) {
        const LightSource& source = job.lights[i];
        ExplainedLight light = explain_light(t, source, frames);
        light.share = to_glm(share);
        if (job.model == Reflection::CookTorrance) light.facets = explain_facets(t, job, at);
        const std::string& name = lighting.lights[static_cast<std::size_t>(source.light)].name;
        if (!source.is_patch) {
            light.name = name;
            e.lights.push_back(std::move(light));
            return;
        }
        if (e.lights.empty() || e.lights.back().index != source.light || e.lights.back().samples.empty())
            e.lights.emplace_back();
        join_samples(e.lights.back(), name, light);
    }));
    return e;
}

}  // namespace glint
