#pragma once
// Stage 1. Vertex positions in camera and clip coordinates and on the screen; triangles clipped where they
// must be and sorted into tiles. Inputs: mesh, transform, camera, size.

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <vector>

#include "models/scene.h"
#include "renderer/pipeline/kernels/drawing_kernels.h"

namespace glint {

inline constexpr std::uint32_t no_triangle = 0xFFFFFFFFu;

struct ObjectGeometry {
    MeshPtr mesh;
    Transform transform;
    bool mirrored = false;  // the transform turns the winding over; facets stay outward all the same
    std::uint32_t first_triangle = 0;  // its triangles have the global numbers first_triangle + 0, 1, 2, ...
    glm::dmat4 view_from_object{1.0};
    glm::dmat3 normal_matrix{1.0};                 // inverse transpose of its upper 3 x 3
    std::vector<std::uint32_t> triangle_vertices;  // three a triangle, indices into vertices
    std::vector<PlacedVertex> vertices;            // #V
    std::vector<ScreenVertex> screen;              // #V

    /// A position of the mesh in camera coordinates.
    [[nodiscard]] glm::vec3 place(std::uint32_t position) const {
        const PlacedVertex& v = vertices[position];
        return {v.x, v.y, v.z};
    }
};

/// Neighbouring triangles of one object, which one task sorts.
struct SortedChunk {
    std::uint32_t object = 0, begin = 0, end = 0;  // triangles, numbers within the object
    SortJob job;
    std::vector<TriangleBox> boxes;      // box_count, of those that may be seen, rising
    std::vector<std::uint32_t> to_clip;  // clip_count numbers within the object, rising
    std::size_t box_count = 0, clip_count = 0;
    std::vector<std::uint32_t>
        next;  // #tiles: where in tile_triangles its next number goes (first: how many)
};

struct Geometry {
    Camera camera;
    PictureSize size{0, 0};
    bool multisampled = false;  // tiles then hold what any sample of their pixels may see
    std::vector<ObjectGeometry> objects;
    std::uint32_t triangle_count = 0;
    std::vector<SortedChunk> chunks;              // of all triangles, in rising order
    std::vector<std::uint32_t> clipped_vertices;  // three a piece: to sorting they are one more object
    std::vector<ClippedTriangle> clipped;  // numbered triangle_count, triangle_count + 1, ... in the tiles
    int tiles_x = 0, tiles_y = 0;
    std::vector<std::uint32_t> tile_first;  // #tiles + 1, into tile_triangles
    std::vector<TileEntry> tile_triangles;

    /// The object that a global triangle number belongs to.
    [[nodiscard]] std::uint32_t object_of(std::uint32_t triangle) const;
    [[nodiscard]] const Triangle& triangle(std::uint32_t object, std::uint32_t global) const {
        return objects[object].mesh->triangles[global - objects[object].first_triangle];
    }
    /// Indices into the mesh's positions of a triangle's corners, in the file's order.
    [[nodiscard]] std::array<std::uint32_t, 3> position_indices(std::uint32_t object,
                                                                const Triangle& t) const {
        const std::vector<std::uint32_t>& position = objects[object].mesh->corner_position;
        return {position[t.corner[0]], position[t.corner[1]], position[t.corner[2]]};
    }
};

/// Does again what differs from what `kept` was made of; true when anything did.
bool update_geometry(Geometry& kept, const Scene& scene, PictureSize size, bool multisampled);

}  // namespace glint
