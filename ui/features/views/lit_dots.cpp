// The dots at the points where the equation is evaluated.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <set>

#include "ui/features/views/views.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int columns = 40;

const char* places_of(ShadingMode mode) {
    switch (mode) {
    case ShadingMode::Flat:
        return "faces";
    case ShadingMode::Gouraud:
        return "corners";
    case ShadingMode::Facet:
    case ShadingMode::Phong:
        return "pixels";
    }
    return "";  // not reached
}

/// Adds a point unless it has already been added: each corner is found once for every face around it.
void add_once(std::vector<LitDot>& dots, std::set<std::array<float, 6>>& known, const ExplainedPoint& at) {
    const glm::vec3 p = at.point.world, n = at.normal.world;
    if (known.insert({p.x, p.y, p.z, n.x, n.y, n.z}).second) dots.push_back({p, n, at.sum});
}

}  // namespace

std::vector<LitDot> lit_dots(const Renderer& renderer, PictureSize size, int across, const PartRect& rect) {
    std::vector<LitDot> dots;
    std::set<std::array<float, 6>> known;
    const int step = std::max(size.width / std::max(across, 1), 1);
    for (int y = step / 2; y < size.height; y += step)
        for (int x = step / 2; x < size.width; x += step) {
            if (!rect.holds({x, y}) || renderer.object_at(x, y) < 0) continue;
            const Explanation e = renderer.explain(x, y);
            if (!e.lit_per_corner) add_once(dots, known, e.at);
            for (const ExplainedCorner& corner : e.corners)
                if (e.lit_per_corner) add_once(dots, known, corner.at);
        }
    return dots;
}

void update_lit_dots(LitDotsState& state, const std::vector<DrawnPart>& parts, PictureSize size,
                     std::uint64_t serial) {
    if (!state.dots && !state.needles) return state.found.forget();
    (void)state.found.of(serial, [&] {
        state.size = size;
        std::vector<PartDots> found;
        found.reserve(parts.size());
        for (const DrawnPart& part : parts)
            found.push_back({part.rect, lit_dots(*part.renderer, size, columns, part.rect)});
        return found;
    });
}

std::string evaluations_text(const Renderer& renderer, const Scene& scene) {
    const FrameStats& stats = renderer.stats();
    const auto lights = static_cast<std::uint64_t>(std::count_if(
        scene.lights.begin(), scene.lights.end(), [](const Light& light) { return light.enabled; }));
    const bool area = std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
        return light.enabled && light.kind == LightKind::Area;
    });
    if (scene.shading.reflection == Reflection::None || lights == 0) return "the equation is not evaluated";
    if (area)
        return fmt::format("{} × lights and their samples = {} evaluations per frame",
                           places_of(scene.shading.mode), stats.evaluations);
    return fmt::format("{} {} × {} {} = {} evaluations per frame", stats.evaluations / lights,
                       places_of(scene.shading.mode), lights, lights == 1 ? "light" : "lights",
                       stats.evaluations);
}

namespace {

/// Draws an arrow; if it points along the line of sight, a disc (towards the viewer) or a ring (away).
void draw_needle(ImDrawList& list, const PictureView& view, const LitDot& dot, const ProjectedPoint& foot) {
    // Perpendicular to the line of sight, the arrow is this many pixels long at any distance.
    const glm::dvec2 beside = foot.pixel + glm::dvec2(24, 0);
    const double length =
        glm::length(unproject(view.map, beside, foot.depth) - unproject(view.map, foot.pixel, foot.depth));
    const ProjectedPoint tip = project(view.map, glm::dvec3(dot.place) + length * glm::dvec3(dot.normal));
    if (!tip.in_front) return;
    const ImU32 colour = to_u32(theme()[Symbol::N]);
    const ImVec2 from = view.to_window(foot.pixel), to = view.to_window(tip.pixel), way = to - from;
    const float across = length_of(way);
    constexpr float head = 7;  // logical pixels
    if (across < px(head)) {
        if (tip.depth < foot.depth) return rimmed_disc(list, from, 2.4f, colour);
        return cased_circle(list, from, 2.4f, colour, 1.2f);
    }
    const ImVec2 along = way / across;
    cased_line(list, from, to - px(head - 1) * along, colour);
    arrow_head(list, to + px(1.5f) * along, along, head + 2.5f, 4.2f, rim_colour());
    arrow_head(list, to, along, head, 2.8f, colour);
}

}  // namespace

void draw_lit_dots(ImDrawList& list, const LitDotsState& state, const PictureView& view) {
    if (state.found.value() == nullptr) return;
    const PictureSize whole = view.map.size;
    const glm::dvec2 larger(double(whole.width) / state.size.width, double(whole.height) / state.size.height);
    const auto corner = [&](glm::ivec2 pixel) { return view.to_window(glm::dvec2(pixel) * larger); };
    for (const PartDots& part : *state.found.value()) {
        list.PushClipRect(corner(part.rect.low), corner(part.rect.high), true);
        for (const LitDot& dot : part.dots) {
            const ProjectedPoint foot = project(view.map, dot.place);
            if (!foot.in_front) continue;
            if (state.needles) draw_needle(list, view, dot, foot);
            if (!state.dots) continue;
            const ImVec2 at = view.to_window(foot.pixel);
            const glm::vec3 c = glm::min(dot.color, glm::vec3(1));
            list.AddCircleFilled(at, px(3.4f), to_u32({1, 1, 1, 1}, 0.9f), 10);
            list.AddCircleFilled(at, px(2.4f), to_u32({c.x, c.y, c.z, 1}), 10);
        }
        list.PopClipRect();
    }
}

void draw_evaluations(ImDrawList& list, const std::string& text, bool compares) {
    ImGui::PushFont(fonts().small);
    const Rect area = clip_area(list);
    const ImVec2 corner{area.high.x, area.low.y + (compares ? px(28) : 0)};
    list_control("evaluations", text.c_str(), badge(list, corner + px(10) * ImVec2(-1, 1), text, {1, 0}));
    ImGui::PopFont();
}

}  // namespace glint
