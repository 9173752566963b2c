#pragma once
// The kernels' ways of a vertex to the screen, for one vertex alone: those of triangles and of clipped pieces
// go the same way, so that no crack opens between them.

#include <glm/mat4x4.hpp>

#include "models/camera.h"
#include "renderer/pipeline/kernels/way_to_screen.h"

namespace glint {

[[nodiscard]] inline Matrix4 matrix_of(const glm::dmat4& m) {
    Matrix4 out;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) out.column[c][r] = m[c][r];
    return out;
}

[[nodiscard]] inline ScreenJob screen_job(const Camera& camera, PictureSize size) {
    return {static_cast<double>(size.width), static_cast<double>(size.height),
            is_orthographic(camera.projection)};
}

/// Precondition: inside the guard band and before the eye.
[[nodiscard]] inline ScreenVertex to_screen(const ScreenJob& screen, const glm::dvec4& clip) {
    const GridPoint<double> at = grid_point(screen, Point4<double>{clip.x, clip.y, clip.z, clip.w});
    return {static_cast<std::int32_t>(nearest(at.x)), static_cast<std::int32_t>(nearest(at.y)),
            static_cast<float>(at.nearness)};
}

}  // namespace glint
