#pragma once
// Which pixels of a scene's picture another program must have drawn equally, however it draws edges.

#include <cstdint>
#include <vector>

#include "renderer/renderer.h"

namespace glint {

enum class PixelKind : std::uint8_t {
    Background,  // and so do its eight neighbours
    Edge,        // a silhouette, a crease, a neighbour of these, or what a stroke covers, however wide
    Surface      // it and its neighbours show one surface
};

/// For each pixel of the renderer's last picture, drawn with one sample, what it is.
[[nodiscard]] std::vector<PixelKind> pixel_kinds(const Renderer& renderer, PictureSize size);

/// For each pixel of a picture 1 where it shows no surface; empty where these pixels are those of the right
/// picture.
using BareMask = std::vector<std::uint8_t>;

/// Makes the masks of the pictures that one renderer draws. Call of() after each picture.
class BareMasks {
  public:
    /// Returns the mask of the renderer's last picture. The first picture is the right one.
    [[nodiscard]] BareMask of(const Renderer& renderer, PictureSize size);

  private:
    BareMask right_, last_;
};

}  // namespace glint
