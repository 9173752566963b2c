// Reads numbers off a plot under the mouse.
#include <fmt/core.h>

#include <algorithm>

#include "ui/features/plots/plot.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"

namespace glint {

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

}  // namespace glint
