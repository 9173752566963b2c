#pragma once
// Mesh files: .obj .ply .off .stl -> Mesh. Every file may be hostile.

#include <string>
#include <string_view>

#include "models/mesh/mesh.h"
#include "models/problem.h"

namespace glint {

/// True for a path with one of the extensions above, ignoring case.
[[nodiscard]] bool is_mesh_path(const std::string& path);

/// Reads and finishes a mesh. Problems contain the path as given and, for text formats, the line. Errors: the
/// file cannot be read, is a directory or a device, or has no faces; an index is out of range; a word is not
/// a number or not within +-1e7; there are more than 2^31 - 1 corners. Tolerated, with one warning per kind
/// that states the count: repeated corners, weights after an OBJ vertex, lines and points, face colours, ...
///
/// .obj: v, vn, f with negative indices, colours after a position, continued lines. .ply: ASCII and both
/// binary byte orders, properties in any order; integer colours are scaled to 0 .. 1. .off: OFF, COFF, NOFF,
/// CNOFF, ASCII; integer colours range from 0 to 255 if any of them is above 1. .stl: ASCII and binary; the
/// format has no indices, so corners at exactly the same position share it (nothing is merged by distance),
/// and its facet normals are the file's normals.
[[nodiscard]] Result<Mesh> read_mesh(const std::string& path);

/// Reads a mesh from bytes in memory; `path` determines the format by its extension and is named in problems.
[[nodiscard]] Result<Mesh> parse_mesh(std::string_view bytes, const std::string& path);

}  // namespace glint
