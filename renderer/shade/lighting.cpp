// Stage 4. Determines which part of the lighting must be recomputed, and how: by lighting each point, by
// adding one light to a cached sum, or by blending the colours of corners.

#include "renderer/shade/lighting.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "models/fields/choices.h"
#include "models/scene/reflection.h"
#include "renderer/lighting/reflection.h"
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
    bool materials = false;  // the materials of all objects
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

/// The sRGB encoding of a linear component of a colour, 0 and above; exact for 0 and 1, for which
/// srgb_encoded() in floats is wrong in the last bit.
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

// While only one light moves, caches the sum of all others and adds the moving light in each frame.

namespace {

constexpr std::size_t grain = 128;  // blocks per task

/// A bounding sphere of the vectors, out of 16, that belong to pixels. The other vectors are replaced with
/// the first of these.
struct Sphere {
    float x = 0, y = 0, z = 0, radius = 0;

    Sphere(const float* xs, const float* ys, const float* zs, unsigned mask) {
        const auto first = static_cast<std::size_t>(std::countr_zero(mask | 1u << (block_size - 1)));
        std::array<float, block_size> a, b, c;
        for (std::size_t i = 0; i < block_size; ++i) {
            const std::size_t from = mask >> i & 1u ? i : first;
            a[i] = xs[from], b[i] = ys[from], c[i] = zs[from];
            x += a[i], y += b[i], z += c[i];
        }
        constexpr float share = 1.0f / block_size;
        x *= share, y *= share, z *= share;
        float farthest = 0;
        for (std::size_t i = 0; i < block_size; ++i) {
            const float dx = a[i] - x, dy = b[i] - y, dz = c[i] - z;
            farthest = std::max(farthest, dx * dx + dy * dy + dz * dz);
        }
        radius = std::sqrt(farthest);
    }
};

/// Computes the bounds of group i of 16.
void bound_group(BoundsBlock& bounds, std::size_t i, const PointBlock& points, unsigned mask) {
    const Sphere positions(points.x, points.y, points.z, mask);
    const Sphere normals(points.nx, points.ny, points.nz, mask);
    bounds.x[i] = positions.x, bounds.y[i] = positions.y, bounds.z[i] = positions.z;
    bounds.radius[i] = positions.radius;
    bounds.nx[i] = normals.x, bounds.ny[i] = normals.y, bounds.nz[i] = normals.z;
    bounds.spread[i] = normals.radius;
}

/// Computes bounding spheres of the positions and normals of each pixel group. Empty for per-vertex and
/// per-face shading, which have few points to light.
void bound_groups(const Surface& s, std::vector<BoundsBlock>& bounds) {
    const std::size_t groups = s.choice.kind == SurfaceKind::Pixels ? s.groups.size() : 0;
    bounds.resize((groups + block_size - 1) / block_size);
    tbb::parallel_for(std::size_t{0}, bounds.size(), [&](std::size_t n) {
        for (std::size_t r = n * block_size; r < std::min(groups, (n + 1) * block_size); ++r)
            bound_group(bounds[n], r % block_size, s.points[r], s.groups[r].mask);
    });
}

void give_lights(LightJob& job, const std::vector<LightSource>& lights) {
    job.lights = lights.data();
    job.light_count = lights.size();
}

float max_product(const Float3& a, const Float3& b) { return std::max({a.x * b.x, a.y * b.y, a.z * b.z}); }

/// An upper bound of one light's contribution at any point. Infinite for an area light, for which no bound is
/// known.
double max_share(const LightJob& job, const LightSource& light) {
    if (light.is_patch) return HUGE_VAL;
    const SurfaceMaterial& m = job.material;
    const double falloff = light.has_falloff ? 1.0 / light.constant : 1.0;
    return falloff *
           (max_product(m.k_a, light.ambient) + max_diffuse_factor * max_product(m.k_d, light.diffuse) +
            max_specular_factor * max_product(m.k_s, light.specular));
}

}  // namespace

