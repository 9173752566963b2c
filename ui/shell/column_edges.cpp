// The edges of the columns, to be dragged.
#include <algorithm>

#include "ui/shell/layout.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// An edge at `x`. `outwards`: 1 when a drag to the right makes its column wider, -1 when a drag to the left.
void edge(const char* id, float x, const Rect& column, float outwards, float initial, float& width,
          float scale) {
    const float reach = 3 * scale;
    ImGui::SetNextWindowPos({x - reach, column.low.y});
    ImGui::SetNextWindowSize({2 * reach, column.size().y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    hit_area("##edge", {2 * reach, column.size().y});
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        ImGui::GetWindowDrawList()->AddRectFilled({x - scale, column.low.y}, {x + scale, column.high.y},
                                                  packed(theme().accent));
    }
    if (held) {
        // From where the hand is, so that the edge stays under it also after a limit was reached.
        const float wanted = outwards > 0 ? ImGui::GetIO().MousePos.x - column.low.x
                                          : column.high.x - ImGui::GetIO().MousePos.x;
        if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1))
            width = std::clamp(wanted / scale, least_column_width, most_column_width);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) width = initial;
    ImGui::End();
}

}  // namespace

void column_edges(LayoutState& state, const Layout& layout, float scale) {
    const LayoutState initial;
    if (layout.has_left)
        edge("##left edge", layout.left.high.x, layout.left, 1, initial.left_width, state.left_width, scale);
    if (layout.has_right)
        edge("##right edge", layout.right.low.x, layout.right, -1, initial.right_width, state.right_width,
             scale);
}

}  // namespace glint
