#include "ui/inspector/tabs.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <utility>

#include "ui/inspector/equation/equation_tab.h"
#include "ui/inspector/outside_view.h"
#include "ui/inspector/vectors/vectors_tab.h"
#include "ui/plots/plots_tab.h"
#include "ui/ui.h"
#include "ui/views/term_grid.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr std::array tabs{
    InspectorTabInfo{InspectorTab::Equation, "Equation",
                     "The lighting equation at the picked pixel, with its numbers", equation_tab},
    InspectorTabInfo{InspectorTab::Vectors, "Vectors",
                     "n, l, v, r and h at the picked point, and the facet's own normal", vectors_tab},
    InspectorTabInfo{InspectorTab::Plots, "Plots",
                     "Falloff, highlight, cone, lobes and microfacets as curves", plots_tab},
    InspectorTabInfo{InspectorTab::Grid, "Light × term",
                     "Every term of every light as a small picture: alone, or left out", term_grid_tab},
    InspectorTabInfo{InspectorTab::Models, "Models",
                     "The same pixel under flat, facet, Gouraud and Phong shading", models_tab},
    InspectorTabInfo{InspectorTab::Sensitivity, "Sensitivity",
                     "What matters here: every number, sorted by how much the pixel moves with it",
                     sensitivity_tab},
    InspectorTabInfo{InspectorTab::Mistakes, "Mistakes", "Mistakes that are really made, each a switch",
                     mistakes_tab},
    InspectorTabInfo{InspectorTab::Matrices, "Matrices", "View, its inverse, projection, and what they carry",
                     matrices_tab},
    InspectorTabInfo{InspectorTab::Outside, "Outside",
                     "The eye, its view volume and the lights, seen from outside", outside_tab},
};

/// A tab's button; the chosen one stands on a bar of the accent.
bool tab_button(const InspectorTabInfo& info, bool chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? theme().field_active : theme().panel);
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? theme().text : theme().dim_text);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(6), px(3)});
    const bool clicked = ImGui::Button(info.label);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (chosen)
        ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - px(2)}, high, to_u32(theme().accent));
    tooltip(info.label, info.what);
    return clicked;
}

/// The buttons in as many rows as they need.
void tab_bar(InspectorState& inspector) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(fonts().small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(1), px(1)});
    bool first = true;
    for (const InspectorTabInfo& info : tabs) {
        const float width = ImGui::CalcTextSize(info.label).x + px(12);
        if (!first && ImGui::GetItemRectMax().x + px(1) + width <= right) ImGui::SameLine();
        first = false;
        if (tab_button(info, inspector.tab == info.tab)) inspector.tab = info.tab;
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({low.x, low.y}, {right, low.y}, to_u32(theme().line));
    ImGui::Dummy({0, px(3)});
}

}  // namespace

std::span<const InspectorTabInfo> inspector_tabs() { return tabs; }

void inspector(UiState& state, const PictureView& view) {
    const std::optional<Symbol> pointed_vector = std::exchange(state.inspector.pointed_vector, std::nullopt);
    const int pointed_light = std::exchange(state.inspector.pointed_light, -1);
    inspector_heading(state);
    tab_bar(state.inspector);
    for (const InspectorTabInfo& info : tabs) {
        if (info.tab != state.inspector.tab) continue;
        ImGui::BeginChild(info.label);  // each tab keeps its own place of scrolling
        info.draw(state, view);
        ImGui::EndChild();
    }
    if (pointed_vector != state.inspector.pointed_vector || pointed_light != state.inspector.pointed_light)
        redraw_within(0);  // the picture's arrows were drawn before
}

}  // namespace glint
