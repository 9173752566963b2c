#pragma once
// Draws all triangles of one tile: sets up several at once (triangle_lanes.h), then draws them one after
// another.

#include "renderer/visibility/fill_triangle.h"
#include "renderer/visibility/triangle_lanes.h"

namespace glint::inline GLINT_ISA {

/// Consecutive entries of the tile's list that belong to one object or are clipped pieces.
struct TileRun {
    const TileEntry* entries;
    unsigned count;
    const ScreenVertex* screen;
    std::uint32_t first_number;
    const ClippedTriangle* pieces;  // null for triangles of an object
    bool mirrored, double_sided;
};

/// The corners of the triangles i .. i + N - 1 of a run. Repeats the last triangle past the end of the run.
template <Number F> CornerLanes<F> corner_lanes(const TileJob& job, const TileRun& run, unsigned i) {
    constexpr unsigned width = NumberTraits<F>::width;
    unsigned at[width], vertex[3][width];
    for (unsigned lane = 0; lane < width; ++lane) at[lane] = i + lane < run.count ? i + lane : run.count - 1;
    const Columns<F> entries = gather_transposed<F>(run.entries, at, sizeof(TileEntry));
    store_ints(vertex[0], bits_of(entries.b));
    store_ints(vertex[1], bits_of(entries.c));
    store_ints(vertex[2], bits_of(entries.d));
    CornerLanes<F> corners;
    corners.number = bits_of(entries.a);
    for (unsigned k = 0; k < 3; ++k) {
        const Columns<F> v = gather_transposed<F>(run.screen, vertex[k], sizeof(ScreenVertex));
        corners.x[k] = bits_of(v.a) - (job.x0 * subpixels + subpixels / 2 + job.offset_x);
        corners.y[k] = bits_of(v.b) - (job.y0 * subpixels + subpixels / 2 + job.offset_y);
        corners.inv_w[k] = v.c;
    }
    return corners;
}

/// Draws one lane. `number`: the triangle's global number.
template <Number F, unsigned N>
void draw_lane(const TileJob& job, const TriangleLanes<N>& lanes, unsigned lane, std::uint32_t number,
               bool mirrored, bool double_sided, TilePixels& tile) {
    const long long area = lanes.small[lane] ? lanes.area[lane] : doubled_area(triangle_of_lane(lanes, lane));
    // Clockwise on the screen is the back, unless the transform mirrors the object.
    const bool back = (area > 0) != mirrored;
    if (area == 0 || !(double_sided || (back ? job.draw_back : job.draw_front))) return;
    const int code = static_cast<int>(seen_code(number, std::uint32_t{back}));
    if (lanes.small[lane]) {
        fill_patches<F>(edges_of_lane(lanes, lane), plane_of_lane(lanes, lane, code), tile);
        return;
    }
    TileTriangle large = triangle_of_lane(lanes, lane);
    large.area = area;
    large.code = code;
    if (area < 0) turn_over(large);
    fill_large_triangle<F>(large, tile);
}

/// Draws all tiny triangles among the first `count` lanes together. Returns the other lanes as bits, to be
/// drawn one by one. All lanes belong to one object.
template <Number F>
unsigned draw_tiny(const TileJob& job, const TriangleLanes<NumberTraits<F>::width>& lanes, unsigned count,
                   bool mirrored, bool double_sided, TilePixels& tile) {
    using I = IntOf<F>;
    const I drawable =
        negative(load_ints<I>(iota) - static_cast<int>(count)) & inverted(load_ints<I>(lanes.empty));
    const I wide = load_ints<I>(lanes.x1) - load_ints<I>(lanes.x0) - tiny_side;
    const I high = load_ints<I>(lanes.y1) - load_ints<I>(lanes.y0) - tiny_side;
    const I tiny = drawable & load_ints<I>(lanes.small) & negative(wide & high);
    const I area = load_ints<I>(lanes.area), clockwise = negative(0 - area),
            counterclockwise = negative(area);
    const I back = mirrored ? counterclockwise : clockwise, front = mirrored ? clockwise : counterclockwise;
    const I drawn = tiny & ((back & (double_sided || job.draw_back ? -1 : 0)) |
                            (front & (double_sided || job.draw_front ? -1 : 0)));
    const I code = seen_code<I>(load_ints<I>(lanes.number), 0 - back);
    if (any_bit(drawn)) fill_tiny<F>(lanes, drawn, code, tile);
    return mask_bits(not_equal(drawable & inverted(tiny), broadcast<I>(0)));
}

/// Prefetches the vertices of the triangles begin .. end - 1 of a run, which are scattered in memory.
inline void prefetch(const TileRun& run, unsigned begin, unsigned end) {
    for (unsigned i = begin; i < end && i < run.count; ++i)
        for (const std::uint32_t vertex : run.entries[i].vertex) __builtin_prefetch(run.screen + vertex);
}

template <Number F> void draw_run(const TileJob& job, const TileRun& run, TilePixels& tile) {
    constexpr unsigned width = NumberTraits<F>::width;
    TriangleLanes<width> lanes;
    for (unsigned i = 0; i < run.count; i += width) {
        prefetch(run, i + width, i + 2 * width);
        make_ready(corner_lanes<F>(job, run, i), lanes);
        const unsigned count = run.count - i < width ? run.count - i : width;
        unsigned left = (1u << count) - 1;
        if (!run.pieces) left = draw_tiny<F>(job, lanes, count, run.mirrored, run.double_sided, tile);
        for (; left; left &= left - 1) {
            const auto lane = static_cast<unsigned>(__builtin_ctz(left));
            if (lanes.empty[lane]) continue;
            const auto number = static_cast<std::uint32_t>(lanes.number[lane]);
            const ClippedTriangle* piece = run.pieces ? run.pieces + (number - run.first_number) : nullptr;
            draw_lane<F>(job, lanes, lane, piece ? piece->triangle : number,
                         piece ? piece->mirrored : run.mirrored,
                         piece ? piece->double_sided : run.double_sided, tile);
        }
    }
}

inline void clear(TilePixels& tile) {
    for (int i = 0; i < tile_size * tile_size; ++i) {
        tile.inv_w[i] = 0;
        tile.seen[i] = 0;
    }
}

template <Number F> void draw_tile(const TileJob& job, TilePixels& tile) {
    if (!job.keep) clear(tile);
    const DrawnObject* object = job.objects;
    for (std::size_t begin = 0, end = 0; begin < job.count; begin = end) {
        const std::uint32_t number = job.entries[begin].number;
        TileRun run{job.entries + begin, 0, nullptr, job.triangle_count, nullptr, false, false};
        std::uint32_t triangles = 0xffffffffu - job.triangle_count;
        if (number >= job.triangle_count) {
            run.screen = job.clipped->corner;
            run.pieces = job.clipped;
        } else {
            while (number - object->first_triangle >= object->triangle_count) ++object;
            run.screen = object->screen;
            run.first_number = object->first_triangle;
            run.mirrored = object->mirrored;
            run.double_sided = object->double_sided;
            triangles = object->triangle_count;
        }
        for (end = begin; end < job.count && job.entries[end].number - run.first_number < triangles;) ++end;
        run.count = static_cast<unsigned>(end - begin);
        draw_run<F>(job, run, tile);
    }
}

/// Returns which pixels of a patch show a triangle: bit i is pixel i.
template <Number F> unsigned covered_of_patch(const std::int32_t* seen) {
    unsigned bits = 0;
    for (int i = 0; i < patch_pixels; i += NumberTraits<F>::width)
        bits |= mask_bits(load_ints<IntOf<F>>(seen + i) > broadcast<IntOf<F>>(0)) << i;
    return bits;
}

/// Copies the rows of a line of patches, starting at `y`.
template <Number F> void take_patches(const TilePixels& tile, int y, const TileRows& out) {
    const std::ptrdiff_t first = std::ptrdiff_t{y / patch_side} * patches_a_row * patch_pixels;
    std::uint64_t covered[patch_side] = {};  // for each row: bit i is pixel i
    for (int p = 0; p < patches_a_row && p * patch_side < out.width; ++p) {
        const std::int32_t* patch = tile.seen + first + std::ptrdiff_t{p} * patch_pixels;
        const int x = p * patch_side, within = min(out.width - x, patch_side);
        const std::uint64_t bits = covered_of_patch<F>(patch);
        for (int row = 0; row < patch_side && y + row < out.height; ++row) {
            std::uint32_t* to = out.seen + static_cast<std::size_t>(y + row) * out.row + x;
            const std::int32_t* from = patch + std::ptrdiff_t{row} * patch_side;
            if (within == patch_side)
                __builtin_memcpy(to, from, sizeof(int) * patch_side);
            else
                for (int i = 0; i < within; ++i) to[i] = static_cast<std::uint32_t>(from[i]);
            covered[row] |= (bits >> row * patch_side & ((1u << within) - 1)) << x;
        }
    }
    if (!out.covered) return;
    for (int row = 0; row < patch_side && y + row < out.height; ++row)
        for (int x = 0; x < out.width; x += static_cast<int>(block_size))
            out.covered[static_cast<std::size_t>(y + row) * out.groups_a_row +
                        x / static_cast<int>(block_size)] = static_cast<std::uint16_t>(covered[row] >> x);
}

template <Number F> void take_rows(const TilePixels& tile, const TileRows& out) {
    for (int y = 0; y < out.height; y += patch_side) take_patches<F>(tile, y, out);
}

}  // namespace glint::inline GLINT_ISA
