#include "renderer/geometry/clip.h"

#include <array>
#include <glm/geometric.hpp>

namespace glint {
namespace {

// A plane as the row to multiply: inside where dot(plane, corner) >= 0.
using Plane = glm::dvec4;
constexpr std::array<Plane, 6> planes{Plane{0, 0, 1, 1},          Plane{0, 0, -1, 1},
                                      Plane{1, 0, 0, guard_band}, Plane{-1, 0, 0, guard_band},
                                      Plane{0, 1, 0, guard_band}, Plane{0, -1, 0, guard_band}};

/// `kept`: its memory is used for what stays.
void clip_to_plane(std::vector<glm::dvec4>& polygon, std::vector<glm::dvec4>& kept, const Plane& plane) {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec4 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double da = glm::dot(plane, a), db = glm::dot(plane, b);
        if (da >= 0) kept.push_back(a);
        // Always from the inner towards the outer corner: both faces of an edge then compute the same point.
        if (da >= 0 && db < 0) kept.push_back(a + (da / (da - db)) * (b - a));
        if (da < 0 && db >= 0) kept.push_back(b + (db / (db - da)) * (a - b));
    }
    polygon.swap(kept);
}

}  // namespace

void clip_polygon(std::vector<glm::dvec4>& polygon, std::vector<glm::dvec4>& spare) {
    for (const Plane& plane : planes) clip_to_plane(polygon, spare, plane);
}

}  // namespace glint
