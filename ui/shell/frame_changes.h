#pragma once
// Finds the parts of the window that a frame draws differently from the one before. The rest need not be
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
    /// Returns rects in ImGui's units, none empty and no two overlapping, that hold every pixel which `data`
    /// draws differently from the call before: none if nothing changed, the whole display at the first call
    /// or when its size changed. Textures are compared by name, not by what is in them.
    [[nodiscard]] std::vector<Rect> update(const ImDrawData& data);

  private:
    std::vector<DrawnList> before_;
    ImVec2 size_{-1, -1};
};

/// Adds a rect to those that do not overlap, joining it with those that it overlaps; at most
/// `max_changed_rects` stay.
void add_rect(std::vector<Rect>& rects, Rect rect);

/// Each rect is drawn by itself, and looks at all that is drawn: a few large ones cost less than many small.
inline constexpr std::size_t max_changed_rects = 4;

}  // namespace glint
