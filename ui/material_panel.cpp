#include "ui/material_panel.h"

#include <imgui.h>

#include <string>

#include "ui/fonts.h"
#include "ui/scene_numbers.h"
#include "ui/theme.h"

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
    ImGui::SetNextItemWidth(row("Preset"));
    const std::string shown = present != nullptr ? std::string(present->name) : "own numbers";
    const bool open = ImGui::BeginCombo("##preset", shown.c_str(), ImGuiComboFlags_HeightLarge);
    if (!open) {
        tooltip("Preset", "One of the classic materials; sets ambient, diffuse, specular and shininess");
        return false;
    }
    std::string_view family;
    for (const MaterialPreset& preset : material_presets()) {
        if (preset.family != family) section(std::string(family = preset.family).c_str());
        if (!preset_row(preset, &preset == present)) continue;
        const Material& m = preset.material;
        material.ambient = m.ambient, material.diffuse = m.diffuse, material.specular = m.specular;
        material.shininess = m.shininess;
        edited = true;
    }
    ImGui::EndCombo();
    return edited;
}

}  // namespace

bool material_panel(Material& material, const std::string& pointer, Reflection reflection) {
    bool edited = preset_field(material);
    edited |= colour_field("Ambient", material.ambient, glm::vec3(0.2f),
                           {"k_a: share of ambient light reflected", pointer + "/ambient"});
    edited |= colour_field("Diffuse", material.diffuse, glm::vec3(0.8f),
                           {"k_d: share reflected evenly in all directions", pointer + "/diffuse"});
    edited |= colour_field("Specular", material.specular, glm::vec3(1),
                           {"k_s: share reflected into the highlight", pointer + "/specular"});
    edited |= colour_field("Emission", material.emission, glm::vec3(0),
                           {"Colour it shines by itself", pointer + "/emission"});
    const bool rough = reflection == Reflection::OrenNayar || reflection == Reflection::CookTorrance;
    const bool power = reflection == Reflection::Phong || reflection == Reflection::BlinnPhong ||
                       reflection == Reflection::Retro;
    const auto dimmed = [&edited](bool unused, auto field) {
        if (unused) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f);
        edited |= field();
        if (unused) ImGui::PopStyleVar();
    };
    dimmed(!power, [&] {
        return number_field("Shininess", material.shininess, shininess_spec.number,
                            {shininess_spec.what, pointer + "/shininess"});
    });
    dimmed(!rough, [&] {
        return number_field("Roughness", material.roughness, roughness_spec.number,
                            {roughness_spec.what, pointer + "/roughness"});
    });
    dimmed(reflection != Reflection::CookTorrance, [&] {
        return colour_field("F0", material.f0, glm::vec3(0.04f),
                            {"Reflectance seen head-on; Cook–Torrance", pointer + "/f0"});
    });
    return edited;
}

}  // namespace glint
