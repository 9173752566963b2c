#include "ui/features/inspector/vectors/vectors_tab.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/reflectance/highlight.h"
#include "renderer/reflectance/term_sensitivity.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

namespace {

constexpr float part_width = 62;

void frame_switch(InspectorState& inspector) {
    const std::array options{Choice{"camera", "Camera",
                                    "Where illumination is computed: the eye at the origin, "
                                    "looking down −z"},
                             Choice{"world", "World", "As in the scene file"}};
    label_cell("Frame");
    inspector.world_frame = segments("##frame", inspector.world_frame ? 1 : 0, options, {"", ""}) == 1;
}

void switches(InspectorState& inspector) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    (void)ImGui::Checkbox("Draw in the picture", &inspector.shows_vectors);
    tooltip("Vectors in the picture", "n, l, v and r or h at the picked point, with their angles",
            "v points at the eye, so it appears as a circle");
    const float facet = ImGui::GetFrameHeight() + px(8) + ImGui::CalcTextSize("Facet").x;
    same_line_if_fits(facet, px(16), right);
    (void)ImGui::Checkbox("Facet", &inspector.shows_facet);
    tooltip("Facet in the picture", "Its corners in order, two edges, and its normal");
}

/// Draws one row. While the row is hovered, its arrow is drawn thick.
void vector_row(InspectorState& inspector, Symbol symbol, const char* letter, const InBothFrames& vector,
                const char* meaning) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    coloured(symbol, letter);
    const glm::vec3 v = inspector.world_frame ? vector.world : vector.camera;
    for (int i = 0; i < 3; ++i) {
        ImGui::TableNextColumn();
        mono_text(shown_number(v[i]));
    }
    if (ImGui::TableGetColumnCount() > 4) {
        ImGui::TableNextColumn();
        ImGui::PushFont(fonts().small);
        dim_text(meaning);
        ImGui::PopFont();
    } else {
        tooltip(letter, meaning);
    }
    const Rect row{low, {ImGui::GetItemRectMax().x, low.y + ImGui::GetTextLineHeight()}};
    if (is_pointed_at(row) && *letter != 'p') inspector.pointed_vector = symbol;
}

void vector_table(InspectorState& inspector, const ExplainedPoint& point, const ExplainedLight* light) {
    const bool roomy = ImGui::GetContentRegionAvail().x > px(290);  // for the explanations
    if (!ImGui::BeginTable("##vectors", roomy ? 5 : 4,
                           ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingFixedFit))
        return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, px(14));
    for (const char* part : {"x", "y", "z"})
        ImGui::TableSetupColumn(part, ImGuiTableColumnFlags_WidthFixed, px(part_width));
    if (roomy) ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    vector_row(inspector, Symbol::Construction, "p", point.point, "the point");
    vector_row(inspector, Symbol::N, "n", point.normal, "normal");
    vector_row(inspector, Symbol::V, "v", point.view, "to the eye");
    if (light != nullptr && light->samples.empty()) {
        vector_row(inspector, Symbol::L, "l", light->l, "to the light");
        vector_row(inspector, Symbol::R, "r", light->r, "l mirrored");
        vector_row(inspector, Symbol::H, "h", light->h, "between l, v");
    }
    ImGui::EndTable();
}

/// Shows that both frames give the same angle: rigid motions preserve it.
void same_product(const ExplainedPoint& point, const ExplainedLight& light) {
    const float camera = glm::dot(point.normal.camera, light.l.camera);
    const float world = glm::dot(point.normal.world, light.l.world);
    small_dim(fmt::format("n·l is {} in camera and {} in world coordinates", shown_number(camera),
                          shown_number(world)));
}

/// Names the light whose vectors are shown; a click chooses a different one.
void light_buttons(UiState& state, const ExplainedPoint& point, const ExplainedLight& chosen) {
    ImGui::PushFont(fonts().small);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (const ExplainedLight& light : point.lights) {
        const std::string name = whole_label(light.name);
        if (&light != &point.lights.front())
            same_line_if_fits(ImGui::CalcTextSize(name.c_str()).x + px(14), px(4), right);
        ImGui::PushID(light.index);
        if (chosen_button(name.c_str(), light.index == chosen.index))
            state.editor.selection = {Selection::Kind::Light, light.index};
        if (is_pointed_at()) state.get<InspectorState>().pointed_light = light.index;
        ImGui::PopID();
    }
    ImGui::PopFont();
}

