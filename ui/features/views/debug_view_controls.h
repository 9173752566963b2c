#pragma once
// A debug view shows one quantity in place of the picture's colours, with a colour bar as legend; stripes may
// mark colours that are too bright to be shown.

#include <imgui.h>

#include <memory>
#include <optional>
#include <string>

#include "renderer/debug_views/debug_view.h"
#include "ui/picture/screen.h"

namespace glint {

/// The shown quantity; changes to it change the picture.
struct DebugViewSet {
    DebugViewChoice choice;
    bool over_range = false;  // stripes where a channel exceeds 1
    bool operator==(const DebugViewSet&) const = default;
};

struct DebugViewState {
    DebugViewSet set;
    std::unique_ptr<DebugViewPainter> painter;  // null until it is needed
    Picture striped;
    std::uint64_t clipped = 0;  // striped pixels
};

struct DebugViewInfo {
    DebugView view;
    const char* label;
    const char* what;
};
/// The window's texts for a debug view.
[[nodiscard]] const DebugViewInfo& info_of(DebugView view);

/// The debug view `steps` positions after `view` (before it, if negative), wrapping around at the ends.
[[nodiscard]] DebugView debug_view_after(DebugView view, int steps);

/// Draws a drop-down for the debug view into the current line. True when a view was chosen.
bool debug_view_choice(DebugViewState& state);
/// Draws a drop-down for the light whose n·l is shown, if any.
void light_choice(DebugViewState& state, const Scene& scene);

/// The width of the legend that draw_debug_view_legend() draws at the picture's left edge; 0: none.
[[nodiscard]] float legend_width(const DebugViewState& state);

/// Draws the colour bar into the picture's lower left corner, with the values at the picked pixel and at the
/// cursor.
void draw_debug_view_legend(ImDrawList& list, const DebugViewState& state, const Scene& scene,
                            const PictureView& view, std::optional<glm::ivec2> picked);

}  // namespace glint
