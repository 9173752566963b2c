// Highlights: a cosine to the power n, other shapes for comparison, and the n that fits a hand-drawn curve
// best.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "models/numbers.h"
#include "models/scene/reflection.h"
#include "renderer/reflectance/curves.h"
#include "renderer/reflectance/highlight.h"
#include "ui/features/plots/plot.h"
#include "ui/features/plots/plots_tab.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int shape_steps = 90, curve_steps = 240;

/// The model whose exponent is fitted: the scene's, or Phong's if the scene's model has none.
Reflection fitted_model(const Scene& scene) {
    return scene.shading.reflection == Reflection::BlinnPhong ? Reflection::BlinnPhong : Reflection::Phong;
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
    tooltip("Use this n", "As the shininess of the picked object, or of the first");
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
    const Reflection reflection = subject.scene.shading.reflection;
    if (subject.point.light != nullptr && raises_a_cosine(reflection))
        draw_mark(list, area, highlight_mark(subject.point, reflection),
                  theme()[reflection == Reflection::Phong ? Symbol::R : Symbol::H]);
    draw_reading(list, area,
                 {{phong, theme()[Symbol::R]}, {blinn, theme()[Symbol::H]}, {close, theme().text}});
    legend({{Symbol::R, fmt::format("(r·v)^{:.4g} Phong", n)},
            {Symbol::H, fmt::format("(n·h)^{:.4g} Blinn–Phong", n)}});
    small_dim(fmt::format("thin: Blinn's with shininess {:.1f}, which is closest to Phong's", like));
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
    if (!fold("Draw a highlight of your own", false)) return;
    const double n = double(subject.material.shininess);
    const Reflection model = fitted_model(subject.scene);
    const Symbol symbol = model == Reflection::Phong ? Symbol::R : Symbol::H;
    const auto power = half_highlight(model, subject.material.shininess);
    // Its width at half height equals that of the power; Blinn-Phong's is measured over twice the angle.
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
