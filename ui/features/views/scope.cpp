// The scan-line scope's mouse handling, and its samples of the picture.

#include "ui/features/views/scope.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "renderer/explain/equation_text.h"
#include "ui/features/plots/plot.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

using Hand = ScopeState::Hand;

/// The distance, in logical pixels, within which an end of the line can be grabbed.
constexpr float end_reach = 10;

glm::dvec2 size_of(const PictureView& view) { return {view.map.size.width, view.map.size.height}; }

/// The window position of the centre of an end's pixel.
ImVec2 place_of(glm::dvec2 share, const PictureView& view) {
    return view.to_window(glm::dvec2(pixel_of(share, view.map.size)) + 0.5);
}

float distance_to_segment(ImVec2 p, ImVec2 a, ImVec2 b) {
    const ImVec2 along = b - a, way = p - a;
    const float square = along.x * along.x + along.y * along.y;
    const float share = square > 0 ? std::clamp((way.x * along.x + way.y * along.y) / square, 0.0f, 1.0f) : 0;
    return length_of(way - share * along);
}

bool is_on_card(const ScopeState& scope, glm::dvec2 share) {
    const glm::dvec2 away = glm::abs(share - scope.card_at) * 2.0;
    return scope.card && away.x <= scope.card_size.x && away.y <= scope.card_size.y;
}

Hand under_cursor(const ScopeState& scope, const PictureView& view, glm::dvec2 share) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const ImVec2 from = place_of(scope.from, view), to = place_of(scope.to, view);
    if (scope.armed) return Hand::New;
    if (length_of(mouse - to) <= px(end_reach)) return Hand::To;
    if (length_of(mouse - from) <= px(end_reach)) return Hand::From;
    if (is_on_card(scope, share)) return Hand::Card;
    return distance_to_segment(mouse, from, to) <= px(tool_line_reach) ? Hand::Line : Hand::None;
}

/// `moved` snapped to horizontal or vertical as seen from `fixed`, whichever is nearer.
glm::dvec2 squared(glm::dvec2 fixed, glm::dvec2 moved, glm::dvec2 size) {
    const glm::dvec2 away = glm::abs(moved - fixed) * size;
    return away.x >= away.y ? glm::dvec2(moved.x, fixed.y) : glm::dvec2(fixed.x, moved.y);
}

void move_line(ScopeState& scope, glm::dvec2 step) {
    // Limits the move so that both ends stay inside the picture.
    const glm::dvec2 low = glm::min(scope.from, scope.to), high = glm::max(scope.from, scope.to);
    step = glm::clamp(step, -low, 1.0 - high);
    scope.from += step;
    scope.to += step;
}

void drag(ScopeState& scope, const PictureView& view, glm::dvec2 share) {
    const glm::dvec2 inside = glm::clamp(share, 0.0, 1.0);
    const bool square = ImGui::GetIO().KeyShift;
    switch (scope.hand) {
    case Hand::None:
        break;
    case Hand::New:
    case Hand::To:
        scope.to = square ? squared(scope.from, inside, size_of(view)) : inside;
        break;
    case Hand::From:
        scope.from = square ? squared(scope.to, inside, size_of(view)) : inside;
        break;
    case Hand::Line:
        move_line(scope, share - scope.last);
        break;
    case Hand::Card:
        scope.card_at = glm::clamp(scope.card_at + share - scope.last, 0.0, 1.0);
        break;
    }
    scope.last = share;
}

void set_cursor(const ScopeState& scope) {
    const Hand shown = scope.hand != Hand::None ? scope.hand : scope.under;
    if (shown == Hand::None) return;
    const bool moves = shown == Hand::Line || shown == Hand::Card;
    ImGui::SetMouseCursor(moves ? ImGuiMouseCursor_ResizeAll : ImGuiMouseCursor_Hand);
}

void draw_card(ImDrawList& list, const ScopeState& scope, const PictureView& view) {
    const ImVec2 low = view.to_window((scope.card_at - scope.card_size / 2.0) * size_of(view));
    const ImVec2 high = view.to_window((scope.card_at + scope.card_size / 2.0) * size_of(view));
    list.AddRectFilled(low, high, to_u32(theme().surround));
    if (scope.hand == Hand::Card || scope.under == Hand::Card)
        list.AddRect(low, high, to_u32(theme().accent));
}

