#pragma once
// One polygon of a mesh: its plane and size, in double, which cutting, normals and counting share, and its
// triangles (docs/scene_file.md, "The lighting equation").

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

struct PolygonPlane {
    glm::dvec3 normal{0};  // unit, Newell's, object coordinates; (0, 0, 0) when the polygon has no area
    double area = 0;       // of the projection along the normal, in square scene units
};

/// The plane of the triangle a, b, c. No area when |(b - a) x (c - a)| <= 1e-12 (longest edge)^2.
[[nodiscard]] PolygonPlane triangle_plane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The plane of polygon `face` by Newell's method; the same threshold, so fewer than three distinct corners
/// have no area.
[[nodiscard]] PolygonPlane polygon_plane(const Mesh& mesh, std::size_t face);

/// Sets `corners` to the corners of polygon `face` without those that repeat the position of the corner
/// before them, or at its end that of the first. Of a run of equal positions the first corner stays.
void distinct_corners(const Mesh& mesh, std::size_t face, std::vector<std::uint32_t>& corners);

inline constexpr std::size_t longest_ear_clipping = 1000;  // corners

/// Cuts polygons; keeps its buffers from one to the next.
class Triangulator {
  public:
    /// Appends the triangles of polygon `face`, each with an area and wound as the polygon where it is
    /// simple: a fan from the first corner when it is convex in its Newell plane (`normal`, unit), else by
    /// ear clipping. `corners`: distinct_corners() of it; fewer than three give nothing. A polygon that
    /// crosses itself is cut as well as it goes. False for one that is too long to clip ears and not convex
    /// even within the rounding of its coordinates: it is cut as a fan. Time: linear when convex, else
    /// at most quadratic. Source: J. O'Rourke, Computational Geometry in C, 1.6.
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
    /// Whether x rises and falls once on the way round, but for steps back that are no longer than `noise`.
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
    std::vector<std::size_t> before_, after_;  // ring of the corners not clipped yet
    std::vector<double> sine_;                 // of each corner's turn
    std::vector<char> is_ear_;
    // Lists the corners in the order of their x: only those between the ends of an ear can lie in
    // it.
    std::vector<std::size_t> order_, lower_, higher_;
};

// Polygons that visit a vertex twice.

/// Looks for them; keeps its buffers from one polygon to the next.
class RepeatedCorners {
  public:
    /// Whether a vertex comes twice in the polygon of these corners, other than at the ends of a bridge: an
    /// edge that is gone both ways, but not straight back, joins a hole to the outline. Precondition: no
    /// vertex comes twice in a row. Time: n log n.
    [[nodiscard]] bool comes_back(const Mesh& mesh, const std::vector<std::uint32_t>& corners);

  private:
    [[nodiscard]] bool has_spike() const;
    [[nodiscard]] bool ends_bridge(std::uint32_t vertex) const;

    std::vector<std::uint32_t> vertices_, sorted_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides_;  // from, to; sorted
};

}  // namespace glint
