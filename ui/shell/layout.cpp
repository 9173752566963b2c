#include "ui/shell/layout.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

namespace {

/// Takes the row of views and the scope's panel from the centre; the picture keeps at least half of it.
void share_centre(Layout& layout, const LayoutState& state, float scale) {
    const Rect all = layout.centre;
    layout.has_views = !state.hides_columns && !state.hides_all;
    layout.has_scope = state.scope && !state.hides_all;
    const float views = layout.has_views ? std::min(views_height * scale, all.size().y / 6) : 0;
    const float scope = layout.has_scope ? std::min(state.scope_height * scale, all.size().y / 2 - views) : 0;
    const float top = std::round(all.low.y + views);
    const float bottom = std::max(std::round(all.high.y - scope), top + 1);
    layout.views = {all.low, {all.high.x, std::max(top, all.low.y + 1)}};
    layout.centre = {{all.low.x, top}, {all.high.x, bottom}};
    layout.scope = {{all.low.x, std::min(bottom, all.high.y - 1)}, all.high};
}

}  // namespace

namespace {

float left_width(const LayoutState& state) { return state.lesson ? state.lesson_width : state.left_width; }

}  // namespace

Layout lay_out(ImVec2 window, const LayoutState& state, float scale) {
    const float width = std::max(window.x, 1.0f), height = std::max(window.y, 1.0f);
    Layout layout;
    layout.inspector_in_left = is_narrow(window, scale);
    const bool columns = !state.hides_columns && !state.hides_all;
    layout.has_left = columns && (state.left || state.lesson || (layout.inspector_in_left && state.right));
    layout.has_right = columns && state.right && !layout.inspector_in_left;
    const float bars = state.hides_all ? 0 : scale;
    const float top = std::round(std::min(top_height * bars, height / 3));
    const float bottom = std::round(height - std::min(status_height * bars, height / 3));
    // The columns together take at most two thirds of the width.
    const float wanted_left = layout.has_left ? left_width(state) * scale : 0;
    const float wanted_right = layout.has_right ? state.right_width * scale : 0;
    const float shrink = std::min(1.0f, width * 2 / 3 / std::max(wanted_left + wanted_right, 1.0f));
    const float left = std::round(wanted_left * shrink), right = std::round(width - wanted_right * shrink);
    layout.top = {{0, 0}, {width, std::max(top, 1.0f)}};
    layout.left = {{0, top}, {std::max(left, 1.0f), bottom}};
    layout.centre = {{left, top}, {std::max(right, left + 1), std::max(bottom, top + 1)}};
    layout.right = {{std::min(right, width - 1), top}, {width, bottom}};
    layout.status = {{0, std::min(bottom, height - 1)}, {width, height}};
    share_centre(layout, state, scale);
    return layout;
}

void make_room_for_caption(Layout& layout, float height) {
    Rect& centre = layout.centre;
    if (height <= 0 || height > centre.size().y / 3) return;
    layout.has_caption = true;
    layout.caption = {{centre.low.x, std::round(centre.high.y - height)}, centre.high};
    centre.high.y = layout.caption.low.y;
}

Rect picture_area(const Rect& centre, float scale) {
    constexpr float margin_wanted = 10;
    const ImVec2 all = centre.size();
    const float margin = std::min({margin_wanted * scale, all.x / 4, all.y / 4});
    const float width = std::max(std::floor(all.x - 2 * margin), 1.0f);
    const float height = std::max(std::floor(all.y - 2 * margin), 1.0f);
    const ImVec2 low{std::round(centre.low.x + margin), std::round(centre.low.y + margin)};
    return {low, {low.x + width, low.y + height}};
}

namespace {

/// Draws a draggable edge at `x`, in front of the columns, so that it receives the mouse. `outwards`: 1 if a
/// drag to the right makes its column wider, -1 if a drag to the left does.
void edge(const char* id, float x, const Rect& column, float outwards, float initial, float least,
          float& width, float scale) {
    const float reach = 3 * scale;
    ImGui::SetNextWindowPos({x - reach, column.low.y});
    ImGui::SetNextWindowSize({2 * reach, column.size().y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    hit_area("##edge", {2 * reach, column.size().y});
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        ImGui::GetWindowDrawList()->AddRectFilled({x - scale, column.low.y}, {x + scale, column.high.y},
                                                  to_u32(theme().accent));
    }
    if (held) {
        // Computed from the cursor's position, so that the edge is under the cursor again after reaching a
        // limit.
        const float wanted = outwards > 0 ? ImGui::GetIO().MousePos.x - column.low.x
                                          : column.high.x - ImGui::GetIO().MousePos.x;
        if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1))
            width = std::clamp(wanted / scale, least, max_column_width);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) width = initial;
    ImGui::End();
}

}  // namespace

void column_edges(LayoutState& state, const Layout& layout, float scale) {
    const LayoutState initial;
    if (layout.has_left)
        edge("##left edge", layout.left.high.x, layout.left, 1,
             state.lesson ? initial.lesson_width : initial.left_width, least_column_width,
             state.lesson ? state.lesson_width : state.left_width, scale);
    if (layout.has_right)
        edge("##right edge", layout.right.low.x, layout.right, -1, initial.right_width, least_why_width,
             state.right_width, scale);
}

}  // namespace glint
