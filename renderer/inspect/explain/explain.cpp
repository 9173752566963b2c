#include "renderer/inspect/explain/explain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "renderer/geometry/clip.h"
#include "renderer/geometry/interpolate.h"
#include "renderer/lighting/display.h"
#include "renderer/lighting/shade_point.h"
#include "renderer/shade/light_sources.h"
#include "renderer/simd/glm_vec3.h"
#include "renderer/strokes/strokes.h"

namespace glint {
namespace {

using Vec = Vec3<float>;

/// What an explanation reads of the stages: those of the picture, or stand-ins for some of them.
struct ExplainedStages {
    const Scene& scene;
    const Geometry& geometry;
    const Visibility& visibility;
    SurfaceInputs surface;
    const Strokes& strokes;
    const Lighting& lighting;
};

/// Camera and world coordinates of the same vector or place.
class Frames {
  public:
    explicit Frames(const Camera& camera) : world_from_view_(world_from_view(camera)) {}
    [[nodiscard]] InBothFrames direction(Vec v) const { return both_frames(to_glm(v), 0); }
    [[nodiscard]] InBothFrames position(Vec v) const { return both_frames(to_glm(v), 1); }

  private:
    [[nodiscard]] InBothFrames both_frames(glm::vec3 v, double w) const {
        return {v, glm::vec3(world_from_view_ * glm::dvec4(glm::dvec3(v), w))};
    }
    glm::dmat4 world_from_view_;
};

ExplainedLight explain_light(const LightTerms<float>& t, const LightSource& source, const Frames& frames) {
    ExplainedLight e;
    e.index = source.light;
    e.l = frames.direction(t.directions.l);
    e.r = frames.direction(t.directions.r);
    e.h = frames.direction(t.directions.h);
    e.n_dot_l = t.directions.n_dot_l;
    e.r_dot_v = t.directions.r_dot_v;
    e.n_dot_h = t.directions.n_dot_h;
    e.distance = source.w > 0 ? t.distance * source.distance_scale : 0;
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

/// Puts the samples of an area light under one entry that holds their sums.
void join_samples(ExplainedLight& joined, const ExplainedLight& sample) {
    if (joined.samples.empty()) {
        joined.name = sample.name;
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

/// The equation at one point, step by step; the sum is added in the picture's own order.
ExplainedPoint explain_point(const ExplainedStages& stages, const LightJob& job, const PositionNormal& place,
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
        light.name = stages.lighting.lights[static_cast<std::size_t>(source.light)].name;
        if (!source.is_patch) {
            e.lights.push_back(light);
            return;
        }
        if (e.lights.empty() || e.lights.back().index != source.light || e.lights.back().samples.empty())
            e.lights.emplace_back();
        join_samples(e.lights.back(), light);
    }));
    return e;
}

void explain_corners(Explanation& e, const ExplainedStages& stages, const SampleFace& face,
                     const LightJob& job, const Frames& frames) {
    const SurfaceInputs& surface = stages.surface;
    const BlendedPoints sample = blended_points(surface, stages.geometry, face);
    const bool lit = stages.lighting.shading.reflection != Reflection::None;
    Vec sum;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sample.count); ++i) {
        ExplainedCorner corner;
        corner.weight = sample.weight[i];
        const PositionNormal place = lit_point(surface, stages.geometry, sample.point[i]);
        corner.at = explain_point(stages, job, place, frames, lit);
        if (!lit) corner.at.sum = vertex_color(surface, stages.geometry, sample.point[i]);
        sum = surface.choice.kind == SurfaceKind::Faces
                  ? to_vec(corner.at.sum)
                  : add_weighted(sum, corner.weight, to_vec(corner.at.sum));
        e.corners.push_back(corner);
    }
    e.lit_per_corner = true;
    e.sum = to_glm(sum);
}

void explain_stroke(Explanation& e, const ExplainedStages& stages, std::size_t pixel) {
    e.stroke.coverage = stages.strokes.coverage_at(pixel);
    e.stroke.color = stages.lighting.npr.stroke;
    e.stroke.shaded = e.sum;
    if (e.stroke.coverage > 0)
        e.sum = to_glm(drawn_over(to_vec(e.sum), e.stroke.coverage, to_vec(e.stroke.color)));
}

/// The point on its way from the mesh to the screen.
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

/// From the shaded sum to what is seen.
void explain_display(Explanation& e, const ExplainedStages& stages, std::size_t pixel) {
    explain_stroke(e, stages, pixel);
    const DisplayJob job = display_job(stages.lighting.display);
    for (int i = 0; i < 3; ++i) {
        e.displayed[i] = displayed(job, e.sum[i]);
        e.byte[static_cast<std::size_t>(i)] = byte_of(e.displayed[i]);
    }
}

/// What lighting would keep of `scene`, without lighting anything.
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
    e.material = stages.lighting.materials[face.object];
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
    e.at = explain_point(stages, job, place, frames, lit_here);
    e.sum = e.at.sum;
    if (!lit_here) explain_corners(e, stages, face, job, frames);
    explain_display(e, stages, pixel);
    return e;
}

}  // namespace

Explanation explain_pixel(const KeptStages& kept, int x, int y) {
    return explain_stages(
        {kept.scene, kept.geometry, kept.visibility, kept.surface, kept.strokes, kept.lighting}, x, y);
}

Explanation explain_pixel_as(const KeptStages& kept, const Scene& other, int x, int y) {
    const SurfaceChoice choice = surface_choice(other.shading);
    const bool same =
        choice.mistakes == kept.surface.choice.mistakes && same_normals(kept.surface.normals, other);
    std::vector<ObjectNormals> normals;
    if (!same) update_normals(normals, other, kept.geometry, choice.mistakes);
    const Lighting lighting = lighting_of(other, kept, choice.kind != SurfaceKind::Pixels);
    return explain_stages({other,
                           kept.geometry,
                           kept.visibility,
                           {choice, same ? kept.surface.normals : normals},
                           kept.strokes,
                           lighting},
                          x, y);
}

}  // namespace glint
