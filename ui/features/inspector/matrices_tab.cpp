#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "renderer/shade/light_sources.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Draws four columns of figures; each row's tooltip explains it.
void matrix(const char* id, const glm::dmat4& m, const std::array<const char*, 4>& meaning) {
    if (!ImGui::BeginTable(id, 4, ImGuiTableFlags_PadOuterX | ImGuiTableFlags_BordersOuterV)) return;
    for (int row = 0; row < 4; ++row) {
        ImGui::TableNextRow();
        for (int column = 0; column < 4; ++column) {
            ImGui::TableNextColumn();
            mono_text(shown_number(static_cast<float>(m[column][row])));
            tooltip(fmt::format("Row {}", row + 1).c_str(), meaning[static_cast<std::size_t>(row)]);
        }
    }
    ImGui::EndTable();
}

double distance_from_identity(const glm::dmat4& m) {
    double most = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) most = std::max(most, std::abs(m[i][j] - (i == j ? 1 : 0)));
    return most;
}

void camera_matrices(const Camera& camera, PictureSize size) {
    const glm::dmat4 view = view_from_world(camera), inverse = world_from_view(camera);
    section_heading("view_from_world: camera from world");
    matrix("##view", view,
           {"To the right of the camera, u; last: −u·eye", "Up, v; last: −v·eye",
            "Backwards, w = (eye − target) normalised; last: −w·eye",
            "Keeps w: 1 for positions, 0 for directions"});
    small_dim("Maps the eye to the origin. The lecture calls this one M_V2W.");
    section_heading("world_from_view: its inverse");
    matrix("##inverse", inverse,
           {"x of u, v, w and of the eye", "y of u, v, w and of the eye", "z of u, v, w and of the eye",
            "Keeps w"});
    small_dim(fmt::format("Maps the origin to the eye. The product of the two differs from I by {:.0e}.",
                          distance_from_identity(view * inverse)));
    section_heading("clip_from_view: projection");
    matrix("##projection", clip_from_view(camera.projection, size),
           {"x: scaled by the width of the view", "y: scaled by its height",
            "z: near becomes −1, far +1, after dividing by w",
            "w: −z under perspective, so distant things are small"});
    small_dim(fmt::format("For {} × {} pixels; visible where −w ≤ x, y, z ≤ w.", size.width, size.height));
}

/// A name and its numbers.
void row(const char* name, const std::string& numbers) {
    dim_text(name);
    ImGui::SameLine(px(56));
    mono_text(numbers);
}

std::string four_numbers(glm::vec4 v) { return shown_vector(v) + " " + shown_number(v.w); }

void light_rows(UiState& state) {
    const Scene& scene = explained_scene(state);
    section_heading("Lights in camera coordinates");
    if (scene.lights.empty()) return wrapped_dim("No lights.");
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const bool world = light.space == LightSpace::World;
        const CarriedLight both = carried(light, scene.camera, scene.shading.mistakes);
        ImGui::PushID(static_cast<int>(i));
        const std::string words =
            fmt::format("{}, given in {} coordinates", light.name, world ? "world" : "camera");
        if (ImGui::Selectable(whole_label(words).c_str()))
            state.editor.selection = {Selection::Kind::Light, static_cast<int>(i)};
        tooltip("Light", "Click to show its panel", "", fmt::format("/lights/{}/position", i));
        row("world", four_numbers(both.world));
        row("camera", four_numbers(both.camera));
        ImGui::PopID();
    }
    small_dim("The last number is w: 0 is a direction, which no translation moves.");
}

void stop(const char* name, const std::string& numbers, const char* what) {
    row(name, numbers);
    tooltip(name, what);
}

/// Lists the picked point's coordinates at each stage from the mesh to its pixel.
void carried_point(const UiState& state) {
    section_heading("The picked point, stage by stage");
    if (!state.on_screen.explanation || !state.on_screen.explanation->hit)
        return wrapped_dim("Click an object to follow a point on it.");
    const ExplainedSpaces& s = state.on_screen.explanation->spaces;
    stop("object", shown_vector(s.object), "In the mesh");
    stop("world", shown_vector(s.world), "After the object's transform");
    stop("camera", shown_vector(s.camera), "After view_from_world");
    ImGui::PushFont(fonts().small);
    ImGui::PushTextWrapPos(0);
    coloured(Symbol::L, "↳ lit here: angles and distances are still correct");
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    stop("clip", four_numbers(s.clip), "After clip_from_view; w last");
    stop("NDC", shown_vector(s.ndc), "Divided by w: −1 to 1");
    stop("pixel", fmt::format("{} {}", shown_number(s.pixel.x), shown_number(s.pixel.y)),
         "Scaled to the picture; y down");
    const InBothFrames& n = state.on_screen.explanation->at.normal;
    section_heading("Its normal");
    stop("world", shown_vector(n.world),
         "Through the inverse transpose of the object's transform, normalised");
    stop("camera", shown_vector(n.camera), "Normals are not projected: lighting uses them here");
}

}  // namespace

CarriedLight carried(const Light& light, const Camera& camera, const Mistakes& mistakes) {
    const glm::dvec4 given(light.position);
    const glm::dmat4 view = view_from_world(camera), carry = camera_from_light(light.space, view, mistakes);
    const glm::dvec4 arrived = carry * given;
    return {carry == view ? given : world_from_view(camera) * arrived, arrived};
}

void matrices_tab(UiState& state, const PictureView& view) {
    carried_point(state);
    camera_matrices(explained_scene(state).camera, view.map.size);
    light_rows(state);
}

}  // namespace glint
