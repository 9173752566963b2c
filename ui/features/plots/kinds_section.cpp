// A live table for the picked point: what each kind of light depends on.
#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <glm/geometric.hpp>

#include "renderer/explain/printed_number.h"
#include "renderer/reflectance/term_sensitivity.h"
#include "ui/features/plots/plots_tab.h"
#include "ui/fields/field_panel.h"
#include "ui/picture/handles/light_place.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

struct Column {
    const char* title;
    float Moved::*moved;
    const char* what;
};
constexpr std::array columns{
    Column{"light", &Moved::light, "the light's position: surface and viewer move away from it by a tenth"},
    Column{"viewer", &Moved::viewer, "the viewer's position: sideways by a tenth of its distance"},
    Column{"surface", &Moved::surface, "the surface's angle: turned by 1°"}};

/// Names the terms that change.
void moved_words(float diffuse, float specular) {
    if (diffuse > 0 && specular > 0) return ImGui::TextUnformatted("both");
    if (diffuse > 0) return coloured(Symbol::Diffuse, "diffuse");
    if (specular > 0) return coloured(Symbol::Specular, "specular");
    coloured(theme().disabled_text, "none");
}

std::string moved_text(const char* term, float moved) {
    return moved > 0 ? fmt::format("{} {:.2g}", term, moved) : fmt::format("{} stays, to the last bit", term);
}

/// According to the lecture's table, a sun does not depend on the viewer; its highlight contradicts that.
bool table_fails(LightKind kind, const Column& column, const LightSensitivity& sensitivity) {
    return kind == LightKind::Directional && column.moved == &Moved::viewer &&
           sensitivity.specular.viewer > 0;
}

/// Draws a cell of the table. True if it has a star.
bool cell(LightKind kind, const Column& column, const LightSensitivity& sensitivity) {
    ImGui::TableNextColumn();
    ImGui::BeginGroup();
    ImGui::PushFont(fonts().small);
    moved_words(sensitivity.diffuse.*column.moved, sensitivity.specular.*column.moved);
    ImGui::PopFont();
    const bool starred = table_fails(kind, column, sensitivity);
    if (starred) {
        ImGui::SameLine(0, px(4));
        ImGui::TextUnformatted("*");
    }
    ImGui::EndGroup();
    tooltip(column.title, column.what,
            moved_text("diffuse", sensitivity.diffuse.*column.moved) + "\n" +
                moved_text("specular", sensitivity.specular.*column.moved));
    return starred;
}

void figure_cell(float value) {
    ImGui::TableNextColumn();
    mono_text(significant_text(double(value), 3));
}

void header() {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(fonts().small);
    for (const char* title : {columns[0].title, columns[1].title, columns[2].title, "falloff", "cone"}) {
        ImGui::TableNextColumn();
        dim_text(title);
    }
    ImGui::PopFont();
}

}  // namespace

Light of_kind_at(const Light& light, LightKind kind, const ExplainedPoint& at, const PictureView& view) {
    Light other = as_kind(light, kind, view.dome, view.map);
    if (light.kind != kind && kind == LightKind::Spot) {
        const glm::dvec3 way = glm::dvec3(at.point.world) - handle_of(other, view.dome, view.map);
        other.spot.direction = glm::vec3(to_own(other, glm::normalize(way), 0, view.map));
    }
    return other;
}

void kinds_section(const PlotSubject& subject, const PictureView& view) {
    if (!fold("What each kind of light depends on", false)) return;
    if (subject.point.at == nullptr || subject.point.material == nullptr)
        return small_dim(
            "Pick a pixel to see how its terms change when the light, the viewer or the surface moves.");
    const Light& light = subject.scene.lights[static_cast<std::size_t>(subject.light)];
    if (!ImGui::BeginTable("##kinds", 6, ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingStretchProp))
        return;
    header();
    bool starred = false;
    for (const LightKind kind : enumerators<LightKind>) {
        const LightSensitivity sensitivity = light_sensitivity(
            subject.scene, view.map.size, of_kind_at(light, kind, *subject.point.at, view),
            *subject.point.material, subject.point.at->point.camera, subject.point.at->normal.camera);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        coloured(kind == light.kind ? theme().text : theme().dim_text, choice_of(kind).label);
        for (const Column& column : columns) starred |= cell(kind, column, sensitivity);
        figure_cell(sensitivity.falloff);
        figure_cell(sensitivity.spot);
    }
    ImGui::EndTable();
    small_dim(
        "Which term changes when the light, the viewer, the surface moves? Each kind of light is tried, "
        "white, at this light's position, a spot aimed at the point.");
    if (starred)
        small_dim(
            "* The lecture's table says that a sun's light does not depend on the viewer: that is true of "
            "its diffuse term.");
}

}  // namespace glint
