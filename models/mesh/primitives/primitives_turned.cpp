// Torus, knot, cylinder, cone: shapes swept around an axis or along a curve.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/mesh/circle.h"
#include "models/mesh/primitives/primitive_builder.h"
#include "models/mesh/primitives/primitives.h"

namespace glint {
namespace {

std::uint32_t at_least(std::uint32_t least, int detail, int divisor = 1) {
    return std::max(least, static_cast<std::uint32_t>((detail + divisor - 1) / divisor));
}

/// A point, or a normal, on a circle around the y axis: angle 0 is at +z, counter-clockwise seen from above.
glm::dvec3 around_y(const CosSin& a, double radius, double y) { return {radius * a.s, y, radius * a.c}; }

// The knot winds twice around y on a ring of radius 0.85 and three times around that ring at 0.4, which keeps
// its strands 0.8 apart; its tube of 0.25 extends to 0.85 + 0.4 + 0.25 = 1.5.
constexpr double knot_ring = 0.85, knot_coil = 0.4, knot_tube = 0.25;

/// One point of the centre line with its tangent and a vector perpendicular to it, both unit.
struct KnotFrame {
    glm::dvec3 centre, tangent, out;
};

KnotFrame knot_point(std::uint32_t i, std::uint32_t n) {
    const CosSin a = on_circle(2 * std::int64_t{i}, n), b = on_circle(3 * std::int64_t{i}, n);
    const double radius = knot_ring + knot_coil * b.c;
    const glm::dvec3 ahead(a.c, 0, -a.s);  // derivative of (sin, 0, cos)
    const glm::dvec3 tangent = 2 * radius * ahead + 3 * knot_coil * glm::dvec3(-b.s * a.s, b.c, -b.s * a.c);
    return {around_y(a, radius, knot_coil * b.s), glm::normalize(tangent), {b.c * a.s, b.s, b.c * a.c}};
}

glm::dvec3 mirrored(const glm::dvec3& v, const glm::dvec3& across) {
    return v - 2 * glm::dot(v, across) / glm::dot(across, across) * across;
}

/// Transports `out` from one point of the curve to the next without rotating it about the curve, by two
/// reflections. Source: W. Wang, B. Juettler, D. Zheng, Y. Liu, Computation of rotation minimizing frames,
/// TOG 27(1), 2008.
glm::dvec3 carried(const KnotFrame& from, const KnotFrame& to) {
    const glm::dvec3 step = to.centre - from.centre;
    const glm::dvec3 tangent = mirrored(from.tangent, step), out = mirrored(from.out, step);
    return mirrored(out, to.tangent - tangent);
}

/// Frames along the knot that rotate as little as a closed tube permits: each is transported to the next, and
/// the remaining angle at the end is distributed evenly.
std::vector<KnotFrame> knot_frames(std::uint32_t n) {
    std::vector<KnotFrame> frames;
    for (std::uint32_t i = 0; i < n; ++i) {
        frames.push_back(knot_point(i, n));
        if (i > 0) frames[i].out = carried(frames[i - 1], frames[i]);
    }
    const glm::dvec3 end = carried(frames.back(), frames.front()), start = frames.front().out;
    const double sine = glm::dot(glm::cross(end, start), frames.front().tangent);
    const double missing = std::copysign(angle_of(glm::dot(end, start), std::abs(sine)), sine);
    for (std::uint32_t i = 1; i < n; ++i) {
        const CosSin turn = cos_sin(missing * i / n);
        KnotFrame& f = frames[i];
        f.out = turn.c * f.out + turn.s * glm::cross(f.tangent, f.out);
    }
    return frames;
}

}  // namespace

PrimitiveBuilder make_torus(int detail) {
    const std::uint32_t around = at_least(3, detail), tube = at_least(3, detail, 2);
    PrimitiveBuilder torus;
    for (std::uint32_t i = 0; i < around; ++i) {
        const CosSin u = on_circle(i, around);
        for (std::uint32_t j = 0; j < tube; ++j) {
            const CosSin v = on_circle(j, tube);
            torus.vertex(around_y(u, 1 + 0.4 * v.c, 0.4 * v.s), around_y(u, v.c, v.s));
        }
    }
    add_closed_grid(torus, around, tube);
    return torus;
}

PrimitiveBuilder make_knot(int detail) {
    const std::uint32_t along = at_least(12, detail), tube = at_least(3, detail, 8);
    PrimitiveBuilder knot;
    for (const KnotFrame& frame : knot_frames(along)) {
        const glm::dvec3 side = glm::cross(frame.out, frame.tangent);
        for (std::uint32_t j = 0; j < tube; ++j) {
            const CosSin v = on_circle(j, tube);
            const glm::dvec3 normal = v.c * frame.out + v.s * side;
            knot.vertex(frame.centre + knot_tube * normal, normal);
        }
    }
    add_closed_grid(knot, along, tube);
    return knot;
}

PrimitiveBuilder make_cylinder(int detail) {
    const std::uint32_t n = at_least(3, detail);
    PrimitiveBuilder cylinder;
    for (const double y : {1.0, -1.0})
        for (std::uint32_t j = 0; j < n; ++j) cylinder.positions.push_back(around_y(on_circle(j, n), 1, y));
    for (std::uint32_t j = 0; j < n; ++j) cylinder.normals.push_back(around_y(on_circle(j, n), 1, 0));
    cylinder.normals.emplace_back(0, 1, 0);
    cylinder.normals.emplace_back(0, -1, 0);
    for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t k = (j + 1) % n;
        cylinder.corner(n + j, j);
        cylinder.corner(n + k, k);
        cylinder.corner(k, k);
        cylinder.corner(j, j);
        cylinder.close_face();
    }
    for (std::uint32_t j = 0; j < n; ++j) cylinder.corner(j, n);
    cylinder.close_face();
    for (std::uint32_t j = n; j-- > 0;) cylinder.corner(n + j, n + 1);
    cylinder.close_face();
    return cylinder;
}

PrimitiveBuilder make_cone(int detail) {
    const std::uint32_t n = at_least(3, detail);
    PrimitiveBuilder cone;
    for (std::uint32_t j = 0; j < n; ++j) cone.positions.push_back(around_y(on_circle(j, n), 1, -1));
    cone.positions.emplace_back(0, 1, 0);
    // The side rises 2 over a radius of 1, so its normal is along (2, 1). The tip has no normal of its own:
    // each facet's corner there uses the normal half-way between its other two.
    for (std::uint32_t j = 0; j < 2 * n; ++j)
        cone.normals.push_back(around_y(on_circle(j, 2 * std::int64_t{n}), 2, 1));
    cone.normals.emplace_back(0, -1, 0);
    for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t k = (j + 1) % n;
        cone.corner(j, 2 * j);
        cone.corner(k, 2 * k);
        cone.corner(n, 2 * j + 1);
        cone.close_face();
    }
    for (std::uint32_t j = n; j-- > 0;) cone.corner(j, 2 * n);
    cone.close_face();
    return cone;
}

}  // namespace glint
