#include "ui/why/equation_tab.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/choices.h"
#include "ui/fonts.h"
#include "ui/icons.h"
#include "ui/theme.h"
#include "ui/ui.h"
#include "ui/why/equation.h"
#include "ui/why/heading.h"
#include "ui/why/parts.h"
#include "ui/why/words.h"
#include "ui/widgets.h"

namespace glint {
namespace {

constexpr float channel_width = 58;

void cells(glm::vec3 value, const ImVec4& colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    for (int i = 0; i < 3; ++i) {
        ImGui::TableNextColumn();
        figures(shown_number(value[i]));
    }
    ImGui::PopStyleColor();
}

void term_row(Symbol symbol, const char* name, glm::vec3 value, bool on) {
    const bool nothing = value == glm::vec3(0);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    coloured(symbol, name);
    if (!on) {
        ImGui::SameLine(0, px(5));
        dim_text("off");
    }
    cells(value, nothing ? theme().disabled_text : theme()[symbol]);
}

bool begin_numbers(const char* id) {
    if (!ImGui::BeginTable(id, 4, ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingFixedFit)) return false;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const char* channel : {"red", "green", "blue"})
        ImGui::TableSetupColumn(channel, ImGuiTableColumnFlags_WidthFixed, px(channel_width));
    return true;
}

/// I = emission + ambient + diffuse + specular, a row a term, a column a channel.
void sum_table(const Explanation& why, const Scene& scene) {
    const TermSums sums = term_sums(why);
    const Terms& terms = scene.shading.terms;
    if (!begin_numbers("##sum")) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(fonts().small);
    dim_text("I =");
    for (const char* channel : {"   red", " green", "  blue"}) {
        ImGui::TableNextColumn();
        dim_text(channel);
    }
    ImGui::PopFont();
    if (sums.emission != glm::vec3(0) || !terms.emission)
        term_row(Symbol::Emission, "e  emission", sums.emission, terms.emission);
    term_row(Symbol::Ambient, "a  ambient", sums.ambient, terms.ambient);
    term_row(Symbol::Diffuse, "d  diffuse", sums.diffuse, terms.diffuse);
    term_row(Symbol::Specular, "s  specular", sums.specular, terms.specular);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("sum");
    const ImVec2 at = ImGui::GetItemRectMin();
    cells(why.sum, theme().text);
    ImGui::GetWindowDrawList()->AddLine({at.x, at.y - px(1)}, {ImGui::GetItemRectMax().x, at.y - px(1)},
                                        packed(theme().dim_text));
    ImGui::EndTable();
}

void display_line(const Explanation& why, const Scene& scene) {
    const Display& display = scene.display;
    std::string steps;
    if (display.exposure != 1) steps += fmt::format("× exposure {:.3g}  ", display.exposure);
    if (display.transfer == Transfer::Srgb) steps += "→ sRGB  ";
    const auto [r, g, b] = why.byte;
    ImGui::PushFont(fonts().small);
    if (!steps.empty()) dim_text(fmt::format("{}→ {} {} {}", steps, r, g, b).c_str());
    if (const std::string clipped = why_clipped(why.sum, display.exposure); !clipped.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme().warning);
        ImGui::TextUnformatted(clipped.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
}

/// "n·l 0.713 (44.5°)", its letters in the vectors' colours.
void dot_line(Symbol a, const char* name_a, Symbol b, const char* name_b, float value) {
    coloured(a, name_a);
    ImGui::SameLine(0, 0);
    ImGui::TextUnformatted("·");
    ImGui::SameLine(0, 0);
    coloured(b, name_b);
    ImGui::SameLine(0, px(6));
    const double angle = std::acos(std::clamp(double(value), -1.0, 1.0)) * 180 / std::numbers::pi;
    figures(fmt::format("{} {:5.1f}°", shown_number(value), angle));
}

void highlight_line(const ExplainedLight& light, const Explanation& why) {
    if (why.reflection == Reflection::Phong) dot_line(Symbol::R, "r", Symbol::V, "v", light.r_dot_v);
    if (why.reflection == Reflection::BlinnPhong) dot_line(Symbol::N, "n", Symbol::H, "h", light.n_dot_h);
    const bool power = why.reflection == Reflection::Phong || why.reflection == Reflection::BlinnPhong;
    if (!power) return;
    ImGui::SameLine(0, px(8));
    dim_text(fmt::format("to the {:.4g}:", why.material.shininess).c_str());
    ImGui::SameLine(0, px(2));
    figures(shown_number(light.specular_factor.x));
}

/// "36 samples, n·l −0.12 to 0.71".
std::string sample_words(const ExplainedLight& area) {
    const auto less = [](const ExplainedLight& a, const ExplainedLight& b) { return a.n_dot_l < b.n_dot_l; };
    const auto [low, high] = std::minmax_element(area.samples.begin(), area.samples.end(), less);
    if (low == area.samples.end()) return {};
    return fmt::format("{} samples, n·l {} to {}", area.samples.size(), shown_number(low->n_dot_l),
                       shown_number(high->n_dot_l));
}

void factor_line(const ExplainedLight& explained, const Light& light) {
    std::string text;
    if (light.kind == LightKind::Point || light.kind == LightKind::Spot)
        text = fmt::format("r {:.3g}   falloff {:.3f}", explained.distance, explained.falloff);
    if (light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90)
        text += fmt::format("   spot {:.3f} at {:.1f}°", explained.spot, explained.spot_angle_deg);
    if (light.kind == LightKind::Area) text = sample_words(explained);
    if (text.empty()) return;
    ImGui::PushFont(fonts().small);
    dim_text(text.c_str());
    ImGui::PopFont();
}

void light_card(const ExplainedLight& explained, const Explanation& why, const Scene& scene, UiState& state) {
    const auto index = static_cast<std::size_t>(explained.index);
    if (index >= scene.lights.size()) return;
    const Light& light = scene.lights[index];
    ImGui::PushID(explained.index);
    ImGui::Dummy({0, px(2)});
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    draw_icon(*ImGui::GetWindowDrawList(), icon_of(light.kind), {low.x + line / 2, low.y + line / 2}, line,
              packed(legible(colour_of(light))));
    if (ImGui::Selectable(fmt::format("      {}", light.name).c_str()))
        state.editor.selection = {Selection::Kind::Light, explained.index};
    tooltip("Light", "Click to show its panel");
    if (light.kind != LightKind::Area) {  // whose samples each have their own vectors
        dot_line(Symbol::N, "n", Symbol::L, "l", explained.n_dot_l);
        highlight_line(explained, why);
    }
    factor_line(explained, light);
    if (const std::string reason = why_dark(explained, light); !reason.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme().warning);
        ImGui::TextUnformatted(reason.c_str());
        ImGui::PopStyleColor();
    }
    if (begin_numbers("##terms")) {
        if (explained.ambient != glm::vec3(0)) term_row(Symbol::Ambient, "a", explained.ambient, true);
        term_row(Symbol::Diffuse, "d", explained.diffuse, true);
        term_row(Symbol::Specular, "s", explained.specular, true);
        ImGui::EndTable();
    }
    ImGui::PopID();
}

/// Which corner's numbers to show: their weights, which sum to 1.
const ExplainedPoint& lit_point(WhyState& state, const Explanation& why) {
    if (!why.lit_per_corner || why.corners.empty()) return why.at;
    const int count = static_cast<int>(why.corners.size());
    state.corner = std::clamp(state.corner, 0, count - 1);
    if (count == 1) {
        wrapped_dim("Lit once for the whole polygon:");
        return why.corners.front().at;
    }
    wrapped_dim("Lit at the corners, the colours mixed by their weights:");
    for (int i = 0; i < count; ++i) {
        const ExplainedCorner& corner = why.corners[static_cast<std::size_t>(i)];
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
    return why.corners[static_cast<std::size_t>(state.corner)].at;
}

}  // namespace

void equation_tab(UiState& state, const PictureView&) {
    if (!state.why)
        return why_empty_state(
            "Here the lighting equation of that pixel appears with its numbers: what each light adds, and "
            "why "
            "a light that you expect adds nothing.");
    const Explanation& why = *state.why;
    const Scene& scene = state.editor.scene();
    if (!why.hit) return wrapped_dim("No object shows here: the pixel has the background's colour.");
    equation(why.reflection);
    sum_table(why, scene);
    display_line(why, scene);
    if (why.reflection == Reflection::None) return;
    section(fmt::format("Lights, under {}",
                        mode_choices[static_cast<std::size_t>(index_of(mode_choices, why.mode))].label)
                .c_str());
    const ExplainedPoint& point = lit_point(state.why_column, why);
    for (const ExplainedLight& light : point.lights) light_card(light, why, scene, state);
    if (point.lights.empty()) wrapped_dim("No light is on: only ambient and emission are left.");
}

}  // namespace glint