/// Builds r = 2 n (n·l) − l in four steps, with a slider for the length of n. The numbers are in the column's
/// frame; the picture shows the chosen step.
void mirror_section(InspectorState& state, const ExplainedPoint& point, const ExplainedLight& light) {
    section_heading("r = 2 n (n·l) − l, step by step");
    static const std::array options{Choice{"", "Off", "r itself is drawn"},
                                    Choice{"", "n, l", "The given vectors"},
                                    Choice{"", "q", "q = n (n·l): the projection of l onto n"},
                                    Choice{"", "2q", "Twice as long"}, Choice{"", "r", "r = 2q − l"}};
    state.mirror_step = segments("##step", state.mirror_step, options, {"", ""});
    if (state.mirror_step == 0) return;
    number_field("|n|", state.normal_length,
                 {.range = {0.25, 2, "0.25 to 2"}, .step = 0.005f, .format = "%.2f", .usual_max = 2}, 1,
                 {"Length of the normal here; a normal should have unit length. Not part of the scene", ""});
    const bool world = state.world_frame;
    const glm::vec3 n = state.normal_length * (world ? point.normal.world : point.normal.camera);
    const glm::vec3 l = world ? light.l.world : light.l.camera;
    const MirrorSteps steps = mirror_steps(n, l);
    vector_line(Symbol::N, "n", n);
    vector_line(Symbol::L, "l", l);
    if (state.mirror_step >= 2) vector_line(Symbol::Construction, "q = n (n·l)", steps.p);
    if (state.mirror_step >= 3) vector_line(Symbol::Construction, "2q", steps.twice_p);
    if (state.mirror_step >= 4) vector_line(Symbol::R, "r = 2q − l", steps.r);
    const float length = state.normal_length;
    if (std::abs(length - 1) > 0.005f)
        warning_text(fmt::format("|n| = {:.2f}: q is {:.2f} times as long as it should be, |r| = {:.2f}",
                                 length, length * length, glm::length(steps.r)));
}

void cell(float moved, const ImVec4& colour) {
    ImGui::TableNextColumn();
    ImGui::PushFont(fonts().figures);
    const bool tiny = moved < 5e-5f;
    coloured(moved > 0 ? colour : theme().disabled_text, moved == 0 ? "no"
                                                         : tiny     ? fmt::format("{:.0e}", moved)
                                                                    : fmt::format("{:.4f}", moved));
    ImGui::PopFont();
}

/// Shows live how much each term at the picked point changes when the normal, the light or the viewer is
/// turned by one degree.
void sensitivity_of_terms(const UiState& state, const ExplainedPoint& point, const ExplainedLight& light) {
    section_heading("What each term depends on: change per 1° of rotation");
    const Shading& shading = explained_scene(state).shading;
    Reflector reflector = reflector_of(state.on_screen.explanation->material, shading);
    reflector.terms = {};
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
    small_dim("For a white light of full strength at this light's position; the point does not move.");
}

}  // namespace

void vectors_tab(UiState& state, const PictureView&) {
    if (!state.on_screen.explanation)
        return inspector_empty_state("Click a pixel to see its vectors here and in the picture.");
    const Explanation& explanation = *state.on_screen.explanation;
    if (!explanation.hit)
        return wrapped_dim("No object is visible here, so there is no normal and no light.");
    const ExplainedPoint& point = asked_point(state.get<InspectorState>(), explanation);
    const ExplainedLight* light = asked_light(state, point);
    switches(state.get<InspectorState>());
    frame_switch(state.get<InspectorState>());
    if (light != nullptr) light_buttons(state, point, *light);
    vector_table(state.get<InspectorState>(), point, light);
    if (light != nullptr && light->samples.empty()) {
        same_product(point, *light);
        lobe_diagram(state, point, *light);
        mirror_section(state.get<InspectorState>(), point, *light);
        sensitivity_of_terms(state, point, *light);
    }
    facet_section(state, explanation);
}

void vector_line(Symbol symbol, const char* name, glm::vec3 v) {
    coloured(symbol, name);
    ImGui::SameLine(px(112));
    mono_text(shown_vector(v));
}

}  // namespace glint
