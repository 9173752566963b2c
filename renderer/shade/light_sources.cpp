#include "renderer/shade/light_sources.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "models/mesh/normals.h"
#include "renderer/geometry/clip.h"
#include "renderer/geometry/object_normals.h"
#include "renderer/lighting/light_job.h"
#include "renderer/shade/lighting.h"

namespace glint {
namespace {

Float3 product(glm::dvec3 a, glm::dvec3 b) { return to_float3(a * b); }

/// The transform of a light's positions and directions to camera coordinates.
struct Frame {
    glm::dmat4 to_camera;
    [[nodiscard]] glm::dvec3 position(glm::dvec3 p) const { return glm::dvec3(to_camera * glm::dvec4(p, 1)); }
    [[nodiscard]] glm::dvec3 direction(glm::dvec3 d) const {
        return glm::dvec3(to_camera * glm::dvec4(d, 0));
    }
};

/// The cosine of a cone's half angle, 0 to 180 degrees.
double cos_of_cutoff(double degrees) {
    // cos 90 degrees is not quite 0 in floating point, and the edge belongs to the cone.
    return degrees == 90 ? 0 : std::cos(glm::radians(degrees));
}

// Student mistakes with lights and the viewer, applied before the equation (models/scene/mistakes.h).

/// Applies the mistakes in the falloff and the cone. Without mistakes, the source is unchanged.
void apply_source_mistakes(const Mistakes& wrong, const Light& light, LightSource& source) {
    if (wrong.falloff_without_constant && light.kind != LightKind::Directional) {
        source.constant = 0;
        source.has_falloff = true;
    }
    if (wrong.falloff_of_directional && light.kind == LightKind::Directional) {
        const float r = glm::length(glm::vec3(light.position));
        const Falloff& f = light.falloff;
        source.has_falloff = true;  // the same at every point
        source.constant = falloff_polynomial(f.constant, f.linear, f.quadratic, r);
        source.linear = source.quadratic = 0;
    }
    if (wrong.distance_is_one && light.kind != LightKind::Directional) {
        source.constant = source.constant + source.linear + source.quadratic;
        source.linear = source.quadratic = 0;
    }
    if (wrong.falloff_forgotten) {
        source.has_falloff = false;
        source.constant = 1;
        source.linear = source.quadratic = 0;
    }
}

/// Sets the cosines of the cone's angles. Mistakes affect both angles in the same way.
void set_cone(const Mistakes& wrong, const SpotCone& cone, LightSource& source) {
    const auto cosine_of = [&wrong](double deg) {
        const double angle = deg / (wrong.cutoff_as_full_angle ? 2.0 : 1.0);
        return wrong.degrees_for_radians ? std::cos(angle) : cos_of_cutoff(angle);
    };
    constexpr double narrowest = 0.001;  // between the cosines, as in KHR_lights_punctual
    const double edge = cosine_of(cone.cutoff_deg);
    source.cos_cutoff = static_cast<float>(edge);
    source.exponent = cone.exponent;
    if (cone.inner_deg < cone.cutoff_deg)
        source.soft_edge = static_cast<float>(1 / std::max(cosine_of(cone.inner_deg) - edge, narrowest));
}

LightJob::Projection projection_of(const glm::dmat4& m) {  // m[column][row]
    const auto f = [&m](int row,
                        int column) {  // for a narrow view: products with positions must fit in a float
        return static_cast<float>(std::clamp(m[column][row], -1e18, 1e18));
    };
    return {f(0, 0), f(0, 2), f(0, 3), f(1, 1), f(1, 2), f(1, 3), f(2, 2), f(2, 3), f(3, 2), f(3, 3)};
}

/// The direction of a spot, camera coordinates, not normalized; 0 if the spot is aimed at the origin from the
/// origin itself.
glm::dvec3 aim_of(const Mistakes& wrong, const Light& light, const Frame& frame, const glm::dmat4& view) {
    if (wrong.spot_direction_left_in_world) return light.spot.direction;
    if (!wrong.aim_stays_at_origin) return frame.direction(light.spot.direction);
    const glm::dvec3 place(glm::dvec3(light.position) / static_cast<double>(light.position.w));
    const glm::dvec3 origin = light.space == LightSpace::World ? glm::dvec3(0) : glm::dvec3(view[3]);
    return frame.direction(origin - place);
}

/// Applies the mistakes in the viewer and the projection; records whether there is any mistake.
void apply_job_mistakes(const Scene& scene, PictureSize size, LightJob& job) {
    const Mistakes& wrong = scene.shading.mistakes;
    job.mistakes = wrong;
    job.power_table = scene.shading.power_table;
    job.any_mistake = wrong != Mistakes{} || job.power_table > 0;
    const bool orthographic = is_orthographic(scene.camera.projection);
    if (wrong.perspective_view_in_ortho && orthographic) job.infinite_viewer = !scene.shading.local_viewer;
    job.mistakes.unnormalized_view &= !job.infinite_viewer;  // its v is already normalized
    if (wrong.viewer_at_origin_of_world) job.eye = to_float3(glm::dvec3(view_from_world(scene.camera)[3]));
    if (wrong.lit_after_projection)
        job.projection = projection_of(clip_from_view(scene.camera.projection, size));
}

void add_area(std::vector<LightSource>& sources, LightSource source, const Light& light, const Frame& frame,
              const glm::dvec3& centre) {
    const glm::dvec3 u = frame.direction(light.area.edge_u), v = frame.direction(light.area.edge_v);
    const glm::dvec3 across = glm::cross(u, v);
    const int n = static_cast<int>(std::lround(std::sqrt(light.area.samples)));
    source.is_patch = true;
    source.axis = to_float3(unit_or_zero(across));
    const double patch = 4 * glm::length(across) / (std::numbers::pi * n * n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double s = (2.0 * i + 1) / n - 1, t = (2.0 * j + 1) / n - 1;
            sources.push_back(source);
            sources.back().xyz = to_float3(centre + s * u + t * v);
            sources.back().patch = static_cast<float>(patch);
        }
}

/// The values that all lights share.
struct LightsOfScene {
    const Scene& scene;
    glm::dmat4 view;
    double divisor;  // every light's intensity is divided by this
};

void add_directional(std::vector<LightSource>& sources, LightSource s, const Light& light, const Frame& frame,
                     const Mistakes& mistakes) {
    const glm::dvec3 given = frame.direction(glm::dvec3(light.position));
    const glm::dvec3 towards = mistakes.light_direction_reversed && mistakes.form == 0 ? -given : given;
    const bool keeps_length = mistakes.unnormalized_light && (mistakes.form & 2) == 0;
    s.xyz = to_float3(keeps_length ? towards : unit_or_zero(towards));
    apply_source_mistakes(mistakes, light, s);
    sources.push_back(s);
}

void add_light(std::vector<LightSource>& sources, const LightsOfScene& all, std::size_t index) {
    const Light& light = all.scene.lights[index];
    const Mistakes& mistakes = all.scene.shading.mistakes;
    const Frame frame{camera_from_light(light.space, all.view, mistakes)};
    LightSource s;
    s.light = static_cast<int>(index);
    const glm::dvec3 intensity(static_cast<double>(light.intensity) / all.divisor);
    s.ambient = product(light.ambient, intensity);
    s.diffuse = product(light.diffuse, intensity);
    s.specular = product(light.specular, intensity);
    const bool directional = light.kind == LightKind::Directional;
    if (directional && !mistakes.direction_is_position)
        return add_directional(sources, s, light, frame, mistakes);
    const double w = directional ? 1 : static_cast<double>(light.position.w);
    const glm::dvec3 position = frame.position(glm::dvec3(light.position) / w);
    s.w = 1;
    s.as_direction = to_float3(frame.direction(glm::dvec3(light.position) / w));
    s.as_given = to_float3(glm::dvec3(light.position) / w);
    if (light.kind == LightKind::Area) {
        add_area(sources, s, light, frame, position);
        return;
    }
    if (!directional) {
        s.has_falloff = light.falloff != Falloff{};
        s.constant = light.falloff.constant;
        s.linear = light.falloff.linear;
        s.quadratic = light.falloff.quadratic;
    }
    s.has_cone = light.kind == LightKind::Spot && light.spot.cutoff_deg < 180;
    if (s.has_cone) {
        s.axis = to_float3(unit_or_zero(aim_of(mistakes, light, frame, all.view)));
        set_cone(mistakes, light.spot, s);
    }
    apply_source_mistakes(mistakes, light, s);
    s.xyz = to_float3(position);
    sources.push_back(s);
}

/// The cool-to-warm tone, which is warm where a surface faces the first enabled light; for an area light, the
/// mean of its samples.
CoolToWarm tone_of(const Npr& npr, const std::vector<LightSource>& lights) {
    CoolToWarm tone;
    tone.on = npr.cool_to_warm;
    tone.cool = to_float3(npr.cool);
    tone.warm = to_float3(npr.warm);
    tone.alpha = npr.alpha;
    tone.beta = npr.beta;
    if (lights.empty()) return tone;
    tone.light_w = lights[0].w;
    glm::dvec3 sum(0);
    std::size_t count = 0;
    for (; count < lights.size() && lights[count].light == lights[0].light; ++count)
        sum += glm::dvec3(lights[count].xyz.x, lights[count].xyz.y, lights[count].xyz.z);
    tone.light = to_float3(sum / static_cast<double>(count));
    return tone;
}

}  // namespace

glm::dmat4 camera_from_light(LightSpace space, const glm::dmat4& view_from_world, const Mistakes& wrong) {
    const bool world = (space == LightSpace::World) != wrong.light_in_wrong_space;
    const glm::dmat4 camera_from_world =
        wrong.light_by_inverse_view ? glm::inverse(view_from_world) : view_from_world;
    const glm::dmat4 frame = world ? camera_from_world : glm::dmat4(1.0);
    return wrong.light_moved_twice ? view_from_world * frame : frame;
}

double share_divisor(const Scene& scene) {
    if (!scene.shading.mistakes.average_of_lights) return 1;
    const auto enabled =
        std::count_if(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.enabled; });
    return static_cast<double>(std::max(enabled, decltype(enabled){1}));
}

