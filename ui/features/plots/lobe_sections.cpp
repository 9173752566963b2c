// The light that a surface reflects into each direction: polar plots, and a slice of the BRDF, forwards and
// backwards.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "renderer/debug_views/profile.h"
#include "renderer/reflectance/lobes.h"
#include "ui/features/plots/plot.h"
#include "ui/features/plots/plots_tab.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int lobe_steps = 180;

Reflector reflector_of(const PlotSubject& subject) {
    return {subject.scene.shading.reflection, subject.material, {}};
}

template <class Value>
std::vector<glm::dvec2> polar(const std::vector<LobeSample>& slice, const Value& value) {
    std::vector<glm::dvec2> curve;
    curve.reserve(slice.size());
    for (const LobeSample& s : slice) curve.emplace_back(s.view_deg, intensity_of(value(s.reflected)));
    return curve;
}

double max_of(const std::vector<glm::dvec2>& curve) {
    double most = 1e-3;
    for (const glm::dvec2 p : curve) most = std::max(most, p.y);
    return most;
}

struct Lobe {
    std::vector<glm::dvec2> ambient, diffuse, specular, total;
};

Lobe lobe_of(const Reflector& reflector, double light_deg, bool with_ambient) {
    const std::vector<LobeSample> slice = lobe_slice(reflector, light_deg, lobe_steps);
    Lobe lobe;
    lobe.ambient = polar(slice, [](const Reflected& r) { return r.ambient; });
    lobe.diffuse = polar(slice, [](const Reflected& r) { return r.diffuse; });
    lobe.specular = polar(slice, [](const Reflected& r) { return r.specular; });
    lobe.total = polar(
        slice, [&](const Reflected& r) { return with_ambient ? r.intensity() : r.diffuse + r.specular; });
    return lobe;
}

void draw_lobe(ImDrawList& list, const PolarArea& area, const Lobe& lobe, bool with_ambient) {
    if (with_ambient) draw_polar_curve(list, area, lobe.ambient, theme()[Symbol::Ambient], 1.2f);
    draw_polar_curve(list, area, lobe.diffuse, theme()[Symbol::Diffuse], 1.2f);
    draw_polar_curve(list, area, lobe.specular, theme()[Symbol::Specular], 1.2f);
    draw_polar_curve(list, area, lobe.total, theme().accent, 2);
}

void lobe_legend(bool with_ambient) {
    if (with_ambient) {
        coloured(Symbol::Ambient, "ambient");
        ImGui::SameLine(0, px(8));
    }
    legend({{Symbol::Diffuse, "diffuse"}, {Symbol::Specular, "specular"}});
    ImGui::SameLine(0, px(8));
    coloured(theme().accent, "sum");
}

void energy_line(const LobeEnergy& energy, double light_deg) {
    const double specular = intensity_of(glm::vec3(energy.specular)),
                 albedo = intensity_of(glm::vec3(energy.albedo));
    mono_text(fmt::format("specular energy {:.4f}   albedo {:.3f}", specular, albedo));
    tooltip("Energy",
            "The specular term times n·v, over all directions (2π k_s / (n + 2) for Phong head on); and "
            "the share of the light's power that is reflected in all",
            fmt::format("for the light at {:.0f}°", light_deg));
    if (albedo > 1.0005) warning_text("More light leaves than arrives.");
}

constexpr double usual_deg = 45;  // for the BRDF's light without a picked pixel
constexpr double steepest = 89;

void verdict(const PlotsState& plots) {
    const double* const error = plots.reciprocity.value();
    if (error == nullptr) return;
    if (*error < 1e-4)
        small_dim("The same both ways, over 4096 pairs of directions: reciprocal (Helmholtz).");
    else
        warning_text(
            fmt::format("Not reciprocal: up to {:.0f} % apart over 4096 pairs of directions.", 100 * *error));
}

}  // namespace

void intensities_section(const PlotSubject& subject) {
    if (!fold("Intensity by direction, light at 60°, 25° and 0°", false)) return;
    const Rect room = plot_room(72);
    const float width = room.size().x / 3;
    const Reflector reflector = reflector_of(subject);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::array<Lobe, 3> lobes;
    constexpr std::array angles{60.0, 25.0, 0.0};
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        lobes[i] = lobe_of(reflector, angles[i], true);
        most = std::max(most, max_of(lobes[i].total));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const float left = room.low.x + width * float(i);
        const PolarArea area = draw_polar_axes(list, {{left, room.low.y}, {left + width, room.high.y}}, most);
        draw_lobe(list, area, lobes[i], true);
        draw_direction(list, area, -angles[i], theme()[Symbol::L], "l", true);
    }
    lobe_legend(true);
    small_dim("For a white light with an ambient part of 1, luminance; the length is what the eye receives.");
}

