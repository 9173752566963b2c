#include "ui/fields/mesh_check.h"

#include <fmt/core.h>
#include <imgui.h>

#include <cctype>
#include <string_view>

#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Draws a button for a repair that a scene can store; true when pressed.
bool repair(const char* name, bool done, const char* what) {
    ImGui::SameLine(0, px(4));
    const bool pressed = small_chosen_button(name, done);
    tooltip(name, what);
    return pressed;
}

/// Draws the repairs of one finding.
void repairs(std::string_view finding, Object& object) {
    if (finding == "normals_against_faces" &&
        repair("Flip", object.normals.flip, "Reverses all normals, for when most of them point inwards"))
        object.normals.flip = !object.normals.flip;
    if (finding.find("normals") != std::string_view::npos && finding != "own_normal_indices") {
        const bool done = object.normals.source == NormalSource::Vertex;
        if (repair("Recompute", done, "Averages the faces' normals instead of using the file's"))
            object.normals.source = done ? NormalSource::Auto : NormalSource::Vertex;
    }
    if ((finding == "open_edges" || finding == "opposite_winding") &&
        repair("Both sides", object.double_sided, "Also draws this object's back faces"))
        object.double_sided = !object.double_sided;
}

}  // namespace

void mesh_check_rows(MeshCheck& check, Object& object) {
    if (!object.mesh) return;
    const std::size_t count = check.info ? check.info->findings.size() : 0;
    const std::string found =
        count > 0 ? fmt::format(": {} {}", count, count == 1 ? "finding" : "findings") : "";
    const bool is_open = fold(("Mesh check" + found + "###check").c_str(), false);
    check.is_wanted = is_open || std::holds_alternative<MeshFile>(object.source);
    if (!is_open) return;
    if (!check.info) return small_dim("Checking …");
    if (count == 0) return small_dim("No problems found.");
    for (std::size_t i = 0; i < count; ++i) {
        const MeshFinding& finding = check.info->findings[i];
        const int index = static_cast<int>(i);
        ImGui::PushID(index);
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(finding.what.c_str());
        ImGui::PopTextWrapPos();
        std::string effect(finding.effect);
        if (!effect.empty())
            effect[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(effect[0])));
        small_dim(effect);
        if (!finding.places.empty()) {
            if (small_chosen_button("Show", check.shown == index))
                check.shown = check.shown == index ? -1 : index;
            tooltip("Show", finding.places.size() < finding.count ? "Shows the first positions in the picture"
                                                                  : "Shows the positions in the picture");
            if (is_pointed_at()) check.hovered = index;
        } else {
            ImGui::Dummy({0, 0});
        }
        repairs(finding.name, object);
        ImGui::PopID();
        ImGui::Dummy({0, px(2)});
    }
}

}  // namespace glint
