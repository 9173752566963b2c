#include "ui/inspector/vectors/vectors_tab.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <glm/geometric.hpp>

#include "ui/inspector/asked.h"
#include "ui/inspector/equation/parts.h"
#include "ui/inspector/equation/words.h"
#include "ui/inspector/heading.h"
#include "ui/inspector/needs_section.h"
#include "ui/inspector/vectors/facet_section.h"
#include "ui/inspector/vectors/lobe_diagram.h"
#include "ui/inspector/vectors/mirror_section.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float part_width = 62;

void frame_switch(WhyState& why) {
    const std::array options{Choice{"camera", "Camera",
                                    "Where illumination is computed: the eye at the origin, "
                                    "looking down −z"},
                             Choice{"world", "World", "As the scene file says where things are"}};
    row("Frame");
    why.world_frame = segments("##frame", why.world_frame ? 1 : 0, options, {"", ""}) == 1;
}

void switches(WhyState& why) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    (void)ImGui::Checkbox("draw them in the picture", &why.shows_vectors);
    tooltip("Vectors in the picture", "n, l, v and r or h at the picked point, with their angles",
            "v, which points at the eye, is a circle there");
    const float facet = ImGui::GetFrameHeight() + px(8) + ImGui::CalcTextSize("its facet").x;
    if (ImGui::GetItemRectMax().x + px(16) + facet <= right) ImGui::SameLine(0, px(16));
    (void)ImGui::Checkbox("its facet", &why.shows_facet);
    tooltip("Facet in the picture", "Its corners in their order, two edges, and its normal");
}

/// One row; pointed at, its arrow is drawn thick.
void vector_row(WhyState& why, Symbol symbol, const char* letter, const InBothFrames& vector,
                const char* meaning) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    coloured(symbol, letter);
    const glm::vec3 v = why.world_frame ? vector.world : vector.camera;
    for (int i = 0; i < 3; ++i) {
        ImGui::TableNextColumn();
        figures(shown_number(v[i]));
    }
    if (ImGui::TableGetColumnCount() > 4) {
        ImGui::TableNextColumn();
        ImGui::PushFont(fonts().small);
        dim_text(meaning);
        ImGui::PopFont();
    } else {
        tooltip(letter, meaning);
    }
    const ImVec2 high{ImGui::GetItemRectMax().x, low.y + ImGui::GetTextLineHeight()};
    if (is_pointed_at(low, high) && *letter != 'p') why.pointed_vector = symbol;
}

void vector_table(WhyState& why, const ExplainedPoint& point, const ExplainedLight* light) {
    const bool roomy = ImGui::GetContentRegionAvail().x > px(290);  // for what each of them is
    if (!ImGui::BeginTable("##vectors", roomy ? 5 : 4,
                           ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingFixedFit))
        return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, px(14));
    for (const char* part : {"x", "y", "z"})
        ImGui::TableSetupColumn(part, ImGuiTableColumnFlags_WidthFixed, px(part_width));
    if (roomy) ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    vector_row(why, Symbol::Emission, "p", point.point, "the point");
    vector_row(why, Symbol::N, "n", point.normal, "normal");
    vector_row(why, Symbol::V, "v", point.view, "to the eye");
    if (light != nullptr && light->samples.empty()) {
        vector_row(why, Symbol::L, "l", light->l, "to the light");
        vector_row(why, Symbol::R, "r", light->r, "l mirrored");
        vector_row(why, Symbol::H, "h", light->h, "halfway l, v");
    }
    ImGui::EndTable();
}

/// The same angle from either frame: rigid motions keep it.
void same_product(const ExplainedPoint& point, const ExplainedLight& light) {
    const float camera = glm::dot(point.normal.camera, light.l.camera);
    const float world = glm::dot(point.normal.world, light.l.world);
    small_dim(fmt::format("n·l is {} in camera and {} in world coordinates", shown_number(camera),
                          shown_number(world)));
}

/// Which light's vectors are shown; a click takes another.
void light_buttons(UiState& state, const ExplainedPoint& point, const ExplainedLight& chosen) {
    ImGui::PushFont(fonts().small);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    bool first = true;
    for (const ExplainedLight& light : point.lights) {
        const float width = ImGui::CalcTextSize(light.name.c_str()).x + px(14);
        if (!first && ImGui::GetItemRectMax().x + px(4) + width <= right) ImGui::SameLine(0, px(4));
        first = false;
        const bool on = light.index == chosen.index;
        ImGui::PushStyleColor(ImGuiCol_Button, on ? theme().accent : theme().field);
        ImGui::PushStyleColor(ImGuiCol_Text, on ? theme().accent_text : theme().text);
        ImGui::PushID(light.index);
        if (ImGui::Button(light.name.c_str())) state.editor.selection = {Selection::Kind::Light, light.index};
        if (is_pointed_at()) state.why_column.pointed_light = light.index;
        ImGui::PopID();
        ImGui::PopStyleColor(2);
    }
    ImGui::PopFont();
}

}  // namespace

void vectors_tab(UiState& state, const PictureView&) {
    if (!state.why)
        return why_empty_state("Here the vectors of that point appear, drawn in the picture too.");
    const Explanation& why = *state.why;
    if (!why.hit) return wrapped_dim("No object shows here: there is no normal and no light.");
    const ExplainedPoint& point = asked_point(state.why_column, why);
    const ExplainedLight* light = asked_light(state, point);
    switches(state.why_column);
    frame_switch(state.why_column);
    if (light != nullptr) light_buttons(state, point, *light);
    vector_table(state.why_column, point, light);
    if (light != nullptr && light->samples.empty()) {
        same_product(point, *light);
        lobe_diagram(state, point, *light);
        mirror_section(state.why_column, point, *light);
        needs_section(state, point, *light);
    }
    facet_section(state, why);
}

}  // namespace glint
