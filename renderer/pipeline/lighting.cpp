#include "renderer/pipeline/lighting.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "renderer/pipeline/light_sources.h"

namespace glint {
namespace {

constexpr std::size_t batch = 16;  // runs whose colours stay in the first-level cache between the steps

ColorBlock uniform_block(const glm::vec3& c) {
    ColorBlock block;
    std::fill_n(block.r, block_size, c.x);
    std::fill_n(block.g, block_size, c.y);
    std::fill_n(block.b, block_size, c.z);
    return block;
}

/// Lights blocks of points; `begun`: sums to which the jobs' lights are added, or null.
void light_blocks(const std::vector<LightJob>& jobs, const Surface& s, std::size_t first, std::size_t count,
                  const ColorBlock* begun, ColorBlock* colors) {
    for (std::size_t i = 0; i < count;) {  // neighbouring blocks of one object go in one call
        const std::uint32_t object = s.point_object[first + i];
        std::size_t same = 1;
        while (i + same < count && s.point_object[first + i + same] == object) ++same;
        lighting_kernels().light(jobs[object], &s.points[first + i], begun ? begun + i : nullptr, colors + i,
                                 same);
        i += same;
    }
}

void light_points(const Lighting& l, const Surface& s, std::size_t first, std::size_t count,
                  ColorBlock* colors) {
    if (l.moving < 0) return light_blocks(l.jobs, s, first, count, nullptr, colors);
    light_blocks(l.moving_jobs, s, first, count, &l.others[first], colors);
}

void color_points(Lighting& l, const Surface& s, const Geometry& g) {
    l.point_colors.resize(s.points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.points.size(), 64), [&](const auto& range) {
        if (l.shading.reflection != Reflection::None) {
            light_points(l, s, range.begin(), range.size(), &l.point_colors[range.begin()]);
            return;
        }
        for (std::size_t b = range.begin(); b != range.end(); ++b) {
            for (std::size_t i = 0; i < block_size; ++i) {
                const PointSource& source = s.sources[b * block_size + i];
                const glm::vec3 c = source.item == no_index ? glm::vec3(0) : vertex_color(s, g, source);
                l.point_colors[b].r[i] = c.x;
                l.point_colors[b].g[i] = c.y;
                l.point_colors[b].b[i] = c.z;
            }
        }
    });
}

void write_run(Lighting& l, const PixelRun& run, const ColorBlock& color, const std::uint32_t* rgba) {
    if (run.mask == 0xFFFF && !l.linear) {  // the usual case
        std::memcpy(&l.picture.rgba[4 * std::size_t{run.first_pixel}], rgba, 4 * block_size);
        return;
    }
    for (std::size_t i = 0; i < block_size; ++i) {
        if (!(run.mask >> i & 1u)) continue;
        std::memcpy(&l.picture.rgba[4 * (run.first_pixel + i)], &rgba[i], 4);
        if (!l.linear) continue;
        float* to = &l.picture.linear[3 * (run.first_pixel + i)];
        to[0] = color.r[i];
        to[1] = color.g[i];
        to[2] = color.b[i];
    }
}

/// Colours of `count` runs from `first` on.
void color_runs(Lighting& l, const Surface& s, std::size_t first, std::size_t count, ColorBlock* colors) {
    const LightingKernels& kernels = lighting_kernels();
    const std::size_t ref = s.corner_ref(first, 0);
    switch (s.choice.kind) {
    case SurfaceKind::Pixels:
        return light_points(l, s, first, count, colors);
    case SurfaceKind::Corners:
        return kernels.blend(l.point_colors.data(), &s.ref_point[ref], &s.ref_weight[ref], s.refs_per_pixel,
                             colors, count);
    case SurfaceKind::Faces:
        return kernels.pick(l.point_colors.data(), s.face_refs[first].point, colors, count);
    }
}

void color_pixels(Lighting& l, const Surface& s, const Strokes& strokes, const DisplayJob& display) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.runs.size(), 8 * batch), [&](const auto& range) {
        std::array<ColorBlock, batch> colors;
        std::array<std::uint32_t, batch * block_size> rgba;
        for (std::size_t first = range.begin(); first < range.end(); first += batch) {
            const std::size_t count = std::min(batch, range.end() - first);
            color_runs(l, s, first, count, colors.data());
            for (std::size_t i = 0; i < count; ++i) {
                const PixelRun& run = s.runs[first + i];
                draw_over(strokes, l.npr.stroke, run.first_pixel, run.mask, colors[i]);
            }
            lighting_kernels().encode(display, colors.data(), rgba.data(), count);
            for (std::size_t i = 0; i < count; ++i)
                write_run(l, s.runs[first + i], colors[i], &rgba[i * block_size]);
        }
    });
}

