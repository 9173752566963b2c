#pragma once
// Silhouettes and creases as strokes over the picture, hidden lines removed: a small stage of its own beside
// surface and lighting. Inputs: the geometry, the visibility, and of `npr` silhouettes, creases, crease_deg
// and stroke_width_px. Nothing of the meshes' topology is built until the first stroke is asked for.

#include <span>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"
#include "renderer/simd/vec3.h"
#include "renderer/strokes/stroke_edges.h"
#include "renderer/strokes/stroke_lines.h"
#include "renderer/visibility/visibility.h"

namespace glint {

/// A wider stroke is drawn this wide, with a warning.
inline constexpr float max_stroke_width_px = 100;

struct Strokes {
    /// width x height, 0 to 1: the share that strokes hide; empty without strokes.
    std::vector<float> coverage;
    std::vector<MeshEdges> meshes;  // of the scene's meshes, each once; kept while the scene has them
    // What the kept coverage was made of, beside geometry and visibility.
    EdgeChoice choice;
    float width_px = 0;

    [[nodiscard]] float coverage_at(std::size_t pixel) const {
        return coverage.empty() ? 0 : coverage[pixel];
    }
};

/// Runs the stage again if anything it reads differs; returns whether it did. `visibility_redone`: whether
/// that stage was run again, as it is whenever the geometry was.
bool update_strokes(Strokes& kept, const Scene& scene, const Geometry& geometry, const Visibility& visibility,
                    bool visibility_redone);

/// Draws the strokes over the shaded colours of those of 16 pixels, `first_pixel` and the next ones, whose
/// bit is set in `mask`; true when there was anything to draw.
bool draw_over(const Strokes& strokes, const glm::vec3& stroke, std::size_t first_pixel, std::uint16_t mask,
               ColorBlock& colors);

// Lines to the share of each pixel that they cover.

/// Share of a pixel that a stroke of `width_px` covers when the pixel's centre lies `distance_px` from the
/// stroke's middle: exact for a straight stroke along rows or columns, width below a pixel included.
[[nodiscard]] float stroke_share(float distance_px, float width_px);

}  // namespace glint

namespace glint::inline GLINT_ISA {

// A stroke drawn over the shaded picture: the last step of a pixel's sum, in linear light, before exposure
// and transfer.

/// Blends the stroke over the shaded colour. `coverage`, 0 to 1: the share of the pixel that the stroke
/// hides; at 1 it hides all of it, however bright.
template <Number F> Vec3<F> drawn_over(Vec3<F> shaded, F coverage, Vec3<F> stroke) {
    return select<F>(coverage >= F(1), stroke, (F(1) - coverage) * shaded + coverage * stroke);
}

}  // namespace glint::inline GLINT_ISA
