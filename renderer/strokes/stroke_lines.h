#pragma once
// Finds the visible segments of edges: inside the view, and not hidden by a surface.
//
// The visibility stage stores one surface per pixel, so an edge is tested once per pixel of its length,
// against the triangle visible at the nearest pixel. The plane of that triangle is extended to the edge, so
// that the depth of a slanted surface is compared at the edge and not half a pixel away. At a rim, the
// nearest pixel may show the edge's own surface, which bulges towards the eye. But next to a visible rim
// there is a more distant surface or the background, so the edge is drawn if at least one of the four pixels
// around it does not hide it. An edge whose facets all face away is visible only through an opening, so the
// nearest pixel must show its own object: a pixel beyond the outline does not prove anything. (Item buffers
// instead compare which face a pixel shows, and lose edges between faces smaller than a pixel.)

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/strokes/stroke_edges.h"
#include "renderer/visibility/visibility.h"

namespace glint {

/// Tests whether the surface visible at a pixel is in front of a position near that pixel.
class Occlusion {
  public:
    explicit Occlusion(const Geometry& geometry);

    /// True if the plane of a triangle (global number) is in front of a screen position (pixels, y down) of
    /// depth inv_w (ScreenVertex) by more than half a pixel's size at that depth. The triangle may extend
    /// behind the eye. A triangle seen exactly edge-on hides nothing.
    [[nodiscard]] bool hides(std::uint32_t triangle, glm::dvec2 pixel, double inv_w) const;

  private:
    const Geometry& g_;
    bool orthographic_;
    double near_, far_;
    double half_pixel_;  // in scene units: at distance 1 (perspective), or at every distance (orthographic)
};

/// A visible segment of an edge.
struct StrokeLine {
    glm::vec2 a{0}, b{0};            // pixels, y down, with (0, 0) at the picture's upper left corner
    float inv_w_a = 0, inv_w_b = 0;  // as in ScreenVertex; linear from a to b
    std::uint32_t object = 0;
};

/// Returns the visible segments of the selected edges of one object, in the order of the edges. `margin_px`:
/// the distance outside the picture within which edges matter, at least 1. An edge may be split at every
/// second pixel of its length.
[[nodiscard]] std::vector<StrokeLine> visible_lines(const Geometry& geometry, const Visibility& visibility,
                                                    std::uint32_t object, const MeshEdges& mesh,
                                                    std::span<const StrokeEdge> edges, double margin_px);

}  // namespace glint
