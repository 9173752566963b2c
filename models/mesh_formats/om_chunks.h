#pragma once
// The structure of an .om file, measured before OpenMesh reads it: its reader trusts every count and size.
// Inside models/ only. Source: OpenMesh documentation, "The OM file format"; OpenMesh/Core/IO/OMFormat.hh.

#include <string>
#include <string_view>

#include "models/problem.h"

namespace glint {

/// A file of the same mesh that holds only the chunks that make it up (places, normals, colours, faces), each
/// once and whole. Indices in them may still be wrong. Throws Unreadable.
[[nodiscard]] std::string sound_om_chunks(std::string_view bytes, const std::string& file,
                                          Warnings& warnings);

}  // namespace glint
