#pragma once
// Finds the tiles that each of several triangles may touch, and the triangles that must be clipped first.

#include "renderer/simd/int_lanes.h"
#include "renderer/simd/transpose.h"
#include "renderer/visibility/fill_triangle.h"

namespace glint::inline GLINT_ISA {

/// -1 where any bit is set, otherwise 0. The bits are below 2^31.
template <class I> I mask_of_bits(I a) { return negative(0 - a); }

/// A corner on the grid, relative to the triangle's first corner.
template <class I> struct FromFirst { I x, y; };

/// Returns -1 where a triangle is culled or has no area, otherwise 0. `small`: -1 where the triangle is less
/// than a tile wide and high, so the products fit in 32 bits. Others are culled when they are drawn.
template <class I> I culled(const BinJob& job, I small, FromFirst<I> b, FromFirst<I> c) {
    const I area = doubled_area(b.x & small, b.y & small, c.x & small, c.y & small);
    const I clockwise = negative(0 - area), counterclockwise = negative(area);
    const int drop_clockwise = job.drop_clockwise ? -1 : 0;
    const int drop_counterclockwise = job.drop_counterclockwise ? -1 : 0;
    const I kept = (clockwise & ~drop_clockwise) | (counterclockwise & ~drop_counterclockwise);
    return small & inverted(kept);
}

/// Bins an object's triangles, one per lane, starting at `t`. Ignores those past `end`.
template <Number F>
void bin_lanes(const BinJob& job, std::uint32_t t, std::uint32_t end, BinnedTriangles& out) {
    constexpr unsigned width = NumberTraits<F>::width;
    using I = IntOf<F>;
    unsigned at[3][width];
    for (unsigned i = 0; i < width; ++i)
        for (unsigned k = 0; k < 3; ++k)
            at[k][i] = job.triangle_vertices[3 * std::size_t{t + i < end ? t + i : t} + k];
    const Columns<F> a = gather_transposed<F>(job.screen, at[0], sizeof(ScreenVertex)),
                     b = gather_transposed<F>(job.screen, at[1], sizeof(ScreenVertex)),
                     c = gather_transposed<F>(job.screen, at[2], sizeof(ScreenVertex));
    const I x[3] = {bits_of(a.a), bits_of(b.a), bits_of(c.a)};
    const I y[3] = {bits_of(a.b), bits_of(b.b), bits_of(c.b)};
    const SampleBox<I> box = sample_box(x, y, subpixels / 2 + job.margin, subpixels / 2 - job.margin,
                                        job.width - 1, job.height - 1);
    const I some = bits_of(a.d) | bits_of(b.d) | bits_of(c.d);
    const I all = bits_of(a.d) & bits_of(b.d) & bits_of(c.d);
    const I beyond = mask_of_bits(all & static_cast<int>(job.beyond_bits));
    const I cut = mask_of_bits(some & static_cast<int>(job.clipped_bits));
    const I empty = negative((box.x1 - box.x0) | (box.y1 - box.y0));
    const I unseen = culled<I>(job, box.small, {x[1] - x[0], y[1] - y[0]}, {x[2] - x[0], y[2] - y[0]});
    int tiles[width], wanted[width], clipped[width];
    store_ints(tiles, TriangleBox::packed<I>(box.x0 >> tile_bits, box.y0 >> tile_bits, box.x1 >> tile_bits,
                                             box.y1 >> tile_bits));
    store_ints(wanted, (beyond | cut | empty | unseen) + 1);
    store_ints(clipped, cut - (cut & beyond));
    const unsigned count = end - t < width ? end - t : width;
    for (unsigned i = 0; i < count; ++i) {  // without branches, which would be unpredictable
        out.boxes[out.box_count] = {job.first_triangle + t + i, static_cast<std::uint32_t>(tiles[i])};
        out.box_count += static_cast<std::size_t>(wanted[i]);
    }
    if (!any_bit(cut)) return;
    for (unsigned i = 0; i < count; ++i)
        if (clipped[i]) out.to_clip[out.to_clip_count++] = t + i;
}

}  // namespace glint::inline GLINT_ISA
