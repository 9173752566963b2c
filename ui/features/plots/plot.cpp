#include "ui/features/plots/plot.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

#include "renderer/explain/equation_text.h"
#include "ui/features/inspector/inspector.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// A curve with more points is thinned: ImGui's vertex indices have 16 bits.
constexpr std::size_t max_points = 1500;

double multiples_in(Interval range, double step) {
    return std::floor(range.high / step + 1e-9) - std::ceil(range.low / step - 1e-9) + 1;
}

/// The smallest step with at most `most` ticks: 1, 2 or 5 times a power of ten.
double tick_step(Interval range, int most) {
    const double power = std::pow(10, std::floor(std::log10(range.length() / (most + 1))));
    for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0})
        if (multiples_in(range, step * power) <= most) return step * power;
    return 100 * power;
}

/// Integer multiples of `step` in the range, so that 0 is exact and no error accumulates; at most 40.
std::vector<double> multiples(Interval range, double step) {
    std::vector<double> values;
    const double first = std::ceil(range.low / step - 1e-9);
    for (int i = 0; i < 40 && (first + i) * step <= range.high + 1e-9 * step; ++i)
        values.push_back((first + i) * step);
    return values;
}

ImVec2 text_size(const std::string& text) {
    return fonts().small->CalcTextSizeA(small_text_height(), 1e9f, 0, text.c_str());
}

/// The margin between the curves' area and the right edge.
float right_margin() { return px(6); }

std::string axis_title(const AxisText& axis) {
    return *axis.unit != 0 ? fmt::format("{}, {}", axis.name, axis.unit) : std::string(axis.name);
}

void draw_x_axis(ImDrawList& list, const PlotArea& area, const AxisText& text) {
    const int most = std::max(2, static_cast<int>(area.rect.size().x / px(62)));
    const double step = text.step > 0 ? text.step : tick_step(area.x, most);
    const float y = area.rect.high.y;
    for (const double v : multiples(area.x, step)) {
        const float x = area.at({v, area.y.low}).x;
        list.AddLine({x, area.rect.low.y}, {x, y}, to_u32(theme().line));
        if (!text.numbers) continue;
        const std::string number = tick_text(v, step);
        const float half = text_size(number).x / 2, right = area.rect.high.x + right_margin();
        plot_text(list, {std::min(x, right - half), y + px(3) + small_text_height() / 2}, theme().dim_text,
                  number, true);
    }
    if (*text.name == 0) return;
    const std::string title = axis_title(text);
    const float below = text.numbers ? small_text_height() + px(3) : px(2);
    plot_text(list, {area.rect.high.x - text_size(title).x, y + below}, theme().text, title);
}

void draw_y_axis(ImDrawList& list, const PlotArea& area, const AxisText& text) {
    if (*text.name != 0)  // above the curves' area, so that it covers no curve
        plot_text(list, {area.rect.low.x, area.rect.low.y - small_text_height() - px(1)}, theme().text,
                  axis_title(text));
    const int most = std::max(2, static_cast<int>(area.rect.size().y / px(24)));
    const float line = small_text_height();
    for (const double v : ticks(area.y, most)) {
        const float y = area.at({area.x.low, v}).y;
        list.AddLine({area.rect.low.x, y}, {area.rect.high.x, y}, to_u32(theme().line));
        if (!text.numbers) continue;
        const std::string number = tick_text(v, tick_step(area.y, most));
        // Keep the number within the height of its own plot, because the plot above also has numbers.
        const float top = std::clamp(y - line / 2, area.rect.low.y - px(1),
                                     std::max(area.rect.high.y - line + px(1), area.rect.low.y));
        plot_text(list, {area.rect.low.x - px(4) - text_size(number).x, top}, theme().dim_text, number);
    }
}

