#include "models/mesh/mesh_memory.h"

#include <memory>
#include <utility>

namespace glint {
namespace {

// Bytes of a triangle, with its part of the vertices, polygons and normals. While a primitive is made its
// places are doubles, and lists that grow are there twice. Of all primitives the cube needs most.
constexpr std::uint64_t bytes_a_triangle_to_make = 260, bytes_a_triangle_once_made = 96;
constexpr std::uint64_t bytes_of_the_smallest = 1 << 16;

template <class T> std::uint64_t bytes_of(const std::vector<T>& list) { return sizeof(T) * list.capacity(); }

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

std::uint64_t most_triangles(Primitive primitive, int detail) {
    const auto d = static_cast<std::uint64_t>(detail);
    constexpr std::uint64_t of_the_coarsest = 64;  // what is cut more finely than asked for, to be a solid
    switch (primitive) {
    case Primitive::Sphere:
    case Primitive::BumpySphere:
    case Primitive::Torus:
        return d * d + of_the_coarsest;
    case Primitive::Icosphere:
        return std::uint64_t{20} << 2 * d;
    case Primitive::Cube:
        return 12 * d * d;
    case Primitive::Plane:
    case Primitive::TessellatedQuad:
        return 2 * d * d;
    case Primitive::Cylinder:
        return 4 * d + of_the_coarsest;
    case Primitive::Cone:
        return 2 * d + of_the_coarsest;
    case Primitive::Teapot:
        return 64 * d * d + 4 * of_the_coarsest;
    case Primitive::Knot:
        return d * d / 4 + 2 * of_the_coarsest;
    case Primitive::SkewQuad:
    case Primitive::TJunction:
        return of_the_coarsest;
    }
    return 0;  // not reached
}

std::uint64_t bytes_to_make(Primitive primitive, int detail) {
    return bytes_a_triangle_to_make * most_triangles(primitive, detail) + bytes_of_the_smallest;
}

std::uint64_t bytes_once_made(Primitive primitive, int detail) {
    return bytes_a_triangle_once_made * most_triangles(primitive, detail) + bytes_of_the_smallest;
}

}  // namespace glint