/// Adds one run's share to the pixels of its group.
void add_share(ColorBlock& sum, std::array<float, block_size>& covered, const PixelRun& run,
               const RunSamples& samples, const ColorBlock& color) {
    for (std::size_t i = 0; i < block_size; ++i) {
        if (!(run.mask >> i & 1u)) continue;
        const float w = samples.weight[i];
        covered[i] += w;
        sum.r[i] += w * color.r[i];
        sum.g[i] += w * color.g[i];
        sum.b[i] += w * color.b[i];
    }
}

/// What the faces leave of a pixel shows the background.
void add_background(ColorBlock& sum, const std::array<float, block_size>& covered,
                    const glm::vec3& background) {
    for (std::size_t i = 0; i < block_size; ++i) {
        const float left = 1 - covered[i];  // exact: shares are whole eighths
        if (left <= 0) continue;
        sum.r[i] += left * background.x;
        sum.g[i] += left * background.y;
        sum.b[i] += left * background.z;
    }
}

/// The same with several samples a pixel: shares are added in linear light, group by group.
void color_sampled_pixels(Lighting& l, const Surface& s, const Strokes& strokes, const DisplayJob& display) {
    std::vector<std::size_t> group{0};
    for (std::size_t r = 1; r <= s.runs.size(); ++r)
        if (r == s.runs.size() || s.runs[r].first_pixel != s.runs[r - 1].first_pixel) group.push_back(r);
    tbb::parallel_for(std::size_t{1}, group.size(), [&](std::size_t n) {
        ColorBlock sum{}, color;
        std::array<float, block_size> covered{};
        PixelRun all = s.runs[group[n - 1]];
        for (std::size_t r = group[n - 1]; r < group[n]; ++r) {
            color_runs(l, s, r, 1, &color);
            add_share(sum, covered, s.runs[r], s.run_samples[r], color);
            all.mask = static_cast<std::uint16_t>(all.mask | s.runs[r].mask);
        }
        add_background(sum, covered, l.display.background);
        draw_over(strokes, l.npr.stroke, all.first_pixel, all.mask, sum);
        std::array<std::uint32_t, block_size> rgba;
        lighting_kernels().encode(display, &sum, rgba.data(), 1);
        write_run(l, all, sum, rgba.data());
    });
}

/// Everything the background's colour with the strokes over it, as it is displayed.
void clear_picture(Lighting& l, PictureSize size, const Strokes& strokes, const DisplayJob& display) {
    const ColorBlock color = uniform_block(l.display.background);
    std::array<std::uint32_t, block_size> rgba{};
    lighting_kernels().encode(display, &color, rgba.data(), 1);
    l.picture.size = size;
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    l.picture.rgba.resize(4 * pixels);
    l.picture.linear.resize(l.linear ? 3 * pixels : 0);
    const std::size_t blocks = (pixels + block_size - 1) / block_size;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 1024), [&](const auto& range) {
        for (std::size_t b = range.begin(); b != range.end(); ++b) {
            const std::size_t left = std::min(block_size, pixels - b * block_size);
            const PixelRun run{static_cast<std::uint32_t>(b * block_size), 0,
                               static_cast<std::uint16_t>(0xFFFFu >> (block_size - left))};
            ColorBlock drawn = color;
            if (!draw_over(strokes, l.npr.stroke, run.first_pixel, run.mask, drawn)) {
                write_run(l, run, color, rgba.data());
                continue;
            }
            std::array<std::uint32_t, block_size> drawn_rgba{};
            lighting_kernels().encode(display, &drawn, drawn_rgba.data(), 1);
            write_run(l, run, drawn, drawn_rgba.data());
        }
    });
}

/// The index of the only light that differs, or -1 when none or several do.
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

/// Splits the lights into the one that moves and the others.
void split_lights(Lighting& l, int moving) {
    l.moving_sources.clear();
    l.other_sources.clear();
    for (const LightSource& s : l.sources)
        (s.light == moving ? l.moving_sources : l.other_sources).push_back(s);
    l.moving_jobs = l.jobs;
    for (LightJob& job : l.moving_jobs) {
        job.lights = l.moving_sources.data();
        job.light_count = l.moving_sources.size();
    }
}

