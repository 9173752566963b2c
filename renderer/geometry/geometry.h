#pragma once
// Stage 1. Computes vertex positions in camera coordinates, in clip coordinates and on the screen. Inputs:
// mesh, transform, camera, size.

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/geometry/geometry_kernels.h"

namespace glint {

inline constexpr std::uint32_t no_triangle = 0xFFFFFFFFu;

struct ObjectGeometry {
    MeshPtr mesh;
    Transform transform;
    bool visible = true;  // false: its triangles are not drawn, but keep their numbers
    bool double_sided = false;
    // The transform contains a reflection (determinant < 0). The winding on the screen is then reversed, so
    // visibility/draw_tile.h swaps front and back. Normals need no change: the inverse transpose preserves
    // the sign of the product of normal and direction, (M^-T n)·(M d) = n·d, so outside remains outside.
    bool mirrored = false;
    std::uint32_t first_triangle = 0;  // its triangles have the global numbers first_triangle + 0, 1, 2, ...
    glm::dmat4 view_from_object{1.0}, clip_from_object{1.0};
    glm::dmat3 normal_matrix{1.0};  // inverse transpose of the upper 3 x 3 of view_from_object
    // Three indices into `vertices` for each triangle; all objects of one mesh share the list.
    std::shared_ptr<const std::vector<std::uint32_t>> vertices_of_mesh;
    std::span<const std::uint32_t> triangle_vertices;  // the contents of `vertices_of_mesh`
    std::vector<TransformedVertex> vertices;           // #V
    std::vector<ScreenVertex> screen;                  // #V

    /// A position of the mesh in camera coordinates.
    [[nodiscard]] glm::vec3 position(std::uint32_t index) const;
    /// The mean of a polygon's corners in camera coordinates.
    [[nodiscard]] glm::dvec3 centroid(std::uint32_t face) const;
};

struct Geometry {
    Camera camera;
    PictureSize size{0, 0};
    glm::dmat4 clip_from_view{1.0};
    std::vector<ObjectGeometry> objects;
    std::uint32_t triangle_count = 0;  // at most max_scene_triangles
    std::uint64_t state = 0;  // changes with every update, unique across all Geometry objects; 0: empty

    /// The object to which a global triangle number belongs.
    [[nodiscard]] std::uint32_t object_of(std::uint32_t triangle) const;
    [[nodiscard]] const Triangle& triangle(std::uint32_t object, std::uint32_t global) const {
        return objects[object].mesh->triangles[global - objects[object].first_triangle];
    }
    /// The mesh position indices of a triangle's corners, in file order.
    [[nodiscard]] std::array<std::uint32_t, 3> position_indices(std::uint32_t object,
                                                                const Triangle& t) const {
        const std::vector<std::uint32_t>& position = objects[object].mesh->corner_position;
        return {position[t.corner[0]], position[t.corner[1]], position[t.corner[2]]};
    }
};

/// Runs the stage again if its inputs have changed since the last call; returns whether they have.
/// Precondition: the scene is not too_large().
bool update_geometry(Geometry& kept, const Scene& scene, PictureSize size);

}  // namespace glint