bool scope_hover(ToolFrame& frame) {
    ScopeState& scope = frame.state.get<ScopeState>();
    scope.under = Hand::None;
    if (!scope.open || !frame.over) return false;
    scope.under = under_cursor(scope, frame.view, frame.pixel / size_of(frame.view));
    set_cursor(scope);
    return scope.under != Hand::None;
}

/// The cursor as a fraction of the picture's size: the centre of its pixel, so pixel_of() finds it despite
/// rounding.
glm::dvec2 share_under(const ToolFrame& frame) {
    return (glm::floor(frame.pixel) + 0.5) / size_of(frame.view);
}

int scope_press(ToolFrame& frame) {
    ScopeState& scope = frame.state.get<ScopeState>();
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return not_taken;
    scope.hand = scope.under;
    scope.last = share_under(frame);
    for (glm::dvec2* end : {&scope.from, &scope.to}) *end = glm::clamp(*end, 0.0, 1.0);  // keep it visible
    if (scope.hand == Hand::New) scope.from = scope.to = glm::clamp(scope.last, 0.0, 1.0);
    return ImGuiMouseButton_Left;
}

/// Shift keeps the line horizontal or vertical.
bool scope_drag(ToolFrame& frame) {
    ScopeState& scope = frame.state.get<ScopeState>();
    if (!scope.open || scope.hand == Hand::None) return false;
    if (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0)
        drag(scope, frame.view, share_under(frame));
    set_cursor(scope);
    return true;
}

/// A press without a drag places the line along the scan line through that pixel.
void scope_release(ToolFrame& frame) {
    ScopeState& scope = frame.state.get<ScopeState>();
    const glm::dvec2 drawn =
        (scope.to - scope.from) * size_of(frame.view) * double(frame.view.units_per_pixel);
    if (scope.hand == Hand::New) {
        if (glm::length(drawn) < double(px(3))) {
            scope.from.x = 0;
            scope.to = {1, scope.from.y};
        }
        scope.armed = false;
    }
    scope.hand = Hand::None;
}

std::string scope_hint(const UiState& state) {
    const ScopeState& scope = state.get<ScopeState>();
    if (!scope.open) return {};
    switch (scope.hand != Hand::None ? scope.hand : scope.under) {
    case Hand::None:
        return {};
    case Hand::New:
        return "Drag a line over the picture · Click: the full scan line · Shift: horizontal or vertical · "
               "Esc: cancel";
    case Hand::From:
    case Hand::To:
        return "Drag the end of the line · Shift: horizontal or vertical";
    case Hand::Line:
        return "Drag the line";
    case Hand::Card:
        return "Drag the card over one side of an edge: the Mach band next to it disappears";
    }
    return {};  // not reached
}

std::string with_sign(double slope) {
    constexpr double rounding = 1e-6;  // rounding error of float intensities
    if (std::abs(slope) < rounding) return "0.0000";
    return (slope > 0 ? "+" : "") + significant_text(slope, 4);
}

/// The panel's text for a sample: its pixel, intensity, differences (where the slope jumps, the slopes before
/// and after) and face.
std::string sample_text(const std::vector<ProfileSample>& samples, std::size_t at) {
    const ProfileSample& s = samples[at];
    std::string text = fmt::format("{},{}  I {}", s.pixel.x, s.pixel.y, significant_text(s.intensity, 4));
    if (const auto jump = slope_jump_at(samples, at)) {
        text += fmt::format("  ΔI {} → {}, jump {}", with_sign(jump->before), with_sign(jump->after),
                            with_sign(jump->after - jump->before));
    } else {
        if (s.first_difference) text += "  ΔI " + with_sign(*s.first_difference);
        if (s.second_difference) text += "  Δ²I " + with_sign(*s.second_difference);
    }
    return text + (s.seen ? fmt::format("  face {}", s.seen->face) : std::string("  background"));
}

}  // namespace

const Tool scope_tool{scope_hover, scope_press, scope_drag, scope_release, scope_hint};

