#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "renderer/reflectance/highlight.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/plots/plot.h"
#include "ui/fields/field_panel.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Clamps a linear colour. The exact displayed colour is known only for the explained sum.
ImU32 ink_of(glm::vec3 c) {
    return to_u32({std::clamp(c.x, 0.0f, 1.0f), std::clamp(c.y, 0.0f, 1.0f), std::clamp(c.z, 0.0f, 1.0f), 1});
}

void swatch(ImU32 colour, float edge) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), high = low + edge * ImVec2(1, 1);
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, colour, px(3));
    ImGui::GetWindowDrawList()->AddRect(low, high, to_u32(theme().line), px(3));
    ImGui::Dummy({edge, edge});
}

/// Lists the corners from which the colour is computed, with their weights.
void corner_lines(const Explanation& explanation) {
    char letter = 'A';
    for (const ExplainedCorner& corner : explanation.corners) {
        swatch(ink_of(corner.at.sum), ImGui::GetTextLineHeight());
        ImGui::SameLine(0, px(6));
        dim_text(fmt::format("{}", letter++).c_str());
        ImGui::SameLine(0, px(6));
        mono_text(fmt::format("{:.3f} × {}", corner.weight, shown_vector(corner.at.sum)));
    }
}

/// Explains how the mode computes the colour.
void how(const Explanation& explanation, const Shading& shading) {
    switch (explanation.mode) {
    case ShadingMode::Flat:
        return small_dim(flat_at_provoking_corner(shading)
                             ? "lit once, at the triangle's provoking corner"
                             : "lit once, at the polygon's centroid, with the facet's normal");
    case ShadingMode::Facet:
        return small_dim("lit here, with the facet's normal");
    case ShadingMode::Gouraud:
        small_dim(fmt::format("lit at the corners; {} weights × colours, added:",
                              choice_of(explanation.interpolation).word));
        return corner_lines(explanation);
    case ShadingMode::Phong:
        return small_dim("lit here, with the corners' normals interpolated and normalised:");
    }
}

/// Shows n in the frame chosen in the Vectors tab.
void normal_line(const InspectorState& state, const Explanation& explanation) {
    if (explanation.lit_per_corner) return;
    const InBothFrames& n = explanation.at.normal;
    coloured(Symbol::N, "n");
    ImGui::SameLine(0, px(6));
    mono_text(shown_vector(state.world_frame ? n.world : n.camera));
}

void mode_block(UiState& state, const Explanation& explanation, ShadingMode mode, const Explanation& phong) {
    Shading& shading = state.editor.scene().shading;
    const Choice choice = choice_of(mode);
    const bool chosen = shading.mode == mode;
    ImGui::PushID(choice.label);
    ImGui::BeginGroup();
    const auto [r, g, b] = explanation.byte;
    const float edge = 2 * ImGui::GetTextLineHeight() + px(5);
    swatch(IM_COL32(r, g, b, 255), edge);
    ImGui::SameLine(0, px(8));
    ImGui::BeginGroup();
    ImGui::PushFont(chosen ? fonts().title : fonts().body);
    if (ImGui::Selectable(choice.label, chosen)) shading.mode = mode;
    ImGui::PopFont();
    const bool pointed = is_pointed_at();
    tooltip(choice.label, choice.meaning, "Hover to preview, click to apply", "/shading/mode");
    mono_text(shown_vector(explanation.sum));
    ImGui::EndGroup();
    how(explanation, shading);
    normal_line(state.get<InspectorState>(), explanation);
    if (mode != ShadingMode::Phong) small_dim("minus Phong: " + shown_vector(explanation.sum - phong.sum));
    ImGui::EndGroup();
    ImGui::PopID();
    ImGui::Dummy({0, px(4)});
    if (!pointed) return;
    Scene other = state.editor.scene();
    other.shading.mode = mode;
    show_instead(state, other, fmt::format("{} shading", choice.label));
}

/// Finds the shininess with which Blinn's highlight looks most like this Phong highlight. A click applies the
/// model and that shininess.
void like_line(UiState& state, const Explanation& explanation) {
    Scene& scene = state.editor.scene();
    const auto object = static_cast<std::size_t>(explanation.object_index);
    const float n = explanation.material.shininess;
    if (explanation.reflection != Reflection::Phong || object >= scene.objects.size() || n <= 0) return;
    const double like = state.get<PlotsState>().blinn_like.of(n, [n] { return blinn_shininess_like(n); });
    section_heading("Blinn–Phong versus Phong");
    wrapped_dim(fmt::format(
        "Phong's highlight here has shininess {:.4g}. Blinn's (n·h)ˢ comes closest to it with {:.4g}.", n,
        like));
    const auto change = [&](Scene& changed) {
        Material& material = changed.objects[object].material;
        if (material.reflection == OwnReflection::Scene)
            changed.shading.reflection = Reflection::BlinnPhong;
        else
            material.reflection = OwnReflection::BlinnPhong;
        material.shininess = static_cast<float>(like);
    };
    if (ImGui::Button("Change to Blinn–Phong")) change(scene);
    tooltip("Change to Blinn–Phong", "Uses that shininess; undo restores Phong");
    if (!is_pointed_at()) return;
    Scene other = scene;
    change(other);
    show_instead(state, other, fmt::format("Blinn–Phong, shininess {:.4g}", like));
}

/// Whether the scenes agree in everything that determines which face is visible at a pixel.
bool same_faces(const Scene& a, const Scene& b) {
    return same_surfaces(a, b) && a.shading.cull == b.shading.cull && a.npr == b.npr;
}

}  // namespace

std::array<Explanation, 4> under_each_mode(const UiState& state, const Explanation& explanation) {
    std::array<Explanation, 4> all;
    Scene other = state.editor.scene();
    for (std::size_t i = 0; i < all.size(); ++i) {
        other.shading.mode = static_cast<ShadingMode>(i);
        all[i] = state.renderer->explain_as(other, explanation.x, explanation.y);
    }
    return all;
}

std::optional<Explanation> under_phong(const UiState& state, const Explanation& explanation) {
    Scene other = explained_scene(state);
    if (explanation.mode != other.shading.mode || !same_faces(state.rendered_scene, other)) return {};
    other.shading.mode = ShadingMode::Phong;
    return state.renderer->explain_as(other, explanation.x, explanation.y);
}

void models_tab(UiState& state, const PictureView&) {
    if (!state.on_screen.explanation)
        return inspector_empty_state(
            "Click a pixel to see it under flat, facet, Gouraud and Phong shading at once.");
    const Explanation& explanation = *state.on_screen.explanation;
    if (!explanation.hit) return wrapped_dim("No object is visible here: every model shows the background.");
    if (!same_faces(state.rendered_scene, state.editor.scene()))
        return wrapped_dim("A different scene is on the screen; this tab is about the edited one.");
    const std::array<Explanation, 4> all = under_each_mode(state, explanation);
    small_dim(fmt::format(
        "Sums at the same pixel, red green blue; {} triangle of face {}, perspective weights {}",
        explanation.front_facing ? "front" : "back", explanation.face, shown_vector(explanation.weights)));
    ImGui::Dummy({0, px(2)});
    for (std::size_t i = 0; i < all.size(); ++i)
        mode_block(state, all[i], static_cast<ShadingMode>(i), all.back());
    like_line(state, explanation);
}

}  // namespace glint
