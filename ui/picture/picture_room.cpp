// The picture's area at the centre of the window: the picture, its overlays, the active tool, and the
// handling of Escape.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/feature.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/magnifier.h"
#include "ui/picture/picture_notes.h"
#include "ui/picture/tool.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Draws the first hints: on one line; on three lines if the picture is too narrow; or not at all.
void first_hints(ImDrawList& list, const UiState& state) {
    const bool covered = !state.notifications.list.empty();
    if (covered || state.viewport.touched || state.displayed != state.rendered) return;
    const Rect shown = clip_area(list);
    const auto fits = [&](const char* text) {
        return ImGui::CalcTextSize(text).x + px(40) <= shown.size().x;
    };
    const char* text =
        "Drag a light or a highlight   ·   Click a pixel to ask why   ·   Drag elsewhere to orbit";
    if (!fits(text)) text = "Drag a light or a highlight\nClick a pixel to ask why\nDrag elsewhere to orbit";
    if (!fits(text)) return;
    badge(list, {shown.middle().x, shown.high.y - px(18)}, text, {0.5f, 1});
}

/// Fills the part of the area that the picture does not cover.
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

/// Returns all tools, in the order in which they receive the mouse: lines and labels of features precede the
/// handles.
std::vector<const Tool*> all_tools() {
    std::vector<const Tool*> tools{&magnifier_tool};
    for (const Feature* feature : features())
        if (feature->tool != nullptr) tools.push_back(feature->tool);
    tools.push_back(&hand_tool);
    return tools;
}

void drag_held_tool(ToolFrame& frame) {
    ToolCapture& held = frame.state.capture;
    if (ImGui::IsMousePosValid() && !held.tool->drag(frame))
        held = {};
    else if (!ImGui::IsMouseDown(held.button)) {
        if (held.tool->release != nullptr) held.tool->release(frame);
        held = {};
    }
}

bool leave_dialog(UiState& state) {
    if (open_dialog(state) == nullptr) return false;
    leave_modal(state);
    return true;
}

bool close_popup() {
    if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return false;
    ImGui::ClosePopupToLevel(0, true);
    return true;
}

bool cancel_loading(UiState& state) {
    if (!state.loading.active()) return false;
    cancel_loads(state);
    return true;
}

/// Handles the mouse over the item drawn last (the picture).
void use_tools(UiState& state, const PictureView& view, const UiInput& input) {
    ToolFrame frame{state, view, input, ImGui::IsItemHovered() && ImGui::IsMousePosValid(),
                    view.to_pixel(ImGui::GetIO().MousePos)};
    if (state.capture.tool != nullptr) return drag_held_tool(frame);
    const Tool* under = nullptr;
    for (const Tool* tool : all_tools())
        if (tool->hover(frame)) {
            under = tool;
            frame.over = false;
        }
    if (under == nullptr) return;
    frame.over = true;
    if (under->press != nullptr)
        if (const int button = under->press(frame); button != not_taken) state.capture = {under, button};
    if (under != &hand_tool) state.viewport.touched |= ImGui::IsAnyMouseDown();
}

/// Draws handles, enlarged pixels, and the overlays of features.
void draw_overlays(ImDrawList& list, UiState& state, const PictureView& view) {
    const bool is_clean = state.layout.hides_all, held = is_held(state);
    if (!is_clean && !held) {
        draw_hand(list, state, view);
        draw_big_pixels(list, state, view);
    }
    const std::span<const Feature* const> all = features();
    for (auto it = all.rbegin(); it != all.rend(); ++it) {
        const Feature& feature = **it;
        const bool holds = feature.why_held != nullptr && !feature.why_held(state).empty();
        if (feature.overlay != nullptr && (feature.overlay_stays || (!is_clean && (!held || holds))))
            feature.overlay(list, state, view);
    }
    if (!is_clean) first_hints(list, state);
}

