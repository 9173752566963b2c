#include "models/mesh/mesh.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "models/mesh/normals.h"
#include "models/mesh/polygon.h"
#include "models/mesh/topology.h"
#include "models/problem.h"
#include "models/progress.h"

namespace glint {
namespace {

// A corner takes up to about a thousand steps of ear clipping: a few milliseconds between two reports.
constexpr std::size_t corners_between_reports = 1 << 14;

}  // namespace

Bounds bounds_of_faces(const Mesh& mesh) {
    if (mesh.corner_position.empty()) return {};
    Bounds bounds{mesh.positions[mesh.corner_position[0]], mesh.positions[mesh.corner_position[0]]};
    for (const std::uint32_t p : mesh.corner_position) {
        bounds.min = glm::min(bounds.min, mesh.positions[p]);
        bounds.max = glm::max(bounds.max, mesh.positions[p]);
    }
    return bounds;
}

std::array<glm::dvec3, 8> corners_of(const Bounds& bounds) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {(i & 1) != 0 ? bounds.max.x : bounds.min.x, (i & 2) != 0 ? bounds.max.y : bounds.min.y,
                      (i & 4) != 0 ? bounds.max.z : bounds.min.z};
    return corners;
}

namespace {

/// The distance of the farthest coordinate, the longest side, and the step between floats at that distance.
struct Rounding {
    float farthest = 0, across = 0, step = 0;
    explicit Rounding(const Bounds& bounds) {
        for (int i = 0; i < 3; ++i) {
            farthest = std::max({farthest, std::abs(bounds.min[i]), std::abs(bounds.max[i])});
            across = std::max(across, bounds.max[i] - bounds.min[i]);
        }
        step = std::nextafter(farthest, HUGE_VALF) - farthest;
    }
};

}  // namespace

glm::dvec3 far_offset(const Bounds& bounds) {
    constexpr float fewest_steps = 1e5f, far_for_a_point = 1e4f;
    const Rounding now(bounds);
    if (!(now.across < fewest_steps * now.step) || (now.across == 0 && now.farthest < far_for_a_point))
        return {};
    const auto across = static_cast<double>(now.across);
    const double unit = across > 1 ? std::pow(10, std::floor(std::log10(across))) : 1;
    glm::dvec3 offset = (glm::dvec3(bounds.min) + glm::dvec3(bounds.max)) / 2.0;
    for (int i = 0; i < 3; ++i)
        offset[i] = std::abs(offset[i]) < across ? 0 : std::round(offset[i] / unit) * unit;
    return offset;
}

std::string offset_warning(const glm::dvec3& offset) {
    return fmt::format(
        "the coordinates are far from the origin: the offset ({:.0f}, {:.0f}, {:.0f}) is subtracted",
        offset.x, offset.y, offset.z);
}

std::optional<std::string> rounding_warning(const Bounds& bounds) {
    constexpr float fewest_steps = 1000;  // across the shape; with fewer, each step is visible
    const auto [farthest, across, step] = Rounding(bounds);
    if (!(across < fewest_steps * step) || farthest == 0) return {};
    return fmt::format(
        "the shape is {:.3g} across at coordinates of up to {:.7g}, which are rounded to steps of "
        "{:.3g}: it is drawn distorted, and may be too small to see; subtract an offset that moves it near "
        "the origin",
        across, farthest, step);
}

void finish_mesh(Mesh& mesh) {
    mesh.triangles.clear();
    if (mesh.corner_position.size() > 2 * mesh.face_count())
        mesh.triangles.reserve(mesh.corner_position.size() - 2 * mesh.face_count());
    Triangulator triangulator;
    RepeatedCorners repeated;
    std::vector<std::uint32_t> corners;
    std::size_t without_area = 0, repeating = 0, returning = 0, long_fans = 0;
    std::size_t next_report = corners_between_reports;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t first = mesh.first_corner[f], size = mesh.first_corner[f + 1] - first;
        if (first >= next_report) {
            report_or_leave(LoadStage::Building, f, mesh.face_count());
            next_report = first + corners_between_reports;
        }
        const PolygonPlane plane = polygon_plane(mesh, f);
        if (!(plane.area > 0)) {
            ++without_area;
        } else if (size == 3) {
            mesh.triangles.push_back({{first, first + 1, first + 2}, f});
        } else {
            distinct_corners(mesh, f, corners);
            repeating += corners.size() < size ? 1 : 0;
            returning += repeated.comes_back(mesh, corners) ? 1 : 0;
            long_fans += triangulator.cut(mesh, f, corners, plane.normal, mesh.triangles) ? 0 : 1;
        }
    }
    mesh.bounds = bounds_of_faces(mesh);
    warn(mesh.warnings, without_area, "degenerate face has no area and is not drawn",
         "degenerate faces have no area and are not drawn");
    warn(mesh.warnings, repeating, "face has a repeated corner, which was skipped",
         "faces have a repeated corner, which was skipped");
    warn(mesh.warnings, returning, "face visits one of its corners twice, and may be drawn wrong",
         "faces visit one of their corners twice, and may be drawn wrong");
    warn(mesh.warnings, long_fans, "face is not convex and has more than 1000 corners: drawn as a fan",
         "faces are not convex and have more than 1000 corners: drawn as fans");
}

}  // namespace glint
