// The Utah teapot, d x d cells a patch, cut into triangles, welded within its parts (which touch, but are not
// joined: the handle's lower end meets the body in a point).
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "models/primitives/primitive_builder.h"
#include "models/primitives/teapot_data.h"

namespace glint {
namespace {

// Bernstein's cubics with their first derivatives.
struct Weights {
    std::array<double, 4> b, db;
};
Weights weights_at(double t) {
    const double s = 1 - t;
    return {{s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t},
            {-3 * s * s, 3 * s * s - 6 * t * s, 6 * t * s - 3 * t * t, 3 * t * t}};
}

struct SurfacePoint {
    glm::dvec3 position, normal;  // y up; the normal outward, of any length
};

SurfacePoint evaluate(const std::array<std::uint16_t, 16>& patch, const Weights& u, const Weights& v) {
    glm::dvec3 s(0), du(0), dv(0), dudv(0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const TeapotPoint& point = teapot_points[patch[4 * i + j]];
            const glm::dvec3 p(point.x, point.z, -point.y);  // z up to y up, without a mirror
            s += u.b[i] * v.b[j] * p;
            du += u.db[i] * v.b[j] * p;
            dv += u.b[i] * v.db[j] * p;
            dudv += u.db[i] * v.db[j] * p;
        }
    const glm::dvec3 normal = glm::cross(dv, du);
    // At a pole a whole row is one point and dS/dv = 0: there dS/dv grows from 0 along d2S/dudv.
    return {s, glm::length(dv) < 1e-9 ? glm::cross(dudv, du) : normal};
}

/// Finds the vertex that another patch has put at the same place already.
class Weld {
  public:
    std::uint32_t find_or_add(const SurfacePoint& point, PrimitiveBuilder& pot) {
        for (int corner = 0; corner < 8; ++corner) {  // the 8 cells nearest to the point
            const glm::dvec3 shift((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                                   (corner & 4) != 0 ? 0.5 : -0.5);
            const auto [first, last] = cells_.equal_range(key(point.position / cell + shift));
            for (auto at = first; at != last; ++at)
                if (glm::length(pot.positions[at->second] - point.position) < 1e-6) return at->second;
        }
        const std::uint32_t index = pot.vertex(point.position, point.normal);
        cells_.emplace(key(point.position / cell), index);
        return index;
    }

  private:
    static constexpr double cell = 1e-5;
    static std::uint64_t key(const glm::dvec3& p) {
        const auto part = [](double x) {
            return static_cast<std::uint64_t>(std::floor(x) + 1048576) & 0x1FFFFF;
        };
        return part(p.x) << 42 | part(p.y) << 21 | part(p.z);
    }
    std::unordered_multimap<std::uint64_t, std::uint32_t> cells_;
};

void add_patch(PrimitiveBuilder& pot, const std::array<std::uint16_t, 16>& patch, std::uint32_t d,
               Weld& weld) {
    std::vector<Weights> weights;
    for (std::uint32_t i = 0; i <= d; ++i) weights.push_back(weights_at(static_cast<double>(i) / d));
    std::vector<std::uint32_t> grid;
    for (std::uint32_t i = 0; i <= d; ++i)
        for (std::uint32_t j = 0; j <= d; ++j) {
            const SurfacePoint point = evaluate(patch, weights[i], weights[j]);
            const bool rim = i == 0 || j == 0 || i == d || j == d;
            grid.push_back(rim ? weld.find_or_add(point, pot) : pot.vertex(point.position, point.normal));
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return grid[i * (d + 1) + j]; };
    for (std::uint32_t i = 0; i < d; ++i)
        for (std::uint32_t j = 0; j < d; ++j) {
            pot.face({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
            if (at(i, j) != at(i, j + 1)) pot.face({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
        }
}

}  // namespace

PrimitiveBuilder make_teapot(int detail) {
    const auto d = static_cast<std::uint32_t>(std::max(detail, 2));  // 1 would fold parts onto themselves
    PrimitiveBuilder pot;
    std::array<Weld, 4> weld;  // body with rim and bottom, handle, spout, lid
    for (std::uint32_t p = 0; p < teapot_patches.size(); ++p) {
        const std::size_t part = p < 12 || p >= 28 ? 0 : p < 16 ? 1 : p < 20 ? 2 : 3;
        add_patch(pot, teapot_patches[p], d, weld[part]);
    }
    return pot;
}

}  // namespace glint
