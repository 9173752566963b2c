// Stage 4. Determines which part of the lighting must be recomputed, and how: by lighting each point, by
// adding one light to a cached sum, or by blending the colours of corners.

#include "renderer/shade/lighting.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "renderer/shade/light_sources.h"
#include "renderer/simd/pow.h"

namespace glint {

void light_blocks(const std::vector<LightJob>& jobs, const Surface& s, std::size_t first, std::size_t count,
                  const ColorBlock* partial_sums, const std::optional<Arrivals>& arrivals,
                  ColorBlock* colors) {
    for (std::size_t i = 0; i < count;) {  // one call for adjacent blocks of one object
        const std::size_t same = s.blocks_of_one_object(first + i, first + count);
        const Arrivals here = arrivals ? arrivals->from(first + i) : Arrivals{};
        lighting_kernels().light(jobs[s.point_object[first + i]], &s.points[first + i],
                                 partial_sums ? partial_sums + i : nullptr, arrivals ? &here : nullptr,
                                 colors + i, same);
        i += same;
    }
}

void light_points(const Lighting& l, const Surface& s, std::size_t first, std::size_t count,
                  ColorBlock* colors) {
    const MovingLight& moving = l.moving_light;
    if (!moving.is_followed()) return light_blocks(l.jobs, s, first, count, nullptr, l.arrivals, colors);
    light_blocks(moving.jobs(), s, first, count, moving.others(first), {}, colors);
}

namespace {

/// Copies the mesh's vertex colours.
void take_vertex_colors(const Surface& s, const Geometry& g, std::size_t block, ColorBlock& colors) {
    const std::vector<ShadingPoint>& points = s.lit_points().shading_points;
    for (std::size_t i = 0; i < block_size; ++i) {
        const ShadingPoint& point = points[block * block_size + i];
        const glm::vec3 c = point.item == no_index ? glm::vec3(0) : vertex_color(s, g, point);
        colors.r[i] = c.x;
        colors.g[i] = c.y;
        colors.b[i] = c.z;
    }
}

void color_batch(Lighting& l, const Surface& s, const Geometry& g, const DisplayJob& display,
                 std::size_t first, std::size_t count) {
    std::array<ColorBlock, batch_size> colors;
    if (l.shading.reflection != Reflection::None) {
        light_points(l, s, first, count, colors.data());
    } else {
        for (std::size_t b = 0; b < count; ++b) take_vertex_colors(s, g, first + b, colors[b]);
    }
    for (std::size_t i = 0; i < count * block_size; ++i) {
        const ColorBlock& from = colors[i / block_size];
        const std::size_t k = i % block_size;
        l.point_colors[first * block_size + i] = {from.r[k], from.g[k], from.b[k], 0};
    }
    if (!l.point_rgba.empty())
        lighting_kernels().encode(display, colors.data(), &l.point_rgba[first * block_size], count);
}

}  // namespace

void color_points(Lighting& l, const Surface& s, const Geometry& g, const DisplayJob& display) {
    const std::size_t all = s.points.size(), batches = (all + batch_size - 1) / batch_size;
    l.point_colors.resize(all * block_size);
    l.point_rgba.resize(s.choice.kind == SurfaceKind::Faces ? all * block_size : 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, batches, 4), [&](const auto& range) {
        for (std::size_t b = range.begin(); b != range.end(); ++b)
            color_batch(l, s, g, display, b * batch_size, std::min(batch_size, all - b * batch_size));
    });
}

glm::vec3 vertex_color(const SurfaceInputs& s, const Geometry& g, const ShadingPoint& source) {
    const Mesh& mesh = *g.objects[source.object].mesh;
    if (mesh.colors.empty()) return glm::vec3(1);
    if (s.choice.kind == SurfaceKind::Corners) {
        return mesh.colors[s.normals[source.object].position_of_slot(source.item)];
    }
    if (s.choice.provoking) return mesh.colors[mesh.corner_position[mesh.triangles[source.item].corner[2]]];
    const auto around = mesh.corners_of(source.item);
    glm::vec3 sum(0);
    for (const std::uint32_t p : around) sum += mesh.colors[p];
    return sum / static_cast<float>(around.size());
}

