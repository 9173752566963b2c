// The panel below the picture: intensity along the scope's line.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/features/plots/plot.h"
#include "ui/features/views/scope.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

using Points = std::vector<glm::dvec2>;

/// A curve with one value per sample, and a gap where `value` returns none.
template <class Value> Points curve(const std::vector<ProfileSample>& samples, const Value& value) {
    Points points;
    points.reserve(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) points.emplace_back(samples[i].position, value(i));
    return points;
}

double or_nan(const std::optional<double>& number) {
    return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

Interval range_of_curves(std::initializer_list<const Points*> curves, bool around_zero) {
    std::vector<double> values;
    for (const Points* points : curves)
        for (const glm::dvec2 p : *points) values.push_back(p.y);
    if (around_zero) values.push_back(0);
    return range_of(values, around_zero ? 1e-4 : 1e-3, 0.08);
}

/// The range of a curve of differences, one per sample, without the jumps at object boundaries. These are a
/// hundred times as high as the bands of interest, and may extend beyond the strip.
Interval range_within_objects(const Points& points, const std::vector<ProfileSample>& samples) {
    const auto object = [&](std::size_t i) { return samples[i].seen ? samples[i].seen->object : -1; };
    Points inside;
    for (std::size_t i = 1; i + 1 < samples.size(); ++i)
        if (object(i - 1) == object(i) && object(i) == object(i + 1)) inside.push_back(points[i]);
    return range_of_curves({inside.empty() ? &points : &inside}, true);
}

struct Strip {
    Rect rect;
    Interval x;
    bool last = false;  // the last strip, with the axis along the line
    AxisText y;
};

PlotArea begin_strip(ImDrawList& list, const Strip& strip, Interval y, const ScopeState& scope) {
    const PlotArea area = draw_axes(list, strip.rect, strip.x, y, {"", "", strip.last}, {});
    const std::vector<ScopeEdge> edges = edges_along(scope.samples);
    // If they were closer together, they would form a grey hatching that hides the curve.
    const bool roomy = static_cast<float>(edges.size()) * px(7) <= area.rect.size().x;
    for (const ScopeEdge& edge : edges)
        if (roomy) draw_upright(list, area, edge.position, theme().dim_text, edge.is_diagonal ? 0.22f : 0.5f);
    return area;
}

/// Space for the strips' names, to the right of all curves, so that no name covers a curve.
float name_room() { return px(96); }

void strip_name(ImDrawList& list, const PlotArea& area, const AxisText& y) {
    const ImVec2 at{area.rect.high.x + px(6), area.rect.middle().y - small_text_height()};
    plot_text(list, at, theme().text, y.name);
    plot_text(list, at + ImVec2(0, small_text_height()), theme().dim_text, y.unit);
}

/// The curve, with its point at the hovered sample.
void strip_curve(ImDrawList& list, const PlotArea& area, const Points& points, const ScopeState& scope,
                 const ImVec4& colour) {
    if (points.empty()) return;
    draw_curve(list, area, points, colour, 1.4f);
    if (scope.hovered >= 0)
        draw_mark(list, area, points[static_cast<std::size_t>(scope.hovered)], colour, false);
}

void intensity_strip(ImDrawList& list, const Strip& strip, const ScopeState& scope) {
    const auto& samples = scope.samples;
    std::array<Points, 3> channel;
    Points luminance, eye;
    if (scope.eye && scope.seen.size() == samples.size())
        eye = curve(samples, [&](std::size_t i) { return scope.seen[i]; });
    for (std::size_t c = 0; scope.channels && c < 3; ++c)
        channel[c] = curve(samples, [&](std::size_t i) { return double(samples[i].color[int(c)]); });
    if (!scope.channels) luminance = curve(samples, [&](std::size_t i) { return samples[i].intensity; });
    const Interval y = range_of_curves({&luminance, &channel[0], &channel[1], &channel[2], &eye}, false);
    const PlotArea area = begin_strip(list, strip, y, scope);
    strip_curve(list, area, luminance, scope, theme().text);
    for (int c = 0; c < 3; ++c)
        strip_curve(list, area, channel[static_cast<std::size_t>(c)], scope, channel_colour(c));
    strip_curve(list, area, eye, scope, theme().warning);
    strip_name(list, area, strip.y);
}

/// A curve about zero in its own strip: a difference or, if requested, the eye's contribution.
struct ZeroCurve {
    AxisText y;
    Points points;
    ImVec4 colour;
};

std::vector<ZeroCurve> zero_curves(const ScopeState& scope) {
    const auto& samples = scope.samples;
    const ImVec4& colour = theme().accent;
    std::vector<ZeroCurve> curves{
        {{"ΔI", "per pixel"},
         curve(samples, [&](std::size_t i) { return or_nan(samples[i].first_difference); }),
         colour},
        {{"Δ²I", "per pixel²"},
         curve(samples, [&](std::size_t i) { return or_nan(samples[i].second_difference); }),
         colour}};
    if (scope.eye && scope.seen.size() == samples.size())
        curves.push_back({{"seen − I", "the bands"},
                          curve(samples, [&](std::size_t i) { return scope.seen[i] - samples[i].intensity; }),
                          theme().warning});
    return curves;
}

/// The sample nearest to the cursor, or -1 when it is not over the strips.
int sample_under(const ScopeState& scope, const Rect& strips, Interval x) {
    if (!ImGui::IsItemHovered() || scope.samples.empty()) return -1;
    const PlotArea area = area_within(strips, x, {}, {}, {});
    const double at = area.value(ImGui::GetIO().MousePos).x;
    const auto nearer = [at](const ProfileSample& a, const ProfileSample& b) {
        return std::abs(a.position - at) < std::abs(b.position - at);
    };
    return static_cast<int>(std::min_element(scope.samples.begin(), scope.samples.end(), nearer) -
                            scope.samples.begin());
}

void strips(ScopeState& scope, const Rect& area) {
    const double length = scope.samples.empty() ? 1 : std::max(scope.samples.back().position, 1.0);
    const Interval x{0, length};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float axis = small_text_height() + px(5);
    const std::vector<ZeroCurve> curves = zero_curves(scope);
    const float unit = (area.size().y - axis) / (2 + static_cast<float>(curves.size()));
    ImGui::SetCursorScreenPos(area.low);
    hit_area("##strips", area.size());
    const Rect plots{area.low, {area.high.x - name_room(), area.high.y}};
    scope.hovered = sample_under(scope, plots, x);
    float y = area.low.y + 2 * unit;
    intensity_strip(list, {{plots.low, {plots.high.x, y}}, x, false, {"I", ""}}, scope);
    for (const ZeroCurve& each : curves) {
        const bool last = &each == &curves.back();
        const float high = last ? area.high.y : y + unit;
        const Strip strip{{{plots.low.x, y}, {plots.high.x, high}}, x, last, each.y};
        const PlotArea room =
            begin_strip(list, strip, range_within_objects(each.points, scope.samples), scope);
        strip_curve(list, room, each.points, scope, each.colour);
        strip_name(list, room, each.y);
        y += unit;
    }
    plot_text(list, {area.low.x, area.high.y - axis + px(3)}, theme().dim_text, "pixel");
}

/// True when clicked.
bool toggle(const char* label, bool on, const char* title, const char* what, const char* more = "") {
    const bool clicked = small_chosen_button(label, on);
    tooltip(title, what, more);
    ImGui::SameLine(0, px(4));
    return clicked;
}

/// True when the command is to be copied.
bool buttons(ScopeState& scope, PictureSize size) {
    scope.armed ^= toggle("Draw", scope.armed, "Draw a line",
                          "Drag over the picture; a click gives the full scan line through a pixel",
                          "Shift: horizontal or vertical");
    scope.channels ^= toggle("RGB", scope.channels, "Red, green and blue",
                             "In place of luminance, 0.2126 R + 0.7152 G + 0.0722 B");
    scope.eye ^= toggle("Eye", scope.eye, "What the eye perceives",
                        "Intensity sharpened by its neighbourhood, as cells of the retina do: the bands that "
                        "Ernst Mach saw appear where the slope jumps",
                        "I + narrow mean − wide mean (difference of Gaussians)");
    if (toggle("Card", scope.card, "Grey card",
               "Place it over one side of an edge: the Mach band next to it disappears, although its pixels "
               "do not change",
               "Drag it over the picture"))
        switch_card(scope, size);
    const bool copy = small_button("Copy");
    tooltip("Copy as command", "The command line that prints these numbers");
    return copy;
}

}  // namespace

bool scope_panel(ScopeState& scope, const Rect& area, PictureSize size) {
    ImGui::PushFont(fonts().small);
    ImGui::SetCursorPosY(px(3));
    const bool copy = buttons(scope, size);
    const std::string text = scope.hovered >= 0
                                 ? sample_text(scope.samples, static_cast<std::size_t>(scope.hovered))
                                 : edge_words(scope.samples);
    ImGui::SameLine(0, px(10));
    const ImVec2 at = ImGui::GetCursorScreenPos() + ImVec2(0, small_padding().y);
    ImGui::PushFont(fonts().figures);
    cut_text(*ImGui::GetWindowDrawList(), at, area.high.x - px(34), text);
    ImGui::PopFont();
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({area.high.x - px(8) - ImGui::GetFrameHeight(), area.low.y + px(2)});
    if (icon_button("##close_scope", Icon::Close)) toggle_scope(scope);
    tooltip("Close the scope", "", "", "P");
    const float top = area.low.y + px(30);
    strips(scope, {{area.low.x + px(4), top}, {area.high.x - px(4), area.high.y - px(2)}});
    return copy;
}

}  // namespace glint