/// The lowest and the highest point of each of `buckets` segments, in order.
std::vector<glm::dvec2> thinned(std::span<const glm::dvec2> points, std::size_t buckets) {
    std::vector<glm::dvec2> kept;
    for (std::size_t b = 0; b < buckets; ++b) {
        const auto piece = points.subspan(b * points.size() / buckets,
                                          (b + 1) * points.size() / buckets - b * points.size() / buckets);
        if (piece.empty()) continue;
        const auto lower = [](glm::dvec2 a, glm::dvec2 c) { return a.y < c.y; };
        auto [low, high] = std::minmax_element(piece.begin(), piece.end(), lower);
        if (high < low) std::swap(low, high);
        kept.push_back(*low);
        if (low != high) kept.push_back(*high);
    }
    return kept;
}

}  // namespace

Interval range_of(std::span<const double> values, double least, double margin) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double v : values) {
        if (!std::isfinite(v)) continue;
        low = std::min(low, v);
        high = std::max(high, v);
    }
    if (low > high) return {0, 1};
    if (high - low < least) {
        const double middle = (low + high) / 2;
        low = middle - least / 2;
        high = middle + least / 2;
    }
    const double more = margin * (high - low);
    return {low - more, high + more};
}

std::vector<double> ticks(Interval range, int most) {
    std::vector<double> values = multiples(range, tick_step(range, most));
    if (values.size() > static_cast<std::size_t>(most)) values.resize(static_cast<std::size_t>(most));
    return values;
}

std::string tick_text(double value, double step) {
    if (std::abs(value) < step * 1e-6) return "0";
    const int places = static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    if (places > 4 || step >= 1e5) return fmt::format("{:.3g}", value);
    return fmt::format("{:.{}f}", value, std::max(places, 0));
}

ImVec2 PlotArea::at(glm::dvec2 value) const {
    const ImVec2 size = rect.size();
    return {rect.low.x + static_cast<float>((value.x - x.low) / x.length()) * size.x,
            rect.high.y - static_cast<float>((value.y - y.low) / y.length()) * size.y};
}

glm::dvec2 PlotArea::value(ImVec2 at) const {
    const ImVec2 size = rect.size();
    return {x.low + x.length() * static_cast<double>((at.x - rect.low.x) / size.x),
            y.low + y.length() * static_cast<double>((rect.high.y - at.y) / size.y)};
}

ImVec4 channel_colour(int channel) {
    static const ImVec4 on_dark[] = {{1, 0.42f, 0.36f, 1}, {0.35f, 0.85f, 0.45f, 1}, {0.45f, 0.65f, 1, 1}};
    static const ImVec4 on_light[] = {{0.75f, 0.1f, 0.1f, 1}, {0, 0.45f, 0.1f, 1}, {0.1f, 0.25f, 0.8f, 1}};
    return theme().dark ? on_dark[channel] : on_light[channel];
}

void plot_text(ImDrawList& list, ImVec2 at, const ImVec4& colour, const std::string& text, bool centre) {
    const ImVec2 low = centre ? at - text_size(text) / 2 : at;
    list.AddText(fonts().small, small_text_height(), low, to_u32(colour), text.c_str());
}

PlotArea area_within(const Rect& all, Interval x, Interval y, const AxisText& x_text,
                     const AxisText& y_text) {
    const float left = y_text.numbers ? px(56) : px(4);  // "−0.00025" and its distance from the axis
    const float below = (x_text.numbers ? small_text_height() + px(3) : 0) +
                        (*x_text.name != 0 ? small_text_height() + px(2) : px(2));
    const float above = *y_text.name != 0 ? small_text_height() + px(2) : px(2);
    PlotArea area{
        {{all.low.x + left, all.low.y + above}, {all.high.x - right_margin(), all.high.y - below}}, x, y};
    area.rect.high.x = std::max(area.rect.high.x, area.rect.low.x + 1);
    area.rect.high.y = std::max(area.rect.high.y, area.rect.low.y + 1);
    return area;
}

PlotArea draw_axes(ImDrawList& list, const Rect& all, Interval x, Interval y, const AxisText& x_text,
                   const AxisText& y_text) {
    const PlotArea area = area_within(all, x, y, x_text, y_text);
    list.AddRectFilled(area.rect.low, area.rect.high, to_u32(theme().window));
    draw_x_axis(list, area, x_text);
    draw_y_axis(list, area, y_text);
    if (y.low < 0 && y.high > 0)
        list.AddLine(area.at({x.low, 0}), area.at({x.high, 0}), to_u32(theme().dim_text, 0.6f));
    list.AddRect(area.rect.low, area.rect.high, to_u32(theme().line));
    return area;
}

