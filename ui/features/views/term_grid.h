#pragma once
// The grid of light by term shows every term of every light as a small picture of its own. Their sum is the
// picture. Lecture: "Phong Lighting Model" (the sum over lights).

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/renderer.h"
#include "ui/features/inspector/blocks_in_sight.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

struct UiState;
struct PictureView;

/// One addend: a light's ambient (0), diffuse (1) or specular (2) term; or without a light (-1) the emission
/// (0) or the global ambient (1).
struct GridCell {
    int light = -1, term = 0;
    bool operator==(const GridCell&) const = default;
};

/// The cells of a scene, row by row: first those without a light.
[[nodiscard]] std::vector<GridCell> grid_cells(const Scene& scene);

/// The scene with these addends alone. The linear pictures of all cells add up to the scene's, on surfaces
/// and without cool-to-warm shading or a clamp of each light.
[[nodiscard]] Scene with_cells(const Scene& scene, const std::vector<GridCell>& shown);

/// Returns by how much a term is brightened so that it can be seen: a power of 2, at most 16, with which only
/// the brightest twentieth of its lit pixels may exceed 1. 0 if the term adds nothing anywhere. `drawn`: its
/// picture, with Picture::linear; background does not count.
[[nodiscard]] int gain_of(const Renderer& drawn_by, const Picture& drawn, float exposure);
/// Returns the scene with its surfaces `gain` times as bright, and the background as it is.
[[nodiscard]] Scene brightened(Scene scene, int gain);

struct TermGridState {
    std::optional<GridCell> solo;
    std::vector<GridCell> muted;
    PictureSheet sheet;      // three pictures a row, drawn while the hand rests
    std::vector<int> gains;  // of the cells that are drawn: how often brighter than it is each is shown
    std::optional<Scene> drawn_of;
    std::size_t next = 0;  // cell to draw; #cells: all are drawn
    std::unique_ptr<Renderer> renderer;
    BlocksInSight rows{5};
};

/// Draws the next few small pictures when the scene's are not drawn yet. `size`: of the large picture.
void update_term_grid(TermGridState& grid, const Scene& scene, PictureSize size);

void term_grid_tab(UiState& state, const PictureView& view);

}  // namespace glint
