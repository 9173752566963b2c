#pragma once
// A pen to draw over the picture with, as on a blackboard. Strokes are kept apart from the scene and the
// saved picture.

#include <imgui.h>

#include <glm/vec2.hpp>
#include <vector>

#include "ui/picture/screen.h"

namespace glint {

/// A line of the pen. Places count from the picture's middle, in its heights, so that a line stays on what it
/// was drawn on when the window changes.
struct PenLine {
    std::vector<glm::vec2> places;
    int colour = 0;  // of pen_colours
    bool operator==(const PenLine&) const = default;
};

struct PenState {
    bool on = false;
    int colour = 0;
    std::vector<PenLine> lines;
};

inline constexpr int pen_colour_count = 5;
[[nodiscard]] ImVec4 pen_colour(int index);

void draw_pen(ImDrawList& list, const PenState& pen, const PictureView& view);

/// Draws the pen's colours, the way back and the sponge, at the picture's upper edge, while the pen is in
/// hand.
void pen_bar(PenState& pen, const PictureView& view);

}  // namespace glint
