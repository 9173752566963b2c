#include "ui/views/views_bar.h"

#include <imgui.h>

#include "ui/commands/command.h"
#include "ui/views/compare_panel.h"
#include "ui/views/views.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// A button that runs a command and shows whether it is on.
void command_button(UiState& state, const char* label, CommandId id, const char* what) {
    const Command& row = command(id);
    const bool on = is_on(state, row).value_or(false);
    const std::string refused = why_disabled(state, row);
    ImGui::PushStyleColor(ImGuiCol_Button, on ? theme().accent : theme().field);
    ImGui::PushStyleColor(ImGuiCol_Text, on ? theme().accent_text : theme().text);
    ImGui::BeginDisabled(!refused.empty());
    if (ImGui::SmallButton(label)) run_command(state, row);
    ImGui::EndDisabled();
    ImGui::PopStyleColor(2);
    tooltip(row.name, what, refused, keys_of(row));
    ImGui::SameLine(0, px(4));
}

}  // namespace

void views_bar(UiState& state) {
    ImGui::PushFont(fonts().small);
    if (look_controls(state.views.look, state.editor.scene()))
        look_at(state.views, state.views.look.set.choice.look);
    command_button(state, "Over-range", CommandId::OverRange,
                   "Stripes over pixels whose colour exceeds 1 in a channel and is cut off");
    command_button(
        state, "Scope", CommandId::Scope,
        "Intensity along a line over the picture, with its first and second difference: Mach bands in "
        "numbers");
    command_button(state, "Compare", CommandId::Compare,
                   "Flat, Gouraud and Phong, or any settings, side by side under lines to drag");
    command_button(
        state, "Pixels", CommandId::Magnify,
        "Each pixel as a square with its number in it: 0 to 255, red, green and blue where there is room. "
        "Ctrl+wheel zooms, the right button moves");
    command_button(
        state, "Dots", CommandId::LitDots,
        "A dot at each place that the equation is evaluated at, thinned, and how often it is in a frame");
    compare_controls(state.views.compare);
    if (state.views.compare.choice.shows_stored) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme().warning);
        ImGui::TextUnformatted("B is shown");
        ImGui::PopStyleColor();
        tooltip("B is shown", "The stored scene, through the edited scene's camera", "",
                keys_of(CommandId::ShowB));
    }
    ImGui::PopFont();
}

}  // namespace glint
