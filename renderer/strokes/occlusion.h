#pragma once
// Whether a surface that a pixel shows lies in front of a place beside that pixel.

#include <glm/vec2.hpp>

#include "renderer/geometry/geometry.h"

namespace glint {

class Occlusion {
  public:
    explicit Occlusion(const Geometry& geometry);

    /// True when the plane of a triangle (global number) lies in front of a place on the screen (pixels, y
    /// down) of the given inv_w (ScreenVertex), by more than half of what a pixel measures at that depth.
    /// The triangle may reach behind the eye. Seen exactly from its side it hides nothing.
    [[nodiscard]] bool hides(std::uint32_t triangle, glm::dvec2 pixel, double inv_w) const;

  private:
    const Geometry& g_;
    bool orthographic_;
    double near_, far_;
    double half_pixel_;  // in scene units at distance 1 (perspective) or at every distance (orthographic)
};

}  // namespace glint
