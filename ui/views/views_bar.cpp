#include "ui/views/views_bar.h"

#include <imgui.h>

#include "ui/commands/actions.h"
#include "ui/views/compare_panel.h"
#include "ui/views/views.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// A button that runs an action and shows whether it is on.
void action_button(UiState& state, const char* label, Action action, const char* what) {
    const ActionInfo& info = info_of(action);
    const bool on = is_on(state, action).value_or(false);
    const std::string refused = why_not(state, action);
    ImGui::PushStyleColor(ImGuiCol_Button, on ? theme().accent : theme().field);
    ImGui::PushStyleColor(ImGuiCol_Text, on ? theme().accent_text : theme().text);
    ImGui::BeginDisabled(!refused.empty());
    if (ImGui::SmallButton(label)) run_action(state, action);
    ImGui::EndDisabled();
    ImGui::PopStyleColor(2);
    tooltip(info.name, what, refused, keys_of(action));
    ImGui::SameLine(0, px(4));
}

}  // namespace

void views_bar(UiState& state) {
    ImGui::PushFont(fonts().small);
    if (look_controls(state.views.look, state.editor.scene()))
        look_at(state.views, state.views.look.set.choice.look);
    action_button(state, "Over-range", Action::OverRange,
                  "Stripes over pixels whose colour exceeds 1 in a channel and is cut off");
    action_button(
        state, "Scope", Action::Scope,
        "Intensity along a line over the picture, with its first and second difference: Mach bands in "
        "numbers");
    action_button(state, "Compare", Action::Compare,
                  "Flat, Gouraud and Phong, or any settings, side by side under lines to drag");
    action_button(
        state, "Pixels", Action::Magnify,
        "Each pixel as a square with its number in it: 0 to 255, red, green and blue where there is room. "
        "Ctrl+wheel zooms, the right button moves");
    action_button(
        state, "Dots", Action::LitDots,
        "A dot at each place that the equation is evaluated at, thinned, and how often it is in a frame");
    compare_controls(state.views.compare);
    if (state.views.compare.choice.shows_stored) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme().warning);
        ImGui::TextUnformatted("B is shown");
        ImGui::PopStyleColor();
        tooltip("B is shown", "The stored scene, through the edited scene's camera", "", "B");
    }
    ImGui::PopFont();
}

}  // namespace glint
