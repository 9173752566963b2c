#pragma once
// One polygon of a mesh: its plane and size, in double, shared by cutting, normals and counting, and its
// triangles (docs/scene_file.md, "The lighting equation").

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

struct PolygonPlane {
    glm::dvec3 normal{0};  // unit, Newell's, object coordinates; (0, 0, 0) if the polygon has no area
    double area = 0;       // of the projection along the normal, in square scene units
};

/// The plane of the triangle a, b, c. The area is 0 if |(b - a) x (c - a)| <= 1e-12 (longest edge)^2.
[[nodiscard]] PolygonPlane triangle_plane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The plane of polygon `face` by Newell's method, with the same threshold: fewer than three distinct corners
/// have no area.
[[nodiscard]] PolygonPlane polygon_plane(const Mesh& mesh, std::size_t face);

/// Sets `corners` to the corners of polygon `face` without those that repeat the position of the corner
/// before them (at the end, of the first corner). The first corner of a run of equal positions stays.
void distinct_corners(const Mesh& mesh, std::size_t face, std::vector<std::uint32_t>& corners);

inline constexpr std::size_t longest_ear_clipping = 1000;  // corners

/// Cuts polygons into triangles; reuses its buffers.
class Triangulator {
  public:
    /// Appends the triangles of polygon `face`, each with an area and, if the polygon is simple, wound like
    /// it: a fan from the first corner if it is convex in its Newell plane (`normal`, unit), else by ear
    /// clipping. `corners`: its distinct_corners(); fewer than three give nothing. The result for a polygon
    /// that crosses itself is approximate. Returns false for a polygon that is too long for ear clipping and
    /// not convex even within the rounding of its coordinates: it is cut as a fan. Time: linear if convex,
    /// else at most quadratic. Source: J. O'Rourke, Computational Geometry in C, 1.6.
    bool cut(const Mesh& mesh, std::uint32_t face, const std::vector<std::uint32_t>& corners,
             const glm::dvec3& normal, std::vector<Triangle>& triangles);

  private:
    struct Point {
        double x, y;
    };
    void project(const Mesh& mesh, const std::vector<std::uint32_t>& corners, const glm::dvec3& normal);
    /// Whether the polygon never turns right. A right turn does not count if moving its corners by at most
    /// `noise` removes it.
    [[nodiscard]] bool convex(double noise) const;
    /// Whether x rises and falls once around the polygon, ignoring steps back of at most `noise`.
    [[nodiscard]] bool winds_once(double noise) const;
    void make_ring();
    void make_sweep();
    void clip(std::size_t i);
    [[nodiscard]] bool blocks(std::size_t k, const Point& a, const Point& b, const Point& c) const;
    [[nodiscard]] bool ear(std::size_t i) const;
    void examine(std::size_t i);
    [[nodiscard]] std::size_t next_ear(std::size_t start, std::size_t left) const;
    void clip_ears(const Mesh& mesh, std::uint32_t face, const std::vector<std::uint32_t>& corners,
                   std::vector<Triangle>& triangles);

    std::vector<Point> points_;                // the corners in the Newell plane, counter-clockwise
    std::vector<std::size_t> before_, after_;  // ring of the corners that have not been clipped yet
    std::vector<double> sine_;                 // of each corner's turn
    std::vector<char> is_ear_;
    // Lists the corners in the order of their x: only those between the ends of an ear can be inside it.
    std::vector<std::size_t> order_, lower_, higher_;
};

// Polygons that visit a vertex twice.

/// Finds them; reuses its buffers.
class RepeatedCorners {
  public:
    /// Whether the polygon of these corners contains a vertex twice, other than at the ends of a bridge. A
    /// bridge is an edge that the polygon traverses in both directions, but not in immediate succession; it
    /// joins a hole to the outline. Precondition: no vertex is repeated consecutively. Time: n log n.
    [[nodiscard]] bool comes_back(const Mesh& mesh, const std::vector<std::uint32_t>& corners);

  private:
    [[nodiscard]] bool has_spike() const;
    [[nodiscard]] bool ends_bridge(std::uint32_t vertex) const;

    std::vector<std::uint32_t> vertices_, sorted_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides_;  // from, to; sorted
};

}  // namespace glint