void draw_scope_line(ImDrawList& list, UiState& state, const PictureView& view) {
    const ScopeState& scope = state.get<ScopeState>();
    if (!scope.open) return;
    if (scope.card) draw_card(list, scope, view);
    const ImVec2 from = place_of(scope.from, view), to = place_of(scope.to, view);
    const ImU32 white = to_u32({1, 1, 1, 1});
    cased_line(list, from, to, white, 1);
    for (const auto& [end, hand] : {std::pair(from, Hand::From), std::pair(to, Hand::To)})
        rimmed_disc(list, end, scope.hand == hand || scope.under == hand ? 5.5f : 4, white);
    if (scope.hovered < 0) return;
    const ProfileSample& sample = scope.samples[static_cast<std::size_t>(scope.hovered)];
    const ImVec2 at = view.to_window(glm::dvec2(sample.pixel) + 0.5);
    cased_circle(list, at, 7, to_u32(theme().accent), 1.8f);
}

glm::ivec2 pixel_of(glm::dvec2 share, PictureSize size) {
    return nearest_pixel(size, share * glm::dvec2(size.width, size.height));
}

void lay_level(ScopeState& scope) {
    const ScopeState initial;
    scope.from = initial.from;
    scope.to = initial.to;
}

void toggle_scope(ScopeState& scope) {
    scope.open = !scope.open;
    scope.armed = scope.open;
    scope.hand = Hand::None;
    scope.hovered = -1;
}

void update_scope(ScopeState& scope, const Renderer& renderer, const Picture& picture) {
    if (!scope.open) return;
    scope.samples =
        profile(renderer, picture, pixel_of(scope.from, picture.size), pixel_of(scope.to, picture.size));
    scope.seen.clear();
    if (scope.eye) scope.seen = perceived(scope.samples, scope.surround_px);
    if (scope.hovered >= static_cast<int>(scope.samples.size())) scope.hovered = -1;
}

void place_card(ScopeState& scope, PictureSize size) {
    const auto bend = [](const ProfileSample& s) { return std::abs(s.second_difference.value_or(0)); };
    const auto sharpest =
        std::max_element(scope.samples.begin(), scope.samples.end(),
                         [&](const ProfileSample& a, const ProfileSample& b) { return bend(a) < bend(b); });
    if (sharpest == scope.samples.end()) return;
    scope.card_at = (glm::dvec2(sharpest->pixel) + 0.5) / glm::dvec2(size.width, size.height);
    scope.card_at.x += scope.card_size.x / 2;
}

void switch_card(ScopeState& scope, PictureSize size) {
    scope.card = !scope.card;
    if (scope.card) place_card(scope, size);
}

std::vector<ScopeEdge> edges_along(const std::vector<ProfileSample>& samples) {
    std::vector<ScopeEdge> found;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const std::optional<SeenPoint>&a = samples[i - 1].seen, &b = samples[i].seen;
        if (!a && !b) continue;
        const bool same_face = a && b && a->object == b->object && a->face == b->face;
        if (same_face && a->triangle == b->triangle) continue;
        found.push_back({(samples[i].position + samples[i - 1].position) / 2, same_face});
    }
    return found;
}

std::string edge_words(const std::vector<ProfileSample>& samples) {
    const std::vector<ScopeEdge> edges = edges_along(samples);
    const auto diagonals = static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [](const ScopeEdge& edge) { return edge.is_diagonal; }));
    const auto counted = [](std::size_t count, const char* what) {
        return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    const std::string all =
        counted(samples.size(), "pixel") + ", " + counted(edges.size() - diagonals, "edge");
    return diagonals == 0 ? all : all + ", " + counted(diagonals, "diagonal");
}

// The panel below the picture: intensity along the scope's line.

namespace {

using Points = std::vector<glm::dvec2>;

/// A curve with one value per sample, and a gap where `value` returns NaN.
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
    // If the edges' lines were closer together, they would form a grey hatching that hides the curve.
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

/// Draws the curve, with a mark at the hovered sample.
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

/// A curve around zero in its own strip: a difference or, if requested, the eye's contribution.
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

/// Draws the buttons. True if the command should be copied.
bool buttons(ScopeState& scope, PictureSize size) {
    scope.armed ^= toggle("Draw", scope.armed, "Draw a line",
                          "Drag over the picture; a click gives the full scan line through a pixel",
                          "Shift: horizontal or vertical");
    scope.channels ^= toggle("RGB", scope.channels, "Red, green and blue",
                             "In place of luminance, 0.2126 R + 0.7152 G + 0.0722 B");
    scope.eye ^= toggle("Eye", scope.eye, "What the eye perceives",
                        "Intensity sharpened against its neighbourhood, as in the retina: the bands that "
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