namespace {

bool same_materials(const std::vector<Material>& kept, const Scene& scene) {
    return std::equal(kept.begin(), kept.end(), scene.objects.begin(), scene.objects.end(),
                      [](const Material& m, const Object& o) { return m == o.material; });
}

/// Records the objects of which only the material has changed; none if anything else has changed.
void find_objects_again(Lighting& l, const Scene& scene, bool same_but_materials) {
    l.objects_again.clear();
    if (!same_but_materials || l.materials.size() != scene.objects.size()) return;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        l.objects_again.push_back(l.materials[i] != scene.objects[i].material);
}

/// The members of `npr` that this stage reads: all except those of the strokes stage. A new member is
/// included unless it is reset here.
Npr without_strokes(Npr npr) {
    const Npr none;
    npr.silhouettes = none.silhouettes;
    npr.creases = none.creases;
    npr.crease_deg = none.crease_deg;
    npr.stroke_width_px = none.stroke_width_px;
    npr.stroke = none.stroke;
    return npr;
}

/// The inputs that are unchanged since the cached picture.
struct Unchanged {
    bool ground = false;     // background, strokes and display: the inputs of pixels that show no surface
    bool pixels = false;     // ground, and the surface that each pixel shows
    bool equation = false;   // the surface, and the equation's inputs except lights and materials
    bool materials = false;  // of all objects
    bool lights = false;

    [[nodiscard]] bool all_but_lights() const { return equation && materials; }
    [[nodiscard]] bool all_but_materials() const { return pixels && equation && lights; }
    [[nodiscard]] bool all() const { return all_but_materials() && materials; }
};

Unchanged compare(const Lighting& kept, const Scene& scene, const Strokes& strokes, bool linear,
                  RedoneStages redone) {
    const bool same_strokes =
        !redone.strokes && (strokes.coverage.empty() || kept.npr.stroke == scene.npr.stroke);
    Unchanged same;
    const bool same_display = display_job(kept.display, kept.shading.mistakes) ==
                              display_job(scene.display, scene.shading.mistakes);
    same.ground = kept.display == scene.display && same_display && kept.linear == linear && same_strokes;
    same.pixels = same.ground && !redone.visibility;
    same.equation = !redone.surface && !redone.transport && kept.global_ambient == scene.global_ambient &&
                    kept.shading == scene.shading && without_strokes(kept.npr) == without_strokes(scene.npr);
    same.materials = same_materials(kept.materials, scene);
    same.lights = kept.lights == scene.lights;
    return same;
}

/// Recomputes sources and jobs, reusing their memory. Returns false if the grid of an object has changed.
bool take_jobs(Lighting& kept, const Scene& scene, PictureSize size, bool at_corners) {
    light_sources(scene, kept.sources);
    bool same_grids = kept.jobs.size() == scene.objects.size();
    kept.materials.resize(scene.objects.size());
    kept.jobs.resize(scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const float grid = kept.jobs[i].grid;
        kept.materials[i] = scene.objects[i].material;
        kept.jobs[i] = light_job(scene, size, kept.materials[i], kept.sources, at_corners);
        same_grids &= kept.jobs[i].grid == grid;
    }
    return same_grids;
}

/// Draws the background in all pixels without a surface. `same_ground`: background, strokes and display are
/// unchanged since the last picture, so most of it is up to date.
void prepare_picture(Lighting& kept, PictureSize size, const Visibility& visibility, const Strokes& strokes,
                     const DisplayJob& display, bool same_ground) {
    const bool plain = visibility.samples == 1 && strokes.coverage.empty();
    if (same_ground && plain && kept.picture.size == size && !kept.covered.empty())
        uncover(kept, visibility, display);
    else
        clear_picture(kept, size, strokes, display);
    if (plain)
        kept.covered = visibility.covered;
    else
        kept.covered.clear();
}

}  // namespace

