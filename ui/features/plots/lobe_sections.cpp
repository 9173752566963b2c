// The light that a surface reflects into each direction: polar plots, and a slice of the BRDF, forwards and
// backwards.

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "models/numbers.h"
#include "models/scene/reflection.h"
#include "renderer/debug_views/profile.h"
#include "renderer/reflectance/highlight.h"
#include "renderer/reflectance/lobes.h"
#include "ui/features/plots/plot.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int lobe_steps = 180;

Reflector reflector_of(const PlotSubject& subject) {
    Reflector reflector = reflector_of(subject.material, subject.scene.shading);
    reflector.terms = {};
    return reflector;
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
            "The specular term times n·v, integrated over all directions (2π k_s / (n + 2) for Phong "
            "head-on); and "
            "the fraction of the light's power that is reflected in total",
            fmt::format("for the light at {:.0f}°", light_deg));
    if (albedo > 1.0005) warning_text("More light leaves than arrives.");
}

constexpr double usual_deg = 45;  // angle of the BRDF's light if no pixel is picked
constexpr double steepest = 89;

void verdict(const PlotsState& plots) {
    const double* const error = plots.reciprocity.value();
    if (error == nullptr) return;
    if (*error < 1e-4)
        small_dim("The same in both directions for 4096 pairs of l and v: reciprocal (Helmholtz).");
    else
        warning_text(fmt::format(
            "Not reciprocal: swapping l and v changes f_r by up to {:.0f} % (4096 pairs).", 100 * *error));
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
    small_dim(
        "Luminance, for a white light with an ambient part of 1; the length shows how much the eye "
        "receives.");
}

