#include "renderer/explain/explain.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "models/fields/choices.h"
#include "renderer/geometry/clip.h"
#include "renderer/geometry/interpolate.h"
#include "renderer/lighting/display.h"
#include "renderer/lighting/illuminate.h"
#include "renderer/shade/light_sources.h"
#include "renderer/shade/lighting.h"
#include "renderer/simd/glm_vec3.h"
#include "renderer/strokes/strokes.h"

namespace glint {
namespace {

using Vec = Vec3<float>;

/// The stages that an explanation reads: the picture's stages, or substitutes for some of them.
struct ExplainedStages {
    const Scene& scene;
    const Geometry& geometry;
    const Visibility& visibility;
    SurfaceInputs surface;
    const Strokes& strokes;
    const Lighting& lighting;
    const PointTransport* transport;  // null for the local model
};

/// The lit points whose colours are blended for a pixel of `face`, with their weights according to
/// surface.choice.
std::vector<ExplainedCorner> lit_corners(const ExplainedStages& stages, const SurfaceInputs& surface,
                                         const SampleFace& face, const LightJob& job, const Frames& frames) {
    const BlendedPoints sample = blended_points(surface, stages.geometry, face);
    const bool lit = stages.lighting.shading.reflection != Reflection::None;
    std::vector<ExplainedCorner> corners(static_cast<std::size_t>(sample.count));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i].weight = sample.weight[i];
        const PositionNormal place = lit_point(surface, stages.geometry, sample.point[i]);
        PointArrivals arrivals{stages.transport};
        if (stages.transport)
            arrivals.point = stages.transport->points.item(surface.choice, sample.point[i], place);
        corners[i].at = explain_point(stages.lighting, job, place, frames, lit, arrivals);
        if (!lit) corners[i].at.sum = vertex_color(surface, stages.geometry, sample.point[i]);
    }
    return corners;
}

glm::vec3 blended(const std::vector<ExplainedCorner>& corners) {
    Vec sum;
    for (const ExplainedCorner& corner : corners)
        sum = add_weighted(sum, corner.weight, to_vec(corner.at.sum));
    return to_glm(sum);
}

void explain_corners(Explanation& e, const ExplainedStages& stages, const SampleFace& face,
                     const LightJob& job, const Frames& frames) {
    SurfaceChoice choice = stages.surface.choice;
    e.corners = lit_corners(stages, stages.surface, face, job, frames);
    e.lit_per_corner = true;
    e.interpolation = choice.interpolation;
    if (choice.kind == SurfaceKind::Faces) {
        if (!e.corners.empty()) e.sum = e.corners.back().at.sum;
        return;
    }
    e.sum = blended(e.corners);
    for (const Interpolation each : enumerators<Interpolation>) {
        choice.interpolation = each;
        const SurfaceInputs surface(choice, stages.surface.normals);
        e.interpolations.push_back({each, blended(lit_corners(stages, surface, face, job, frames))});
    }
}

void explain_stroke(Explanation& e, const ExplainedStages& stages, std::size_t pixel) {
    e.stroke.coverage = stages.strokes.coverage_at(pixel);
    e.stroke.color = stages.lighting.npr.stroke;
    e.stroke.shaded = e.sum;
    if (e.stroke.coverage > 0)
        e.sum = to_glm(drawn_over(to_vec(e.sum), e.stroke.coverage, to_vec(e.stroke.color)));
}

/// The point in every coordinate system from the mesh to the screen.
ExplainedSpaces explain_spaces(const Geometry& g, const SampleFace& face) {
    const glm::dvec4 camera(glm::dvec3(face.p), 1);
    const glm::dvec4 clip = g.clip_from_view * camera;
    ExplainedSpaces s;
    s.object = glm::vec3(glm::inverse(g.objects[face.object].view_from_object) * camera);
    s.world = glm::vec3(world_from_view(g.camera) * camera);
    s.camera = face.p;
    s.clip = glm::vec4(clip);
    s.ndc = glm::vec3(clip / clip.w);
    s.pixel = glm::vec2(to_pixel(viewport_of(g.camera, g.size), clip));
    return s;
}

