// One object: its mesh, transform and material.

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <string_view>
#include <type_traits>

#include "models/gltf/gltf.h"
#include "ui/document/scene_edit.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/widgets/kept.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

bool same_look(const Material& a, const Material& b) {
    return a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular &&
           a.shininess == b.shininess;
}

/// Returns the preset with the same values as this material, if any.
const MaterialPreset* preset_of(const Material& material) {
    for (const MaterialPreset& preset : material_presets())
        if (same_look(preset.material, material)) return &preset;
    return nullptr;
}

/// Draws a ball in the preset's colours: ambient rim, diffuse body, a highlight.
void swatch(const Material& m, ImVec2 centre, float radius) {
    const auto ink = [](glm::vec3 c) {
        return ImGui::ColorConvertFloat4ToU32(
            {std::min(c.x, 1.0f), std::min(c.y, 1.0f), std::min(c.z, 1.0f), 1});
    };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(centre, radius, ink(0.5f * (m.ambient + m.diffuse)));
    list.AddCircleFilled({centre.x - 0.1f * radius, centre.y - 0.1f * radius}, 0.78f * radius,
                         ink(m.ambient + m.diffuse));
    list.AddCircleFilled({centre.x - 0.35f * radius, centre.y - 0.35f * radius}, 0.25f * radius,
                         ink(m.ambient + m.diffuse + m.specular));
}

bool preset_row(const MaterialPreset& preset, bool chosen) {
    const std::string id = "##" + std::string(preset.name);
    const bool pressed = ImGui::Selectable(id.c_str(), chosen, 0, {0, ImGui::GetFrameHeight()});
    const ImVec2 low = ImGui::GetItemRectMin();
    const float height = ImGui::GetFrameHeight();
    swatch(preset.material, {low.x + 0.6f * height, low.y + height / 2}, 0.38f * height);
    const std::string name(preset.name);
    ImGui::GetWindowDrawList()->AddText(
        {low.x + 1.3f * height, low.y + (height - ImGui::GetTextLineHeight()) / 2},
        ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
    return pressed;
}

void preset_field(Material& material) {
    const MaterialPreset* present = preset_of(material);
    ImGui::SetNextItemWidth(label_cell("Preset"));
    const std::string shown = present != nullptr ? std::string(present->name) : "Custom";
    const bool open = ImGui::BeginCombo("##preset", shown.c_str(), ImGuiComboFlags_HeightLarge);
    if (!open)
        return tooltip("Preset",
                       "One of the classic materials; sets ambient, diffuse, specular and shininess");
    std::string_view family;
    for (const MaterialPreset& preset : material_presets()) {
        if (preset.family != family) section_heading(std::string(family = preset.family).c_str());
        if (preset_row(preset, &preset == present)) apply(preset, material);
    }
    ImGui::EndCombo();
}

/// Returns the label of a mesh: a primitive's label, or a file's name.
std::string mesh_label(const MeshSource& source) {
    const auto* primitive = std::get_if<PrimitiveMesh>(&source);
    return primitive != nullptr ? choice_of(primitive->primitive).label : short_name(source);
}

/// Draws a drop-down of all primitives, with an entry for choosing a file at its end.
void source_field(MeshSource& source, const std::string& pointer, ObjectRequests& requests) {
    ImGui::SetNextItemWidth(label_cell("Mesh"));
    if (!ImGui::BeginCombo("##mesh", whole_label(mesh_label(source)).c_str(), ImGuiComboFlags_HeightLarge))
        return tooltip("Mesh", "The shape: a built-in one, or a mesh file", "", pointer + "/mesh");
    for (const Primitive primitive : enumerators<Primitive>) {
        const auto* present = std::get_if<PrimitiveMesh>(&source);
        const bool chosen = present != nullptr && present->primitive == primitive;
        if (ImGui::Selectable(choice_of(primitive).label, chosen) && !chosen)
            source = default_mesh(primitive);
    }
    ImGui::Separator();
    if (ImGui::Selectable("File…")) requests.browse_mesh = true;
    ImGui::EndCombo();
}

/// Draws a slider up to the mesh's original number of triangles, which is shown as "all".
void decimate_field(const Row& row, int& decimate, const Mesh* mesh, const Help& help) {
    constexpr std::size_t when_not_known = 1'000'000;
    const std::size_t given = mesh == nullptr             ? when_not_known
                              : mesh->given_triangles > 0 ? mesh->given_triangles
                                                          : mesh->triangles.size();
    const auto all = static_cast<float>(std::max<std::size_t>(given, 2));
    const Real kind{.range = {1, double(all), "1 to all"},
                    .format = decimate == 0 ? "all" : "%.0f",
                    .usual_max = all,
                    .logarithmic = true};
    float wanted = decimate == 0 ? all : std::min(static_cast<float>(decimate), all);
    if (number_field(row.label, wanted, kind, all, help))
        decimate = wanted >= all ? 0 : std::max(static_cast<int>(std::round(wanted)), 1);
}

/// Draws the fields of the mesh's source, such as the number of subdivisions.
void detail_fields(Object& object, const std::string& pointer) {
    std::visit(
        [&](auto& source) {
            FieldPanel panel(source, pointer + "/mesh");
            if constexpr (std::is_same_v<std::decay_t<decltype(source)>, MeshFile>) {
                if (is_gltf_path(source.path))
                    panel.draw({"part"});
                else
                    panel.skip("part");  // there is only one
            }
            if constexpr (std::is_same_v<std::decay_t<decltype(source)>, PrimitiveMesh>)
                panel.skip("primitive").draw_as("detail", [&](const Row& row, const Help& help, const auto&) {
                    const PrimitiveInfo info = info_of(source.primitive);
                    integer_field(row.label, source.detail, Count{1, info.max_detail}, info.default_detail,
                                  help);
                });
            panel.draw_as("decimate", [&](const Row& row, const Help& help, const auto&) {
                decimate_field(row, source.decimate, object.mesh.get(), help);
            });
            panel.rest();
        },
        object.source);
}

void mesh_facts(const Object& object, const std::string& about_mesh) {
    if (!object.mesh) return;
    const Mesh& mesh = *object.mesh;
    const std::size_t faces = mesh.face_count(), triangles = mesh.triangles.size();
    label_cell("");
    // If every face is a triangle, one number is enough; otherwise faces and triangles get a line each.
    if (faces != triangles) {
        dim_text(fmt::format("{} {}", with_thousands(faces), faces == 1 ? "face" : "faces").c_str());
        label_cell("");
    }
    const std::string count =
        fmt::format("{} {}", with_thousands(triangles), triangles == 1 ? "triangle" : "triangles");
    dim_text(count.c_str());
    if (mesh.given_triangles > 0) {
        label_cell("");
        dim_text(fmt::format("out of {}", with_thousands(mesh.given_triangles)).c_str());
    }
    const auto line = [](const std::string& words) {
        label_cell("");
        ImGui::PushTextWrapPos(0);
        dim_text(words.c_str());
        ImGui::PopTextWrapPos();
    };
    for (const std::string& warning : mesh.warnings) line(warning);
    if (!about_mesh.empty()) line(about_mesh);
}

template <class Vector> auto largest_of(const Vector& scale) {
    const Vector size = glm::abs(scale);
    return std::max({size.x, size.y, size.z});
}

/// The scales before the common field changed them, and the scales that it set.
struct UniformScale {
    glm::dvec3 before{0};
    glm::vec3 written{0};
};

/// Draws one number for all three scales: the largest one. The scales keep their ratio and signs.
void uniform_scale_field(glm::vec3& scale, const std::string& pointer) {
    // The ratio is taken from before the edit: typing "0.5" passes through "0", which would lose the ratio.
    auto& [before, written] = widget_state<UniformScale>();
    if (scale != written) before = scale;
    float wanted = largest_of(scale);
    const Real kind{.range = above_zero, .step = 0.01f, .format = "%.2f", .logarithmic = true};
    const Help help{"Scales all three axes by one factor. Shows the largest of the three", pointer};
    if (number_field("Scale all", wanted, kind, 1, help))
        scale = written = glm::vec3(before * (double(wanted) / largest_of(before)));
}

/// Draws a choice between the gizmos that can appear on the object in the picture.
void gizmo_field(GizmoMode& gizmo) {
    const auto with_key = [](const char* what, CommandId id) {
        return fmt::format("{} (key {})", what, keys_of(id));
    };
    static const std::string
        move = with_key("Drag arrows, planes or the centre to move it", CommandId::MoveByHand),
        turn = with_key("Drag rings to turn it round an axis or the line of sight", CommandId::RotateByHand),
        scale = with_key("Drag boxes to scale it along its own axes, the centre to scale it uniformly",
                         CommandId::ScaleByHand);
    const std::array modes{Choice{"", "None", "No gizmo in the picture"}, Choice{"", "Move", move.c_str()},
                           Choice{"", "Rotate", turn.c_str()}, Choice{"", "Scale", scale.c_str()}};
    label_cell("Gizmo");
    gizmo = static_cast<GizmoMode>(segments("##gizmo", static_cast<int>(gizmo), modes,
                                            {"What a drag in the picture does to the object", ""}));
}

}  // namespace

