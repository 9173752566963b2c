#pragma once
// The positions of the columns. The three columns answer three questions: what is in the scene, what do I
// see, and why is it that colour?

#include "ui/widgets/area.h"

namespace glint {

struct LayoutState {
    bool left = true, right = true;                // whether each column is shown
    bool hides_columns = false;                    // F11: only the picture
    bool hides_all = false;                        // F10: no columns and no bars
    bool projector = false;                        // large type, high contrast
    bool left_before = true, right_before = true;  // `left` and `right` before projector mode
    float left_width = 280, right_width = 360;     // logical pixels
    bool lesson = false;  // the left column shows a lesson or a game, and has a separate width
    float lesson_width = 350;
    bool scope = false;  // the panel below the picture is open
    float scope_height = 210;
    bool caption = true;  // the scene's caption is shown below the picture
    bool operator==(const LayoutState&) const = default;
};

struct Layout {
    Rect top, left, centre, right, status;
    Rect views, scope;  // above and below `centre`, the picture's area
    Rect caption;       // between `centre` and `scope`
    bool has_views = false, has_scope = false, has_caption = false;
    bool has_left = false, has_right = false;
    bool inspector_in_left = false;  // too narrow for three columns: WHY is a tab of the left one
};

/// Divides a window. `scale`: as passed to apply_theme(). All rectangles have positive size, however small
/// the window is; columns shrink before the picture does.
[[nodiscard]] Layout lay_out(ImVec2 window, const LayoutState& state, float scale);

/// Takes `height` for the caption's lines from the centre, unless that would leave the picture less than two
/// thirds of it.
void make_room_for_caption(Layout& layout, float height);

/// Draws the draggable edges of the columns; a double-click resets one. Drawn after the columns, so that they
/// are on top.
void column_edges(LayoutState& state, const Layout& layout, float scale);

/// The picture's area within the centre: all of it except a margin.
[[nodiscard]] Rect picture_area(const Rect& centre, float scale);

/// Below this width, in logical pixels, the right column becomes a tab of the left one.
inline constexpr float three_column_width = 1100;
[[nodiscard]] inline bool is_narrow(ImVec2 window, float scale) {
    return window.x < three_column_width * scale;
}
inline constexpr float top_height = 38, status_height = 26, views_height = 30;
// In narrower columns, three numbers in a row, or the three channels of WHY's table, would be cut off.
inline constexpr float least_column_width = 260, least_why_width = 310, max_column_width = 700;

}  // namespace glint
