#include "renderer/pipeline/rasterize.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "renderer/pipeline/binning.h"

namespace glint {
namespace {

/// One edge as a function of the sample: not negative inside. Moved down by one where a sample exactly on the
/// edge belongs to the neighbour. Steps are for a whole pixel.
struct Edge {
    std::int64_t value = 0, step_x = 0, step_y = 0;
};

/// Edge from a to b of a triangle that runs clockwise as seen (y down), at the sample (x, y) in 1/256 pixels.
Edge edge_at(const ScreenVertex& a, const ScreenVertex& b, std::int64_t x, std::int64_t y) {
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    const bool top_or_left = dy < 0 || (dy == 0 && dx > 0);
    return {dx * (y - a.y) - dy * (x - a.x) - (top_or_left ? 0 : 1), -dy * subpixels, dx * subpixels};
}

/// Nearness over the triangle, linear on the screen: value at the first sample and steps a pixel.
struct Plane {
    float value = 0, step_x = 0, step_y = 0;
};

Plane nearness_plane(const std::array<ScreenVertex, 3>& c, std::int64_t area, std::int64_t x,
                     std::int64_t y) {
    const double x1 = c[1].x - c[0].x, y1 = c[1].y - c[0].y, x2 = c[2].x - c[0].x, y2 = c[2].y - c[0].y;
    const double q0 = c[0].nearness, q1 = c[1].nearness - q0, q2 = c[2].nearness - q0;
    const double inverse = 1.0 / static_cast<double>(area);
    const double per_x = (q1 * y2 - q2 * y1) * inverse, per_y = (q2 * x1 - q1 * x2) * inverse;
    const double value =
        q0 + per_x * static_cast<double>(x - c[0].x) + per_y * static_cast<double>(y - c[0].y);
    return {static_cast<float>(value), static_cast<float>(per_x * subpixels),
            static_cast<float>(per_y * subpixels)};
}

/// A triangle ready to be filled: clockwise as seen, its first sample at the box's upper left pixel.
struct Setup {
    PixelBox box;
    std::array<Edge, 3> edge;
    Plane nearness;
    std::uint64_t id = 0;
    bool back = false;
};

/// A tile begins empty; cleared just before it is drawn, it is in the cache then.
void clear(const PixelBox& tile, int width, Visibility& out) {
    for (int sample = 0; sample < out.samples; ++sample)
        for (int y = tile.y0; y <= tile.y1; ++y) {
            const std::size_t first = static_cast<std::size_t>(sample) * out.plane +
                                      static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                      static_cast<std::size_t>(tile.x0);
            const int count = tile.x1 - tile.x0 + 1;
            std::fill_n(&out.keys[first], count, std::uint64_t{0});
            std::fill_n(&out.back[first], count, std::uint8_t{0});
        }
}

void fill(const Setup& s, int width, Visibility& out, std::size_t plane) {
    for (int row = 0; row <= s.box.y1 - s.box.y0; ++row) {
        const std::size_t first = plane +
                                  static_cast<std::size_t>(s.box.y0 + row) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(s.box.x0);
        const std::int64_t r0 = s.edge[0].value + row * s.edge[0].step_y;
        const std::int64_t r1 = s.edge[1].value + row * s.edge[1].step_y;
        const std::int64_t r2 = s.edge[2].value + row * s.edge[2].step_y;
        const float row_nearness = s.nearness.value + static_cast<float>(row) * s.nearness.step_y;
        for (int i = 0; i <= s.box.x1 - s.box.x0; ++i) {
            if (((r0 + i * s.edge[0].step_x) | (r1 + i * s.edge[1].step_x) | (r2 + i * s.edge[2].step_x)) < 0)
                continue;
            const float nearness = std::max(row_nearness + static_cast<float>(i) * s.nearness.step_x, 0.0f);
            const std::uint64_t key = std::uint64_t{std::bit_cast<std::uint32_t>(nearness)} << 32 | s.id;
            const std::size_t pixel = first + static_cast<std::size_t>(i);
            if (key > out.keys[pixel]) {
                out.keys[pixel] = key;
                out.back[pixel] = s.back;
            }
        }
    }
}

/// One of a pixel's samples: moving the triangle by the sample's offset the other way puts it on the centres.
void rasterize_triangle(const Geometry& g, const ScreenTriangle& t, int sample, const PixelBox& tile,
                        Visibility& out) {
    std::array<ScreenVertex, 3> c = t.corner;
    const SampleOffset offset = sample_offset(out.samples, sample);
    for (ScreenVertex& v : c) {
        v.x -= offset.x;
        v.y -= offset.y;
    }
    std::int64_t area = doubled_area(c);
    Setup s;
    s.back = (area > 0) != t.mirrored;  // clockwise as seen is the back, unless the transform turned it over
    if (out.cull != Cull::None && s.back == (out.cull == Cull::Back)) return;
    if (area < 0) {
        std::swap(c[1], c[2]);
        area = -area;
    }
    s.box = pixels_of(c, tile);
    if (s.box.empty()) return;
    const std::int64_t x = std::int64_t{s.box.x0} * subpixels + subpixels / 2;
    const std::int64_t y = std::int64_t{s.box.y0} * subpixels + subpixels / 2;
    s.edge = {edge_at(c[0], c[1], x, y), edge_at(c[1], c[2], x, y), edge_at(c[2], c[0], x, y)};
    s.nearness = nearness_plane(c, area, x, y);
    s.id = static_cast<std::uint32_t>(~t.triangle);
    fill(s, g.size.width, out, static_cast<std::size_t>(sample) * out.plane);
}

}  // namespace

void rasterize_tiles(const Geometry& g, Visibility& out) {
    tbb::parallel_for(0, g.tiles_x * g.tiles_y, [&g, &out](int tile) {
        const int x0 = tile % g.tiles_x * tile_size, y0 = tile / g.tiles_x * tile_size;
        const PixelBox box{x0, y0, std::min(x0 + tile_size, g.size.width) - 1,
                           std::min(y0 + tile_size, g.size.height) - 1};
        const auto number = static_cast<std::size_t>(tile);
        clear(box, g.size.width, out);
        for (std::uint32_t i = g.tile_first[number]; i < g.tile_first[number + 1]; ++i)
            for (int sample = 0; sample < out.samples; ++sample)
                rasterize_triangle(g, screen_triangle(g, g.tile_triangles[i]), sample, box, out);
    });
}

}  // namespace glint
