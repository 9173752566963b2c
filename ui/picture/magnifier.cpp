#include "ui/picture/magnifier.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "models/scene/scene.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

constexpr float least_square = 10, least_number = 26, least_three = 44;  // window pixels per picture pixel

struct PixelRange {
    int x0, y0, x1, y1;  // x1 and y1 excluded
};

PixelRange visible(const ImDrawList& list, const PictureView& view) {
    const glm::dvec2 low = view.to_pixel(list.GetClipRectMin()), high = view.to_pixel(list.GetClipRectMax());
    const PictureSize size = view.map.size;
    return {static_cast<int>(std::clamp(std::floor(low.x), 0.0, double(size.width))),
            static_cast<int>(std::clamp(std::floor(low.y), 0.0, double(size.height))),
            static_cast<int>(std::clamp(std::ceil(high.x), 0.0, double(size.width))),
            static_cast<int>(std::clamp(std::ceil(high.y), 0.0, double(size.height)))};
}

PixelRange within(const PixelRange& range, const PartRect& rect) {
    return {std::max(range.x0, rect.low.x), std::max(range.y0, rect.low.y), std::min(range.x1, rect.high.x),
            std::min(range.y1, rect.high.y)};
}

std::pair<int, std::int64_t> face_at(const Renderer& renderer, PictureSize size, int x, int y) {
    if (!is_inside(size, {x, y})) return {-1, -1};
    const auto seen = renderer.seen_at(x, y);
    return seen ? std::pair(seen->object, std::int64_t{seen->face}) : std::pair(-1, std::int64_t{-1});
}

/// Returns the luminance, 0 to 2'550'000. Source: the weights of Rec. 709.
int brightness(int r, int g, int b) { return 2126 * r + 7152 * g + 722 * b; }

/// Draws the numbers of the pixels in `numbered`; `shown` is the picture below them.
void draw_number(ImDrawList& list, const PictureView& view, const Picture& numbered, const Picture& shown,
                 int x, int y) {
    const std::size_t at = 4 * shown.pixel(x, y);
    const int r = numbered.rgba[at], g = numbered.rgba[at + 1], b = numbered.rgba[at + 2];
    const bool light = brightness(shown.rgba[at], shown.rgba[at + 1], shown.rgba[at + 2]) > 1'200'000;
    const ImU32 ink = light ? IM_COL32(0, 0, 0, 210) : IM_COL32(255, 255, 255, 220);
    const bool three = view.units_per_pixel >= px(least_three) && !(r == g && g == b);
    const std::string text =
        three ? fmt::format("{}\n{}\n{}", r, g, b) : fmt::format("{}", (brightness(r, g, b) + 5000) / 10000);
    const float height = std::min(view.units_per_pixel * (three ? 0.28f : 0.4f), small_text_height());
    const ImVec2 size = fonts().figures->CalcTextSizeA(height, 1e9f, 0, text.c_str());
    const ImVec2 low = view.to_window(glm::dvec2(x, y) + 0.5) - size / 2;
    list.AddText(fonts().figures, height, low, ink, text.c_str());
}

/// Draws the stepped edges of the rasterisation, between pixels that show different faces.
void draw_edges(ImDrawList& list, const PictureView& view, const Renderer& renderer,
                const PixelRange& range) {
    const PictureSize size = view.map.size;
    const ImU32 colour = to_u32(theme().warning);
    for (int y = range.y0; y < range.y1; ++y)
        for (int x = range.x0; x < range.x1; ++x) {
            const auto here = face_at(renderer, size, x, y);
            if (x > 0 && face_at(renderer, size, x - 1, y) != here)
                list.AddLine(view.to_window({x, y}), view.to_window({x, y + 1}), colour, px(2));
            if (y > 0 && face_at(renderer, size, x, y - 1) != here)
                list.AddLine(view.to_window({x, y}), view.to_window({x + 1, y}), colour, px(2));
        }
}

/// Draws the exact polygon over its stepped picture, and the scan line through the pixel.
void draw_picked(ImDrawList& list, const PictureView& view, const Renderer& renderer, const Scene& drawn,
                 glm::ivec2 picked) {
    const PictureSize size = view.map.size;
    list.AddRect(view.to_window({0, picked.y}), view.to_window({size.width, picked.y + 1}),
                 to_u32(theme().accent), 0, 0, px(1.5f));
    const auto seen = renderer.seen_at(picked.x, picked.y);
    if (!seen || static_cast<std::size_t>(seen->object) >= drawn.objects.size()) return;
    const Object& object = drawn.objects[static_cast<std::size_t>(seen->object)];
    if (!object.mesh || seen->face + 1 >= object.mesh->first_corner.size()) return;
    const glm::dmat4 world_from_object = glint::world_from_object(object.transform);
    const std::uint32_t first = object.mesh->first_corner[seen->face],
                        end = object.mesh->first_corner[seen->face + 1];
    for (std::uint32_t i = first; i < end; ++i) {
        const glm::vec3 corner = object.mesh->positions[object.mesh->corner_position[i]];
        const ProjectedPoint at =
            project(view.map, glm::dvec3(world_from_object * glm::dvec4(glm::dvec3(corner), 1)));
        if (!at.in_front) return list.PathClear();
        list.PathLineTo(view.to_window(at.pixel));
    }
    list.PathStroke(to_u32({1, 1, 1, 1}, 0.9f), ImDrawFlags_Closed, px(1.5f));
}

}  // namespace