void draw_curve(ImDrawList& list, const PlotArea& area, std::span<const glm::dvec2> points,
                const ImVec4& colour, float width) {
    std::vector<glm::dvec2> fewer;
    if (points.size() > max_points) {
        fewer = thinned(points, max_points / 2);
        points = fewer;
    }
    list.PushClipRect(area.rect.low, area.rect.high, true);
    const auto stroke = [&] { list.PathStroke(to_u32(colour), 0, px(width)); };
    for (const glm::dvec2 p : points) {
        if (std::isfinite(p.x) && std::isfinite(p.y))
            list.PathLineTo(area.at(p));
        else
            stroke();  // a gap
    }
    stroke();
    list.PopClipRect();
}

void draw_point(ImDrawList& list, ImVec2 at, const ImVec4& colour) {
    list.AddCircleFilled(at, px(5), to_u32(theme().window));
    list.AddCircleFilled(at, px(3.6f), to_u32(colour));
}

void begin_drawing(ImDrawList& list, const Rect& room) {
    list.AddRectFilled(room.low, room.high, to_u32(theme().window));
    list.PushClipRect(room.low, room.high, true);
}

void end_drawing(ImDrawList& list, const Rect& room) {
    list.PopClipRect();
    list.AddRect(room.low, room.high, to_u32(theme().line));
}

void draw_mark(ImDrawList& list, const PlotArea& area, glm::dvec2 at, const ImVec4& colour, bool figures) {
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return;
    ImVec2 place = area.at(at);
    place.x = std::clamp(place.x, area.rect.low.x, area.rect.high.x);
    place.y = std::clamp(place.y, area.rect.low.y, area.rect.high.y);
    draw_point(list, place, colour);
    if (!figures) return;
    const std::string text = significant_text(at.y, 3);
    const float width = text_size(text).x;
    const bool left = place.x + px(9) + width > area.rect.high.x;
    const float y = std::clamp(place.y - small_text_height() - px(3), area.rect.low.y,
                               area.rect.high.y - small_text_height());
    plot_text(list, {left ? place.x - px(9) - width : place.x + px(9), y}, colour, text);
}

void draw_upright(ImDrawList& list, const PlotArea& area, double x, const ImVec4& colour, float opacity) {
    const float at = area.at({x, area.y.low}).x;
    if (at < area.rect.low.x || at > area.rect.high.x) return;
    list.AddLine({at, area.rect.low.y}, {at, area.rect.high.y}, to_u32(colour, opacity));
}

// Reads numbers off a plot under the mouse.

std::optional<double> value_at(std::span<const glm::dvec2> points, double x) {
    const auto after =
        std::lower_bound(points.begin(), points.end(), x, [](glm::dvec2 p, double at) { return p.x < at; });
    if (after == points.end()) return std::nullopt;
    if (after->x == x) return after->y;
    if (after == points.begin()) return std::nullopt;
    const glm::dvec2 a = *(after - 1), b = *after;
    return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

void draw_reading(ImDrawList& list, const PlotArea& area, std::initializer_list<ReadCurve> curves) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!ImGui::IsWindowHovered() || !area.rect.holds(mouse)) return;
    const double x = area.value(mouse).x;
    draw_upright(list, area, x, theme().text, 0.6f);
    std::vector<std::pair<std::string, ImVec4>> lines{{fmt::format("at {:.4g}", x), theme().dim_text}};
    for (const ReadCurve& curve : curves) {
        const std::optional<double> y = value_at(curve.points, x);
        if (!y) continue;
        const ImVec2 at = area.at({x, *y});
        if (area.rect.holds(at)) draw_point(list, at, curve.colour);
        lines.emplace_back(fmt::format("{:.4g}", *y), curve.colour);
    }
    const float line = small_text_height(), width = px(62);
    const bool left = mouse.x + px(8) + width > area.rect.high.x;
    const ImVec2 low{left ? mouse.x - px(8) - width : mouse.x + px(8), area.rect.low.y + px(3)};
    list.AddRectFilled(low - px(1) * ImVec2(3, 1),
                       low + ImVec2(width, line * static_cast<float>(lines.size()) + px(2)),
                       to_u32(theme().window, 0.85f), px(3));
    for (std::size_t i = 0; i < lines.size(); ++i)
        plot_text(list, low + ImVec2(0, line * static_cast<float>(i)), lines[i].second, lines[i].first);
}

