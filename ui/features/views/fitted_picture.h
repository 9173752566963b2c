#pragma once
// A picture that another program drew through the camera of a scene, laid over the picture that the window
// shows of it, which may have another size and shape.

#include <glm/vec2.hpp>
#include <optional>

#include "models/scene/scene.h"
#include "renderer/picture.h"

namespace glint {

/// Maps the pixels of one picture to those of another that the same camera sees: `scale` times the position,
/// plus `offset`, in pixels of the other.
struct PixelsBetween {
    glm::dvec2 scale{1}, offset{0};

    [[nodiscard]] glm::dvec2 operator()(glm::dvec2 place) const { return scale * place + offset; }
};
[[nodiscard]] PixelsBetween pixels_between(const Camera& camera, PictureSize from, PictureSize to);

/// The pixel of the other picture in which the middle of a pixel lies; nothing outside of it.
[[nodiscard]] std::optional<glm::ivec2> pixel_in(const PixelsBetween& between, glm::ivec2 pixel,
                                                 PictureSize to);

/// Returns `picture` (bytes) at the size of `shown`, a picture of `scene`: each pixel is the one that lies
/// there. What `picture` does not reach is grey, or taken from `shown` if `fills`. Linear colours are made
/// from the bytes if `shown` has them.
[[nodiscard]] Picture fitted_picture(const Picture& picture, const Scene& scene, const Picture& shown,
                                     bool fills);

}  // namespace glint
