#pragma once
// Pictures to and from bytes (models/file.h writes them): PNG (8 bit, carrying its scene in a text chunk), PFM (linear float).

#include <string>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

/// The keyword of the PNG text chunk (iTXt, UTF-8) that holds the scene's JSON.
inline constexpr const char* scene_chunk_keyword = "glint-scene";

/// PNG bytes of `rgba`; `scene_json` goes into a text chunk unless empty. Same input, same bytes.
[[nodiscard]] std::string png_bytes(const Picture& picture, const std::string& scene_json);

/// PFM bytes: "PF", little-endian (scale -1.0), bottom row first, `linear` times `exposure`.
/// Precondition: picture.linear is filled. Source: formulas, "Colour and files"; Debevec's PFM.
[[nodiscard]] std::string pfm_bytes(const Picture& picture, float exposure);

/// Reads an 8-bit or 16-bit PNG of any colour type as 8-bit RGBA.
[[nodiscard]] Result<Picture> read_png(const std::string& path);

}  // namespace glint
