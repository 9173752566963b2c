#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/shortcut.h"

namespace glint {
namespace {

std::string shown_source(const MeshSource& source) {
    if (const auto* file = std::get_if<MeshFile>(&source))
        return file->path.substr(file->path.find_last_of('/') + 1);
    return std::string(name_of(std::get<PrimitiveMesh>(source).primitive));
}

/// Drop-down of all primitives and, at its end, of files.
bool source_field(Object& object, const std::string& pointer, ObjectRequests& requests) {
    ImGui::SetNextItemWidth(label_cell("Mesh"));
    if (!ImGui::BeginCombo("##mesh", shown_source(object.source).c_str(), ImGuiComboFlags_HeightLarge)) {
        tooltip("Mesh", "The shape: one that needs no file, or a file", "", pointer + "/mesh");
        return false;
    }
    bool edited = false;
    for (const Primitive primitive : enumerators<Primitive>) {
        const PrimitiveMesh fresh{primitive, info_of(primitive).default_detail};
        const auto* present = std::get_if<PrimitiveMesh>(&object.source);
        const bool chosen = present != nullptr && present->primitive == primitive;
        const std::string name(name_of(primitive));
        if (ImGui::Selectable(name.c_str(), chosen) && !chosen) {
            object.source = fresh;
            object.mesh = nullptr;
            edited = true;
        }
    }
    ImGui::Separator();
    if (ImGui::Selectable("File…")) requests.browse_mesh = true;
    ImGui::EndCombo();
    return edited;
}

bool detail_field(Object& object, const std::string& pointer) {
    auto* primitive = std::get_if<PrimitiveMesh>(&object.source);
    if (primitive == nullptr) return false;
    FieldPanel panel(*primitive, pointer + "/mesh");
    panel.skip("primitive").draw_as("detail", [&](const Row& row, const Help& help, const auto&) {
        const PrimitiveInfo info = info_of(primitive->primitive);
        return integer_field(row.label, primitive->detail, 1, info.max_detail, info.default_detail, help);
    });
    if (!panel.rest().edited()) return false;
    object.mesh = nullptr;
    return true;
}

void mesh_facts(const Object& object) {
    if (!object.mesh) return;
    const Mesh& mesh = *object.mesh;
    const std::size_t faces = mesh.face_count(), triangles = mesh.triangles.size();
    label_cell("");
    // Where every face is a triangle one number says it all, and two need two lines.
    if (faces != triangles) {
        dim_text(fmt::format("{} {}", faces, faces == 1 ? "face" : "faces").c_str());
        label_cell("");
    }
    dim_text(fmt::format("{} {}", triangles, triangles == 1 ? "triangle" : "triangles").c_str());
    for (const std::string& warning : mesh.warnings) {
        label_cell("");
        ImGui::PushTextWrapPos(0);
        dim_text(warning.c_str());
        ImGui::PopTextWrapPos();
    }
}

/// Which gizmo stands on the object in the picture.
void gizmo_field(GizmoMode& gizmo) {
    const auto with_key = [](const char* what, CommandId id) {
        return fmt::format("{} (key {})", what, keys_of(id));
    };
    static const std::string move = with_key("Arrows, planes and the middle move it", CommandId::MoveByHand),
                             turn = with_key("Rings turn it round an axis or the line of sight",
                                             CommandId::RotateByHand),
                             scale = with_key("Boxes scale it along its own axes, the middle as a whole",
                                              CommandId::ScaleByHand);
    const std::array modes{Choice{"", "–", "No gizmo in the picture"}, Choice{"", "Move", move.c_str()},
                           Choice{"", "Turn", turn.c_str()}, Choice{"", "Scale", scale.c_str()}};
    label_cell("By hand");
    gizmo = static_cast<GizmoMode>(
        segments("##gizmo", static_cast<int>(gizmo), modes, {"What drags in the picture do to it", ""}));
}

}  // namespace

bool object_panel(Object& object, const std::string& pointer, Reflection reflection,
                  ObjectRequests& requests) {
    const Object before = object;
    FieldPanel panel(object, pointer);
    panel.draw({"name"});
    bool edited = source_field(object, pointer, requests);
    edited |= detail_field(object, pointer);
    mesh_facts(object);
    panel.group("material", object.material, [&](Material& material, const std::string& at) {
        return material_panel(material, at, reflection);
    });
    panel.group("transform", object.transform, [&](Transform& transform, const std::string& at) {
        gizmo_field(requests.gizmo);
        return field_rows(transform, at);
    });
    panel.group("normals", object.normals, field_rows<NormalOptions>);
    edited |= panel.rest().edited();
    return edited && keep_valid(object, before);
}

}  // namespace glint