/// Fills in the steps from the shaded sum to the displayed colour.
void explain_display(Explanation& e, const ExplainedStages& stages, std::size_t pixel) {
    explain_stroke(e, stages, pixel);
    const DisplayJob job = display_job(stages.lighting.display, stages.lighting.shading.mistakes);
    for (int i = 0; i < 3; ++i) {
        const bool wrong = job.any_mistake();
        e.displayed[i] = wrong ? mistakenly_displayed(job, e.sum[i]) : displayed(job, e.sum[i]);
        e.byte[static_cast<std::size_t>(i)] =
            wrong ? wrapped_byte_of(e.displayed[i]) : byte_of(e.displayed[i]);
    }
}

/// The data that lighting would cache for `scene`, without lighting any point.
Lighting lighting_of(const Scene& scene, const KeptStages& kept, bool at_corners) {
    Lighting l;
    l.sources = light_sources(scene);
    l.lights = scene.lights;
    l.shading = scene.shading;
    l.npr = scene.npr;
    l.display = scene.display;
    l.picture.size = kept.geometry.size;
    for (const Object& object : scene.objects) {
        l.materials.push_back(object.material);
        l.jobs.push_back(light_job(scene, kept.geometry.size, object.material, l.sources, at_corners));
    }
    return l;
}

Explanation explain_stages(const ExplainedStages& stages, int x, int y) {
    const Geometry& g = stages.geometry;
    const Shading& shading = stages.lighting.shading;
    Explanation e;
    e.x = x;
    e.y = y;
    e.mode = shading.mode;
    e.reflection = shading.reflection;
    const std::size_t pixel = stages.lighting.picture.pixel(x, y);
    const std::uint32_t triangle = stages.visibility.triangle_at(pixel);
    if (triangle == no_triangle) {
        e.sum = stages.lighting.display.background;
        explain_display(e, stages, pixel);
        return e;
    }
    const SampleFace face = sample_face(stages.surface.choice, g, stages.visibility, x, y);
    const Triangle& t = g.triangle(face.object, triangle);
    const std::vector<Triangle>& all = g.objects[face.object].mesh->triangles;
    const auto first_of_face = std::lower_bound(
        all.begin(), all.end(), t.face, [](const Triangle& a, std::uint32_t f) { return a.face < f; });
    e.hit = true;
    e.object_index = static_cast<int>(face.object);
    e.object = stages.scene.objects[face.object].name;
    e.material = mistaken_material(shading.mistakes, stages.lighting.materials[face.object]);
    e.reflection = reflection_of(e.material, shading.reflection);
    e.face = t.face;
    e.triangle = static_cast<std::uint32_t>(&t - &*first_of_face);
    e.front_facing = !stages.visibility.back_at(pixel);
    e.corner = g.position_indices(face.object, t);
    e.weights = face.weights;
    e.spaces = explain_spaces(g, face);
    const LightJob& job = stages.lighting.jobs[face.object];
    const Frames frames(stages.scene.camera);
    const PositionNormal place = pixel_point(stages.surface, g, face);
    const bool lit_here = stages.surface.choice.kind == SurfaceKind::Pixels;
    PointArrivals arrivals{stages.transport};
    if (stages.transport && lit_here)
        arrivals.point = stages.transport->points.pixel(stages.surface, face, pixel, place);
    e.at = explain_point(stages.lighting, job, place, frames, lit_here, arrivals);
    e.sum = e.at.sum;
    if (!lit_here) explain_corners(e, stages, face, job, frames);
    explain_display(e, stages, pixel);
    return e;
}

}  // namespace