void light_sources(const Scene& scene, std::vector<LightSource>& sources) {
    const LightsOfScene all{scene, view_from_world(scene.camera), share_divisor(scene)};
    sources.clear();
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (!scene.lights[i].enabled) continue;
        const Mistakes& wrong = scene.shading.mistakes;
        if (wrong.last_light_only && wrong.form == 1 && !sources.empty()) continue;
        if (wrong.last_light_only) sources.clear();
        add_light(sources, all, i);
    }
}

std::vector<LightSource> light_sources(const Scene& scene) {
    std::vector<LightSource> sources;
    light_sources(scene, sources);
    return sources;
}

LightJob light_job(const Scene& scene, PictureSize size, const Material& given,
                   const std::vector<LightSource>& lights, bool at_corners) {
    const Material m = mistaken_material(scene.shading.mistakes, given);
    const bool opengl = scene.shading.rules == Rules::OpenGL2;
    LightJob job;
    job.lights = lights.data();
    job.light_count = lights.size();
    job.material = surface_material(m);
    if (opengl) job.material.shininess = std::min(m.shininess, opengl_max_shininess);
    const Mistakes& wrong = scene.shading.mistakes;
    const bool without_k_a = wrong.ambient_without_material;
    job.material.global_ambient = product(without_k_a ? glm::vec3(1) : m.ambient, scene.global_ambient);
    if (without_k_a && wrong.form == 1) job.material.k_a = {1, 1, 1};
    job.model = reflection_of(given, scene.shading.reflection);
    if (wrong.alpha_not_squared && job.model == Reflection::CookTorrance)
        job.material.roughness = wrong.form == 1 ? m.roughness * m.roughness : std::sqrt(m.roughness);
    job.terms = scene.shading.terms;
    job.tone = tone_of(scene.npr, lights);
    if (job.tone.on) job.terms.emission = job.terms.ambient = job.terms.diffuse = false;
    job.infinite_viewer = !scene.shading.local_viewer || is_orthographic(scene.camera.projection);
    job.bounced = scene.transport.model == TransportModel::Bounces;
    job.clamp = opengl && at_corners;
    apply_job_mistakes(scene, size, job);
    job.grid = rounding_grid(job, scene.display.exposure);
    job.material.min_cosine_squared = min_cosine_squared(job.material.shininess);
    return job;
}

