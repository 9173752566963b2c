#include "models/mesh/mesh.h"

#include <algorithm>
#include <glm/common.hpp>

#include "models/mesh/polygon.h"
#include "models/mesh/triangulate.h"
#include "models/progress.h"
#include "models/warn.h"

namespace glint {
namespace {

// A corner takes at most about a thousand steps of ear clipping: a few milliseconds from report to report.
constexpr std::size_t corners_between_reports = 1 << 14;

Bounds bounds_of_faces(const Mesh& mesh) {
    if (mesh.corner_position.empty()) return {};
    Bounds bounds{mesh.positions[mesh.corner_position[0]], mesh.positions[mesh.corner_position[0]]};
    for (const std::uint32_t p : mesh.corner_position) {
        bounds.min = glm::min(bounds.min, mesh.positions[p]);
        bounds.max = glm::max(bounds.max, mesh.positions[p]);
    }
    return bounds;
}

}  // namespace

void finish_mesh(Mesh& mesh) {
    mesh.triangles.clear();
    if (mesh.corner_position.size() > 2 * mesh.face_count())
        mesh.triangles.reserve(mesh.corner_position.size() - 2 * mesh.face_count());
    Triangulator triangulator;
    std::vector<std::uint32_t> corners;
    std::size_t without_area = 0, repeating = 0, long_fans = 0;
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
            const Cut cut = triangulator.cut(mesh, f, corners, plane.normal, mesh.triangles);
            long_fans += cut == Cut::LongFan ? 1 : 0;
        }
    }
    mesh.bounds = bounds_of_faces(mesh);
    warn(mesh.warnings, without_area, "degenerate face has no area and is not drawn",
         "degenerate faces have no area and are not drawn");
    warn(mesh.warnings, repeating, "face has a repeated corner, which was skipped",
         "faces have a repeated corner, which was skipped");
    warn(mesh.warnings, long_fans, "face is not convex and has more than 1000 corners: drawn as a fan",
         "faces are not convex and have more than 1000 corners: drawn as fans");
}

}  // namespace glint
