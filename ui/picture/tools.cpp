// Whose turn it is: the order in which tools are asked for the mouse, drawn, and left by Escape.
#include <imgui_internal.h>

#include <array>

#include "ui/picture/tool.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/views/views.h"

namespace glint {
namespace {

constexpr std::array asked_for_the_mouse{&pen_tool, &magnifier_tool, &compare_tool, &scope_tool, &hand_tool};

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

bool cancel_loading(UiState& state) {
    if (!state.loading.active()) return false;
    cancel_loads(state);
    return true;
}

bool close_shortcuts(UiState& state) { return std::exchange(state.shows_shortcuts, false); }
bool close_wedge(UiState& state) { return std::exchange(state.lecture.wedge.open, false); }
bool show_panels(UiState& state) { return std::exchange(state.layout.hides_all, false); }

bool forget_probe(UiState& state) {
    if (!state.viewport.probe || ImGui::GetIO().WantTextInput) return false;
    state.viewport.probe.reset();
    return true;
}

/// The innermost first.
const std::array left_by_escape{hand_tool.cancel, close_palette,     leave_dialog, close_popup,
                                cancel_loading,   close_shortcuts,   close_wedge,  pen_tool.cancel,
                                show_panels,      scope_tool.cancel, forget_probe};

}  // namespace

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

void draw_tools(ImDrawList& list, UiState& state, const PictureView& view) {
    hand_tool.draw(list, state, view);
    magnifier_tool.draw(list, state, view);
    draw_lit_dots(list, state.views.lit, *state.renderer, state.rendered_scene, view);
    compare_tool.draw(list, state, view);
    draw_debug_view_legend(list, state.views.debug_view, state.rendered_scene, view,
                           probe_pixel(state.viewport, view.map.size));
    scope_tool.draw(list, state, view);
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
