#include <fmt/core.h>
#include <imgui.h>

#include <array>

#include "renderer/inspect/reflectance/term_sensitivity.h"
#include "ui/inspector/equation/parts.h"
#include "ui/inspector/tabs.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

void cell(float moved, const ImVec4& colour) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, moved > 0 ? colour : theme().disabled_text);
    const bool tiny = moved < 5e-5f;
    mono_text(moved == 0 ? "no" : tiny ? fmt::format("{:.0e}", moved) : fmt::format("{:.4f}", moved));
    ImGui::PopStyleColor();
}

}  // namespace

void term_sensitivity_section(const UiState& state, const ExplainedPoint& point,
                              const ExplainedLight& light) {
    section_heading("Which term needs what: moved by a turn of 1°");
    const Shading& shading = state.editor.scene().shading;
    const Reflector reflector{shading.reflection, state.explanation->material, Terms{}};
    const auto sensitivity =
        term_sensitivity(reflector, point.normal.camera, light.l.camera, point.view.camera);
    constexpr std::array names{"ambient", "diffuse", "specular"};
    constexpr std::array symbols{Symbol::Ambient, Symbol::Diffuse, Symbol::Specular};
    if (!ImGui::BeginTable("##needs", 4, ImGuiTableFlags_NoPadOuterX)) return;
    ImGui::TableNextColumn();
    for (const auto& [symbol, name] :
         {std::pair(Symbol::N, "normal"), std::pair(Symbol::L, "light"), std::pair(Symbol::V, "viewer")}) {
        ImGui::TableNextColumn();
        coloured(symbol, name);
    }
    for (std::size_t i = 0; i < sensitivity.size(); ++i) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        coloured(symbols[i], names[i]);
        cell(sensitivity[i].normal, theme()[symbols[i]]);
        cell(sensitivity[i].light, theme()[symbols[i]]);
        cell(sensitivity[i].viewer, theme()[symbols[i]]);
    }
    ImGui::EndTable();
    small_dim("For a white light of full strength from where this one stands; the point stays.");
}

}  // namespace glint