namespace {

/// The first enabled light in camera coordinates: its position (w = 1; the centre of an area light) or the
/// direction towards it (w = 0).
glm::dvec4 first_light(const std::vector<LightSource>& sources) {
    glm::dvec3 sum(0);
    std::size_t count = 0;
    for (; count < sources.size() && sources[count].light == sources[0].light; ++count)
        sum += glm::dvec3(sources[count].xyz.x, sources[count].xyz.y, sources[count].xyz.z);
    return {sum / static_cast<double>(count), sources[0].w};
}

bool faces_away(const ObjectGeometry& object, std::uint32_t face, glm::dvec3 n, glm::dvec4 light) {
    return !(glm::dot(n, glm::dvec3(light) - light.w * object.centroid(face)) > 0);
}

}  // namespace

std::vector<std::uint8_t> culled_by_light(const Scene& scene, const Geometry& g) {
    if (!lights_cull(scene)) return {};
    const std::vector<LightSource> sources = light_sources(scene);
    if (sources.empty()) return {};
    const glm::dvec4 light = first_light(sources);
    const NormalMistakes mistakes = normal_mistakes(scene.shading.mistakes);
    std::vector<std::uint8_t> culled(g.triangle_count, 0);
    for (std::size_t o = 0; o < g.objects.size(); ++o) {
        const ObjectGeometry& object = g.objects[o];
        const std::vector<Triangle>& triangles = object.mesh->triangles;
        const bool flip = scene.objects[o].normals.flip;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size()), [&](const auto& range) {
            std::uint32_t face =
                no_index;  // of the previous triangle, so that a polygon of many triangles is tested once
            std::uint8_t away = 0;
            for (std::size_t t = range.begin(); t != range.end(); ++t) {
                if (triangles[t].face != face) {
                    face = triangles[t].face;
                    const glm::dvec3 n(camera_facet_normal(object, flip, face, mistakes));
                    away = faces_away(object, face, n, light) ? 1 : 0;
                }
                culled[object.first_triangle + t] = away;
            }
        });
    }
    return culled;
}

}  // namespace glint
