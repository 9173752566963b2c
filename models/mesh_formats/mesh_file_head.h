#pragma once
// What tells early, while a mesh file is being read, that no mesh will come of it. Inside models/ only.

#include <string_view>

#include "models/io/file.h"

namespace glint {

/// True where the first block of a file cannot begin one of the format with that extension (".obj", lower
/// case); its reader then fails in that block already.
[[nodiscard]] bool begins_badly(std::string_view extension, const FileBlock& first);

/// Whether all of a file that begins so is text.
[[nodiscard]] bool is_text_mesh(std::string_view extension, const FileBlock& first);

/// Whether the block holds nothing but zero bytes, as the holes of a file do, and more than a line of text
/// might.
[[nodiscard]] bool is_hole(const FileBlock& block);

}  // namespace glint
