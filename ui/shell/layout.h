#pragma once
// Where the columns are. Three columns for three questions: what is in the scene, what do I see, why that
// colour.

#include "ui/widgets/area.h"

namespace glint {

struct LayoutState {
    bool left = true, right = true;             // columns shown
    bool hides_columns = false;                 // F11: the picture alone
    bool hides_all = false;                     // F10: and no bars
    float left_width = 280, right_width = 340;  // logical pixels
    bool scope = false;                         // the panel below the picture is open
    float scope_height = 210;
    bool operator==(const LayoutState&) const = default;
};

struct Layout {
    Rect top, left, centre, right, status;
    Rect views, scope;  // above and below `centre`, the picture's room
    bool has_views = false, has_scope = false;
    bool has_left = false, has_right = false;
    bool inspector_in_left = false;  // too narrow for three: WHY is a tab of the left column
};

/// Divides a window. `scale`: as given to apply_theme(). All rectangles have positive size, however small the
/// window is; columns give way before the picture does.
[[nodiscard]] Layout lay_out(ImVec2 window, const LayoutState& state, float scale);

/// Edges of the columns to be dragged; double-click puts one back. After the columns, so that they lie above.
void column_edges(LayoutState& state, const Layout& layout, float scale);

/// Where the picture lies in the centre: a margin of surround all round, and never narrower than 4:3, since a
/// scene's field of view is vertical and a tall picture would cut off what was composed for a wide one.
[[nodiscard]] Rect picture_area(const Rect& centre, float scale);

/// Below this width, in logical pixels, the right column becomes a tab of the left.
inline constexpr float three_column_width = 1100;
inline constexpr float top_height = 38, status_height = 26, views_height = 30;
inline constexpr float least_column_width = 220, max_column_width = 700;

}  // namespace glint
