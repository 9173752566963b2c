// The scan-line scope's mouse handling, and its samples of the picture.
#include "ui/features/views/scope.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "renderer/explain/printed_number.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"

namespace glint {
namespace {

using Hand = ScopeState::Hand;

/// Logical pixels within which an end or the line can be grabbed.
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
    // Limits the move so that both ends stay inside.
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

/// The cursor as a share: the centre of its pixel, for which pixel_of() returns that pixel despite rounding.
glm::dvec2 share_under(const ToolFrame& frame) {
    return (glm::floor(frame.pixel) + 0.5) / size_of(frame.view);
}

int scope_press(ToolFrame& frame) {
    ScopeState& scope = frame.state.get<ScopeState>();
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return not_taken;
    scope.hand = scope.under;
    scope.last = share_under(frame);
    for (glm::dvec2* end : {&scope.from, &scope.to})
        *end = glm::clamp(*end, 0.0, 1.0);  // where it is visible
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
    constexpr double rounding = 1e-6;  // of float intensities
    if (std::abs(slope) < rounding) return "0.0000";
    return (slope > 0 ? "+" : "") + significant_text(slope, 4);
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

}  // namespace glint