Explanation explain_pixel(const KeptStages& kept, int x, int y) {
    const TransportStage& t = kept.transport;
    const PointTransport transport{
        {t.rays, kept.geometry, world_from_view(kept.scene.camera)}, t.inputs, kept.scene};
    return explain_stages({kept.scene, kept.geometry, kept.visibility, kept.surface, kept.strokes,
                           kept.lighting, t.any_shadow ? &transport : nullptr},
                          x, y);
}

Explanation explain_pixel_as(KeptStages& kept, const Scene& other, int x, int y) {
    const SurfaceChoice choice = surface_choice(other.shading);
    const bool same =
        choice.mistakes == kept.surface.choice.mistakes && same_normals(kept.surface.normals, other);
    std::vector<ObjectNormals> normals;
    if (!same) update_normals(normals, other, kept.geometry, choice.mistakes);
    const bool transported = has_transport(other);
    TransportInputs inputs;
    if (transported) inputs = transport_inputs(other);
    if (transported) kept.transport.rays.update(other);
    const PointTransport transport{
        {kept.transport.rays, kept.geometry, world_from_view(other.camera)}, inputs, other};
    const Lighting lighting = lighting_of(other, kept, choice.kind != SurfaceKind::Pixels);
    return explain_stages({other,
                           kept.geometry,
                           kept.visibility,
                           {choice, same ? kept.surface.normals : normals},
                           kept.strokes,
                           lighting,
                           transported ? &transport : nullptr},
                          x, y);
}

// The lighting equation at one point with all intermediate numbers, by the picture's own functions on one
// lane.

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

/// Groups the samples of an area light under one entry with their sums and the light's name.
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

/// The fraction of an area light's samples in front of the surface that reach it; 1 if no sample is in front.
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

// Individual rays and paths of the picture's lit points.

namespace {

/// The lit point of a pixel, or nullopt for background. `corner` as in Renderer::shadow_rays().
std::optional<TracedPoint> drawn_point(const KeptStages& stages, int x, int y, int corner) {
    const std::size_t pixel = stages.lighting.picture.pixel(x, y);
    if (stages.visibility.triangle_at(pixel) == no_triangle) return std::nullopt;
    const LitPointFinder finder{stages.transport.rays, stages.geometry, world_from_view(stages.scene.camera)};
    const SurfaceChoice& choice = stages.surface.choice;
    const SampleFace face = sample_face(choice, stages.geometry, stages.visibility, x, y);
    if (choice.kind == SurfaceKind::Pixels)
        return finder.pixel(stages.surface, face, pixel, pixel_point(stages.surface, stages.geometry, face));
    const BlendedPoints points = blended_points(stages.surface, stages.geometry, face);
    const auto begin = points.weight.begin();
    const auto heaviest = std::max_element(begin, begin + points.count) - begin;
    const bool is_corner = corner >= 0 && corner < points.count;
    const ShadingPoint& source = points.point[static_cast<std::size_t>(is_corner ? corner : heaviest)];
    return finder.item(choice, source, lit_point(stages.surface, stages.geometry, source));
}

}  // namespace

std::vector<TracedLight> trace_lights(KeptStages& stages, int x, int y, int corner) {
    stages.transport.rays.update(stages.scene);
    const std::optional<TracedPoint> point = drawn_point(stages, x, y, corner);
    if (!point) return {};
    const TransportInputs inputs = transport_inputs(stages.scene);
    std::vector<TracedLight> rays;
    for (std::size_t i = 0; i + 1 < inputs.begins.size(); ++i) {
        const std::uint32_t middle = (inputs.begins[i] + inputs.begins[i + 1]) / 2;
        rays.push_back(traced_light(stages.transport.rays, inputs.lights[middle], *point));
    }
    return rays;
}

std::vector<PathStep> trace_path(KeptStages& stages, int x, int y, int path, int corner) {
    stages.transport.rays.update(stages.scene);
    std::vector<PathStep> steps;
    if (const std::optional<TracedPoint> point = drawn_point(stages, x, y, corner))
        (void)radiance_of_path(stages.transport.rays, transport_inputs(stages.scene), *point, path, &steps);
    return steps;
}

}  // namespace glint
