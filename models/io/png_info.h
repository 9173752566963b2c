#pragma once
// The data of a PNG picture other than its pixels: Glint writes a picture's scene into it (docs/formats.md).
// Uses libpng.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/problem.h"

namespace glint {

struct PngInfo {
    std::uint32_t width = 0, height = 0;
    std::vector<std::pair<std::string, std::string>> texts;  // keyword and text of each iTXt chunk

    /// The first text with that keyword; null if there is none.
    [[nodiscard]] const std::string* text(std::string_view keyword) const;
};

/// Reads the chunks before the pixels. If no text with that keyword is among them, also reads those after the
/// pixels. Returns a problem, with `file`, if the bytes are not a PNG, are damaged or truncated, or have no
/// text with the keyword, or if that text exceeds `max_bytes`.
[[nodiscard]] Result<PngInfo> png_info(std::string_view bytes, std::string_view keyword,
                                       std::size_t max_bytes, const std::string& file);

/// Like png_info(), for the file at `path`.
[[nodiscard]] Result<PngInfo> read_png_info(const std::string& path, std::string_view keyword,
                                            std::size_t max_bytes);

}  // namespace glint
