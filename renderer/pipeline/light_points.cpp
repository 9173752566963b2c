#include "renderer/pipeline/light_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace glint {

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

/// The colours of the mesh itself.
void take_vertex_colors(Lighting& l, const Surface& s, const Geometry& g, std::size_t block) {
    for (std::size_t i = 0; i < block_size; ++i) {
        const PointSource& source = s.sources[block * block_size + i];
        const glm::vec3 c = source.item == no_index ? glm::vec3(0) : vertex_color(s, g, source);
        l.point_colors[block].r[i] = c.x;
        l.point_colors[block].g[i] = c.y;
        l.point_colors[block].b[i] = c.z;
    }
}

void color_points(Lighting& l, const Surface& s, const Geometry& g, const DisplayJob& display) {
    const bool lit = l.shading.reflection != Reflection::None;
    const bool encoded = s.choice.kind == SurfaceKind::Faces;
    l.point_colors.resize(s.points.size());
    l.point_rgba.resize(encoded ? s.points.size() * block_size : 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.points.size(), 64), [&](const auto& range) {
        const std::size_t first = range.begin();
        if (lit) light_points(l, s, first, range.size(), &l.point_colors[first]);
        for (std::size_t b = first; !lit && b != range.end(); ++b) take_vertex_colors(l, s, g, b);
        if (encoded)
            lighting_kernels().encode(display, &l.point_colors[first], &l.point_rgba[first * block_size],
                                      range.size());
    });
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

}  // namespace glint
