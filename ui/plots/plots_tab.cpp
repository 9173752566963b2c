#include "ui/plots/plots_tab.h"

#include <imgui.h>

#include <algorithm>

#include "ui/inspector/equation/parts.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

void light_field(PlotsState& plots, const Scene& scene) {
    plots.light = std::clamp(plots.light, 0, static_cast<int>(scene.lights.size()) - 1);
    ImGui::SetNextItemWidth(label_cell("Light"));
    if (!ImGui::BeginCombo("##plot_light",
                           scene.lights[static_cast<std::size_t>(plots.light)].name.c_str())) {
        tooltip("Light", "Whose curves are drawn");
        return;
    }
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
        ImGui::PushID(i);
        if (ImGui::Selectable(scene.lights[static_cast<std::size_t>(i)].name.c_str(), i == plots.light))
            plots.light = i;
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

}  // namespace

void plots_tab(UiState& state, const PictureView& view) {
    const Scene& scene = state.editor.scene();
    PlotsState& plots = state.views.plots;
    if (scene.lights.empty()) return wrapped_dim("The curves are those of a light: add one (L).");
    light_field(plots, scene);
    PlotSubject subject{scene, plots.light, plot_point(state.explanation, plots.light), {}};
    if (subject.point.material != nullptr)
        subject.material = *subject.point.material;
    else if (!scene.objects.empty())
        subject.material = scene.objects.front().material;
    if (subject.point.at == nullptr) small_dim("Pick a pixel to see where it lies on each curve.");
    if (subject.point.at != nullptr && subject.point.light == nullptr) small_dim("This light is off.");
    cosine_section(plots, subject);
    falloff_section(subject);
    spot_section(subject);
    kinds_section(subject, view);
    highlight_section(plots, subject);
    sketch_section(state, plots, subject);
    intensities_section(subject);
    lobe_section(plots, subject);
    brdf_section(plots, subject);
    microfacet_section(plots, subject);
}

}  // namespace glint
