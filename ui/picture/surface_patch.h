#pragma once
// The surface in a few pixels round a centre, and the slope of a quantity there.

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "renderer/renderer.h"
#include "ui/picture/screen.h"

namespace glint {

/// The surfaces of a picture, seen by its camera. The renderer's last picture must show the scene through
/// `map`.
struct SurfaceView {
    const Scene& scene;
    const Renderer& renderer;
    const ScreenMap& map;
    const Dome& dome;
};

/// Returns the surface point at a position in the last picture, which must have this size; nullopt outside
/// the picture or on the background.
[[nodiscard]] std::optional<SeenPoint> seen_at(const Renderer& renderer, PictureSize size, glm::dvec2 pixel);

/// A square of 2 radius + 1 pixels per side, row by row. Pixels that do not show the same surface as the
/// centre (another object, a part farther away, the far side of a crease) are not used; in `points` the
/// centre replaces them.
struct SurfacePatch {
    int radius = 0;
    std::vector<SeenPoint> points;
    std::vector<bool> used;

    [[nodiscard]] const SeenPoint& middle() const { return points[points.size() / 2]; }
    /// The offset from the centre, in pixels.
    [[nodiscard]] glm::dvec2 offset(std::size_t i) const;
    /// Gradient at the centre of ln(values), per pixel, from pairs of opposite pixels up to `within` pixels
    /// across or up, so that curvature cancels. 0 if undefined. Values of 0 are not used.
    [[nodiscard]] glm::dvec2 slope_of_log(const std::vector<double>& values, int within) const;
    /// Length of the gradient at the centre of a patch of radius 1, per pixel; 0 if undefined.
    [[nodiscard]] double steepness(const std::function<double(const SeenPoint&)>& value) const;
    /// Distance of the largest value from the centre, in pixels; among equal values, the nearest counts.
    /// `radius` + 1 if the centre is 0.
    [[nodiscard]] double distance_of_maximum(const std::vector<double>& values) const;
};

/// Returns the patch round a pixel; nullopt on the background.
[[nodiscard]] std::optional<SurfacePatch> surface_patch(const Renderer& renderer, PictureSize size,
                                                        glm::dvec2 pixel, int radius);

}  // namespace glint
