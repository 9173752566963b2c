#include "ui/inspector/equation/equation_tab.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/fields/field_panel.h"
#include "ui/inspector/asked.h"
#include "ui/inspector/equation/factors.h"
#include "ui/inspector/equation/parts.h"
#include "ui/inspector/equation/text_line.h"
#include "ui/inspector/equation/words.h"
#include "ui/inspector/tabs.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"

namespace glint {
namespace {

/// Buttons for the corners, with their weights, which sum to 1.
void corner_buttons(InspectorState& state, const Explanation& explanation) {
    for (int i = 0; i < static_cast<int>(explanation.corners.size()); ++i) {
        const ExplainedCorner& corner = explanation.corners[static_cast<std::size_t>(i)];
        const std::string label = fmt::format("{} {:.2f}", static_cast<char>('A' + i % 26), corner.weight);
        const bool chosen = i == state.corner;
        if (i % 4 != 0) ImGui::SameLine(0, px(4));
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? theme().accent : theme().field);
        ImGui::PushStyleColor(ImGuiCol_Text, chosen ? theme().accent_text : theme().text);
        ImGui::PushFont(fonts().figures);
        if (ImGui::Button(label.c_str())) state.corner = i;
        ImGui::PopFont();
        ImGui::PopStyleColor(2);
        tooltip("Corner", "Its share of the pixel; click for its numbers");
    }
}

/// Where what is written out was lit.
void lit_at(InspectorState& state, const Explanation& explanation) {
    if (!explanation.lit_per_corner || explanation.corners.empty()) return;
    if (explanation.corners.size() == 1) return wrapped_dim("Lit once for the whole polygon:");
    state.corner = std::clamp(state.corner, 0, static_cast<int>(explanation.corners.size()) - 1);
    wrapped_dim("Lit at the corners, the colours mixed by their weights:");
    corner_buttons(state, explanation);
}

/// Cool to warm: what stands in place of emission, ambient and diffuse.
void tone_line(const ExplainedTone& tone, int channel) {
    TextLine line;
    line.plain("k_w = (1 + n·l)/2 = ").number(shown_number(tone.k_w), theme().text);
    TextLine mix;
    mix.gap(14).plain("warm ").number(shown_number(tone.warm[channel]), theme().text);
    mix.plain(" · k_w + cool ").number(shown_number(tone.cool[channel]), theme().text);
    mix.plain(" (1 − k_w)");
    mix.result(shown_number(tone.color[channel]), theme().text);
}

void unlit(UiState& state, const Explanation& explanation, const ExplainedPoint& point) {
    const int channel = state.inspector.channel;
    if (point.cool_to_warm.used) return tone_line(point.cool_to_warm, channel);
    for (const TermLine& line : unlit_lines(state.editor.scene(), explanation, point, channel)) {
        ImGui::PushID(line.letter);
        (void)draw_term_line(line);
        ImGui::PopID();
    }
}

void mistakes_note(const Scene& scene) {
    if (const int on = mistakes_on(scene.shading.mistakes); on > 0)
        warning_text(
            fmt::format("{} mistake{} on: terms come out as the mistake makes them, and need not be "
                        "the product of their factors",
                        on, on == 1 ? " is" : "s are"));
}

std::string section_title(const InspectorState& state, const Explanation& explanation) {
    constexpr std::array channels{"red", "green", "blue"};
    return fmt::format("In {}, under {} shading", channels[static_cast<std::size_t>(state.channel)],
                       choice_of(explanation.mode).label);
}

}  // namespace

void equation_tab(UiState& state, const PictureView&) {
    if (!state.explanation)
        return inspector_empty_state(
            "Here the lighting equation of that pixel appears with its numbers: what each light adds, and "
            "why "
            "a light that you expect adds nothing.");
    const Explanation& explanation = *state.explanation;
    if (!explanation.hit) return wrapped_dim("No object shows here: the pixel has the background's colour.");
    if (static_cast<std::size_t>(explanation.object_index) >= state.editor.scene().objects.size()) return;
    equation(explanation.reflection);
    sum_table(state, explanation);
    display_lines(state, explanation);
    if (explanation.reflection != Reflection::None) {
        section_heading(section_title(state.inspector, explanation).c_str());
        mistakes_note(state.editor.scene());
        lit_at(state.inspector, explanation);
        const ExplainedPoint& point = asked_point(state.inspector, explanation);
        unlit(state, explanation, point);
        for (std::size_t i = 0; i < point.lights.size(); ++i) light_card(state, explanation, point, i);
        if (point.lights.empty()) wrapped_dim("No light is on: only ambient and emission are left.");
    }
    copy_buttons(explanation, state.editor.scene());
}

}  // namespace glint
