#pragma once
// Which pixels of a scene's picture another program must have drawn alike, whatever it does at edges.

#include <cstdint>
#include <vector>

#include "renderer/renderer.h"

namespace glint {

enum class PixelKind : std::uint8_t {
    Background,  // and so do its eight neighbours
    Edge,        // a silhouette, a crease, a stroke's neighbourhood, or a neighbour of these
    Surface      // it and its neighbours show one surface
};

/// For each pixel of the renderer's last picture, drawn with one sample, what it is.
[[nodiscard]] std::vector<PixelKind> pixel_kinds(const Renderer& renderer, PictureSize size);

/// For each pixel of the renderer's last picture 1 where it shows no surface; empty where the picture shows
/// the same faces as the one before.
using BareMask = std::vector<std::uint8_t>;
[[nodiscard]] BareMask bare_mask(const Renderer& renderer, PictureSize size);

}  // namespace glint
