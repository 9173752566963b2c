// From keys to commands.
#include <imgui_internal.h>

#include <algorithm>

#include "ui/commands/command.h"
#include "ui/ui.h"
#include "ui/views/views.h"
#include "ui/widgets/modal.h"

namespace glint {
namespace {

/// Escape leaves the innermost thing: a drag, a dialog, a sheet.
void escape(UiState& state) {
    if (cancel_gesture(state.viewport, state.editor.scene())) return;
    if (state.palette.open) {
        state.palette.open = false;
        return;
    }
    if (modal_of(state) != Modal::None) return leave_modal(state);
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return ImGui::ClosePopupToLevel(0, true);
    if (state.loading.active())
        cancel_loads(state);
    else if (state.shows_shortcuts)
        state.shows_shortcuts = false;
    else if (leave_lecture_tool(state))
        return;
    else if (!leave_view_tool(state.views) && !ImGui::GetIO().WantTextInput)
        state.viewport.probe.reset();
}

}  // namespace

void run_keys(UiState& state, const UiInput& input) {
    const bool busy =
        state.viewport.gesture != Gesture::None || (ImGui::IsAnyMouseDown() && ImGui::IsAnyItemActive());
    for (const KeyPress& press : input.presses) {
        if (press.key == Key::Escape) escape(state);
        if (busy || state.palette.open || modal_of(state) != Modal::None) continue;
        // While text is typed its keys are text; Ctrl+S still saves.
        const bool typing = ImGui::GetIO().WantTextInput;
        if (typing && !(press.ctrl && press.key == Key::S)) continue;
        const auto has_key = [&press](const Command& command) {
            return std::find(command.keys.begin(), command.keys.end(), press) != command.keys.end();
        };
        const auto found = std::find_if(commands().begin(), commands().end(), has_key);
        if (found != commands().end()) run_command(state, *found);
    }
}

}  // namespace glint
