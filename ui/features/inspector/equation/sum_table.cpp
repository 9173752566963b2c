#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/features/inspector/equation/words.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// The width of a column; smaller if the names would not fit otherwise.
float channel_width() { return std::min(px(58), (ImGui::GetContentRegionAvail().x - px(100)) / 3); }
constexpr std::array channel_names{"red", "green", "blue"};

/// The headings "red green blue" of the columns; a click chooses the channel.
void header_row(InspectorState& inspector) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(fonts().small);
    dim_text("I =");
    for (int c = 0; c < 3; ++c) {
        ImGui::TableNextColumn();
        const char* name = channel_names[static_cast<std::size_t>(c)];
        ImGui::PushStyleColor(ImGuiCol_Text, c == inspector.channel ? theme().text : theme().dim_text);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + px(8));
        if (ImGui::Selectable(name, false, 0, {ImGui::GetContentRegionAvail().x - px(4), 0}))
            inspector.channel = c;
        ImGui::PopStyleColor();
        const auto [low, high] = last_item();
        if (c == inspector.channel)
            ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - px(1.5f)}, high,
                                                      to_u32(theme().accent));
        tooltip(name, "Click to write out the products below in this channel");
    }
    ImGui::PopFont();
}

/// The numbers of a row; each can be copied, alone or all three.
void cells(const char* row, glm::vec3 value, const ImVec4& colour) {
    ImGui::PushID(row);
    for (int c = 0; c < 3; ++c) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, colour);
        mono_text(shown_number(value[c]));
        ImGui::PopStyleColor();
        copy_menu(c, shown_number(value[c]), shown_vector(value));
    }
    ImGui::PopID();
}

void term_row(UiState& state, Symbol symbol, const char* name, glm::vec3 value, bool on) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    coloured(symbol, name);
    if (!on) {
        ImGui::SameLine(0, px(5));
        dim_text("off");
    }
    cells(name, value, value == glm::vec3(0) ? theme().disabled_text : theme()[symbol]);
    const Rect row{low, {ImGui::GetItemRectMax().x, low.y + ImGui::GetTextLineHeight()}};
    list_control(name, "", row);
    if (!on || !is_pointed_at(row)) return;
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, to_u32(theme().field));
    show_instead(state, with_term_alone(explained_scene(state), symbol), fmt::format("{} alone", name + 3));
}

void sum_row(glm::vec3 sum) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("sum");
    const ImVec2 at = ImGui::GetItemRectMin() - ImVec2(0, px(1));
    cells("sum", sum, theme().text);
    ImGui::GetWindowDrawList()->AddLine(at, {ImGui::GetItemRectMax().x, at.y}, to_u32(theme().dim_text));
}

}  // namespace

void sum_table(UiState& state, const Explanation& explanation) {
    const TermSums sums = term_sums(explanation);
    const Terms& on = explained_scene(state).shading.terms;
    const float width = channel_width();
    if (!ImGui::BeginTable("##sum", 4, ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const char* channel : channel_names)
        ImGui::TableSetupColumn(channel, ImGuiTableColumnFlags_WidthFixed, width);
    header_row(state.get<InspectorState>());
    if (explained_scene(state).npr.cool_to_warm) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted("tone, for e + a + d");
        cells("tone", sums.tone, theme().text);
    } else {
        term_row(state, Symbol::Emission, "e  emission", sums.emission, on.emission);
        term_row(state, Symbol::Ambient, "a  ambient", sums.ambient, on.ambient);
        term_row(state, Symbol::Diffuse, "d  diffuse", sums.diffuse, on.diffuse);
    }
    // In a comparison the scene's own model may differ from that of the picked part.
    if (explained_scene(state).transport.model == TransportModel::Bounces || sums.bounced != glm::vec3(0))
        term_row(state, Symbol::Ambient, "b  bounced", sums.bounced, on.ambient);
    term_row(state, Symbol::Specular, "s  specular", sums.specular, on.specular);
    sum_row(explanation.stroke.coverage > 0 ? explanation.stroke.shaded : explanation.sum);
    ImGui::EndTable();
}

void display_lines(const UiState& state, const Explanation& explanation) {
    const Display& display = explained_scene(state).display;
    if (explanation.stroke.coverage > 0)
        small_dim(fmt::format("a stroke covers {:.0f} % of the pixel → {}", 100 * explanation.stroke.coverage,
                              shown_vector(explanation.sum)));
    std::string steps;
    if (display.exposure != 1) steps += fmt::format("× exposure {:.3g}  ", display.exposure);
    if (display.transfer == Transfer::Srgb) steps += "→ sRGB  ";
    const auto [r, g, b] = explanation.byte;
    if (!steps.empty()) small_dim(fmt::format("{}→ {} {} {}", steps, r, g, b));
    if (const std::string clipped = clipping_reason(explanation.sum, display.exposure); !clipped.empty()) {
        ImGui::PushFont(fonts().small);
        warning_text(clipped);
        ImGui::PopFont();
    }
}

}  // namespace glint
