#pragma once
// Counts the memory of meshes against the limit (models/memory_limit.h).

#include <cstdint>

#include "models/memory_limit.h"
#include "models/mesh/mesh.h"
#include "models/primitives/primitives.h"

namespace glint {

/// Bytes that a mesh holds.
[[nodiscard]] std::uint64_t mesh_bytes(const Mesh& mesh);

/// Makes the mesh shared, and counts its memory as long as anybody holds it. Throws Refused.
[[nodiscard]] MeshPtr share_mesh(Mesh mesh);

/// Upper bounds of the bytes that make_primitive() holds at any one time, and that the finished mesh holds.
[[nodiscard]] std::uint64_t bytes_to_make(Primitive primitive, int detail);
[[nodiscard]] std::uint64_t bytes_once_made(Primitive primitive, int detail);

}  // namespace glint
