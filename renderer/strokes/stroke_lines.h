#pragma once
// Finds the visible pieces of edges: on the screen, inside the view, and only where no surface hides them.
//
// The visibility stage knows one surface per pixel, so an edge is tested once per pixel of its length,
// against the triangle that the nearest pixel shows. The plane of that triangle is extended to the edge, so
// that the depth of a slanted surface is compared at the edge and not half a pixel beside it. At a rim, that
// pixel may show the edge's own surface, which bulges towards the eye. But a visible rim has something
// farther away, or nothing, beside it, so it is drawn if one of the four pixels around it does not hide it.
// An edge whose facets all face away can only be seen through an opening, so the nearest pixel must show its
// own object: a pixel beyond the outline proves nothing. (Item buffers compare which face a pixel shows
// instead, and lose edges between faces that are smaller than a pixel.)

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/strokes/stroke_edges.h"
#include "renderer/visibility/visibility.h"

namespace glint {

/// Tells whether a surface that a pixel shows lies in front of a place beside that pixel.
class Occlusion {
  public:
    explicit Occlusion(const Geometry& geometry);

    /// True when the plane of a triangle (global number) lies in front of a screen position (pixels, y down)
    /// of depth inv_w (ScreenVertex) by more than half a pixel's size at that depth. The triangle may reach
    /// behind the eye; seen exactly edge-on, it hides nothing.
    [[nodiscard]] bool hides(std::uint32_t triangle, glm::dvec2 pixel, double inv_w) const;

  private:
    const Geometry& g_;
    bool orthographic_;
    double near_, far_;
    double half_pixel_;  // in scene units at distance 1 (perspective) or at every distance (orthographic)
};

/// A piece of an edge that is seen.
struct StrokeLine {
    glm::vec2 a{0}, b{0};            // pixels, y down, (0, 0) the picture's upper left corner
    float inv_w_a = 0, inv_w_b = 0;  // as in ScreenVertex; linear from a to b
    std::uint32_t object = 0;
};

/// Returns the visible pieces of the chosen edges of one object, in the order of the edges. `margin_px`: how
/// far outside the picture an edge still matters, at least 1. An edge may fall to pieces at every second
/// pixel of its length: what that takes is added to `share`.
[[nodiscard]] std::vector<StrokeLine> visible_lines(const Geometry& geometry, const Visibility& visibility,
                                                    std::uint32_t object, const MeshEdges& mesh,
                                                    std::span<const StrokeEdge> edges, double margin_px);

}  // namespace glint
