// Plots in a half-disc of directions.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/features/plots/plot.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"

namespace glint {
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

}  // namespace glint
