#pragma once
// The light-by-term grid shows every term of every light as a thumbnail. Their sum is the picture.
// Lecture: "Phong Lighting Model" (the sum over lights).

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/renderer.h"
#include "ui/features/inspector/inspector.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

struct UiState;
struct PictureView;

/// One addend: a light's ambient (0), diffuse (1) or specular (2) term; or, without a light (-1), the
/// emission (0) or the global ambient term (1).
struct GridCell {
    int light = -1, term = 0;
    bool operator==(const GridCell&) const = default;
};

/// The cells of a scene, row by row: first those without a light.
[[nodiscard]] std::vector<GridCell> grid_cells(const Scene& scene);

/// The scene with only these addends. The linear pictures of all cells add up to the scene's picture on
/// surfaces, unless cool-to-warm shading or clamping of each light is on.
[[nodiscard]] Scene with_cells(const Scene& scene, const std::vector<GridCell>& shown);

/// Returns the brightening factor that makes a term visible: a power of 2, at most 16, with which only
/// the brightest twentieth of the term's lit pixels may exceed 1. 0 if the term contributes nothing. `drawn`:
/// its picture, with Picture::linear; background does not count.
[[nodiscard]] int gain_of(const Renderer& drawn_by, const Picture& drawn, float exposure);
/// Returns the scene with its surfaces `gain` times as bright, and the background unchanged.
[[nodiscard]] Scene brightened(Scene scene, int gain);

struct TermGridState {
    std::optional<GridCell> solo;
    std::vector<GridCell> muted;
    PictureSheet sheet;      // three pictures per row, drawn while the mouse is idle
    std::vector<int> gains;  // brightening factors of the drawn cells
    std::optional<Scene> drawn_of;
    std::size_t next = 0;  // index of the next cell to draw; the number of cells once all are drawn
    std::unique_ptr<Renderer> renderer;
    BlocksInSight rows{5};
};

void term_grid_tab(UiState& state, const PictureView& view);

}  // namespace glint