void lobe_section(PlotsState& plots, const PlotSubject& subject) {
    if (!fold("The lobe at the picked point", false)) return;
    if (subject.point.light == nullptr)
        return small_dim(
            "Pick a pixel, with this light on, to see how much light is reflected in each direction.");
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

// Highlights: a cosine to the power n, other shapes for comparison, and the n that fits a hand-drawn curve
// best.

namespace {

constexpr int shape_steps = 90, curve_steps = 240;

/// The model whose exponent is fitted: the surface's, or Phong's if the surface's model has none.
Reflection fitted_model(const PlotSubject& subject) {
    const bool is_blinn = reflector_of(subject).reflection == Reflection::BlinnPhong;
    return is_blinn ? Reflection::BlinnPhong : Reflection::Phong;
}

/// Half of a model's highlight from its centre outwards.
std::vector<glm::dvec2> half_highlight(Reflection reflection, float shininess) {
    std::vector<glm::dvec2> curve;
    for (int deg = 0; deg <= shape_steps; ++deg)
        curve.emplace_back(deg, highlight_at(reflection, shininess, deg));
    return curve;
}

/// Records the mouse positions while the button is down over the plot, one value for each degree.
void draw_by_hand(HighlightSketch& sketch, const PlotArea& area) {
    ImGui::SetCursorScreenPos(area.rect.low);
    hit_area("##sketch", area.rect.size());
    tooltip("Sketch", "Draw here how the highlight should fade, from its centre outwards");
    if (!ImGui::IsItemActive()) return sketch.last.reset();
    const glm::dvec2 hand = area.value(ImGui::GetIO().MousePos);
    const glm::dvec2 now{std::clamp(hand.x, 0.0, 90.0), std::clamp(hand.y, 0.0, 1.0)};
    add_to_sketch(sketch, sketch.last.value_or(now), now);
    sketch.last = now;
}

void fit_row(UiState& state, HighlightSketch& sketch, const std::optional<HighlightFit>& fit) {
    if (!fit) return small_dim("Draw a curve over the plot to find the power that fits it best.");
    mono_text(fmt::format("best: n = {:.4g}, {:.3f} off on average", fit->shininess, fit->error));
    if (small_button("Use this n")) {
        const auto object = state.on_screen.explanation && state.on_screen.explanation->hit
                                ? static_cast<std::size_t>(state.on_screen.explanation->object_index)
                                : std::size_t{0};
        Scene* const scene = editable_scene(state);
        if (scene != nullptr && object < scene->objects.size())
            scene->objects[object].material.shininess = static_cast<float>(fit->shininess);
    }
    tooltip("Use this n", "Sets the shininess of the picked object, or of the first one");
    ImGui::SameLine();
    if (small_button("Clear")) sketch = {};
}

bool raises_a_cosine(Reflection reflection) {
    return info_of(reflection).cosine == HighlightCosine::RV ||
           info_of(reflection).cosine == HighlightCosine::NH;
}

}  // namespace

void highlight_section(PlotsState& plots, const PlotSubject& subject) {
    if (!fold("Highlight: a power of a cosine", true)) return;
    const float n = subject.material.shininess;
    const double like = plots.blinn_like.of(n, [n] { return blinn_shininess_like(n); });
    const auto phong = highlight_curve(Reflection::Phong, n, curve_steps);
    const auto blinn = highlight_curve(Reflection::BlinnPhong, n, curve_steps);
    const auto close = highlight_curve(Reflection::BlinnPhong, static_cast<float>(like), curve_steps);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotArea area = draw_axes(list, plot_room(curve_height), {-90, 90}, {0, 1.1},
                                    {"r to v", "degrees", true, 30}, {"S", ""});
    draw_curve(list, area, blinn, theme()[Symbol::H]);
    draw_curve(list, area, phong, theme()[Symbol::R], 2.6f);
    draw_curve(list, area, close, theme().text, 1);
    const Reflection reflection = reflector_of(subject).reflection;
    if (subject.point.light != nullptr && raises_a_cosine(reflection))
        draw_mark(list, area, highlight_mark(subject.point, reflection),
                  theme()[reflection == Reflection::Phong ? Symbol::R : Symbol::H]);
    draw_reading(list, area,
                 {{phong, theme()[Symbol::R]}, {blinn, theme()[Symbol::H]}, {close, theme().text}});
    legend({{Symbol::R, fmt::format("(r·v)^{:.4g} Phong", n)},
            {Symbol::H, fmt::format("(n·h)^{:.4g} Blinn–Phong", n)}});
    small_dim(fmt::format("thin line: Blinn–Phong with shininess {:.1f}, closest to Phong", like));
}

void add_to_sketch(HighlightSketch& sketch, glm::dvec2 from, glm::dvec2 to) {
    if (from.x > to.x) std::swap(from, to);
    const int most = static_cast<int>(sketch.value.size()) - 1;
    const int first = static_cast<int>(std::clamp(std::round(from.x), 0.0, double(most)));
    const int last = static_cast<int>(std::clamp(std::round(to.x), 0.0, double(most)));
    for (int deg = first; deg <= last; ++deg) {
        const double share = last > first ? double(deg - first) / (last - first) : 1;
        sketch.value[static_cast<std::size_t>(deg)] = static_cast<float>(from.y + share * (to.y - from.y));
    }
}

std::vector<glm::dvec2> points_of(const HighlightSketch& sketch) {
    std::vector<glm::dvec2> points;
    for (std::size_t deg = 0; deg < sketch.value.size(); ++deg)
        if (sketch.value[deg] >= 0) points.emplace_back(deg, sketch.value[deg]);
    return points;
}

void sketch_section(UiState& state, PlotsState& plots, const PlotSubject& subject) {
    if (!fold("Draw your own highlight", false)) return;
    const double n = double(subject.material.shininess);
    const Reflection model = fitted_model(subject);
    const Symbol symbol = model == Reflection::Phong ? Symbol::R : Symbol::H;
    const auto power = half_highlight(model, subject.material.shininess);
    // All shapes are as wide at half height as the power; Blinn-Phong's is measured over twice the angle.
    const double like = model == Reflection::Phong ? n : n / 4;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const PlotArea area = draw_axes(list, plot_room(120), {0, 90}, {0, 1.1},
                                    {"from the highlight's centre", "degrees", true, 30}, {"S", ""});
    const ImVec2 below = ImGui::GetCursorScreenPos();
    draw_by_hand(plots.sketch, area);
    ImGui::SetCursorScreenPos({cursor.x, below.y});
    draw_curve(list, area, highlight_shape(HighlightShape::Linear, like, shape_steps), theme().dim_text,
               1.2f);
    draw_curve(list, area, power, theme()[symbol], 3);
    // Drawn on top: for a large n the two are hard to distinguish.
    draw_curve(list, area, highlight_shape(HighlightShape::Gaussian, like, shape_steps), theme()[Symbol::L],
               1.2f);
    const auto drawn = points_of(plots.sketch);
    draw_curve(list, area, drawn, theme().accent, 2.6f);
    const auto fit = fitted_highlight(model, drawn);
    if (fit)
        draw_curve(list, area, half_highlight(model, static_cast<float>(fit->shininess)), theme().text, 1);
    legend({{symbol, fmt::format("{}^{:.4g}", model == Reflection::Phong ? "(r·v)" : "(n·h)", n)},
            {Symbol::L, "Gaussian"}});
    ImGui::SameLine(0, px(8));
    dim_text("linear");
    fit_row(state, plots.sketch, fit);
}

}  // namespace glint
