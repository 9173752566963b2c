// Cube, plane, and the two figures of the lecture's interpolation slides.
#include <array>
#include <glm/vec2.hpp>

#include "models/mesh/primitives/primitive_builder.h"
#include "models/mesh/primitives/primitives.h"

namespace glint {
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

/// Points in x, y, facing +z, with grey levels.
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

}  // namespace glint
