#pragma once
// The plots of the tab, one a function. Each draws into the current window at its width.

#include "ui/plots/plots_tab.h"
#include "ui/shell/layout.h"

namespace glint {

/// What every plot draws from.
struct PlotSubject {
    const Scene& scene;
    int light = 0;  // in scene.lights, which are not empty
    PlotPoint point;
    Material material;  // of the picked object, else of the first; defaults without objects
};

/// Room for a plot: as wide as the window, `height` units of the design high; moves the cursor below it.
[[nodiscard]] Rect plot_room(float height);

void falloff_section(const PlotSubject& subject);
void highlight_section(PlotsState& plots, const PlotSubject& subject);
void cosine_section(PlotsState& plots, const PlotSubject& subject);
void sketch_section(UiState& state, PlotsState& plots, const PlotSubject& subject);
void spot_section(const PlotSubject& subject);
void kinds_section(const PlotSubject& subject, const PictureView& view);
void intensities_section(const PlotSubject& subject);
void brdf_section(PlotsState& plots, const PlotSubject& subject);
void lobe_section(PlotsState& plots, const PlotSubject& subject);
void microfacet_section(PlotsState& plots, const PlotSubject& subject);

}  // namespace glint
