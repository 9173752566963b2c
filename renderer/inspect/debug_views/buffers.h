#pragma once
// What lies behind every pixel, as pictures of numbers: for people who check a renderer of their own.

#include <string>
#include <vector>

#include "renderer/picture.h"
#include "renderer/renderer.h"

namespace glint {

struct PixelBuffer {
    std::string name;
    Picture picture;  // `linear` alone is filled: three numbers a pixel
};

/// The buffers of the last picture, drawn with one sample a pixel; 0 on background unless said. Camera
/// coordinates, scene units.
///   position, normal          x, y, z; under flat and gouraud of the pixel's own point, which is not lit
///   depth                     distance in front of the camera, in all three
///   face                      1 where a surface shows, its object's number, its face's number (from 0)
///   side                      1 front, -1 back, by the winding on the screen, in all three
///   emission, global_ambient  terms of the sum; under gouraud and flat blended as the colours are
///   ambient, diffuse, specular  the same, of all lights together
///   sum                       the pixel's linear colour before exposure, background too
[[nodiscard]] std::vector<PixelBuffer> pixel_buffers(const Renderer& renderer, PictureSize size);

/// The memory that the buffers take, in bytes.
[[nodiscard]] std::uint64_t buffers_memory(PictureSize size);

}  // namespace glint
