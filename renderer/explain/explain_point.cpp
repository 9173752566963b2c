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
    if (sample.reached > 0) joined.falloff += sample.falloff;
    if (joined.blocker < 0) {
        joined.blocker = sample.blocker;
        joined.blocked_by = sample.blocked_by;
    }
    joined.ambient += sample.ambient;
    joined.diffuse += sample.diffuse;
    joined.specular += sample.specular;
}

/// The share of an area light's samples in front of the surface that reach it; 1 if no sample is in front.
float reached_share(const std::vector<ExplainedLight>& samples) {
    float in_front = 0, reached = 0;
    for (const ExplainedLight& s : samples) {
        in_front += s.n_dot_l > 0 ? 1.0f : 0.0f;
        reached += s.n_dot_l > 0 ? s.reached : 0;
    }
    return in_front > 0 ? reached / in_front : 1;
}

/// Explains only whether light source `i` reaches the point, and which surface blocks it.
ExplainedLight explain_way(const PointArrivals& arrivals, std::size_t i) {
    ExplainedLight e;
    if (arrivals.transport == nullptr) return e;
    const PointTransport& t = *arrivals.transport;
    const LightSource& source = t.inputs.lights[i];
    if (reaches(t.points.rays, t.inputs, source, arrivals.point)) return e;
    e.reached = 0;
    e.blocker = traced_light(t.points.rays, source, arrivals.point).object;
    if (e.blocker >= 0) e.blocked_by = t.scene.objects[static_cast<std::size_t>(e.blocker)].name;
    return e;
}

ExplainedBounces explain_bounces(const LightJob& job, const PointArrivals& arrivals) {
    if (!job.bounced || !arrivals.transport || job.tone.on) return {};
    const PointTransport& t = *arrivals.transport;
    const BouncedLight light = bounced_light(t.points.rays, t.inputs, arrivals.point);
    const Vec term = broadcast<float>(job.material.k_d) * to_vec(light.mean);
    return {true, light.mean, light.standard_error, light.paths,
            job.terms.ambient ? to_glm(term) : glm::vec3(0)};
}

ExplainedTone explain_tone(const LightJob& job, const PointAt<float>& at) {
    const CoolToWarmTerms<float> t = cool_to_warm(job.tone, broadcast<float>(job.material.k_d), at);
    return {true, t.n_dot_l, t.k_w, to_glm(t.cool), to_glm(t.warm), to_glm(t.color)};
}

}  // namespace

ExplainedPoint explain_point(const Lighting& lighting, const LightJob& job, const PositionNormal& place,
                             const Frames& frames, bool lit, const PointArrivals& arrivals) {
    const PointAt<float> at = seen_from_eye(job, to_vec(place.p), to_vec(place.n));
    ExplainedPoint e;
    e.point = frames.position(at.p);
    e.normal = frames.direction(at.n);
    e.view = frames.direction(at.v);
    if (!lit) return e;
    if (job.terms.emission) e.emission = to_glm(broadcast<float>(job.material.emission));
    e.bounces = explain_bounces(job, arrivals);
    const Vec bounced = to_vec(e.bounces.arrives);
    if (job.terms.ambient && !e.bounces.used)
        e.global_ambient = to_glm(broadcast<float>(job.material.global_ambient));
    if (job.tone.on) e.cool_to_warm = explain_tone(job, at);
    e.base = to_glm(begin_sum(job, at, bounced));
    ExplainedLight way;  // surfaces between the point and the light that `visit` receives next
    const auto reached = [&](std::size_t i) {
        way = explain_way(arrivals, i);
        return way.reached;
    };
    const auto visit = [&](std::size_t i, const LightTerms<float>& t, const Vec& share) {
        const LightSource& source = job.lights[i];
        ExplainedLight light = explain_light(t, source, frames);
        light.share = to_glm(share);
        light.reached = way.reached;
        light.blocker = way.blocker;
        light.blocked_by = way.blocked_by;
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
    };
    e.sum = to_glm(shade_point(job, at, bounced, reached, visit));
    for (ExplainedLight& light : e.lights)
        if (!light.samples.empty()) light.reached = reached_share(light.samples);
    return e;
}

}  // namespace glint
