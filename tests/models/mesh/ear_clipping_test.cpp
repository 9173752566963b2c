// Ear clipping against its definition, without any shortcut: every query examines every corner of the ring.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "models/mesh/polygon.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_helpers.h"

using namespace glint;

namespace {

struct Point {
    double x, y;
    bool operator==(const Point&) const = default;
};
double cross(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }
double sine(Point a, Point b, Point c) {  // at a, from b to c
    const double bb = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    const double cc = (c.x - a.x) * (c.x - a.x) + (c.y - a.y) * (c.y - a.y);
    return bb * cc > 0 ? cross(a, b, c) / std::sqrt(bb * cc) : 0;
}

/// The remaining corners, in their order, and the positions of all.
struct Ring {
    std::vector<std::uint32_t> left;
    std::vector<Point> place;
    std::vector<bool> is_ear;  // as determined when the corner last got a new neighbour

    [[nodiscard]] std::array<std::uint32_t, 3> around(std::size_t i) const {
        const std::size_t n = left.size();
        return {left[(i + n - 1) % n], left[i], left[(i + 1) % n]};
    }
    [[nodiscard]] double turn(std::size_t i) const {
        const auto [a, b, c] = around(i);
        return sine(place[b], place[c], place[a]);
    }
    [[nodiscard]] bool ear(std::size_t i) const {
        const auto [before, here, after] = around(i);
        const Point a = place[before], b = place[here], c = place[after];
        return turn(i) > 1e-6 && std::none_of(left.begin(), left.end(), [&](std::uint32_t k) {
                   const Point p = place[k];
                   const bool beside = p.x < std::min({a.x, b.x, c.x}) || p.x > std::max({a.x, b.x, c.x});
                   const bool outside = cross(a, b, p) < 0 || cross(b, c, p) < 0 || cross(c, a, p) < 0;
                   return !beside && !outside && p != a && p != b && p != c;
               });
    }
    /// Returns the first ear from `start` on, else the first of the corners with the sharpest left turn.
    [[nodiscard]] std::size_t next(std::size_t start) const {
        const std::size_t n = left.size();
        std::size_t best = start;
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t i = (start + k) % n;
            if (is_ear[left[i]]) return i;
            if (turn(i) > turn(best)) best = i;
        }
        return best;
    }
};

Ring ring_of(const Mesh& mesh, double facing) {
    Ring ring;
    const glm::dvec3 origin(mesh.positions[0]);
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p = glm::dvec3(mesh.positions[i]) - origin;
        ring.left.push_back(i);
        ring.place.push_back({facing > 0 ? -p.y : p.y, p.x});  // z = 0 as the triangulator rotates it
    }
    return ring;
}

/// Whether the triangles are a fan from the first corner, as for a polygon without a right turn.
bool is_fan(const std::vector<Triangle>& triangles, const Ring& ring) {
    for (std::size_t i = 0; i < ring.left.size(); ++i)
        if (ring.turn(i) < -1e-6) return false;
    return std::all_of(triangles.begin(), triangles.end(),
                       [](const Triangle& t) { return t.corner[0] == 0; });
}

std::vector<Triangle> clipped(const Mesh& mesh, Ring ring) {
    for (std::size_t i = 0; i < ring.left.size(); ++i) ring.is_ear.push_back(ring.ear(i));
    std::vector<Triangle> triangles;
    for (std::size_t start = 0; ring.left.size() >= 3;) {
        const std::size_t i = ring.next(start);
        const std::array<std::uint32_t, 3> t = ring.around(i);
        if (triangle_plane(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]).area > 0)
            triangles.push_back({t, 0});
        ring.left.erase(ring.left.begin() + static_cast<std::ptrdiff_t>(i));
        const std::size_t n = ring.left.size();
        start = i % n;
        for (const std::size_t k : {(start + n - 1) % n, start}) ring.is_ear[ring.left[k]] = ring.ear(k);
    }
    return triangles;
}

enum class Kind { Star, Crossing, Grid, Comb };

std::vector<glm::vec3> outline(Kind kind, std::mt19937& random) {
    const auto number = [&random] { return static_cast<double>(random() >> 8) / (1 << 24); };
    const int n = 4 + static_cast<int>(random() % 40);
    std::vector<glm::vec3> points;
    for (int i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n, radius = 0.1 + number();
        switch (kind) {
        case Kind::Star:
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
            break;
        case Kind::Crossing:
            points.emplace_back(number(), number(), 0);
            break;
        case Kind::Grid:  // coincident corners, and corners on straight sides
            points.emplace_back(random() % 5, random() % 5, 0);
            break;
        case Kind::Comb:
            points.emplace_back(i + 0.2 * number(), i % 2 == 0 ? 0 : 10 + number(), 0);
            break;
        }
    }
    if (kind == Kind::Comb) points.emplace_back(0, -1, 0);
    return points;
}

}  // namespace

TEST_CASE("ear clipping equals an exhaustive search for every polygon", "[triangulate][property]") {
    std::mt19937 random(5);
    std::size_t compared = 0;
    for (const Kind kind : {Kind::Star, Kind::Crossing, Kind::Grid, Kind::Comb}) {
        for (int trial = 0; trial < 500; ++trial) {
            const Mesh mesh = test::make_polygon(outline(kind, random));
            std::vector<std::uint32_t> corners;
            distinct_corners(mesh, 0, corners);
            if (corners.size() != mesh.positions.size() || !(polygon_plane(mesh, 0).area > 0)) continue;
            const glm::dvec3 normal = polygon_plane(mesh, 0).normal;
            const Ring ring = ring_of(mesh, normal.z);
            std::vector<Triangle> triangles;
            REQUIRE(Triangulator().cut(mesh, 0, corners, normal, triangles));
            if (is_fan(triangles, ring)) continue;
            ++compared;
            INFO(static_cast<int>(kind) << " " << trial);
            REQUIRE(triangles == clipped(mesh, ring));
        }
    }
    CHECK(compared > 1000);
}