float rounding_grid(const LightJob& job, float exposure) {
    constexpr std::size_t fewest_lights = 3;  // with two lights, caching would save only one of them
    constexpr double coarsest = 0x1p-18;  // relative to white: a hundredth of a level where sRGB is steepest
    const bool bounded = info_of(job.model).is_bounded;
    if (job.light_count < fewest_lights || !bounded || job.bounced || job.tone.on || job.power_table > 0 ||
        job.clamp)
        return 0;
    const SurfaceMaterial& m = job.material;
    const double base = std::max({m.emission.x + m.global_ambient.x, m.emission.y + m.global_ambient.y,
                                  m.emission.z + m.global_ambient.z});
    double most = base, sum = base;
    for (std::size_t i = 0; i < job.light_count; ++i) {
        const double share = max_share(job, job.lights[i]);
        most = std::max(most, share);
        sum += share;
    }
    const double steps = std::max(std::ldexp(most, -22), std::ldexp(sum, -24));  // as rounded() requires
    if (!(steps > 1e-30 && steps < 1e30)) return 0;
    // A light that is far away or falls off quickly may contribute far less than its bound.
    const double grid = std::exp2(std::ceil(std::log2(steps)));
    return grid * double(exposure) <= coarsest ? static_cast<float>(grid) : 0;
}

int changed_light(const std::vector<Light>& kept, const std::vector<Light>& now) {
    int changed = -1;
    if (kept.size() != now.size()) return -1;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (kept[i] == now[i]) continue;
        if (changed >= 0) return -1;
        changed = static_cast<int>(i);
    }
    return changed;
}

void MovingLight::split(int moving, const std::vector<LightSource>& sources,
                        const std::vector<LightJob>& jobs) {
    moving_sources_.clear();
    other_sources_.clear();
    for (const LightSource& s : sources) (s.light == moving ? moving_sources_ : other_sources_).push_back(s);
    jobs_ = jobs;
    for (LightJob& job : jobs_) give_lights(job, moving_sources_);
}

void MovingLight::light_others(const std::vector<LightJob>& jobs, const Surface& s) {
    std::vector<LightJob> other_jobs = jobs;
    for (LightJob& job : other_jobs) give_lights(job, other_sources_);
    others_.resize(s.points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.points.size(), grain), [&](const auto& range) {
        light_blocks(other_jobs, s, range.begin(), range.size(), nullptr, {}, &others_[range.begin()]);
    });
}

void MovingLight::follow(int moving, bool same_grids, const std::vector<LightSource>& sources,
                         const std::vector<LightJob>& jobs, const Surface& surface) {
    // With a mistake, contributions may be so large that the sum depends on the order.
    const bool exact =
        std::all_of(jobs.begin(), jobs.end(), [](const LightJob& j) { return j.grid > 0 && !j.any_mistake; });
    if (!allowed || moving < 0 || !exact) {
        moving_ = -1;
        return;
    }
    split(moving, sources, jobs);
    if (moving_ != moving || !same_grids) {
        light_others(jobs, surface);
        bound_groups(surface, bounds_);
        shown_lit_.assign(bounds_.size(), 0xFFFF);
    }
    moving_ = moving;
}

GroupsToDo MovingLight::groups_to_do(std::size_t batch) {
    if (!is_followed() || bounds_.empty()) return {};
    unsigned lit = 0;  // groups that the moving light may reach
    for (const LightSource& source : moving_sources_) lit |= shade_kernels().find_lit(source, bounds_[batch]);
    const unsigned shown = shown_lit_[batch];
    shown_lit_[batch] = static_cast<std::uint16_t>(lit);
    return {lit, shown & ~lit};
}

void MovingLight::forget_picture() { std::fill(shown_lit_.begin(), shown_lit_.end(), 0xFFFF); }

}  // namespace glint