void lobe_section(PlotsState& plots, const PlotSubject& subject) {
    if (!fold("The lobe at the picked point", false)) return;
    if (subject.point.light == nullptr)
        return small_dim("Pick a pixel, with this light on, to see the light reflected there by direction.");
    const LocalDirections local = local_directions(subject.point);
    if (!(local.light_deg < 90))
        return warning_text(
            fmt::format("The light is behind the surface ({:.1f}°): no lobe.", local.light_deg));
    const Reflector reflector = reflector_of(subject);
    const Lobe lobe = lobe_of(reflector, local.light_deg, false);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PolarArea area = draw_polar_axes(list, plot_room(180), max_of(lobe.total));
    draw_lobe(list, area, lobe, false);
    draw_direction(list, area, -local.light_deg, theme()[Symbol::L], "l", true);
    draw_direction(list, area, local.light_deg, theme()[Symbol::R], "r", false);
    draw_direction(list, area, local.view_deg, theme()[Symbol::V], "v", false);
    const Reflected seen = reflected(reflector, local.l, local.v);
    const double amount = intensity_of(seen.diffuse + seen.specular);
    draw_point(list, area.at(local.view_deg, amount), theme()[Symbol::V]);
    lobe_legend(false);
    small_dim(
        fmt::format("l at {:.1f}°, v at {:.1f}° from n: {:.3f} of the light's intensity (the disc; v may be "
                    "outside the drawn plane of l and n)",
                    local.light_deg, std::abs(local.view_deg), amount));
    const double whole_deg = std::round(std::min(local.light_deg, 89.0));
    update_at_rest(plots.energy, {reflector, whole_deg}, [&] {
        return LobeEnergy{specular_energy(reflector, whole_deg), directional_albedo(reflector, whole_deg)};
    });
    if (const LobeEnergy* energy = plots.energy.value()) energy_line(*energy, plots.energy.key()->light_deg);
}

BrdfCurves brdf_curves(const Reflector& reflector, double light_deg) {
    BrdfCurves curves;
    for (const LobeSample& s : lobe_slice(reflector, light_deg, lobe_steps)) {
        curves.forwards.emplace_back(s.view_deg, intensity_of(s.brdf));
        const glm::vec3 back = brdf(reflector, in_plane(s.view_deg), in_plane(-light_deg));
        curves.backwards.emplace_back(s.view_deg, intensity_of(back));
    }
    return curves;
}

void brdf_section(PlotsState& plots, const PlotSubject& subject) {
    if (!fold("The BRDF f_r(l, v), a slice", false)) return;
    const Reflector reflector = reflector_of(subject);
    const bool picked = subject.point.light != nullptr;
    const double light_deg = picked ? local_directions(subject.point).light_deg : usual_deg;
    if (!(light_deg <= steepest)) return small_dim("The light is behind the surface: f_r is 0.");
    const BrdfCurves curves = brdf_curves(reflector, light_deg);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const AxisText up{"f_r", "1/sr"};
    const PlotArea area = draw_axes(list, plot_room(132), {-90, 90}, {0, 1.25 * max_of(curves.forwards)},
                                    {"v from n", "degrees", true, 30}, up);
    draw_upright(list, area, -light_deg, theme()[Symbol::L], 0.7f);
    draw_upright(list, area, light_deg, theme()[Symbol::R], 0.4f);
    draw_curve(list, area, curves.backwards, theme()[Symbol::L], 1.2f);
    draw_curve(list, area, curves.forwards, theme()[Symbol::V], 2.2f);
    draw_reading(list, area, {{curves.forwards, theme()[Symbol::V]}, {curves.backwards, theme()[Symbol::L]}});
    if (picked) {
        const LocalDirections local = local_directions(subject.point);
        const double f = intensity_of(brdf(reflector, local.l, local.v));
        if (local.v.z > 0) draw_mark(list, area, {local.view_deg, f}, theme()[Symbol::V]);
    }
    legend({{Symbol::V, "f_r(l, v)"}, {Symbol::L, "f_r(v, l): read backwards"}});
    small_dim(fmt::format("l at {:.1f}° from n (line); f_r = (d + s) / (π n·l)", light_deg));
    update_at_rest(plots.reciprocity, reflector, [&] { return reciprocity_error(reflector); });
    verdict(plots);
}

}  // namespace glint
