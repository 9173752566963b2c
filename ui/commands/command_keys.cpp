// From keys to commands.
#include <imgui.h>

#include <algorithm>

#include "ui/commands/command.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/modal.h"

namespace glint {
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
