// A slice of the BRDF, read forwards and backwards.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/inspect/debug_views/profile.h"
#include "ui/inspector/equation/parts.h"
#include "ui/plots/plot.h"
#include "ui/plots/plots_tab.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int steps = 180;
constexpr double usual_deg = 45;  // of the light, where none is picked
constexpr double steepest = 89;

bool same(const Reflector& a, const Reflector& b) {
    return a.reflection == b.reflection && a.material == b.material;
}

/// It takes some milliseconds: kept, and not begun again while the mouse drags something.
void update_reciprocity(PlotsState& plots, const Reflector& reflector) {
    if (plots.reciprocity_of && same(*plots.reciprocity_of, reflector)) return;
    if (ImGui::IsAnyMouseDown()) return redraw_within(0.1);
    plots.reciprocity = reciprocity_error(reflector);
    plots.reciprocity_of = reflector;
}

void verdict(const PlotsState& plots) {
    if (!plots.reciprocity_of) return;
    const double error = plots.reciprocity;
    if (error < 1e-4)
        small_dim("The same both ways, over 4096 pairs of directions: reciprocal (Helmholtz).");
    else
        warning_text(
            fmt::format("Not reciprocal: up to {:.0f} % apart over 4096 pairs of directions.", 100 * error));
}

}  // namespace

BrdfCurves brdf_curves(const Reflector& reflector, double light_deg) {
    BrdfCurves curves;
    for (const LobeSample& s : lobe_slice(reflector, light_deg, steps)) {
        curves.forwards.emplace_back(s.view_deg, intensity_of(s.brdf));
        const glm::vec3 back = brdf(reflector, in_plane(s.view_deg), in_plane(-light_deg));
        curves.backwards.emplace_back(s.view_deg, intensity_of(back));
    }
    return curves;
}

void brdf_section(PlotsState& plots, const PlotSubject& subject) {
    section_heading("BRDF f(l, v), a slice");
    const Reflector reflector{subject.scene.shading.reflection, subject.material, {}};
    const bool picked = subject.point.light != nullptr;
    const double light_deg = picked ? local_directions(subject.point).light_deg : usual_deg;
    if (!(light_deg <= steepest)) return small_dim("The light stands behind the surface: f is 0.");
    const BrdfCurves curves = brdf_curves(reflector, light_deg);
    double most = 1e-3;
    for (const glm::dvec2 p : curves.forwards) most = std::max(most, p.y);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const AxisText up{"f", "1/sr"};
    const PlotArea area =
        draw_axes(list, plot_room(132), {-90, 90}, {0, 1.25 * most}, {"v from n", "degrees", true, 30}, up);
    draw_upright(list, area, -light_deg, theme()[Symbol::L], 0.7f);
    draw_upright(list, area, light_deg, theme()[Symbol::R], 0.4f);
    draw_curve(list, area, curves.backwards, theme()[Symbol::L], 1.2f);
    draw_curve(list, area, curves.forwards, theme()[Symbol::V], 2.2f);
    draw_y_name(list, area, up);
    if (picked) {
        const LocalDirections local = local_directions(subject.point);
        const double f = intensity_of(brdf(reflector, local.l, local.v));
        if (local.v.z > 0)
            draw_mark(list, area, {local.view_deg, f}, theme()[Symbol::V], fmt::format("{:.3f}", f));
    }
    coloured(Symbol::V, "f(l, v)");
    ImGui::SameLine(0, px(10));
    coloured(Symbol::L, "f(v, l): read backwards");
    small_dim(fmt::format("l at {:.1f}° from n (line); f = (d + s) / (π n·l)", light_deg));
    update_reciprocity(plots, reflector);
    verdict(plots);
}

}  // namespace glint
