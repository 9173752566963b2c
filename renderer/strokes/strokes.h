#pragma once
// Silhouettes and creases as strokes over the picture, hidden lines removed: a small stage of its own beside
// surface and lighting. Inputs: the geometry, the visibility, and of `npr` silhouettes, creases, crease_deg
// and stroke_width_px. Nothing of the meshes' topology is built until the first stroke is asked for.

#include <vector>

#include "models/scene/scene.h"
#include "renderer/lighting/light_job.h"
#include "renderer/strokes/stroke_edges.h"
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

/// Does the stage again when anything it reads differs; true when it did. `visibility_redone`: whether that
/// stage was (it is whenever the geometry was).
bool update_strokes(Strokes& kept, const Scene& scene, const Geometry& geometry, const Visibility& visibility,
                    bool visibility_redone);

/// Draws the strokes over the shaded colours of those of 16 pixels, `first_pixel` and the next ones, whose
/// bit is set in `mask`; true when there was anything to draw.
bool draw_over(const Strokes& strokes, const glm::vec3& stroke, std::size_t first_pixel, std::uint16_t mask,
               ColorBlock& colors);

}  // namespace glint
