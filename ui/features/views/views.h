#pragma once
// Ways to view the picture: the row above it, tools on it, panels below it.

#include <imgui.h>

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/picture/screen.h"
#include "ui/widgets/kept.h"

namespace glint {

struct UiState;
struct WindowCommand;

// Lit dots show where the equation is evaluated: a dot at each face's point, corner or pixel, thinned
// out; its normal as a needle; and the number of evaluations per frame. Lecture: "Flat Shading", "Gouraud
// Shading", "Phong Shading".

struct LitDot {
    glm::vec3 place{0}, normal{0};  // in world coordinates
    glm::vec3 color{0};             // the result of the equation there, linear
};

/// The dots of a part of the picture.
struct PartDots {
    PartRect rect;
    std::vector<LitDot> dots;
};

struct LitDotsState {
    bool dots = false, needles = false;
    Kept<std::uint64_t, std::vector<PartDots>> found;  // dots found in the picture with this serial
    PictureSize size;  // size of that picture; smaller than the displayed size while the view moves
};

/// The points at which the equation was evaluated for the pixels within `rect` of a grid with about `across`
/// columns over the renderer's last picture. Each corner and each face's point occurs once.
[[nodiscard]] std::vector<LitDot> lit_dots(const Renderer& renderer, PictureSize size, int across,
                                           const PartRect& rect);

/// Finds the dots again when the picture has changed.
void update_lit_dots(LitDotsState& state, const std::vector<DrawnPart>& parts, PictureSize size,
                     std::uint64_t serial);

/// Describes the number of evaluations: "5321 corners × 4 lights = 21284 evaluations per frame".
[[nodiscard]] std::string evaluations_text(const Renderer& renderer, const Scene& scene);

void draw_lit_dots(ImDrawList& list, const LitDotsState& state, const PictureView& view);
/// Draws the number of evaluations (evaluations_text()) in the picture's corner, below the labels of a
/// comparison.
void draw_evaluations(ImDrawList& list, const std::string& text, bool compares);

/// Copies the command line that prints the scope's numbers to the clipboard. Precondition: a picture was
/// drawn.
void copy_profile_command(UiState& state);

/// The inputs of the shown picture apart from the drawn one; it is composed again if they change.
struct ShownFrom {
    CompareChoice compare;
    DebugViewSet debug_view;
    bool linear = false;
    bool operator==(const ShownFrom&) const = default;
    /// Whether the shown picture shows measurements instead of colours.
    [[nodiscard]] bool is_measured() const {
        return debug_view != DebugViewSet{} || (compare.on && compare.difference);
    }
};

/// The state of viewing the picture; none of it is part of the scene.
struct ViewsState {
    // The inputs of the shown picture:
    ShownFrom shown_from;
    std::uint64_t shown_serial = 0;  // UiState::picture_serial when they were recorded
};

/// Shows one quantity in place of the picture. A quantity and a comparison are mutually exclusive.
void show_quantity(UiState& state, DebugView view, bool keep_comparing = false);

/// Whether parts of a comparison or a quantity are shown in place of the scene's own picture.
[[nodiscard]] bool is_composed(const UiState& state);

// The features' commands.
[[nodiscard]] std::vector<WindowCommand> scope_commands();
[[nodiscard]] std::vector<WindowCommand> debug_view_commands();
[[nodiscard]] std::vector<WindowCommand> lit_dots_commands();
[[nodiscard]] std::vector<WindowCommand> compare_commands();
[[nodiscard]] std::vector<WindowCommand> stored_scene_commands();

}  // namespace glint
