#include "ui/object_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "ui/choices.h"
#include "ui/icons.h"
#include "ui/limits.h"
#include "ui/material_panel.h"
#include "ui/widgets.h"

namespace glint {
namespace {

std::string shown_source(const MeshSource& source) {
    if (const auto* file = std::get_if<MeshFile>(&source))
        return file->path.substr(file->path.find_last_of('/') + 1);
    return std::string(primitive_name(std::get<PrimitiveMesh>(source).primitive));
}

/// Drop-down of all primitives and, at its end, of files.
bool source_field(Object& object, const std::string& pointer, ObjectWishes& wishes) {
    ImGui::SetNextItemWidth(row("Mesh"));
    if (!ImGui::BeginCombo("##mesh", shown_source(object.source).c_str(), ImGuiComboFlags_HeightLarge)) {
        tooltip("Mesh", "The shape: one that needs no file, or a file", "", pointer + "/mesh");
        return false;
    }
    bool edited = false;
    for (const Primitive primitive : all_primitives) {
        const PrimitiveMesh fresh{primitive, default_detail(primitive)};
        const auto* present = std::get_if<PrimitiveMesh>(&object.source);
        const bool chosen = present != nullptr && present->primitive == primitive;
        const std::string name(primitive_name(primitive));
        if (ImGui::Selectable(name.c_str(), chosen) && !chosen) {
            object.source = fresh;
            object.mesh = nullptr;
            edited = true;
        }
    }
    ImGui::Separator();
    if (ImGui::Selectable("File…")) wishes.browse_mesh = true;
    ImGui::EndCombo();
    return edited;
}

bool detail_field(Object& object, const std::string& pointer) {
    auto* primitive = std::get_if<PrimitiveMesh>(&object.source);
    if (primitive == nullptr) return false;
    const int initial = default_detail(primitive->primitive);
    if (!integer_field("Detail", primitive->detail, 1, max_detail(primitive->primitive), initial,
                       {"How finely the shape is cut into polygons", pointer + "/mesh/detail"}))
        return false;
    object.mesh = nullptr;
    return true;
}

void mesh_facts(const Object& object) {
    if (!object.mesh) return;
    const Mesh& mesh = *object.mesh;
    const std::size_t faces = mesh.face_count(), triangles = mesh.triangles.size();
    row("");
    // Where every face is a triangle one number says it all, and two need two lines.
    if (faces != triangles) {
        dim_text(fmt::format("{} {}", faces, faces == 1 ? "face" : "faces").c_str());
        row("");
    }
    dim_text(fmt::format("{} {}", triangles, triangles == 1 ? "triangle" : "triangles").c_str());
    for (const std::string& warning : mesh.warnings) {
        row("");
        ImGui::PushTextWrapPos(0);
        dim_text(warning.c_str());
        ImGui::PopTextWrapPos();
    }
}

/// Which gizmo stands on the object in the picture.
void gizmo_field(GizmoMode& gizmo) {
    static const std::array<Option, 4> modes{
        Option{"–", "", "No gizmo in the picture"},
        Option{"Move", "", "Arrows, planes and the middle move it (key G)"},
        Option{"Turn", "", "Rings turn it round an axis or the line of sight (key R)"},
        Option{"Scale", "", "Boxes scale it along its own axes, the middle as a whole (key T)"}};
    row("By hand");
    gizmo = static_cast<GizmoMode>(
        segments("##gizmo", static_cast<int>(gizmo), modes, {"What drags in the picture do to it", ""}));
}

bool transform_fields(Transform& transform, const std::string& pointer, GizmoMode& gizmo) {
    section("Transform");
    gizmo_field(gizmo);
    const Number place{.speed = 0.01f, .format = "%.2f"}, angle{.speed = 0.5f, .format = "%.1f", .unit = "°"};
    bool edited = false;
    edited |= vector_field("Move", transform.translate, place, glm::vec3(0),
                           {"Where it stands, scene units", pointer + "/translate"});
    edited |= vector_field("Rotate", transform.rotate_deg, angle, glm::vec3(0),
                           {"About x, then y, then z", pointer + "/rotate_deg"});
    edited |= vector_field("Scale", transform.scale, place, glm::vec3(1),
                           {"Along its own axes; negative mirrors", pointer + "/scale"});
    return edited;
}

bool normal_fields(NormalOptions& normals, const std::string& pointer) {
    section("Normals");
    bool edited = choice_field("Source", normals.source, normal_source_choices,
                               {"Where the corners' normals come from", pointer + "/source"});
    edited |= choice_field("Weights", normals.weighting, weighting_choices,
                           {"How facets count when normals are averaged", pointer + "/weighting"});
    edited |= number_field(
        "Crease", normals.crease_deg,
        {.min = 0,
         .max = 180,
         .initial = 180,
         .speed = 0.3f,
         .format = "%.1f°",
         .unit = "°",
         .shown_max = 180},
        {"Facets that meet at more are not averaged across; 180 is no crease", pointer + "/crease_deg"});
    return edited;
}

}  // namespace

bool object_panel(Object& object, const std::string& pointer, Reflection reflection, ObjectWishes& wishes) {
    const Object before = object;
    bool edited = name_field("Name", object.name, {"What the object is called", pointer + "/name"});
    edited |= source_field(object, pointer, wishes);
    edited |= detail_field(object, pointer);
    mesh_facts(object);
    section("Material");
    edited |= material_panel(object.material, pointer + "/material", reflection);
    edited |= transform_fields(object.transform, pointer + "/transform", wishes.gizmo);
    edited |= normal_fields(object.normals, pointer + "/normals");
    return edited && keep_valid(object, before);
}

}  // namespace glint