void apply(const MaterialPreset& preset, Material& material) {
    const Material& m = preset.material;
    material.ambient = m.ambient, material.diffuse = m.diffuse, material.specular = m.specular;
    material.shininess = m.shininess;
}

void material_panel(Material& material, const std::string& pointer, Reflection of_scene) {
    const ReflectionInfo uses = info_of(reflection_of(material, of_scene));
    preset_field(material);
    FieldPanel panel(material, pointer);
    panel.dim("shininess", uses.uses_shininess())
        .dim("roughness", uses.uses_roughness)
        .dim("f0", uses.uses_f0)
        .dim("reflection", uses.is_lit);
    panel.draw({"reflection"});
    panel.rest();
}

void object_panel(Object& object, const std::string& pointer, Reflection reflection,
                  ObjectRequests& requests) {
    FieldPanel panel(object, pointer);
    panel.draw({"name", "visible", "double_sided"});
    const MeshSource source = object.source;
    source_field(object.source, pointer, requests);
    detail_fields(object, pointer);
    if (object.source != source) object.mesh = nullptr;
    mesh_facts(object, requests.about_mesh);
    if (requests.check != nullptr) mesh_check_rows(*requests.check, object);
    const auto normals = [&] { panel.group("normals", object.normals, field_rows<NormalOptions>); };
    // If the mesh has no normals, these are the fields that users look for first.
    const bool brings_normals = !object.mesh || object.mesh->given_normals != GivenNormals::None;
    if (!brings_normals) normals();
    // Drawn below the fields, so that the fields do not move when the note disappears.
    if (smooths_every_edge(object))
        wrapped_dim(
            "The mesh has no normals, so facet normals are averaged across all edges. Crease keeps edges "
            "sharp.");
    panel.group("material", object.material,
                [&](Material& material, const std::string& at) { material_panel(material, at, reflection); });
    panel.group("transform", object.transform, [&](Transform& transform, const std::string& at) {
        gizmo_field(requests.gizmo);
        field_rows(transform, at);
        uniform_scale_field(transform.scale, at + "/scale");
    });
    if (brings_normals) normals();
    panel.rest();
}

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