PictureView view_of(const Scene& scene, const Rect& centre, const UiState& state) {
    const float dots = std::max(ImGui::GetIO().DisplayFramebufferScale.x, 0.1f);
    const Rect area = picture_area(centre, px(1));
    const ImVec2 room = area.size();
    const auto pixels = [dots](float units) {
        return static_cast<int>(std::clamp(units * dots, 1.0f, float(max_picture_side)));
    };
    PictureView view;
    view.origin = area.low;
    view.units_per_pixel = 1 / dots;
    view.map = screen_map(scene.camera, {pixels(room.x), pixels(room.y), true});
    view.bounds = scene_bounds(scene);
    view.dome = sun_dome(scene.camera.target, view.bounds, view.map);
    magnify(view, area, state.get<MagnifierState>());
    return view;
}

}  // namespace

PictureView picture_view(const Rect& centre, const UiState& state) {
    return view_of(state.editor.scene(), centre, state);
}

bool picture_room(UiState& state, const Layout& layout, const UiInput& input) {
    begin_area("##view", layout.centre);
    const PictureView view = picture_view(layout.centre, state);
    follow_shape(state, view.map.size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // ImGui's own clip rectangle excludes part of the border.
    list.PushClipRect(layout.centre.low, layout.centre.high);
    draw_surround(list, layout.centre, {view.origin, view.end()});
    state.picture_rect = {{view.origin, view.end()}, layout.centre};
    list.PopClipRect();
    const Rect in_sight = picture_in_sight(state);  // a magnified picture extends behind the columns
    ImGui::SetCursorScreenPos(in_sight.low);
    hit_area("##picture", in_sight.size(),
             ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                 ImGuiButtonFlags_MouseButtonMiddle);
    use_tools(state, view, input);
    ImGui::End();
    return state.viewport.gesture != Gesture::None;
}

Rect picture_in_sight(const UiState& state) {
    const auto& [picture, room] = state.picture_rect;
    return {{std::max(picture.low.x, room.low.x), std::max(picture.low.y, room.low.y)},
            {std::min(picture.high.x, room.high.x), std::min(picture.high.y, room.high.y)}};
}

void picture_overlay(UiState& state, const Layout& layout) {
    // The overlays of a frozen picture are frozen too; over B, they show B's lights.
    const PictureView view = view_of(
        state.on_screen.is_out_of_hand() ? shown_scene(state) : state.editor.scene(), layout.centre, state);
    resume_area("##view");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(view.origin, view.end(), true);
    state.legend_width = state.label_height = 0;
    draw_overlays(list, state, view);
    draw_refinement(list, view, std::min(state.refinement.progress(), state.parts_progress));
    list.PopClipRect();
    ImGui::End();
    if (!state.layout.hides_all) picture_badge(state, picture_in_sight(state));
    // A picture without bars shows only messages that need attention.
    if (state.layout.hides_all)
        std::erase_if(state.notifications.list, [](const Notification& n) { return n.tone == Tone::Done; });
    // Placed next to the legend of false colours, which is read at the same time.
    draw_notifications(state, layout.centre.high - px(18) * ImVec2(1, 1), layout.centre.low.y,
                       std::max(layout.centre.size().x - px(36) - state.legend_width, px(160)));
}

std::string tools_hint(const UiState& state) {
    for (const Tool* tool : all_tools())
        if (tool->hint != nullptr)
            if (std::string hint = tool->hint(state); !hint.empty()) return hint;
    return {};
}

void escape(UiState& state) {
    // While text is being typed, Escape only ends the typing, and the text field handles that itself.
    if (cancel_gesture(state.viewport, state.editor.scene()) || std::exchange(state.palette.open, false) ||
        leave_dialog(state) || close_popup() || ImGui::GetIO().WantTextInput || cancel_loading(state) ||
        std::exchange(state.shows_shortcuts, false))
        return;
    for (const Feature* feature : features())
        if (feature->escape != nullptr && feature->escape(state)) return;
}

}  // namespace glint
