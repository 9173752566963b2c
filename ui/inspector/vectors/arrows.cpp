#include "ui/inspector/vectors/arrows.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace glint {
namespace {

constexpr float rim_width = 2.4f;  // units of the design, more than the line

const ImVec4 rim{0, 0, 0, 1};

constexpr float label_reach = 30;  // units of the design that a word may be pushed away

float length_of(ImVec2 v) { return std::sqrt(v.x * v.x + v.y * v.y); }

/// The letter with its middle at `centre`, or near it where something is written there.
void letter_at(ImDrawList& list, ImVec2 centre, const ArrowLook& look) {
    if (*look.letter == 0) return;
    if (look.words != nullptr)
        look.words->letter(centre, look.colour, look.letter);
    else
        rimmed_text(list, centre, look.colour, look.letter);
}

/// An arrow that points along the line of sight.
void draw_end_on(ImDrawList& list, ImVec2 at, const ArrowLook& look) {
    const float radius = px(6);
    list.AddCircle(at, radius, to_u32(rim, 0.6f), 0, px(look.width + rim_width));
    list.AddCircle(at, radius, to_u32(look.colour), 0, px(look.width));
    list.AddCircleFilled(at, px(2), to_u32(look.colour));
    letter_at(list, {at.x + px(14), at.y + px(10)}, look);
}

}  // namespace

ImVec2 PointPen::at(glm::dvec3 offset) const {
    return view.to_window(project(view.map, origin + reach * offset).pixel);
}

PointPen pen_at(ImDrawList& list, const PictureView& view, glm::dvec3 origin, float length) {
    const OnScreen seen = project(view.map, origin);
    const glm::dvec3 beside = unproject(view.map, seen.pixel + glm::dvec2(1, 0), seen.depth);
    const double scene_units_per_pixel = glm::distance(origin, beside);
    return {list, view, origin, double(px(length) / view.units_per_pixel) * scene_units_per_pixel};
}

void Words::letter(ImVec2 centre, const ImVec4& colour, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    words_.push_back({room_.place_anyhow(centre, size, px(label_reach)), colour, text});
}

void Words::degrees(ImVec2 centre, const ImVec4& colour, const std::string& text) {
    if (const auto free = room_.place(centre, ImGui::CalcTextSize(text.c_str()), px(label_reach)))
        words_.push_back({*free, colour, text});
}

void Words::draw(ImDrawList& list) const {
    for (const Word& word : words_) rimmed_text(list, word.centre, word.colour, word.text);
}

void rimmed_text(ImDrawList& list, ImVec2 centre, const ImVec4& colour, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at{std::round(centre.x - size.x / 2), std::round(centre.y - size.y / 2)};
    for (const ImVec2 off : {ImVec2(-1, 0), ImVec2(1, 0), ImVec2(0, -1), ImVec2(0, 1), ImVec2(1, 1),
                             ImVec2(-1, -1), ImVec2(-1, 1), ImVec2(1, -1)})
        list.AddText({at.x + px(off.x), at.y + px(off.y)}, to_u32(rim, 0.55f), text.c_str());
    list.AddText(at, to_u32(colour), text.c_str());
}

void draw_arrow(ImDrawList& list, ImVec2 from, ImVec2 to, const ArrowLook& look) {
    const ImVec2 way{to.x - from.x, to.y - from.y};
    const float length = length_of(way);
    if (length < px(9)) return draw_end_on(list, from, look);
    const ImVec2 along{way.x / length, way.y / length}, across{-along.y, along.x};
    const float head = std::min(px(4.5f + 1.5f * look.width), length / 2), half = 0.45f * head;
    const ImVec2 neck{to.x - along.x * head, to.y - along.y * head};
    const ImVec2 left{neck.x + across.x * half, neck.y + across.y * half};
    const ImVec2 right{neck.x - across.x * half, neck.y - across.y * half};
    list.AddLine(from, neck, to_u32(rim, 0.6f), px(look.width + rim_width));
    list.AddTriangle(to, left, right, to_u32(rim, 0.6f), px(rim_width));
    list.AddLine(from, neck, to_u32(look.colour), px(look.width));
    list.AddTriangleFilled(to, left, right, to_u32(look.colour));
    letter_at(list, {to.x + along.x * px(11), to.y + along.y * px(11)}, look);
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
    const auto draw = [&](const ImVec4& ink, float opacity, float width) {
        pen.list.AddPolyline(points.data(), steps + 1, to_u32(ink, opacity), 0, px(width));
    };
    draw(rim, 0.6f, 1.4f + rim_width);
    draw(colour, 1, 1.4f);
    const ImVec2 first = points.front(), last = points.back();
    if (length_of({last.x - first.x, last.y - first.y}) < px(16)) return;  // nearly end-on: no room for words
    const ImVec2 middle = points[steps / 2], foot = pen.at(glm::dvec3(0));
    const float out = std::max(length_of({middle.x - foot.x, middle.y - foot.y}), 1.0f);
    const ImVec2 spot{middle.x + (middle.x - foot.x) / out * px(13),
                      middle.y + (middle.y - foot.y) / out * px(13)};
    words.degrees(spot, colour, fmt::format("{:.0f}°", angle * 180 / std::numbers::pi));
}

}  // namespace glint