DisplayJob display_job(const Display& display, const Mistakes& mistakes) {
    return {display.exposure, display.transfer == Transfer::Srgb, mistakes.encoded_twice,
            mistakes.bytes_wrap};
}

bool update_lighting(Lighting& kept, const Scene& scene, const Geometry& g, const Visibility& visibility,
                     const Surface& surface, const Strokes& strokes, const std::optional<Arrivals>& arrivals,
                     bool linear, RedoneStages redone) {
    const Unchanged same = compare(kept, scene, strokes, linear, redone);
    if (same.all()) return false;
    find_objects_again(kept, scene, same.all_but_materials());
    const int moving = same.all_but_lights() ? changed_light(kept.lights, scene.lights) : -1;
    kept.arrivals = arrivals;
    kept.lights = scene.lights;
    kept.global_ambient = scene.global_ambient;
    kept.shading = scene.shading;
    kept.npr = scene.npr;
    kept.display = scene.display;
    kept.linear = linear;
    const bool at_corners = surface.choice.kind != SurfaceKind::Pixels;
    const bool same_grids = take_jobs(kept, scene, g.size, at_corners);
    kept.moving_light.follow(arrivals ? -1 : moving, same_grids, kept.sources, kept.jobs, surface);
    const DisplayJob display = display_job(scene.display, scene.shading.mistakes);
    if (!same.pixels) {
        prepare_picture(kept, g.size, visibility, strokes, display, same.ground);
        kept.moving_light.forget_picture();
    }
    if (at_corners) color_points(kept, surface, g, display);
    color_pixels(kept, surface, strokes, display);
    return true;
}

namespace {

/// The sRGB encoding of a linear component of a colour, 0 and above; exact for 0 and 1, which srgb_encoded()
/// in floats misses by the last bit.
float srgb_of(float x) {
    if (x <= 0.0031308f) return 12.92f * x;
    return static_cast<float>(1.055 * static_cast<double>(power(x, 1 / 2.4f)) - 0.055);
}

}  // namespace

Material mistaken_material(const Mistakes& wrong, Material m) {
    if (wrong.lit_in_srgb)
        for (glm::vec3* color : {&m.ambient, &m.diffuse, &m.specular, &m.emission})
            for (int i = 0; i < 3; ++i) (*color)[i] = srgb_of((*color)[i]);
    if (wrong.coefficients_swapped) std::swap(m.diffuse, m.specular);
    if (wrong.highlight_tinted) m.specular *= m.diffuse;
    if (wrong.highlight_normalized) {
        constexpr float pi = 3.14159265f;
        const float n = m.shininess;
        m.specular *= wrong.highlight_form == 0   ? (n + 8) / (8 * pi)
                      : wrong.highlight_form == 1 ? (n + 2) / (2 * pi)
                                                  : (n + 2) / 8;
    }
    if (wrong.shininess_as_fraction) m.shininess /= 128;
    if (wrong.shininess_inverted && m.shininess > 0) m.shininess = std::min(1 / m.shininess, 1e30f);
    return m;
}

float min_cosine_squared(float shininess) {
    return shininess > 0 ? static_cast<float>(std::exp2(-48.0 / static_cast<double>(shininess)))
                         : std::numeric_limits<float>::lowest();  // anything to the power 0 is 1
}

SurfaceMaterial surface_material(const Material& m) {
    SurfaceMaterial s;
    s.k_a = to_float3(m.ambient);
    s.k_d = to_float3(m.diffuse);
    s.k_s = to_float3(m.specular);
    s.f0 = to_float3(m.f0);
    s.shininess = m.shininess;
    s.roughness = m.roughness;
    s.emission = to_float3(m.emission);
    s.min_cosine_squared = min_cosine_squared(m.shininess);
    return s;
}

}  // namespace glint
