#include "ui/features/inspector/vectors/arrows.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float label_reach = 30;  // how far a label may be displaced, logical pixels

/// Draws the letter centred at `centre`, or near it if that area is taken.
void letter_at(ImDrawList& list, ImVec2 centre, const ArrowLook& look) {
    if (*look.letter == 0) return;
    if (look.words != nullptr)
        look.words->letter(centre, look.colour, look.letter);
    else
        rimmed_text(list, centre, look.colour, look.letter);
}

/// Draws an arrow that points along the line of sight.
void draw_end_on(ImDrawList& list, ImVec2 at, const ArrowLook& look) {
    cased_circle(list, at, 6, to_u32(look.colour), look.width);
    list.AddCircleFilled(at, px(2), to_u32(look.colour));
    letter_at(list, at + px(1) * ImVec2(14, 10), look);
}

}  // namespace

ImVec2 PointPen::at(glm::dvec3 offset) const { return view.shown(origin + reach * offset); }

PointPen pen_at(ImDrawList& list, const PictureView& view, glm::dvec3 origin, float length) {
    const ProjectedPoint seen = project(view.map, origin);
    const glm::dvec3 beside = unproject(view.map, seen.pixel + glm::dvec2(1, 0), seen.depth);
    const double scene_units_per_pixel = glm::distance(origin, beside);
    return {list, view, origin, view.pixels(length) * scene_units_per_pixel};
}

void Words::keep_off(ImVec2 from, ImVec2 to) {
    const ImVec2 half = px(2.5f) * ImVec2(1, 1);
    const int boxes = std::max(1, static_cast<int>(length_of(to - from) / px(5)));
    for (int i = 0; i <= boxes; ++i) {
        const ImVec2 at = from + float(i) / float(boxes) * (to - from);
        lines_.keep_free({at - half, at + half});
    }
}

void Words::letter(ImVec2 centre, const ImVec4& colour, const std::string& text) {
    letters_.push_back({centre, colour, text});
}

void Words::degrees(ImVec2 centre, const ImVec4& colour, const std::string& text) {
    angles_.push_back({centre, colour, text});
}

void Words::draw(ImDrawList& list) const {
    LabelRoom room = lines_;
    for (const Word& word : letters_) {
        const ImVec2 size = ImGui::CalcTextSize(word.text.c_str());
        const ImVec2 at = room.place_anyhow(word.wanted, size, px(label_reach));
        const ImVec2 way = word.wanted - at;
        if (length_of(way) > size.y)
            cased_line(list, at + 0.5f * size.y / length_of(way) * way, word.wanted, to_u32(word.colour), 1);
        rimmed_text(list, at, word.colour, word.text);
        list_control("Letter of a vector", word.text, {at - size / 2, at + size / 2});
    }
    for (const Word& word : angles_)
        if (const ImVec2 size = ImGui::CalcTextSize(word.text.c_str()) + px(1) * ImVec2(8, 2);
            const auto free = room.place(word.wanted, size, px(label_reach))) {
            rimmed_text(list, *free, word.colour, word.text);
            list_control("Angle of vectors", word.text, {*free - size / 2, *free + size / 2});
        }
}

void draw_arrow(ImDrawList& list, ImVec2 from, ImVec2 to, const ArrowLook& look) {
    const ImVec2 way = to - from;
    const float length = length_of(way);
    if (length < px(9)) return draw_end_on(list, from, look);
    if (look.words != nullptr) look.words->keep_off(from, to);
    const ImVec2 along = way / length;
    const float head = std::min(px(4.5f + 1.5f * look.width), length / 2) / px(1);
    cased_line(list, from, to - px(head) * along, to_u32(look.colour), look.width);
    arrow_head(list, to + px(1.5f) * along, along, head + 3, 0.45f * head + 1.5f, rim_colour());
    arrow_head(list, to, along, head, 0.45f * head, to_u32(look.colour));
    letter_at(list, to + px(11) * along, look);
}

void draw_arc(const PointPen& pen, glm::dvec3 a, glm::dvec3 b, double radius, const ImVec4& colour,
              Words& words) {
    const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
    const glm::dvec3 side = b - a * glm::dot(a, b);
    if (angle < 0.01 || glm::length(side) < 1e-6) return;
    const glm::dvec3 to_side = glm::normalize(side);
    const auto direction = [&](double t) { return std::cos(t) * a + std::sin(t) * to_side; };
    constexpr int steps = 24;
    std::vector<ImVec2> points;
    for (int i = 0; i <= steps; ++i) points.push_back(pen.at(radius * direction(angle * i / steps)));
    cased_outline(pen.list, points, to_u32(colour), 1.4f, false);
    if (length_of(points.back() - points.front()) < px(16)) return;  // nearly end-on: no room for labels
    const ImVec2 middle = points[steps / 2], out = middle - pen.at(glm::dvec3(0));
    const ImVec2 spot = middle + px(13) / std::max(length_of(out), 1.0f) * out;
    words.degrees(spot, colour, fmt::format("{:.0f}°", angle * 180 / std::numbers::pi));
}

namespace {

constexpr int directions = 16;
constexpr int rings = 8;  // from the preferred position out to the maximum distance

Rect about(ImVec2 middle, ImVec2 size) {
    return {{middle.x - size.x / 2, middle.y - size.y / 2}, {middle.x + size.x / 2, middle.y + size.y / 2}};
}

}  // namespace

ImVec2 LabelRoom::inside(ImVec2 middle, ImVec2 size) const {
    if (!bounds_) return middle;
    const auto within = [](float at, float length, float low, float high) {
        return std::max(std::min(at, high - length / 2), low + length / 2);
    };
    return {within(middle.x, size.x, bounds_->low.x, bounds_->high.x),
            within(middle.y, size.y, bounds_->low.y, bounds_->high.y)};
}

bool LabelRoom::is_free(const Rect& area) const {
    return std::none_of(taken_.begin(), taken_.end(),
                        [&area](const Rect& other) { return overlap(area, other); });
}

std::optional<ImVec2> LabelRoom::place(ImVec2 wanted, ImVec2 size, float reach) {
    for (int ring = 0; ring <= rings; ++ring) {
        const float away = reach * float(ring) / rings;
        for (int i = 0; i < (ring == 0 ? 1 : directions); ++i) {
            const float angle = 2 * std::numbers::pi_v<float> * float(i) / directions;
            const ImVec2 middle =
                inside({wanted.x + away * std::sin(angle), wanted.y - away * std::cos(angle)}, size);
            const Rect area = about(middle, size);
            if (!is_free(area)) continue;
            taken_.push_back(area);
            return middle;
        }
    }
    return {};
}

ImVec2 LabelRoom::place_anyhow(ImVec2 wanted, ImVec2 size, float reach) {
    if (const auto middle = place(wanted, size, reach)) return *middle;
    const ImVec2 middle = inside(wanted, size);
    taken_.push_back(about(middle, size));
    return middle;
}

}  // namespace glint