// Plots in a half-disc of directions.

namespace {

constexpr float pi = std::numbers::pi_v<float>;

void half_ring(ImDrawList& list, ImVec2 centre, float radius, const ImVec4& colour) {
    list.PathArcTo(centre, radius, -pi, 0, 48);
    list.PathStroke(to_u32(colour), 0, px(1));
}

}  // namespace

ImVec2 PolarArea::at(double deg, double amount) const {
    const double angle = deg * std::numbers::pi / 180, length = double(radius) * amount / most;
    return {centre.x + static_cast<float>(length * std::sin(angle)),
            centre.y - static_cast<float>(length * std::cos(angle))};
}

PolarArea draw_polar_axes(ImDrawList& list, const Rect& all, double most) {
    const float text = small_text_height();
    const ImVec2 size = all.size();
    PolarArea area;
    area.radius = std::max(std::min(size.x / 2 - px(12), size.y - text - px(10)), 4.0f);
    area.centre = {(all.low.x + all.high.x) / 2, all.high.y - px(6)};
    area.most = most;
    const std::vector<double> rings = ticks({0, most}, 4);
    const double step = rings.size() > 1 ? rings[1] - rings[0] : most;
    list.PathArcTo(area.centre, area.radius, -pi, 0, 48);
    list.PathFillConvex(to_u32(theme().window));
    for (const double ring : rings)
        if (ring > 0)
            half_ring(list, area.centre, static_cast<float>(ring / most) * area.radius, theme().line);
    half_ring(list, area.centre, area.radius, theme().line);
    for (const double deg : {-60.0, -30.0, 0.0, 30.0, 60.0})
        list.AddLine(area.centre, area.at(deg, most), to_u32(theme().line));
    const ImVec2 half{area.radius + px(6), 0};
    list.AddLine(area.centre - half, area.centre + half, to_u32(theme().dim_text), px(1.5f));
    if (rings.size() > 1)
        plot_text(list, area.at(0, rings.back()) + ImVec2(px(3), 0), theme().dim_text,
                  tick_text(rings.back(), step));
    return area;
}

void draw_polar_curve(ImDrawList& list, const PolarArea& area, std::span<const glm::dvec2> curve,
                      const ImVec4& colour, float width) {
    for (const glm::dvec2 p : curve)
        if (std::isfinite(p.y)) list.PathLineTo(area.at(p.x, std::max(p.y, 0.0)));
    list.PathStroke(to_u32(colour), 0, px(width));
}

void draw_direction(ImDrawList& list, const PolarArea& area, double deg, const ImVec4& colour,
                    const char* letter, bool arrives) {
    const ImVec2 rim = area.at(deg, area.most), near = area.at(deg, 0.12 * area.most);
    const ImVec2 from = arrives ? rim : area.centre, to = arrives ? near : area.at(deg, 0.92 * area.most);
    list.AddLine(from, to, to_u32(colour), px(1.6f));
    const ImVec2 way = to - from;
    arrow_head(list, to, way / std::max(length_of(way), 1e-3f), 6, 3, to_u32(colour));
    const ImVec2 beyond = area.at(deg, area.most * (1 + double(px(8)) / double(area.radius)));
    plot_text(list, beyond, colour, letter, true);
}

namespace {

double degrees_of(double cosine) { return glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))); }

const ExplainedPoint& heaviest(const Explanation& explanation) {
    if (!explanation.lit_per_corner || explanation.corners.empty()) return explanation.at;
    const auto lighter = [](const ExplainedCorner& a, const ExplainedCorner& b) {
        return a.weight < b.weight;
    };
    return std::max_element(explanation.corners.begin(), explanation.corners.end(), lighter)->at;
}

}  // namespace

