#pragma once
// A triangle whose edge functions may not fit 32 bits: they are found in 64 and brought to the tile.

#include "renderer/visibility/fill_triangle.h"

namespace glint::inline GLINT_ISA {

using LongEdge = EdgeFunction<long long>;

inline LongEdge edge_from(const TileCorner& a, const TileCorner& b) {
    return edge_function<long long>(a.x, a.y, b.x, b.y);
}

enum class Fit { Outside, Fits, TooLarge };

/// Edge `k` over the patches of `out`, which are given. Outside: no pixel there is inside.
inline Fit fit_edge(const LongEdge& edge, PatchEdges& out, int k) {
    const int x0 = out.x0 * patch_side, x1 = out.x1 * patch_side + patch_side - 1;
    const int y0 = out.y0 * patch_side, y1 = out.y1 * patch_side + patch_side - 1;
    const long long low =
        edge.value + edge.step_x * (edge.step_x < 0 ? x1 : x0) + edge.step_y * (edge.step_y < 0 ? y1 : y0);
    const long long high =
        edge.value + edge.step_x * (edge.step_x < 0 ? x0 : x1) + edge.step_y * (edge.step_y < 0 ? y0 : y1);
    if (high < 0) return Fit::Outside;
    const bool all_inside = low >= 0;
    constexpr long long most = 0x7fffffff;
    if (!all_inside && (low < -most || high > most)) return Fit::TooLarge;
    const LongEdge taken = all_inside ? LongEdge{0, 0, 0} : edge;
    out.value[k] = static_cast<int>(taken.value + taken.step_x * x0 + taken.step_y * y0);
    out.step_x[k] = static_cast<int>(taken.step_x);
    out.step_y[k] = static_cast<int>(taken.step_y);
    return Fit::Fits;
}

/// Draws the patches x0..x1, y0..y1. False, and nothing is drawn, when an edge does not fit.
template <Number F>
bool fill_long_edges(const TilePlane& plane, const LongEdge (&edges)[3], int x0, int y0, int x1, int y1,
                     TilePixels& tile) {
    PatchEdges patches{x0, y0, x1, y1, {}, {}, {}};
    for (int k = 0; k < 3; ++k) {
        const Fit fit = fit_edge(edges[k], patches, k);
        if (fit != Fit::Fits) return fit == Fit::Outside;
    }
    fill_patches<F>(patches, plane, tile);
    return true;
}

template <Number F> void fill_large_triangle(const TileTriangle& t, TilePixels& tile) {
    const LongEdge edges[3] = {edge_from(t.corner[0], t.corner[1]), edge_from(t.corner[1], t.corner[2]),
                               edge_from(t.corner[2], t.corner[0])};
    const TilePlane plane = plane_of(t);
    const int x0 = t.x0 / patch_side, y0 = t.y0 / patch_side;
    const int x1 = t.x1 / patch_side, y1 = t.y1 / patch_side;
    if (fill_long_edges<F>(plane, edges, x0, y0, x1, y1, tile)) return;
    for (int y = y0; y <= y1; ++y)  // 100 000 pixels long: one patch always fits
        for (int x = x0; x <= x1; ++x) fill_long_edges<F>(plane, edges, x, y, x, y, tile);
}

}  // namespace glint::inline GLINT_ISA
