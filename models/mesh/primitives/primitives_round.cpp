// Sphere, bumpy sphere, icosphere.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "models/mesh/circle.h"
#include "models/mesh/primitives/primitive_builder.h"
#include "models/mesh/primitives/primitives.h"

namespace glint {
namespace {

/// Directions of a globe: the top pole, the rings from top to bottom, the bottom pole; slices to the right as
/// seen from outside, starting at +z. Triangles at the poles, which are one vertex each, quads elsewhere.
PrimitiveBuilder make_globe(int detail) {
    const auto slices = static_cast<std::uint32_t>(std::max(detail, 3));
    const std::uint32_t stacks = std::max((slices + 1) / 2, 2u);
    PrimitiveBuilder globe;
    const auto add = [&globe](const glm::dvec3& p) { return globe.vertex(p, p); };
    const std::uint32_t top = add({0, 1, 0});
    for (std::uint32_t i = 1; i < stacks; ++i) {
        const CosSin polar = on_circle(i, 2 * std::int64_t{stacks});
        for (std::uint32_t j = 0; j < slices; ++j) {
            const CosSin turn = on_circle(j, slices);
            add({polar.s * turn.s, polar.c, polar.s * turn.c});
        }
    }
    const std::uint32_t bottom = add({0, -1, 0});
    const auto at = [slices](std::uint32_t ring, std::uint32_t j) {
        return 1 + (ring - 1) * slices + j % slices;
    };
    for (std::uint32_t j = 0; j < slices; ++j) globe.face({top, at(1, j), at(1, j + 1)});
    for (std::uint32_t i = 1; i + 1 < stacks; ++i)
        for (std::uint32_t j = 0; j < slices; ++j)
            globe.face({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), at(i, j)});
    for (std::uint32_t j = 0; j < slices; ++j) globe.face({bottom, at(stacks - 1, j + 1), at(stacks - 1, j)});
    return globe;
}

// sin(kx) sin(ky) sin(kz) with k = sqrt(19) pi/2 reaches +1 and -1 on the unit sphere: all three sines are
// +-1 at the directions (3, 3, 1)/sqrt(19), their permutations and mirror images.
const double bump_frequency = std::sqrt(19.0) * std::acos(0.0);
constexpr double bump_height = 0.05;

/// Moves a point of the unit sphere along its normal by the bumps and tilts the normal accordingly. The
/// normal of the surface r(u) u over unit u is along r u - (the part of r's gradient perpendicular to u).
void raise_bump(glm::dvec3& position, glm::dvec3& normal) {
    const glm::dvec3 u = position;
    const CosSin x = cos_sin(bump_frequency * u.x), y = cos_sin(bump_frequency * u.y),
                 z = cos_sin(bump_frequency * u.z);
    const double r = 1 + bump_height * x.s * y.s * z.s;
    const glm::dvec3 gradient =
        bump_height * bump_frequency * glm::dvec3(x.c * y.s * z.s, x.s * y.c * z.s, x.s * y.s * z.c);
    position = r * u;
    normal = r * u - (gradient - glm::dot(gradient, u) * u);
}

/// Splits every triangle in four at the midpoints of its edges, which neighbours share, and moves them onto
/// the sphere.
PrimitiveBuilder subdivide(PrimitiveBuilder from) {
    PrimitiveBuilder to;
    to.positions = std::move(from.positions);
    to.normals = std::move(from.normals);
    std::unordered_map<std::uint64_t, std::uint32_t> middles;
    middles.reserve(from.corner_position.size());
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
        const auto [found, is_new] =
            middles.try_emplace(key, static_cast<std::uint32_t>(to.positions.size()));
        if (is_new) {
            const glm::dvec3 p = glm::normalize(to.positions[a] + to.positions[b]);
            to.vertex(p, p);
        }
        return found->second;
    };
    for (std::size_t t = 0; t < from.corner_position.size(); t += 3) {
        const std::uint32_t a = from.corner_position[t], b = from.corner_position[t + 1],
                            c = from.corner_position[t + 2];
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        to.face({a, ab, ca});
        to.face({ab, b, bc});
        to.face({ca, bc, c});
        to.face({ab, bc, ca});
    }
    return to;
}

/// The corners of three golden rectangles, one in each coordinate plane.
PrimitiveBuilder make_icosahedron() {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    PrimitiveBuilder ico;
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {1.0, -1.0})
            for (const double b : {golden, -golden}) {
                glm::dvec3 p(0);
                p[axis] = a;
                p[(axis + 1) % 3] = b;
                p = glm::normalize(p);
                ico.vertex(p, p);
            }
    // Every three vertices at the distance of an edge form a face; its winding is chosen to face outward.
    const double edge = 1.2 * glm::length(ico.positions[0] - ico.positions[2]);
    const auto near = [&](std::uint32_t a, std::uint32_t b) {
        return glm::length(ico.positions[a] - ico.positions[b]) < edge;
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c) {
                if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
                const glm::dvec3 &p = ico.positions[a], &q = ico.positions[b], &r = ico.positions[c];
                if (glm::dot(p, glm::cross(q, r)) > 0)
                    ico.face({a, b, c});
                else
                    ico.face({a, c, b});
            }
    return ico;
}

}  // namespace

PrimitiveBuilder make_sphere(int detail) { return make_globe(detail); }

PrimitiveBuilder make_bumpy_sphere(int detail) {
    PrimitiveBuilder sphere = make_globe(detail);
    for (std::size_t i = 0; i < sphere.positions.size(); ++i)
        raise_bump(sphere.positions[i], sphere.normals[i]);
    return sphere;
}

PrimitiveBuilder make_icosphere(int detail) {
    PrimitiveBuilder sphere = make_icosahedron();
    for (int i = 0; i < detail; ++i) sphere = subdivide(std::move(sphere));
    return sphere;
}

}  // namespace glint
