#pragma once
// The text that a PNG picture carries: Glint writes the scene of a picture into it (docs/interface.md).
// Source: PNG Specification (Second Edition), sections 5 "Datastream structure" and 11.3.4.5 "iTXt".

#include <optional>
#include <string>
#include <string_view>

#include "models/problem.h"

namespace glint {

/// What is wrong with a file that begins with `bytes`, and so is not a PNG; nothing when it may be one.
[[nodiscard]] std::optional<Problem> why_no_png(std::string_view bytes, const std::string& file);

/// Text of the first iTXt chunk with that keyword, compressed or not, wherever it stands. Problems, with
/// `file`: no PNG, a chunk that is cut off or whose checksum is wrong, no such chunk, more than `max_bytes`
/// of text.
[[nodiscard]] Result<std::string> png_text(std::string_view bytes, std::string_view keyword,
                                           std::size_t max_bytes, const std::string& file);

/// Whether the file is a PNG with an iTXt chunk of that keyword, whatever is in it; reads the beginnings of
/// chunks alone, so that it takes no time. False for what cannot be read, is not a file, or ends too early.
[[nodiscard]] bool has_png_text(const std::string& path, std::string_view keyword);

}  // namespace glint
