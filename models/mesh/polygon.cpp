// Planes of polygons, and finish_mesh(), which cuts them into triangles.
#include "models/mesh/polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "models/problem.h"
#include "models/progress.h"

namespace glint {
namespace {

PolygonPlane plane_of(const glm::dvec3& twice_area, double longest_squared) {
    const double length = std::sqrt(glm::dot(twice_area, twice_area));
    if (!(length > 1e-12 * longest_squared)) return {};
    return {twice_area / length, length / 2};
}

}  // namespace

PolygonPlane triangle_plane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 ab = glm::dvec3(b) - glm::dvec3(a), ac = glm::dvec3(c) - glm::dvec3(a), bc = ac - ab;
    return plane_of(glm::cross(ab, ac), std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)}));
}

PolygonPlane polygon_plane(const Mesh& mesh, std::size_t face) {
    const auto corners = mesh.corners_of(face);
    const auto& p = mesh.positions;
    if (corners.size() < 3) return {};
    if (corners.size() == 3) return triangle_plane(p[corners[0]], p[corners[1]], p[corners[2]]);
    // Newell's sum equals the sum of the fan's cross products. It is computed relative to the first corner,
    // so that a polygon far from the origin loses no precision.
    const glm::dvec3 origin(p[corners[0]]);
    glm::dvec3 twice_area(0), before = glm::dvec3(p[corners[1]]) - origin;
    double longest_squared = glm::dot(before, before);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const glm::dvec3 here = glm::dvec3(p[corners[i]]) - origin, edge = here - before;
        twice_area += glm::cross(before, here);
        longest_squared = std::max(longest_squared, glm::dot(edge, edge));
        before = here;
    }
    return plane_of(twice_area, std::max(longest_squared, glm::dot(before, before)));
}

void distinct_corners(const Mesh& mesh, std::size_t face, std::vector<std::uint32_t>& corners) {
    corners.clear();
    const auto place = [&mesh](std::uint32_t corner) { return mesh.positions[mesh.corner_position[corner]]; };
    for (std::uint32_t c = mesh.first_corner[face]; c < mesh.first_corner[face + 1]; ++c)
        if (corners.empty() || place(corners.back()) != place(c)) corners.push_back(c);
    while (corners.size() > 1 && place(corners.back()) == place(corners.front())) corners.pop_back();
}

