// Curves of one factor each: falloff, highlight, cone.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "models/scene/reflection.h"
#include "renderer/inspect/reflectance/curves.h"
#include "renderer/inspect/reflectance/highlight.h"
#include "ui/inspector/equation/parts.h"
#include "ui/plots/plot.h"
#include "ui/plots/plots_tab.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int steps = 240;
constexpr float plot_height = 132;

std::string mark_text(glm::dvec2 at) { return fmt::format("{:.3f}", at.y); }

/// How far a falloff's plot reaches: past the point, to where little is left.
double farthest_of(const PlotSubject& subject) {
    const double there = subject.point.light != nullptr ? double(subject.point.light->distance) : 0;
    return std::max(1.5 * there, 5.0);
}

bool raises_a_cosine(Reflection reflection) {
    return info_of(reflection).cosine == HighlightCosine::RV ||
           info_of(reflection).cosine == HighlightCosine::NH;
}

}  // namespace

Rect plot_room(float height) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, px(60)), px(height)};
    ImGui::Dummy(size);
    return {low, {low.x + size.x, low.y + size.y}};
}

void falloff_section(const PlotSubject& subject) {
    section_heading("Falloff over the distance to the light");
    const auto curve = falloff_curve(subject.scene, subject.light, farthest_of(subject), steps);
    if (curve.empty()) {
        const bool area =
            subject.scene.lights[static_cast<std::size_t>(subject.light)].kind == LightKind::Area;
        return small_dim(area ? "An area light has none of its own: it comes from its samples."
                              : "A directional light has none: it is infinitely far.");
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    double most = 0;
    for (const glm::dvec2 p : curve) most = std::max(most, p.y);
    if (subject.point.light != nullptr)
        most = std::min(most, 4 * std::max(falloff_mark(subject.point).y, 0.25));
    const PlotArea area = draw_axes(list, plot_room(plot_height), {0, curve.back().x}, {0, 1.1 * most},
                                    {"r", "scene units"}, {"falloff", ""});
    draw_curve(list, area, curve, theme()[Symbol::L]);
    draw_y_name(list, area, {"falloff", ""});
    if (subject.point.light != nullptr) {
        const glm::dvec2 mark = falloff_mark(subject.point);
        draw_mark(list, area, mark, theme()[Symbol::L], mark_text(mark));
    }
}

void highlight_section(PlotsState& plots, const PlotSubject& subject) {
    section_heading("Highlight: a cosine to the power n");
    const float n = subject.material.shininess;
    if (!plots.blinn_like || plots.blinn_like->first != n) plots.blinn_like = {n, blinn_shininess_like(n)};
    const double like = plots.blinn_like->second;
    const auto phong = highlight_curve(Reflection::Phong, n, steps);
    const auto blinn = highlight_curve(Reflection::BlinnPhong, n, steps);
    const auto close = highlight_curve(Reflection::BlinnPhong, static_cast<float>(like), steps);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotArea area = draw_axes(list, plot_room(plot_height), {-90, 90}, {0, 1.1},
                                    {"r to v", "degrees", true, 30}, {"S", ""});
    draw_curve(list, area, blinn, theme()[Symbol::H]);
    draw_curve(list, area, phong, theme()[Symbol::R], 2.6f);
    draw_curve(list, area, close, theme().text, 1);
    draw_y_name(list, area, {"S", ""});
    const Reflection reflection = subject.scene.shading.reflection;
    if (subject.point.light != nullptr && raises_a_cosine(reflection)) {
        const glm::dvec2 mark = highlight_mark(subject.point, reflection);
        draw_mark(list, area, mark, theme()[reflection == Reflection::Phong ? Symbol::R : Symbol::H],
                  mark_text(mark));
    }
    coloured(Symbol::R, fmt::format("(r·v)^{:.4g} Phong", n).c_str());
    ImGui::SameLine(0, px(10));
    coloured(Symbol::H, fmt::format("(n·h)^{:.4g} Blinn", n).c_str());
    small_dim(fmt::format("thin: Blinn's with n′ = {:.1f}, which comes nearest to Phong's", like));
}

void spot_section(const PlotSubject& subject) {
    const auto curve = spot_curve(subject.scene, subject.light, steps);
    if (curve.empty()) return;
    section_heading("Cone: how much goes into which direction");
    const Light& light = subject.scene.lights[static_cast<std::size_t>(subject.light)];
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotArea area = draw_axes(list, plot_room(plot_height), {-90, 90}, {0, 1.1},
                                    {"from the axis", "degrees", true, 30}, {"spot", ""});
    for (const float side : {-1.0f, 1.0f})
        draw_upright(list, area, double(side * light.spot.cutoff_deg), theme().dim_text);
    draw_curve(list, area, curve, theme()[Symbol::L]);
    draw_y_name(list, area, {"spot", ""});
    if (subject.point.light == nullptr) return;
    const glm::dvec2 mark = spot_mark(subject.point);
    draw_mark(list, area, mark, theme()[Symbol::L], mark_text(mark));
}

}  // namespace glint
