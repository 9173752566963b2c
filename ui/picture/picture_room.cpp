#include <algorithm>

#include "models/saturate.h"
#include "ui/inspector/vectors/vectors_tab.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// In one line, or in three where the picture is too narrow for that.
void first_hints(const UiState& state, const PictureView& view) {
    if (state.viewport.touched || state.views.debug_view.set.choice.view != DebugView::Picture) return;
    const char* text =
        "Drag a light or a highlight   ·   Click a pixel to ask why   ·   Drag elsewhere to orbit";
    const float room = float(view.map.size.width) * view.units_per_pixel;
    if (ImGui::CalcTextSize(text).x + px(40) > room)
        text = "Drag a light or a highlight\nClick a pixel to ask why\nDrag elsewhere to orbit";
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float middle = view.origin.x + room / 2;
    const float bottom = view.origin.y + float(view.map.size.height) * view.units_per_pixel - px(18);
    const ImVec2 low{middle - size.x / 2 - px(14), bottom - size.y - px(12)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {middle + size.x / 2 + px(14), bottom}, to_u32(theme().window, 0.85f), px(14));
    list.AddText({low.x + px(14), low.y + px(6)}, to_u32(theme().text), text);
}

/// What of the room the picture leaves free.
void draw_surround(ImDrawList& list, const Rect& room, const Rect& picture) {
    const ImU32 colour = to_u32(theme().surround);
    const auto fill = [&](ImVec2 low, ImVec2 high) {
        if (low.x < high.x && low.y < high.y) list.AddRectFilled(low, high, colour);
    };
    fill(room.low, {room.high.x, picture.low.y});
    fill({room.low.x, picture.high.y}, room.high);
    fill({room.low.x, picture.low.y}, {picture.low.x, picture.high.y});
    fill({picture.high.x, picture.low.y}, {room.high.x, picture.high.y});
}

}  // namespace

PictureView picture_view(const Rect& centre, const UiState& state) {
    const Scene& scene = state.editor.scene();
    const float dots = std::max(ImGui::GetIO().DisplayFramebufferScale.x, 0.1f);
    const Rect area = picture_area(centre, px(1));
    const ImVec2 room = area.size();
    const auto pixels = [dots](float units) {
        return std::clamp(saturated_int(units * dots), 1, max_picture_side);
    };
    PictureView view;
    view.origin = area.low;
    view.units_per_pixel = 1 / dots;
    view.map = screen_map(scene.camera, {pixels(room.x), pixels(room.y)});
    view.bounds = scene_bounds(scene);
    view.dome = sun_dome(scene.camera.target, view.bounds, view.map);
    magnify(view, area, state.views.magnifier);
    return view;
}

bool picture_room(UiState& state, const Layout& layout, const UiInput& input) {
    begin_area("##view", layout.centre);
    const PictureView view = picture_view(layout.centre, state);
    const ImVec2 high = view.to_window({view.map.size.width, view.map.size.height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(layout.centre.low, layout.centre.high);  // ImGui's own leaves out some of the border
    draw_surround(list, layout.centre, {view.origin, high});
    state.picture_rect = {{view.origin, high}, layout.centre};
    list.PopClipRect();
    // Magnified, the picture goes on behind the columns.
    const ImVec2 low{std::max(view.origin.x, layout.centre.low.x),
                     std::max(view.origin.y, layout.centre.low.y)};
    ImGui::SetCursorScreenPos(low);
    hit_area("##picture",
             {std::min(high.x, layout.centre.high.x) - low.x, std::min(high.y, layout.centre.high.y) - low.y},
             ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                 ImGuiButtonFlags_MouseButtonMiddle);
    use_tools(state, view, input);
    ImGui::End();
    return state.viewport.gesture != Gesture::None;
}

void picture_overlay(UiState& state, const Layout& layout, const PictureView& view) {
    resume_area("##view");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high = view.to_window({view.map.size.width, view.map.size.height});
    list.PushClipRect(view.origin, high, true);
    if (!state.layout.hides_all) {
        draw_tools(list, state, view);
        draw_point_vectors(list, state, view);
        first_hints(state, view);
        frozen_badge(list, state.lecture, view);
    }
    draw_pen(list, state.lecture.pen, view);
    list.PopClipRect();
    ImGui::End();
    pen_bar(state.lecture.pen, view);
    draw_notifications(state.notifications, {layout.centre.high.x - px(18), layout.centre.high.y - px(18)},
                       layout.centre.size().x - px(36));
}

}  // namespace glint
