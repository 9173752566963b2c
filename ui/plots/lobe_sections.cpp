// Polar plots: what a surface sends into which direction.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/inspect/debug_views/profile.h"
#include "renderer/inspect/reflectance/lobes.h"
#include "ui/inspector/equation/parts.h"
#include "ui/plots/plot.h"
#include "ui/plots/plots_tab.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int steps = 180;

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

double most_of(const std::vector<glm::dvec2>& curve) {
    double most = 1e-3;
    for (const glm::dvec2 p : curve) most = std::max(most, p.y);
    return most;
}

struct Lobe {
    std::vector<glm::dvec2> ambient, diffuse, specular, total;
};

Lobe lobe_of(const Reflector& reflector, double light_deg, bool with_ambient) {
    const std::vector<LobeSample> slice = lobe_slice(reflector, light_deg, steps);
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

void legend(bool with_ambient) {
    if (with_ambient) {
        coloured(Symbol::Ambient, "ambient");
        ImGui::SameLine(0, px(8));
    }
    coloured(Symbol::Diffuse, "diffuse");
    ImGui::SameLine(0, px(8));
    coloured(Symbol::Specular, "specular");
    ImGui::SameLine(0, px(8));
    ImGui::PushStyleColor(ImGuiCol_Text, theme().accent);
    ImGui::TextUnformatted("sum");
    ImGui::PopStyleColor();
}

/// The integrals take some milliseconds: kept, and not begun again while the mouse drags something.
void update_energy(PlotsState& plots, const Reflector& reflector, double light_deg) {
    const double deg = std::round(std::min(light_deg, 89.0));
    const auto same = [&](const Reflector& r) {
        return r.reflection == reflector.reflection && r.material == reflector.material;
    };
    if (plots.energy_of && same(*plots.energy_of) && plots.energy_deg == deg) return;
    if (ImGui::IsAnyMouseDown()) return redraw_within(0.1);
    plots.energy = specular_energy(reflector, deg);
    plots.albedo = directional_albedo(reflector, deg);
    plots.energy_of = reflector;
    plots.energy_deg = deg;
}

}  // namespace

void intensities_section(const PlotSubject& subject) {
    section_heading("Intensity by direction, light at 60°, 25° and 0°");
    const Rect room = plot_room(72);
    const float width = room.size().x / 3;
    const Reflector reflector = reflector_of(subject);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::array<Lobe, 3> lobes;
    constexpr std::array angles{60.0, 25.0, 0.0};
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        lobes[i] = lobe_of(reflector, angles[i], true);
        most = std::max(most, most_of(lobes[i].total));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const float left = room.low.x + width * float(i);
        const PolarArea area = draw_polar_axes(list, {{left, room.low.y}, {left + width, room.high.y}}, most);
        draw_lobe(list, area, lobes[i], true);
        draw_direction(list, area, -angles[i], theme()[Symbol::L], "l", true);
    }
    legend(true);
    small_dim("For a white light with an ambient part of 1, luminance; the length is what the eye gets.");
}

void lobe_section(PlotsState& plots, const PlotSubject& subject) {
    section_heading("The lobe at the picked point");
    if (subject.point.light == nullptr)
        return small_dim("Pick a pixel, with this light on, to see what its surface sends where.");
    const LocalDirections local = local_directions(subject.point);
    if (!(local.light_deg < 90))
        return warning_text(
            fmt::format("The light stands behind the surface ({:.1f}°): no lobe.", local.light_deg));
    const Reflector reflector = reflector_of(subject);
    const Lobe lobe = lobe_of(reflector, local.light_deg, false);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PolarArea area = draw_polar_axes(list, plot_room(180), most_of(lobe.total));
    draw_lobe(list, area, lobe, false);
    draw_direction(list, area, -local.light_deg, theme()[Symbol::L], "l", true);
    draw_direction(list, area, local.light_deg, theme()[Symbol::R], "r", false);
    draw_direction(list, area, local.view_deg, theme()[Symbol::V], "v", false);
    const Reflected seen = reflected(reflector, local.l, local.v);
    const double amount = intensity_of(seen.diffuse + seen.specular);
    const ImVec2 at = area.at(local.view_deg, amount);
    list.AddCircleFilled(at, px(5), to_u32(theme().window));
    list.AddCircleFilled(at, px(3.6f), to_u32(theme()[Symbol::V]));
    legend(false);
    small_dim(fmt::format(
        "l at {:.1f}°, v at {:.1f}° from n: {:.3f} of the light's intensity (the disc; v need not lie in the "
        "plane of l and n, which is drawn)",
        local.light_deg, std::abs(local.view_deg), amount));
    update_energy(plots, reflector, local.light_deg);
    if (!plots.energy_of) return;
    const double energy = intensity_of(glm::vec3(plots.energy)),
                 albedo = intensity_of(glm::vec3(plots.albedo));
    mono_text(fmt::format("specular energy {:.4f}   albedo {:.3f}", energy, albedo));
    tooltip("Energy",
            "The specular term times n·v, over all directions (2π k_s / (n + 2) for Phong head on); and "
            "the share of the light's power that is reflected in all",
            fmt::format("for the light at {:.0f}°", plots.energy_deg));
    if (albedo > 1.0005) warning_text("More light leaves than arrives.");
}

}  // namespace glint
