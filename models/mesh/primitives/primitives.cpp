#include "models/mesh/primitives/primitives.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <unordered_map>

#include "models/numbers.h"

namespace glint {
namespace {

/// The centre of the bounds; exactly 0 if it differs from 0 only by rounding.
glm::dvec3 middle_of_bounds(const std::vector<glm::dvec3>& positions) {
    glm::dvec3 low = positions.front(), high = low;
    for (const glm::dvec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    glm::dvec3 middle = (low + high) / 2.0;
    for (int i = 0; i < 3; ++i)
        if (std::abs(middle[i]) < 1e-12) middle[i] = 0;
    return middle;
}

}  // namespace

void add_closed_grid(PrimitiveBuilder& to, std::uint32_t columns, std::uint32_t rows) {
    const auto at = [=](std::uint32_t i, std::uint32_t j) { return i % columns * rows + j % rows; };
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j)
            to.face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
}

Mesh make_primitive(Primitive primitive, int detail) {
    const auto start = std::chrono::steady_clock::now();
    PrimitiveBuilder built = info_of(primitive).make(detail);
    const glm::dvec3 middle = middle_of_bounds(built.positions);
    Mesh mesh;
    mesh.positions.reserve(built.positions.size());
    for (const glm::dvec3& p : built.positions) mesh.positions.emplace_back(p - middle);
    mesh.normals.reserve(built.normals.size());
    for (const glm::dvec3& n : built.normals) mesh.normals.emplace_back(glm::normalize(n));
    mesh.first_corner = std::move(built.first_corner);
    mesh.corner_position = std::move(built.corner_position);
    mesh.corner_normal = std::move(built.corner_normal);
    mesh.colors = std::move(built.colors);
    mesh.given_normals = GivenNormals::Analytic;
    finish_mesh(mesh);
    mesh.load_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return mesh;
}

// Cube, plane, and the two figures from the lecture's interpolation slides.

namespace {

/// Numbers the lattice points (i, j, k), 0 to d each, on the surface of a cube of d^3 cells.
struct CubeLattice {
    std::uint32_t d;

    /// The index along the rim of the square 0 .. d by 0 .. d, counter-clockwise from (0, 0).
    [[nodiscard]] std::uint32_t on_rim(std::uint32_t i, std::uint32_t j) const {
        if (j == 0) return i;
        if (i == d) return d + j;
        return j == d ? 2 * d + (d - i) : 3 * d + (d - j);
    }
    /// Numbers the entire layer k = 0 first, then the entire layer k = d, then the rims between.
    [[nodiscard]] std::uint32_t index(const std::array<std::uint32_t, 3>& p) const {
        const std::uint32_t layer = (d + 1) * (d + 1);
        if (p[2] == 0) return p[1] * (d + 1) + p[0];
        if (p[2] == d) return layer + p[1] * (d + 1) + p[0];
        return 2 * layer + (p[2] - 1) * 4 * d + on_rim(p[0], p[1]);
    }
    [[nodiscard]] std::uint32_t count() const { return 2 * (d + 1) * (d + 1) + (d - 1) * 4 * d; }
};

void add_cube_side(PrimitiveBuilder& cube, const CubeLattice& lattice, std::uint32_t axis, bool positive) {
    const std::uint32_t d = lattice.d, normal = 2 * axis + (positive ? 0 : 1);
    const std::uint32_t u = (axis + (positive ? 1 : 2)) % 3, v = (axis + (positive ? 2 : 1)) % 3;
    const auto corner = [&](std::uint32_t i, std::uint32_t j) {
        std::array<std::uint32_t, 3> p{};
        p[axis] = positive ? d : 0;
        p[u] = i;
        p[v] = j;
        const std::uint32_t index = lattice.index(p);
        for (int k = 0; k < 3; ++k) cube.positions[index][k] = -1 + 2.0 * p[static_cast<std::size_t>(k)] / d;
        cube.corner(index, normal);
    };
    for (std::uint32_t j = 0; j < d; ++j)
        for (std::uint32_t i = 0; i < d; ++i) {
            corner(i, j);
            corner(i + 1, j);
            corner(i + 1, j + 1);
            corner(i, j + 1);
            cube.close_face();
        }
}

/// Adds points given as (x, y, grey level) in the plane z = 0, facing +z.
void add_figure_points(PrimitiveBuilder& to, std::initializer_list<glm::dvec3> points_and_greys) {
    for (const glm::dvec3& p : points_and_greys) {
        to.vertex({p.x, p.y, 0}, {0, 0, 1});
        to.colors.emplace_back(static_cast<float>(p.z));
    }
}

}  // namespace

PrimitiveBuilder make_cube(int detail) {
    const CubeLattice lattice{static_cast<std::uint32_t>(detail)};
    PrimitiveBuilder cube;
    cube.positions.resize(lattice.count());
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 normal(0);
            normal[axis] = sign;
            cube.normals.push_back(normal);
        }
    for (const std::uint32_t axis : {0u, 1u, 2u})
        for (const bool positive : {true, false}) add_cube_side(cube, lattice, axis, positive);
    return cube;
}

