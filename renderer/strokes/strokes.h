#pragma once
// Draws silhouettes and creases as strokes over the picture, with hidden lines removed. A small separate
// stage. Inputs: the geometry, the visibility, and from `npr` silhouettes, creases, crease_deg and
// stroke_width_px. The topology of the meshes is built only when strokes are first drawn.

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/scene/scene.h"
#include "models/scene/shading.h"
#include "renderer/geometry/geometry.h"
#include "renderer/lighting/light_job.h"
#include "renderer/simd/vec3.h"
#include "renderer/visibility/visibility.h"

namespace glint {

// Finds the visible segments of edges: inside the view, and not hidden by a surface.
//
// The visibility stage stores one surface per pixel, so an edge is tested once per pixel of its length,
// against the triangle visible at the nearest pixel. The plane of that triangle is extended to the edge, so
// the depth of a slanted surface is compared at the edge and not half a pixel away. At a rim, the nearest
// pixel may show the edge's own surface, which bulges towards the eye. But next to a visible rim there is a
// more distant surface or the background, so the edge is drawn if at least one of the four pixels around it
// does not hide it. An edge whose facets all face away is visible only through an opening, so the nearest
// pixel must show its own object: a pixel beyond the outline proves nothing. (Item buffers instead compare
// which face a pixel shows, and lose edges between faces smaller than a pixel.)

// Selects the edges of a mesh that are drawn as strokes. Lecture: "Non-photorealistic shading: silhouettes
// and creases".
//
// Silhouette: (e.n0)(e.n1) <= 0, with e from the edge to the eye, and n0 and n1 the normals of its two
// facets: one facet is front-facing and the other is not. Crease: n0.n1 <= cos(crease_deg). An edge of
// exactly that angle is a crease here, although averaged normals (models/mesh/normals.h) still join across
// it.

/// The edges and facet normals of a mesh, computed once.
struct MeshEdges {
    MeshPtr mesh;
    Topology topology;
    std::vector<glm::dvec3> facet_normals;  // #F, object coordinates, normalized; (0, 0, 0) without an area
};
[[nodiscard]] MeshEdges mesh_edges(MeshPtr mesh);

/// The view for which edges are selected.
struct EdgeView {
    // Object coordinates: w = 1: position of the eye, w = 0: direction towards it.
    glm::dvec4 eye{0, 0, 0, 1};
    // Inverse transpose of the transform to the frame in which creases are measured.
    glm::dmat3 normal_matrix{1.0};
};

struct EdgeChoice {
    bool silhouettes = false, creases = false;
    float crease_deg = 40;  // 0 to 180
    Cull cull = Cull::None;
    bool operator==(const EdgeChoice&) const = default;
};

/// The orientation of the surface at an edge.
enum class EdgeFacing {
    Towards,  // all adjacent facets are front-facing
    Away,     // all are back-facing
    Rim       // some face each way, or there is one facet: at most one side of the edge shows the surface
};

struct StrokeEdge {
    std::uint32_t edge = 0;  // index into Topology::edges
    EdgeFacing facing = EdgeFacing::Rim;
};

/// Returns the edges to draw, in ascending order. Silhouettes include all boundary edges. An edge shared by
/// three or more facets is drawn if any two of them qualify (for creases, of the first 256). A facet seen
/// exactly edge-on qualifies with every other facet. A polygon without area does not count as a facet, but an
/// edge that it shares with a facet is not a boundary. Omits edges whose facets are all culled. Supports all
/// non-singular transforms, including reflections.
[[nodiscard]] std::vector<StrokeEdge> stroke_edges(const MeshEdges& edges, const EdgeView& view,
                                                   const EdgeChoice& choice);

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

/// Wider strokes are clamped to this width, with a warning.
inline constexpr float max_stroke_width_px = 100;

struct Strokes {
    /// width x height, 0 to 1: the fraction of each pixel covered by strokes. Empty without strokes.
    std::vector<float> coverage;
    std::vector<MeshEdges> meshes;  // one per mesh in the scene, cached while the scene contains it
    // The other inputs of the cached coverage, apart from geometry and visibility.
    EdgeChoice choice;
    float width_px = 0;

    [[nodiscard]] float coverage_at(std::size_t pixel) const {
        return coverage.empty() ? 0 : coverage[pixel];
    }
};

/// Runs the stage again if any of its inputs has changed; returns whether it did. `visibility_redone`:
/// whether that stage has run again, as it does whenever the geometry changes.
bool update_strokes(Strokes& kept, const Scene& scene, const Geometry& geometry, const Visibility& visibility,
                    bool visibility_redone);

/// Draws the strokes over the shaded colours of 16 consecutive pixels, starting at `first_pixel`, for those
/// whose bit is set in `mask`. Returns whether there was anything to draw.
bool draw_over(const Strokes& strokes, const glm::vec3& stroke, std::size_t first_pixel, std::uint16_t mask,
               ColorBlock& colors);

// Computes the fraction of each pixel that is covered by lines.

/// The fraction of a pixel covered by a stroke of `width_px` whose centre line is `distance_px` from the
/// pixel's centre. Exact for a straight stroke along rows or columns, including widths below a pixel.
[[nodiscard]] float stroke_share(float distance_px, float width_px);

}  // namespace glint

namespace glint::inline GLINT_ISA {

// Blends strokes over the shaded picture: the last step of a pixel's sum, in linear light, before exposure
// and transfer.

/// Blends the stroke over the shaded colour. `coverage`, 0 to 1: the fraction of the pixel covered by the
/// stroke; at 1 it replaces the colour completely.
template <Number F> Vec3<F> drawn_over(Vec3<F> shaded, F coverage, Vec3<F> stroke) {
    return select<F>(coverage >= F(1), stroke, (F(1) - coverage) * shaded + coverage * stroke);
}

}  // namespace glint::inline GLINT_ISA