void magnify(PictureView& view, const Rect& area, const MagnifierState& magnifier) {
    if (magnifier.zoom <= 1) return;
    const float plain = view.units_per_pixel;
    // A whole number, so that squares are sharp.
    const float type = std::max(std::ceil(px(1) / plain - 0.01f), 1.0f);
    view.units_per_pixel = plain * type * static_cast<float>(magnifier.zoom);
    const auto place = [&](float low, float high, double share, int pixels) {
        const float length = static_cast<float>(pixels) * view.units_per_pixel;
        const float wanted = (low + high) / 2 - static_cast<float>(share) * length;
        return std::round(std::clamp(wanted, std::min(high - length, low), low) / plain) * plain;
    };
    view.origin = {place(area.low.x, area.high.x, magnifier.centre.x, view.map.size.width),
                   place(area.low.y, area.high.y, magnifier.centre.y, view.map.size.height)};
}

void zoom_about(MagnifierState& magnifier, int zoom, glm::dvec2 share) {
    zoom = std::clamp(zoom, 1, max_zoom);
    const double shrink = double(magnifier.zoom) / zoom;
    magnifier.centre = glm::clamp(share + (magnifier.centre - share) * shrink, 0.0, 1.0);
    magnifier.zoom = zoom;
}

namespace {

/// Ctrl+wheel zooms; in an enlarged picture the right button pans.
bool magnifier_hover(ToolFrame& frame) {
    ImGuiIO& io = ImGui::GetIO();
    MagnifierState& magnifier = frame.state.get<MagnifierState>();
    if (!frame.over) return false;
    if (!io.KeyCtrl || io.MouseWheel == 0)
        return magnifier.zoom > 1 && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    const glm::dvec2 size(frame.view.map.size.width, frame.view.map.size.height);
    // A slow frame may receive several steps.
    constexpr float most_steps = 6;  // number of steps from 1 to max_zoom
    const int steps = static_cast<int>(std::lround(std::clamp(io.MouseWheel, -most_steps, most_steps)));
    const int sure = steps != 0          ? steps
                     : io.MouseWheel > 0 ? 1
                                         : -1;  // at least one step, even with smooth scrolling
    zoom_about(magnifier, sure > 0 ? magnifier.zoom << sure : magnifier.zoom >> -sure, frame.pixel / size);
    io.MouseWheel = 0;  // keeps the camera from moving as well
    return true;
}

int magnifier_press(ToolFrame& frame) {
    const bool begins =
        frame.state.get<MagnifierState>().zoom > 1 && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    return begins ? ImGuiMouseButton_Right : not_taken;
}

bool magnifier_drag(ToolFrame& frame) {
    MagnifierState& magnifier = frame.state.get<MagnifierState>();
    if (magnifier.zoom <= 1) return false;
    const glm::dvec2 size(frame.view.map.size.width, frame.view.map.size.height);
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    magnifier.centre -= glm::dvec2(moved.x, moved.y) / (size * double(frame.view.units_per_pixel));
    magnifier.centre = glm::clamp(magnifier.centre, 0.0, 1.0);
    return true;
}

}  // namespace

const Tool magnifier_tool{.hover = magnifier_hover, .press = magnifier_press, .drag = magnifier_drag};

void draw_big_pixels(ImDrawList& list, UiState& state, const PictureView& view) {
    const Picture& shown = *state.displayed;
    const auto picked = probe_pixel(state.viewport, view.map.size);
    if (state.get<MagnifierState>().zoom <= 1 || view.units_per_pixel < px(least_square) ||
        !(shown.size == view.map.size))
        return;
    const PixelRange range = visible(list, view);
    const ImU32 line = to_u32({0.5f, 0.5f, 0.5f, 1}, 0.35f);
    for (int x = range.x0; x <= range.x1; ++x)
        list.AddLine(view.to_window({x, range.y0}), view.to_window({x, range.y1}), line);
    for (int y = range.y0; y <= range.y1; ++y)
        list.AddLine(view.to_window({range.x0, y}), view.to_window({range.x1, y}), line);
    for (const ShownPart& part : state.parts) {
        if (part.renderer == nullptr) continue;
        draw_edges(list, view, *part.renderer, within(range, part.rect));
        if (picked && part.rect.holds(*picked))
            draw_picked(list, view, *part.renderer,
                        part.other != nullptr ? *part.other : state.rendered_scene, *picked);
    }
    if (view.units_per_pixel < px(least_number)) return;
    const Picture& numbered = *state.unpainted;
    for (int y = range.y0; y < range.y1; ++y)
        for (int x = range.x0; x < range.x1; ++x) draw_number(list, view, numbered, shown, x, y);
}

}  // namespace glint
