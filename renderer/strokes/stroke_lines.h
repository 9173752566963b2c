#pragma once
// Edges as they are seen: on the screen, inside the view, and only where no surface hides them.
//
// The visibility stage knows one surface a pixel, so an edge is looked at once a pixel of its length, and
// what may hide it there is the triangle that the nearest pixel shows, carried on in its plane to the edge
// itself: so the depth of a slanted surface is compared where the edge is, not half a pixel beside it. At a
// rim that pixel may show the edge's own surface, which bulges towards the eye; but a rim that is seen is
// seen against something farther away or nothing, so one of the four pixels around it suffices to show it. An
// edge whose facets all face away is seen through an opening if at all, and must find its own object there:
// what lies beyond the outline does not show that. (Item buffers ask which face a pixel shows instead, and
// lose edges between faces that are smaller than a pixel.)

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

/// A piece of an edge that is seen.
struct StrokeLine {
    glm::vec2 a{0}, b{0};            // pixels, y down, (0, 0) the picture's upper left corner
    float inv_w_a = 0, inv_w_b = 0;  // as in ScreenVertex; linear from a to b
    std::uint32_t object = 0;
};

/// The visible pieces of the chosen edges of one object, in the order of the edges. `margin_px`: how far
/// outside the picture an edge still matters, at least 1.
[[nodiscard]] std::vector<StrokeLine> visible_lines(const Geometry& geometry, const Visibility& visibility,
                                                    std::uint32_t object, const MeshEdges& mesh,
                                                    std::span<const StrokeEdge> edges, double margin_px);

}  // namespace glint
