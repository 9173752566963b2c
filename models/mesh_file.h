#pragma once
// Mesh files: .obj .ply .off .stl .om -> Mesh. Everything is read as if a stranger had made it to hurt us.

#include <string>

#include "models/mesh.h"
#include "models/problem.h"

namespace glint {

/// True for a path with one of the extensions above, in any case.
[[nodiscard]] bool is_mesh_path(const std::string& path);

/// Reads and finishes a mesh. Problems carry the path as given and, for text formats, the line.
/// Errors: cannot be read, a directory or a device, no faces, an index out of range, a number that is none or
/// not within +-1e30, more than 2^31 - 1 corners. Tolerated with one warning a kind and its count: repeated
/// corners, weights after an OBJ vertex, lines and points, corners without a normal, ...
[[nodiscard]] Result<Mesh> read_mesh(const std::string& path);

}  // namespace glint