PlotPoint plot_point(const std::optional<Explanation>& explanation, int light) {
    PlotPoint point;
    if (!explanation || !explanation->hit) return point;
    point.at = &heaviest(*explanation);
    point.material = &explanation->material;
    for (const ExplainedLight& each : point.at->lights)
        if (each.index == light)
            point.light = each.samples.empty() ? &each : &each.samples[each.samples.size() / 2];
    return point;
}

glm::dvec2 falloff_mark(const PlotPoint& point) { return {point.light->distance, point.light->falloff}; }

glm::dvec2 spot_mark(const PlotPoint& point) { return {point.light->spot_angle_deg, point.light->spot}; }

glm::dvec2 highlight_mark(const PlotPoint& point, Reflection reflection) {
    const double deg = reflection == Reflection::BlinnPhong ? 2 * degrees_of(double(point.light->n_dot_h))
                                                            : degrees_of(double(point.light->r_dot_v));
    return {deg, point.light->specular_factor.x};
}

LocalDirections local_directions(const PlotPoint& point) {
    LocalDirections local;
    if (point.light == nullptr) return local;
    const glm::dvec3 n = point.at->normal.camera, l = point.light->l.camera, v = point.at->view.camera;
    glm::dvec3 x = n * glm::dot(n, l) - l;
    if (glm::length(x) < 1e-6) x = v - n * glm::dot(n, v);  // light along n: any plane works; use v's
    if (glm::length(x) < 1e-6)
        x = glm::cross(n, std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    x = glm::normalize(x);
    const glm::dvec3 y = glm::cross(n, x);
    local.l = glm::vec3(glm::dot(l, x), glm::dot(l, y), glm::dot(l, n));
    local.v = glm::vec3(glm::dot(v, x), glm::dot(v, y), glm::dot(v, n));
    local.light_deg = degrees_of(double(local.l.z));
    local.view_deg = degrees_of(double(local.v.z)) * (local.v.x < 0 ? -1 : 1);
    return local;
}

Rect plot_room(float height) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, px(60)), px(height)};
    ImGui::Dummy(size);
    return {low, low + size};
}

int plotted_light(const UiState& state) {
    const std::vector<Light>& lights = explained_scene(state).lights;
    const auto exists = [&](int light) {
        return light >= 0 && static_cast<std::size_t>(light) < lights.size();
    };
    const Selection& selection = state.editor.selection;
    if (selection.kind == Selection::Kind::Light && exists(selection.index)) return selection.index;
    if (state.on_screen.explanation && state.on_screen.explanation->hit)
        if (const ExplainedLight* light =
                asked_light(state, asked_point(state.get<InspectorState>(), *state.on_screen.explanation));
            light != nullptr && exists(light->index))
            return light->index;
    return 0;
}

void plots_tab(UiState& state, const PictureView& view) {
    const Scene& scene = explained_scene(state);
    PlotsState& plots = state.get<PlotsState>();
    if (scene.lights.empty()) return wrapped_dim("The curves describe a light: add one (Shift+L).");
    const int light = plotted_light(state);
    int chosen = light;
    ImGui::SetNextItemWidth(label_cell("Light"));
    if (light_combo("##plot_light", chosen, scene.lights))
        tooltip("Light", "The light whose curves are drawn: the selected one");
    if (chosen != light) state.editor.selection = {Selection::Kind::Light, chosen};
    PlotSubject subject{scene, light, plot_point(state.on_screen.explanation, light), {}};
    if (subject.point.material != nullptr)
        subject.material = *subject.point.material;
    else if (!scene.objects.empty())
        subject.material = scene.objects.front().material;
    if (subject.point.at == nullptr) small_dim("Pick a pixel to see its position on each curve.");
    if (subject.point.at != nullptr && subject.point.light == nullptr) small_dim("This light is off.");
    falloff_section(subject);
    highlight_section(plots, subject);
    cosine_section(plots, subject);
    spot_section(subject);
    lobe_section(plots, subject);
    intensities_section(subject);
    kinds_section(subject, view);
    sketch_section(state, plots, subject);
    brdf_section(plots, subject);
    microfacet_section(plots, subject);
}

}  // namespace glint
