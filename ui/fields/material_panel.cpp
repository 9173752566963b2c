#include <imgui.h>

#include <string>

#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

bool same_look(const Material& a, const Material& b) {
    return a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular &&
           a.shininess == b.shininess;
}

/// The preset that this material is, if any.
const MaterialPreset* preset_of(const Material& material) {
    for (const MaterialPreset& preset : material_presets())
        if (same_look(preset.material, material)) return &preset;
    return nullptr;
}

/// A ball of the preset's colours: ambient rim, diffuse body, a highlight.
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

bool preset_field(Material& material) {
    const MaterialPreset* present = preset_of(material);
    bool edited = false;
    ImGui::SetNextItemWidth(label_cell("Preset"));
    const std::string shown = present != nullptr ? std::string(present->name) : "Custom";
    const bool open = ImGui::BeginCombo("##preset", shown.c_str(), ImGuiComboFlags_HeightLarge);
    if (!open) {
        tooltip("Preset", "One of the classic materials; sets ambient, diffuse, specular and shininess");
        return false;
    }
    std::string_view family;
    for (const MaterialPreset& preset : material_presets()) {
        if (preset.family != family) section_heading(std::string(family = preset.family).c_str());
        if (!preset_row(preset, &preset == present)) continue;
        apply(preset, material);
        edited = true;
    }
    ImGui::EndCombo();
    return edited;
}

}  // namespace

void apply(const MaterialPreset& preset, Material& material) {
    const Material& m = preset.material;
    material.ambient = m.ambient, material.diffuse = m.diffuse, material.specular = m.specular;
    material.shininess = m.shininess;
}

bool material_panel(Material& material, const std::string& pointer, Reflection reflection) {
    const ReflectionInfo uses = info_of(reflection);
    bool edited = preset_field(material);
    FieldPanel panel(material, pointer);
    panel.dim("shininess", uses.uses_shininess())
        .dim("roughness", uses.uses_roughness)
        .dim("f0", uses.uses_f0);
    return panel.rest().edited() || edited;
}

}  // namespace glint
