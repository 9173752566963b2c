#pragma once
// Draws silhouettes and creases as strokes over the picture, with hidden lines removed. A small separate
// stage. Inputs: the geometry, the visibility, and from `npr` silhouettes, creases, crease_deg and
// stroke_width_px. The topology of the meshes is built only when strokes are first drawn.

#include <span>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"
#include "renderer/simd/vec3.h"
#include "renderer/strokes/stroke_lines.h"
#include "renderer/visibility/visibility.h"

namespace glint {

/// Wider strokes are clamped to this width, with a warning.
inline constexpr float max_stroke_width_px = 100;

struct Strokes {
    /// width x height, 0 to 1: the fraction of each pixel covered by strokes. Empty without strokes.
    std::vector<float> coverage;
    std::vector<MeshEdges> meshes;  // of each mesh of the scene, cached while the scene contains it
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
