#include "models/mesh/mesh_memory.h"

#include <memory>
#include <utility>

namespace glint {
namespace {

// Bytes of a triangle, with its part of the vertices, polygons and normals. While a primitive is made its
// positions are doubles, and lists that grow are there twice. Of all primitives the cube takes most.
constexpr std::uint64_t bytes_a_triangle_to_make = 260, bytes_a_triangle_once_made = 96;
constexpr std::uint64_t bytes_of_the_smallest = 1 << 16;

template <class T> std::uint64_t bytes_of(const std::vector<T>& list) { return sizeof(T) * list.capacity(); }

std::uint64_t max_triangles(Primitive primitive, int detail) {
    return info_of(primitive).max_triangles(static_cast<std::uint64_t>(detail));
}

/// Gives the mesh's share back with the mesh.
struct Counted {
    Mesh mesh;
    MemoryShare share;
};

}  // namespace

std::uint64_t mesh_bytes(const Mesh& mesh) {
    return bytes_of(mesh.positions) + bytes_of(mesh.first_corner) + bytes_of(mesh.corner_position) +
           bytes_of(mesh.normals) + bytes_of(mesh.corner_normal) + bytes_of(mesh.colors) +
           bytes_of(mesh.triangles);
}

MeshPtr share_mesh(Mesh mesh) {
    MemoryShare share(memory_need(MemoryUse::Meshes, mesh_bytes(mesh)));
    const auto counted = std::make_shared<Counted>(Counted{std::move(mesh), std::move(share)});
    return {counted, &counted->mesh};
}

std::uint64_t bytes_to_make(Primitive primitive, int detail) {
    return bytes_a_triangle_to_make * max_triangles(primitive, detail) + bytes_of_the_smallest;
}

std::uint64_t bytes_once_made(Primitive primitive, int detail) {
    return bytes_a_triangle_once_made * max_triangles(primitive, detail) + bytes_of_the_smallest;
}

}  // namespace glint
