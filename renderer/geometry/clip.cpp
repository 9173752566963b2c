#include "renderer/geometry/clip.h"

#include <glm/geometric.hpp>

namespace glint {
namespace {

/// `kept`: its memory is used for what stays.
void clip_to_plane(std::vector<glm::dvec4>& polygon, std::vector<glm::dvec4>& kept, const glm::dvec4& plane) {
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
    constexpr auto planes = view_planes(guard_band, guard_band);
    for (const glm::dvec4& plane : planes) clip_to_plane(polygon, spare, plane);
}

}  // namespace glint
