#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "ui/views/views.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

struct Preset {
    const char* label;
    std::vector<Variant> parts;
};

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all{
        {"Flat, Gouraud, Phong",
         {variant_of(ShadingMode::Flat), variant_of(ShadingMode::Gouraud), variant_of(ShadingMode::Phong)}},
        {"Gouraud, Phong", {variant_of(ShadingMode::Gouraud), variant_of(ShadingMode::Phong)}},
        {"Facet, Phong", {variant_of(ShadingMode::Facet), variant_of(ShadingMode::Phong)}},
        {"Phong's and Blinn's highlight",
         {variant_of(Reflection::Phong), variant_of(Reflection::BlinnPhong)}},
        {"As edited, B", {{}, {Variant::Kind::Stored, 0}}}};
    return all;
}

void presets_popup(CompareChoice& choice) {
    if (ImGui::SmallButton("Parts##presets")) ImGui::OpenPopup("##presets");
    tooltip("What is compared", "Or click a label on the picture to choose one part");
    ImGui::SameLine(0, px(4));
    if (!ImGui::BeginPopup("##presets")) return;
    for (const Preset& preset : presets()) {
        const bool needs_b = preset.parts.back().kind == Variant::Kind::Stored;
        const auto flags = needs_b && !choice.stored ? ImGuiSelectableFlags_Disabled : 0;
        if (ImGui::Selectable(preset.label, choice.parts == preset.parts, flags))
            set_parts(choice, preset.parts);
        if (flags != 0) tooltip(preset.label, "Store a scene first", "", keys_of(CommandId::StoreB));
    }
    ImGui::EndPopup();
}

/// Whether the parts lie side by side; of no use to a difference.
void stacked_button(CompareChoice& choice) {
    if (ImGui::SmallButton(choice.stacked ? "Stacked###stacked" : "Side by side###stacked"))
        choice.stacked = !choice.stacked;
    tooltip(choice.stacked ? "Stacked" : "Side by side",
            "Whether the parts follow from top to bottom or from left to right");
    ImGui::SameLine(0, px(4));
}

void difference_controls(CompareState& state) {
    CompareChoice& choice = state.choice;
    if (ImGui::SmallButton(fmt::format("×{}###gain", choice.gain).c_str()))
        choice.gain = choice.gain >= most_gain ? 1 : 2 * choice.gain;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) choice.gain = std::max(choice.gain / 2, 1);
    tooltip("Scale of the difference", "Click: twice as much, after ×64 again ×1 · Right click: half");
    ImGui::SameLine(0, px(8));
    const Comparison& n = state.numbers;
    mono_text(fmt::format("max {}  mean {:.2f}", n.max_error, (n.mean[0] + n.mean[1] + n.mean[2]) / 3));
    tooltip(
        "How far apart", "Largest and mean difference of the first and the last part, in steps of 0 to 255",
        fmt::format("max {} {} {}\nmean {:.3f} {:.3f} {:.3f}\nroot of mean square {:.3f} {:.3f} {:.3f}\n{} "
                    "pixels differ",
                    n.max[0], n.max[1], n.max[2], n.mean[0], n.mean[1], n.mean[2], n.rmse[0], n.rmse[1],
                    n.rmse[2], n.differing_pixels));
    ImGui::SameLine(0, px(4));
}

}  // namespace

void compare_controls(CompareState& state) {
    CompareChoice& choice = state.choice;
    if (!choice.on) return;
    presets_popup(choice);
    if (!choice.difference) stacked_button(choice);
    ImGui::PushStyleColor(ImGuiCol_Button, choice.difference ? theme().accent : theme().field);
    ImGui::PushStyleColor(ImGuiCol_Text, choice.difference ? theme().accent_text : theme().text);
    if (ImGui::SmallButton("Difference")) choice.difference = !choice.difference;
    ImGui::PopStyleColor(2);
    tooltip("Difference",
            (label_of(choice.parts.front()) + " against " + label_of(choice.parts.back())).c_str(),
            "Red, green and blue apart, of what is displayed");
    ImGui::SameLine(0, px(4));
    if (choice.difference) difference_controls(state);
}

}  // namespace glint
