#pragma once
// Writes the numbers behind every pixel as pictures, for people who check a renderer of their own.

#include <functional>
#include <string>
#include <vector>

#include "renderer/picture.h"
#include "renderer/renderer.h"

namespace glint {

struct PixelBuffer {
    std::string name;
    Picture picture;  // `linear` alone is filled: three numbers a pixel
};

/// The names of a scene's buffers, in the order in which a program makes them. Background has 0 unless said;
/// camera coordinates, scene units; scalars stand in all three numbers.
///   face                      1 where a surface shows, its object's number, its face's number (from 0)
///   position, depth, normal   of the pixel's own point, which under flat and gouraud is not lit;
///                             depth is the distance in front of the camera
///   side                      1 front, -1 back, by the winding on the screen
///   view                      to the eye, unit but where corners are lit
///   l_N, n_dot_l_N            to light N of Scene::lights, unit but where corners are lit; its cosine, not
///                             clamped; not of area lights
///   emission, global_ambient  terms of the sum
///   ambient_N, diffuse_N, specular_N  those of light N
///   ambient, diffuse, specular  those of all lights together
///   sum                       the pixel's linear colour before exposure, background too
/// Lights that are switched off have none. From `view` on, all are blended as colours are where corners are
/// lit, and vectors become shorter than 1.
[[nodiscard]] std::vector<std::string> buffer_names(const Scene& scene);

/// Returns the buffers `names`, some of buffer_names(), of the renderer's last picture, which must show
/// `scene` with one sample a pixel, in the order of buffer_names().
[[nodiscard]] std::vector<PixelBuffer> pixel_buffers(const Renderer& renderer, const Scene& scene,
                                                     PictureSize size, const std::vector<std::string>& names);

/// Returns how many of `all` buffers are computed in one pass, which explains every pixel once: the largest
/// of 12, of as many as fit in 64 MiB, and of an eighth of `all`. So there are at most eight passes, and the
/// time does not grow with the square of the number of lights.
[[nodiscard]] std::size_t buffers_at_once(PictureSize size, std::size_t all);
/// Calls visit() with the buffers `names`, some of buffer_names() and in that order, until it returns false.
/// Throws LimitExceeded where those of one pass exceed memory_limit().
void visit_pixel_buffers(const Renderer& renderer, const Scene& scene, PictureSize size,
                         const std::vector<std::string>& names,
                         const std::function<bool(const PixelBuffer&)>& visit);
/// The memory that so many buffers take, in bytes.
[[nodiscard]] std::uint64_t buffers_memory(PictureSize size, std::size_t buffers);

}  // namespace glint
