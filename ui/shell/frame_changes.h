#pragma once
// What of the window a frame draws otherwise than the one before. The rest is still there and need not be
// drawn again: in software, panels full of text take longer than the picture.

#include <imgui.h>

#include <vector>

#include "ui/widgets/area.h"

namespace glint {

/// A copy of what ImGui draws for one window: it uses its own again in the next frame.
struct DrawnList {
    std::vector<ImDrawCmd> commands;
    std::vector<ImDrawIdx> indices;
    std::vector<ImDrawVert> vertices;
};

/// Compares what ImGui draws in this frame to what it drew in the last.
class FrameChanges {
  public:
    /// Rects in ImGui's units, none of them empty and none overlapping another, that hold every pixel which
    /// `data` draws otherwise than the data of the call before; none when nothing changed, the whole display
    /// at the first call and when its size changed. Textures are compared by name: what is in them is not
    /// seen.
    [[nodiscard]] std::vector<Rect> update(const ImDrawData& data);

  private:
    std::vector<DrawnList> before_;
    ImVec2 size_{-1, -1};
};

/// Adds a rect to those that do not overlap: those that it touches become one with it, and at most
/// `max_changed_rects` stay.
void add_rect(std::vector<Rect>& rects, Rect rect);

/// Each rect is drawn by itself, and looks at all that is drawn: a few large ones cost less than many small.
inline constexpr std::size_t max_changed_rects = 4;

}  // namespace glint