namespace {

// The sine of the turning angle below which a corner counts as straight: rounding turns a straight line by
// about 1e-7.
constexpr double straight = 1e-6;

void add(const Mesh& mesh, const Triangle& t, std::vector<Triangle>& triangles) {
    const auto place = [&](std::size_t i) { return mesh.positions[mesh.corner_position[t.corner[i]]]; };
    if (triangle_plane(place(0), place(1), place(2)).area > 0) triangles.push_back(t);
}

template <class P> double cross(const P& a, const P& b, const P& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Sine of the angle at a from b to c; 0 if b or c is a.
template <class P> double turn(const P& a, const P& b, const P& c) {
    const double bb = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    const double cc = (c.x - a.x) * (c.x - a.x) + (c.y - a.y) * (c.y - a.y);
    return bb * cc > 0 ? cross(a, b, c) / std::sqrt(bb * cc) : 0;
}

/// The longest side of a triangle: the cross product divided by it is the smallest height.
template <class P> double longest_side(const P& a, const P& b, const P& c) {
    return std::max({std::hypot(b.x - a.x, b.y - a.y), std::hypot(c.x - a.x, c.y - a.y),
                     std::hypot(c.x - b.x, c.y - b.y)});
}

/// The largest movement of a corner, relative to the line through two others, that rounding of coordinates
/// can cause: each of the three points moves by half a unit in the last place along each axis.
double rounding_of(const Mesh& mesh, const std::vector<std::uint32_t>& corners) {
    float largest = 0;
    for (const std::uint32_t c : corners) {
        const glm::vec3 size = glm::abs(mesh.positions[mesh.corner_position[c]]);
        largest = std::max({largest, size.x, size.y, size.z});
    }
    constexpr double half_bit = std::numeric_limits<float>::epsilon() / 2;
    return 2 * std::sqrt(3.0) * half_bit * static_cast<double>(largest);
}

constexpr std::size_t longest_ear_clipping = 1000;  // corners

/// Cuts polygons into triangles; reuses its buffers.
class Triangulator {
  public:
    /// Appends the triangles of polygon `face`, each with an area and, if the polygon is simple, wound like
    /// it: a fan from the first corner if it is convex in its Newell plane (`normal`, a unit vector), else by
    /// ear clipping. `corners`: its distinct_corners(); fewer than three yield nothing. The result for a
    /// polygon that crosses itself is approximate. Returns false for a polygon that is too long for ear
    /// clipping and not convex even within the rounding of its coordinates: it is cut as a fan. Time: linear
    /// if convex, else at most quadratic. Source: J. O'Rourke, Computational Geometry in C, 1.6.
    bool cut(const Mesh& mesh, std::uint32_t face, const std::vector<std::uint32_t>& corners,
             const glm::dvec3& normal, std::vector<Triangle>& triangles) {
        bool is_convex = corners.size() <= 3;
        if (!is_convex) {
            project(mesh, corners, normal);
            is_convex = convex(0);
        }
        if (!is_convex && corners.size() <= longest_ear_clipping) {
            clip_ears(mesh, face, corners, triangles);
            return true;
        }
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            add(mesh, {{corners[0], corners[i], corners[i + 1]}, face}, triangles);
        if (is_convex) return true;
        const double noise = rounding_of(mesh, corners);
        return convex(noise) && winds_once(noise);
    }

  private:
    struct Point {
        double x, y;
    };

    void project(const Mesh& mesh, const std::vector<std::uint32_t>& corners, const glm::dvec3& normal) {
        // Two axes such that u x v = normal; u from the coordinate axis that is most parallel to the plane.
        const glm::dvec3 size = glm::abs(normal);
        const glm::dvec3 axis = size.x <= size.y && size.x <= size.z   ? glm::dvec3(1, 0, 0)
                                : size.y <= size.x && size.y <= size.z ? glm::dvec3(0, 1, 0)
                                                                       : glm::dvec3(0, 0, 1);
        const glm::dvec3 u = glm::normalize(glm::cross(axis, normal)), v = glm::cross(normal, u);
        const glm::dvec3 origin(mesh.positions[mesh.corner_position[corners[0]]]);
        points_.resize(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec3 p = glm::dvec3(mesh.positions[mesh.corner_position[corners[i]]]) - origin;
            points_[i] = {glm::dot(p, u), glm::dot(p, v)};
        }
    }

    /// Whether the polygon never turns right. A right turn does not count if moving its corners by at most
    /// `noise` removes it.
    [[nodiscard]] bool convex(double noise) const {
        const std::size_t n = points_.size();
        const auto turns_right = [noise](const Point& a, const Point& b, const Point& c) {
            return turn(a, b, c) < -straight && cross(a, b, c) < -noise * longest_side(a, b, c);
        };
        for (std::size_t i = 0; i < n; ++i) {
            const Point &here = points_[i], &next = points_[(i + 1) % n], &then = points_[(i + 2) % n];
            if (turns_right(next, then, here)) return false;
            // Left turns alone are not enough, because a pentagram or a spiral winds twice: the fan's
            // triangles must also be counter-clockwise and stay on the left of its first edge.
            if (turns_right(points_[0], here, next)) return false;
            if (turns_right(points_[0], points_[1], here)) return false;
        }
        return true;
    }

    /// Whether x rises and falls once around the polygon, ignoring backward steps of at most `noise`.
    [[nodiscard]] bool winds_once(double noise) const {
        const auto first = std::min_element(points_.begin(), points_.end(),
                                            [](const Point& a, const Point& b) { return a.x < b.x; });
        std::size_t at = static_cast<std::size_t>(first - points_.begin()), turns = 0;
        double sign = 1, furthest = first->x;  // 1 while x rises, -1 while it falls
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const double x = points_[at++ % points_.size()].x;
            if (sign * x < furthest - noise) {
                ++turns;
                sign = -sign;
                furthest = sign * x;
            }
            furthest = std::max(furthest, sign * x);
        }
        return turns <= 1;
    }

    void make_ring() {
        const std::size_t n = points_.size();
        before_.resize(n);
        after_.resize(n);
        sine_.resize(n);
        is_ear_.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            before_[i] = (i + n - 1) % n;
            after_[i] = (i + 1) % n;
        }
    }

    /// Whether a corner at p prevents the triangle a, b, c from being an ear: it is inside or on its edge. A
    /// corner at the position of a, b or c does not, because bridges to holes have such corners.
    static bool blocks(const Point& p, const Point& a, const Point& b, const Point& c) {
        if (cross(a, b, p) < 0 || cross(b, c, p) < 0 || cross(c, a, p) < 0) return false;
        const auto at_p = [&p](const Point& q) { return p.x == q.x && p.y == q.y; };
        return !at_p(a) && !at_p(b) && !at_p(c);
    }