/// Lights every point with all lights but the moving one.
void light_others(Lighting& l, const Surface& s) {
    std::vector<LightJob> jobs = l.jobs;
    for (LightJob& job : jobs) {
        job.lights = l.other_sources.data();
        job.light_count = l.other_sources.size();
    }
    l.others.resize(s.points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.points.size(), 8 * batch), [&](const auto& range) {
        light_blocks(jobs, s, range.begin(), range.size(), nullptr, &l.others[range.begin()]);
    });
}

/// Decides whether the sum of all lights but one can be used, and brings it up to date. `moving`: the only
/// light that differs from the frame before, or -1.
void keep_others(Lighting& l, const Surface& s, int moving, bool same_grids) {
    const bool exact =
        std::all_of(l.jobs.begin(), l.jobs.end(), [](const LightJob& j) { return j.grid > 0; });
    if (!l.keep_sums || moving < 0 || !exact || s.choice.kind != SurfaceKind::Pixels) {
        l.moving = -1;
        return;
    }
    split_lights(l, moving);
    if (l.moving != moving || !same_grids) light_others(l, s);
    l.moving = moving;
}

bool same_materials(const std::vector<Material>& kept, const Scene& scene) {
    return std::equal(kept.begin(), kept.end(), scene.objects.begin(), scene.objects.end(),
                      [](const Material& m, const Object& o) { return m == o.material; });
}

bool same_tone(const Npr& a, const Npr& b) {
    return a.cool_to_warm == b.cool_to_warm && a.cool == b.cool && a.warm == b.warm && a.alpha == b.alpha &&
           a.beta == b.beta;
}

}  // namespace

DisplayJob display_job(const Display& display) {
    return {display.exposure, display.transfer == Transfer::Srgb};
}

glm::vec3 vertex_color(const SurfaceInputs& s, const Geometry& g, const PointSource& source) {
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

bool update_lighting(Lighting& kept, const Scene& scene, const Geometry& g, const Surface& surface,
                     const Strokes& strokes, bool linear, RedoneStages redone) {
    const bool same_strokes =
        !redone.strokes && (strokes.coverage.empty() || kept.npr.stroke == scene.npr.stroke);
    const bool same_display =
        kept.display == scene.display && kept.linear == linear && !redone.visibility && same_strokes;
    const bool same = same_display && !redone.surface && kept.lights == scene.lights &&
                      kept.global_ambient == scene.global_ambient && kept.shading == scene.shading &&
                      same_tone(kept.npr, scene.npr) && same_materials(kept.materials, scene);
    if (same) return false;
    const bool lights_alone = !redone.surface && kept.global_ambient == scene.global_ambient &&
                              kept.shading == scene.shading && same_tone(kept.npr, scene.npr) &&
                              same_materials(kept.materials, scene);
    const int moving = lights_alone ? changed_light(kept.lights, scene.lights) : -1;
    std::vector<float> grids;
    for (const LightJob& job : kept.jobs) grids.push_back(job.grid);
    kept.lights = scene.lights;
    kept.global_ambient = scene.global_ambient;
    kept.shading = scene.shading;
    kept.npr = scene.npr;
    kept.display = scene.display;
    kept.linear = linear;
    kept.sources = light_sources(scene);
    kept.materials.clear();
    kept.jobs.clear();
    const bool at_corners = surface.choice.kind != SurfaceKind::Pixels;
    for (const Object& object : scene.objects) {
        kept.materials.push_back(object.material);
        kept.jobs.push_back(light_job(scene, g.size, object.material, kept.sources, at_corners));
    }
    const bool same_grids = std::equal(grids.begin(), grids.end(), kept.jobs.begin(), kept.jobs.end(),
                                       [](float grid, const LightJob& job) { return grid == job.grid; });
    keep_others(kept, surface, moving, same_grids);
    const DisplayJob display = display_job(scene.display);
    if (!same_display) clear_picture(kept, g.size, strokes, display);
    if (at_corners) color_points(kept, surface, g);
    if (surface.run_samples.empty())
        color_pixels(kept, surface, strokes, display);
    else
        color_sampled_pixels(kept, surface, strokes, display);
    return true;
}

}  // namespace glint
