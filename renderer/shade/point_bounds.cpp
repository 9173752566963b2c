#include "renderer/shade/point_bounds.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace glint {
namespace {

/// The ball around those of 16 vectors that belong to pixels; the first of these stands in for the rest.
struct Ball {
    float x = 0, y = 0, z = 0, radius = 0;

    Ball(const float* xs, const float* ys, const float* zs, unsigned mask) {
        const auto first = static_cast<std::size_t>(std::countr_zero(mask | 1u << (block_size - 1)));
        std::array<float, block_size> a, b, c;
        for (std::size_t i = 0; i < block_size; ++i) {
            const std::size_t from = mask >> i & 1u ? i : first;
            a[i] = xs[from], b[i] = ys[from], c[i] = zs[from];
            x += a[i], y += b[i], z += c[i];
        }
        constexpr float share = 1.0f / block_size;
        x *= share, y *= share, z *= share;
        float most = 0;
        for (std::size_t i = 0; i < block_size; ++i) {
            const float dx = a[i] - x, dy = b[i] - y, dz = c[i] - z;
            most = std::max(most, dx * dx + dy * dy + dz * dz);
        }
        radius = std::sqrt(most);
    }
};

/// Bounds of block i of 16.
void bound_block(ReachBlock& bounds, std::size_t i, const PointBlock& points, unsigned mask) {
    const Ball places(points.x, points.y, points.z, mask), normals(points.nx, points.ny, points.nz, mask);
    bounds.x[i] = places.x, bounds.y[i] = places.y, bounds.z[i] = places.z;
    bounds.radius[i] = places.radius;
    bounds.nx[i] = normals.x, bounds.ny[i] = normals.y, bounds.nz[i] = normals.z;
    bounds.spread[i] = normals.radius;
}

}  // namespace

void bound_pixels(const Surface& s, std::vector<ReachBlock>& bounds) {
    const std::size_t runs = s.choice.kind == SurfaceKind::Pixels ? s.runs.size() : 0;
    bounds.resize((runs + block_size - 1) / block_size);
    tbb::parallel_for(std::size_t{0}, bounds.size(), [&](std::size_t n) {
        for (std::size_t r = n * block_size; r < std::min(runs, (n + 1) * block_size); ++r)
            bound_block(bounds[n], r % block_size, s.points[r], s.runs[r].mask);
    });
}

}  // namespace glint
