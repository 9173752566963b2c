#include "renderer/geometry/clip.h"

#include <glm/geometric.hpp>

namespace glint {
namespace {

/// Clips the polygon to a plane. `kept`: scratch memory.
void clip_to_plane(std::vector<glm::dvec4>& polygon, std::vector<glm::dvec4>& kept, const glm::dvec4& plane) {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec4 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double da = glm::dot(plane, a), db = glm::dot(plane, b);
        if (da >= 0) kept.push_back(a);
        // Always computed from the inner to the outer corner, so that both faces of an edge compute the same
        // point.
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

std::pmr::vector<ClippedCorner> clip_at_near(const Geometry& g, std::uint32_t object_index,
                                             std::span<const std::uint32_t> corners, ClipMemory& memory) {
    const ObjectGeometry& object = g.objects[object_index];
    const Viewport viewport = viewport_of(g.camera, g.size);
    std::pmr::vector<glm::dvec4> clip(&memory.pool);
    clip.reserve(corners.size());
    for (const std::uint32_t c : corners)
        clip.push_back(object.clip_from_object *
                       glm::dvec4(glm::dvec3(object.mesh->positions[object.mesh->corner_position[c]]), 1.0));

    std::pmr::vector<ClippedCorner> cut(&memory.pool);
    cut.reserve(corners.size() + 1);
    const auto add = [&](const glm::dvec4& corner, std::size_t i, std::size_t j, double t) {
        const glm::dvec4 c = before_eye(g.camera.projection, corner);
        cut.push_back({to_pixel(viewport, c), corners[i], corners[j], t});
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t j = (i + 1) % corners.size();
        const double here = glm::dot(near_plane, clip[i]), next = glm::dot(near_plane, clip[j]);
        if (here >= 0) add(clip[i], i, i, 0);
        if ((here >= 0) == (next >= 0)) continue;
        const double t = here / (here - next);
        add(clip[i] + t * (clip[j] - clip[i]), i, j, t);
    }
    return cut;
}

}  // namespace glint
