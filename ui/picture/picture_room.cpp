// The room in the middle of the window: the picture, what is drawn over it, and whose turn it is: the order
// in which tools are asked for the mouse, drawn, and left by Escape.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/vectors/vectors_tab.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/predict_mode.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/features/views/debug_view_legend.h"
#include "ui/features/views/views.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/picture_notes.h"
#include "ui/picture/tool.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Says what can be done: in one line, in three where the picture is too narrow for that, or not at all.
void first_hints(ImDrawList& list, const UiState& state) {
    const bool covered = !state.notifications.list.empty();
    if (covered || state.viewport.touched ||
        state.get<DebugViewState>().set.choice.view != DebugView::Picture)
        return;
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

/// Fills what of the room the picture leaves free.
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

constexpr std::array asked_for_the_mouse{&pen_tool,     &lesson_tool, &magnifier_tool,
                                         &compare_tool, &scope_tool,  &hand_tool};

void drag_held_tool(ToolFrame& frame) {
    ToolCapture& held = frame.state.capture;
    if (ImGui::IsMousePosValid() && !held.tool->drag(frame))
        held = {};
    else if (!ImGui::IsMouseDown(held.button)) {
        if (held.tool->release != nullptr) held.tool->release(frame);
        held = {};
    }
}

bool close_palette(UiState& state) { return std::exchange(state.palette.open, false); }

bool leave_dialog(UiState& state) {
    if (modal_of(state) == Modal::None) return false;
    leave_modal(state);
    return true;
}

bool close_popup(UiState&) {
    if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return false;
    ImGui::ClosePopupToLevel(0, true);
    return true;
}

/// While the user types, Escape ends only the typing, and the text field does that itself. Everything else
/// stays open.
bool end_typing(UiState&) { return ImGui::GetIO().WantTextInput; }

bool cancel_loading(UiState& state) {
    if (!state.loading.active()) return false;
    cancel_loads(state);
    return true;
}

bool close_shortcuts(UiState& state) { return std::exchange(state.shows_shortcuts, false); }
bool close_animate(UiState& state) {
    if (!state.get<AnimateState>().open) return false;
    if (state.get<AnimateState>().job) {  // what is being written does not go on unseen
        state.get<AnimateState>().job->cancel();
        return true;
    }
    state.get<AnimateState>().open = state.get<AnimateState>().playing = false;
    return true;
}
bool close_wedge(UiState& state) { return std::exchange(state.get<WedgeState>().open, false); }
bool show_panels(UiState& state) { return std::exchange(state.layout.hides_all, false); }

bool forget_probe(UiState& state) {
    if (!state.viewport.probe) return false;
    ask_about(state.viewport, {});
    return true;
}

bool leave_prediction(UiState& state) {
    if (state.get<PredictState>().stage == PredictStage::Off) return false;
    end_prediction(state);
    return true;
}

bool leave_my_picture(UiState& state) {
    if (!state.get<MyPictureState>().shown && !state.get<MyPictureState>().reading) return false;
    put_picture_away(state);
    return true;
}

/// Escape runs the first of these that has something to leave: the innermost.
const std::array left_by_escape{hand_tool.cancel, close_palette,   leave_dialog,    close_popup,
                                end_typing,       cancel_loading,  close_shortcuts, close_wedge,
                                close_animate,    pen_tool.cancel, show_panels,     scope_tool.cancel,
                                leave_prediction, forget_probe,    leave_my_picture};

/// Reads the mouse over the item drawn last (the picture).
void use_tools(UiState& state, const PictureView& view, const UiInput& input) {
    ToolFrame frame{state, view, input, ImGui::IsItemHovered() && ImGui::IsMousePosValid(),
                    view.to_pixel(ImGui::GetIO().MousePos)};
    if (state.capture.tool != nullptr) return drag_held_tool(frame);
    const Tool* under = nullptr;
    for (const Tool* tool : asked_for_the_mouse)
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

/// How often the equation is evaluated: of a comparison in the part under the mouse, else in the first one.
std::string evaluations_under(const UiState& state, const PictureView& view) {
    const CompareState& compare = state.get<CompareState>();
    const std::vector<DrawnPart> parts = drawn_parts(compare, *state.renderer, view.map.size);
    const glm::ivec2 pixel = nearest_pixel(view.map.size, view.to_pixel(ImGui::GetIO().MousePos));
    const auto holds = [pixel](const DrawnPart& part) { return part.rect.holds(pixel); };
    const auto under = std::find_if(parts.begin(), parts.end(), holds);
    if (parts.empty()) return {};
    const DrawnPart& part = under != parts.end() ? *under : parts.front();
    const Scene scene = scene_under(part.variant, state.rendered_scene, compare.choice.stored.get());
    const std::string text = evaluations_text(*part.renderer, scene);
    return parts.size() == 1 ? text : label_of(part.variant) + ": " + text;
}

/// Draws what the tools show over the picture, but for the pen's lines.
void draw_tools(ImDrawList& list, UiState& state, const PictureView& view) {
    if (is_held(state)) return lesson_tool.draw(list, state, view);  // there is nothing to take hold of
    hand_tool.draw(list, state, view);
    magnifier_tool.draw(list, state, view);
    draw_lit_dots(list, state.get<LitDotsState>(), view);
    if (state.get<LitDotsState>().dots)
        draw_evaluations(list, evaluations_under(state, view), state.get<CompareState>().choice.on);
    compare_tool.draw(list, state, view);
    draw_debug_view_legend(list, state.get<DebugViewState>(), state.rendered_scene, view,
                           probe_pixel(state.viewport, view.map.size));
    scope_tool.draw(list, state, view);
    lesson_tool.draw(list, state, view);
}

}  // namespace

namespace {

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
    const ImVec2 high = view.end();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(layout.centre.low, layout.centre.high);  // ImGui's own leaves out some of the border
    draw_surround(list, layout.centre, {view.origin, high});
    state.picture_rect = {{view.origin, high}, layout.centre};
    list.PopClipRect();
    // Magnified, the picture goes on behind the columns.
    const Rect& room = layout.centre;
    const ImVec2 low{std::max(view.origin.x, room.low.x), std::max(view.origin.y, room.low.y)},
        end{std::min(high.x, room.high.x), std::min(high.y, room.high.y)};
    ImGui::SetCursorScreenPos(low);
    hit_area("##picture", end - low,
             ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                 ImGuiButtonFlags_MouseButtonMiddle);
    use_tools(state, view, input);
    ImGui::End();
    return state.viewport.gesture != Gesture::None;
}

void picture_overlay(UiState& state, const Layout& layout) {
    // What is drawn over a frozen picture is frozen with it; over B lie B's lights.
    const PictureView view =
        view_of(is_out_of_hand(state) ? shown_scene(state) : state.editor.scene(), layout.centre, state);
    resume_area("##view");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(view.origin, view.end(), true);
    if (!state.layout.hides_all) {
        draw_tools(list, state, view);
        draw_point_vectors(list, state, view);
        first_hints(list, state);
    }
    draw_pen(list, state.get<PenState>(), view);
    const Rect in_sight = clip_area(list);
    list.PopClipRect();
    ImGui::End();
    if (!state.layout.hides_all) picture_badge(state, in_sight);
    pen_bar(state.get<PenState>(), in_sight);
    // Over a clean picture only what needs an eye is said.
    if (state.layout.hides_all)
        std::erase_if(state.notifications.list, [](const Notification& n) { return n.tone == Tone::Done; });
    // Beside the legend of a false colour, which is read while they stand.
    const float legend = state.layout.hides_all ? 0 : legend_width(state.get<DebugViewState>());
    draw_notifications(state.notifications, layout.centre.high - px(18) * ImVec2(1, 1), layout.centre.low.y,
                       std::max(layout.centre.size().x - px(36) - legend, px(160)));
}

std::string tools_hint(const UiState& state) {
    for (const Tool* tool : asked_for_the_mouse)
        if (tool->hint != nullptr)
            if (std::string hint = tool->hint(state); !hint.empty()) return hint;
    return {};
}

void escape(UiState& state) {
    for (const auto leave : left_by_escape)
        if (leave(state)) return;
}

}  // namespace glint
