#pragma once
// Where the columns are. Three columns for three questions: what is in the scene, what do I see, why that
// colour.

#include "ui/widgets/area.h"

namespace glint {

struct LayoutState {
    bool left = true, right = true;                // columns shown
    bool hides_columns = false;                    // F11: the picture alone
    bool hides_all = false;                        // F10: and no bars
    bool projector = false;                        // large type, strong contrast
    bool left_before = true, right_before = true;  // the columns before the projector
    float left_width = 280, right_width = 360;     // logical pixels
    bool lesson = false;  // the left column holds a lesson or a game, and is as wide as those need
    float lesson_width = 350;
    bool scope = false;  // the panel below the picture is open
    float scope_height = 210;
    bool caption = true;  // what the scene says of itself stands below the picture
    bool operator==(const LayoutState&) const = default;
};

struct Layout {
    Rect top, left, centre, right, status;
    Rect views, scope;  // above and below `centre`, the picture's room
    Rect caption;       // between `centre` and `scope`
    bool has_views = false, has_scope = false, has_caption = false;
    bool has_left = false, has_right = false;
    bool inspector_in_left = false;  // too narrow for three: WHY is a tab of the left column
};

/// Divides a window. `scale`: as given to apply_theme(). All rectangles have positive size, however small the
/// window is; columns give way before the picture does.
[[nodiscard]] Layout lay_out(ImVec2 window, const LayoutState& state, float scale);

/// Takes the caption's lines, `height` high, off the centre; the picture keeps two thirds of it.
void make_room_for_caption(Layout& layout, float height);

/// Edges of the columns to be dragged; double-click puts one back. After the columns, so that they lie above.
void column_edges(LayoutState& state, const Layout& layout, float scale);

/// Where the picture lies in the centre: all of it but a margin of surround.
[[nodiscard]] Rect picture_area(const Rect& centre, float scale);

/// Below this width, in logical pixels, the right column becomes a tab of the left.
inline constexpr float three_column_width = 1100;
/// Whether a window is so narrow.
[[nodiscard]] inline bool is_narrow(ImVec2 window, float scale) {
    return window.x < three_column_width * scale;
}
inline constexpr float top_height = 38, status_height = 26, views_height = 30;
// Narrower, numbers would be cut off: three in a row, or the three channels of WHY's table.
inline constexpr float least_column_width = 260, least_why_width = 310, max_column_width = 700;

}  // namespace glint