PrimitiveBuilder make_plane(int detail) {
    const auto d = static_cast<std::uint32_t>(detail);
    PrimitiveBuilder plane;
    for (std::uint32_t j = 0; j <= d; ++j)
        for (std::uint32_t i = 0; i <= d; ++i)
            plane.vertex({-1 + 2.0 * i / d, 0, 1 - 2.0 * j / d}, {0, 1, 0});
    const auto at = [d](std::uint32_t i, std::uint32_t j) { return j * (d + 1) + i; };
    for (std::uint32_t j = 0; j < d; ++j)
        for (std::uint32_t i = 0; i < d; ++i)
            plane.face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return plane;
}

PrimitiveBuilder make_skew_quad(int) {
    PrimitiveBuilder quad;
    add_figure_points(quad, {{0, 0, 0}, {4, 0, 1}, {6, 4, 0}, {0, 4, 1}});  // A B C D
    quad.face({0, 1, 2, 3});
    return quad;
}

PrimitiveBuilder make_t_junction(int detail) {
    PrimitiveBuilder figure;
    enum : std::uint32_t { A, B, C, D, E, F, G, H };
    add_figure_points(figure, {{4, 0, 0.4},    // A
                               {4, 4, 0.9},    // B
                               {4, 8, 0.4},    // C
                               {0, 0, 0.2},    // D
                               {0, 8, 0.2},    // E
                               {8, 0, 0.6},    // F
                               {8, 4, 0.6},    // G
                               {8, 8, 0.6}});  // H
    if (detail == 1)
        figure.face({D, A, C, E});
    else
        figure.face({D, A, B, C, E});
    figure.face({A, F, G, B});
    figure.face({B, G, H, C});
    return figure;
}

// Sphere, bumpy sphere, icosphere.

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

/// Moves a point on the unit sphere along its normal by the height of the bumps, and tilts the normal
/// accordingly. The normal of the surface r(u) u over unit u is along r u - (the part of r's gradient
/// perpendicular to u).
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

/// Splits every triangle into four at the midpoints of its edges, which neighbours share, and moves them onto
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
    // Any three vertices that are one edge length apart form a face; its winding is chosen to face outward.
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

// Torus, knot, cylinder, cone: shapes swept around an axis or along a curve.

namespace {

std::uint32_t at_least(std::uint32_t least, int detail, int divisor = 1) {
    return std::max(least, static_cast<std::uint32_t>((detail + divisor - 1) / divisor));
}

/// A point, or a normal, on a circle around the y axis: angle 0 is at +z, counter-clockwise seen from above.
glm::dvec3 around_y(const CosSin& a, double radius, double y) { return {radius * a.s, y, radius * a.c}; }

// The knot winds twice around y on a ring of radius 0.85 and three times around that ring at 0.4, which keeps
// its strands 0.8 apart; its tube of 0.25 extends to 0.85 + 0.4 + 0.25 = 1.5.
constexpr double knot_ring = 0.85, knot_coil = 0.4, knot_tube = 0.25;

/// One point of the centre line with its tangent and a vector perpendicular to the tangent, both normalized.
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
    // each facet's corner there uses the normal halfway between those at its other two corners.
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
