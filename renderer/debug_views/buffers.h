#pragma once
// Writes the numbers behind every pixel as pictures, for people who check their own renderer.

#include <functional>
#include <string>
#include <vector>

#include "renderer/picture.h"
#include "renderer/renderer.h"

namespace glint {

struct PixelBuffer {
    std::string name;
    Picture picture;  // only `linear` is filled: three numbers per pixel
};

/// The names of a scene's buffers, in the order in which a program computes them. Background pixels are 0
/// unless noted otherwise; camera coordinates, scene units; scalars are repeated in all three numbers.
///   face                      1 for a surface, its object's number, its face's number (from 0)
///   position, depth, normal   of the pixel's own point, which is not lit in the modes flat and gouraud;
///                             depth is the distance in front of the camera
///   side                      1 front, -1 back, by the winding on the screen
///   view                      to the eye; normalized unless corners are lit
///   l_N, n_dot_l_N            to light N of Scene::lights, normalized unless corners are lit; its
///                             cosine, not clamped; none for area lights
///   distance_N, falloff_N, cone_N  of a light with a position; for a spot, the cone's factor
///   r_N, h_N                  l mirrored at n; halfway between l and v
///   emission, global_ambient  terms of the sum (bounced: under the model `bounces`)
///   ambient_N, diffuse_N, specular_N  those of light N
///   ambient, diffuse, specular  those of all lights together
///   sum                       the pixel's linear colour before exposure, including the background
/// Disabled lights have none. If corners are lit, all buffers from `view` on are blended like colours, and
/// vectors become shorter than 1.
[[nodiscard]] std::vector<std::string> buffer_names(const Scene& scene);

/// Returns the buffers `names`, a subset of buffer_names() in the same order, of the renderer's last picture,
/// which must show `scene` with one sample per pixel.
[[nodiscard]] std::vector<PixelBuffer> pixel_buffers(const Renderer& renderer, const Scene& scene,
                                                     PictureSize size, const std::vector<std::string>& names);

/// Returns the number of buffers, out of `all`, that one pass computes. A pass explains every pixel once. It
/// is the largest of 12, the number that fits in 64 MiB, and an eighth of `all`. So there are at most eight
/// passes, and the time does not grow with the square of the number of lights.
[[nodiscard]] std::size_t buffers_at_once(PictureSize size, std::size_t all);
/// Calls visit() with the buffers `names`, a subset of buffer_names() in the same order, until it returns
/// false. Throws LimitExceeded if the buffers of one pass exceed memory_limit().
void visit_pixel_buffers(const Renderer& renderer, const Scene& scene, PictureSize size,
                         const std::vector<std::string>& names,
                         const std::function<bool(const PixelBuffer&)>& visit);
/// The memory used by `buffers` buffers, in bytes.
[[nodiscard]] std::uint64_t buffers_memory(PictureSize size, std::size_t buffers);

}  // namespace glint
