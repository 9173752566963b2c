#include "ui/picture/world_pen.h"

#include <cmath>
#include <numbers>

#include "ui/widgets/theme.h"

namespace glint {

void WorldPen::line(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float width) const {
    constexpr double eye = 1e-3;
    const double depth_a = -(view.map.view_from_world * glm::dvec4(a, 1)).z;
    const double depth_b = -(view.map.view_from_world * glm::dvec4(b, 1)).z;
    if (depth_a < eye && depth_b < eye) return;
    if (depth_a < eye) a += (b - a) * ((eye - depth_a) / (depth_b - depth_a));
    if (depth_b < eye) b += (a - b) * ((eye - depth_b) / (depth_a - depth_b));
    const OnScreen from = project(view.map, a), to = project(view.map, b);
    if (!from.in_front || !to.in_front) return;
    list.AddLine(view.to_window(from.pixel), view.to_window(to.pixel), colour, width);
}

void WorldPen::cased(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float opacity) const {
    line(a, b, to_u32({0, 0, 0, 1}, 0.45f * opacity), px(3));
    line(a, b, colour, px(1.3f));
}

void WorldPen::circle(glm::dvec3 centre, glm::dvec3 u, glm::dvec3 v, ImU32 colour, float opacity) const {
    constexpr int sides = 48;
    const auto point = [&](int i) {
        const double a = 2 * std::numbers::pi * i / sides;
        return centre + std::cos(a) * u + std::sin(a) * v;
    };
    for (int i = 0; i < sides; ++i) cased(point(i), point(i + 1), colour, opacity);
}

void WorldPen::mark(glm::dvec3 place, ImU32 colour, float opacity, bool hovered) const {
    const OnScreen at = project(view.map, place);
    if (!at.in_front) return;
    const ImVec2 middle = view.to_window(at.pixel);
    const float radius = px(hovered ? 5.5f : 3.5f);
    list.AddCircleFilled(middle, radius + px(1.2f), to_u32({0, 0, 0, 1}, 0.7f * opacity));
    list.AddCircleFilled(middle, radius, colour);
    if (hovered) list.AddCircle(middle, radius + px(1.2f), to_u32({1, 1, 1, 1}, opacity), 0, px(1.5f));
}

}  // namespace glint