    /// Whether corner i is an ear: a left turn that no other corner of the ring blocks.
    [[nodiscard]] bool ear(std::size_t i) const {
        if (sine_[i] <= straight) return false;
        const std::size_t before = before_[i], after = after_[i];
        for (std::size_t k = after_[after]; k != before; k = after_[k])
            if (blocks(points_[k], points_[before], points_[i], points_[after])) return false;
        return true;
    }

    void examine(std::size_t i) {
        sine_[i] = turn(points_[i], points_[after_[i]], points_[before_[i]]);
        is_ear_[i] = ear(i) ? 1 : 0;
    }

    /// Returns the first ear at or after `start` in a ring of `left` corners. If there is none (the polygon
    /// crosses itself, or only straight corners are left), returns the corner with the sharpest left turn.
    [[nodiscard]] std::size_t next_ear(std::size_t start, std::size_t left) const {
        std::size_t i = start, best = start;
        double best_sine = -2;
        for (; left > 0; --left, i = after_[i]) {
            if (is_ear_[i] != 0) return i;
            if (sine_[i] > best_sine) {
                best_sine = sine_[i];
                best = i;
            }
        }
        return best;
    }

    void clip_ears(const Mesh& mesh, std::uint32_t face, const std::vector<std::uint32_t>& corners,
                   std::vector<Triangle>& triangles) {
        make_ring();
        for (std::size_t i = 0; i < corners.size(); ++i) examine(i);
        std::size_t start = 0;
        for (std::size_t left = corners.size(); left >= 3; --left) {
            const std::size_t i = next_ear(start, left), b = before_[i], a = after_[i];
            add(mesh, {{corners[b], corners[i], corners[a]}, face}, triangles);
            after_[b] = a;
            before_[a] = b;
            examine(b);  // only the neighbours can change
            examine(a);
            start = a;
        }
    }

    std::vector<Point> points_;                // the corners in the Newell plane, counter-clockwise
    std::vector<std::size_t> before_, after_;  // ring of the corners that have not been clipped yet
    std::vector<double> sine_;                 // the sine of each corner's turn
    std::vector<char> is_ear_;
};

/// Finds polygons that visit a vertex twice; reuses its buffers.
class RepeatedCorners {
  public:
    /// Whether the polygon of these corners contains a vertex twice, other than at the ends of a bridge. A
    /// bridge is an edge that the polygon traverses in both directions, but not in immediate succession; it
    /// joins a hole to the outline. Precondition: no vertex is repeated consecutively. Time: n log n.
    [[nodiscard]] bool comes_back(const Mesh& mesh, const std::vector<std::uint32_t>& corners) {
        vertices_.clear();
        for (const std::uint32_t c : corners) vertices_.push_back(mesh.corner_position[c]);
        sorted_ = vertices_;
        std::sort(sorted_.begin(), sorted_.end());
        auto twin = std::adjacent_find(sorted_.begin(), sorted_.end());
        if (twin == sorted_.end()) return false;
        if (has_spike()) return true;
        sides_.clear();
        for (std::size_t i = 0; i < vertices_.size(); ++i)
            sides_.emplace_back(vertices_[i], vertices_[(i + 1) % vertices_.size()]);
        std::sort(sides_.begin(), sides_.end());
        while (twin != sorted_.end()) {
            if (!ends_bridge(*twin)) return true;
            twin = std::adjacent_find(std::upper_bound(twin, sorted_.end(), *twin), sorted_.end());
        }
        return false;
    }

  private:
    [[nodiscard]] bool has_spike() const {
        const std::size_t n = vertices_.size();
        for (std::size_t i = 0; i < n; ++i)
            if (vertices_[i] == vertices_[(i + 2) % n]) return true;
        return false;
    }

    [[nodiscard]] bool ends_bridge(std::uint32_t vertex) const {
        auto side = std::lower_bound(sides_.begin(), sides_.end(), std::pair(vertex, std::uint32_t{0}));
        for (; side != sides_.end() && side->first == vertex; ++side)
            if (std::binary_search(sides_.begin(), sides_.end(), std::pair(side->second, vertex)))
                return true;
        return false;
    }

    std::vector<std::uint32_t> vertices_, sorted_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides_;  // from, to; sorted
};

// A corner takes up to about a thousand steps of ear clipping: a few milliseconds between two reports.
constexpr std::size_t corners_between_reports = 1 << 14;

}  // namespace

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
    warn(mesh.warnings, returning, "face visits one of its corners twice, and may be drawn incorrectly",
         "faces visit one of their corners twice, and may be drawn incorrectly");
    warn(mesh.warnings, long_fans, "face is not convex and has more than 1000 corners: drawn as a fan",
         "faces are not convex and have more than 1000 corners: drawn as fans");
}

}  // namespace glint
