#pragma once
// A picture by another program, drawn through the camera of a scene, mapped to the window's picture of it,
// which may have another size and shape.

#include <glm/vec2.hpp>
#include <optional>

#include "models/scene/scene.h"
#include "renderer/picture.h"

namespace glint {

/// Maps the pixels of one picture to those of another from the same camera: `scale` times the position, plus
/// `offset`, in pixels of the other.
struct PixelsBetween {
    glm::dvec2 scale{1}, offset{0};

    [[nodiscard]] glm::dvec2 operator()(glm::dvec2 place) const { return scale * place + offset; }
};
[[nodiscard]] PixelsBetween pixels_between(const Camera& camera, PictureSize from, PictureSize to);

/// The pixel of the other picture that contains a pixel's centre; nothing outside it.
[[nodiscard]] std::optional<glm::ivec2> pixel_in(const PixelsBetween& between, glm::ivec2 pixel,
                                                 PictureSize to);

/// Returns `picture` (bytes) at the size of `shown`, a picture of `scene`: each pixel is taken from the same
/// position. Pixels outside `picture` are grey, or taken from `shown` if `fills`. Linear colours are computed
/// from the bytes if `shown` has them.
[[nodiscard]] Picture fitted_picture(const Picture& picture, const Scene& scene, const Picture& shown,
                                     bool fills);

}  // namespace glint
