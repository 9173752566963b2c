#include "renderer/shade/light_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace glint {

void light_blocks(const std::vector<LightJob>& jobs, const Surface& s, std::size_t first, std::size_t count,
                  const ColorBlock* partial_sums, ColorBlock* colors) {
    for (std::size_t i = 0; i < count;) {  // neighbouring blocks of one object go in one call
        const std::size_t same = s.count_of_one_object(first + i, first + count);
        lighting_kernels().light(jobs[s.point_object[first + i]], &s.points[first + i],
                                 partial_sums ? partial_sums + i : nullptr, colors + i, same);
        i += same;
    }
}

void light_points(const Lighting& l, const Surface& s, std::size_t first, std::size_t count,
                  ColorBlock* colors) {
    const MovingLight& moving = l.moving_light;
    if (!moving.is_followed()) return light_blocks(l.jobs, s, first, count, nullptr, colors);
    light_blocks(moving.jobs(), s, first, count, moving.others(first), colors);
}

namespace {

/// The colours of the mesh itself.
void take_vertex_colors(const Surface& s, const Geometry& g, std::size_t block, ColorBlock& colors) {
    for (std::size_t i = 0; i < block_size; ++i) {
        const ShadingPoint& source = s.sources[block * block_size + i];
        const glm::vec3 c = source.item == no_index ? glm::vec3(0) : vertex_color(s, g, source);
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

}  // namespace glint
