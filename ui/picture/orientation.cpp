// Orientation in the scene: clickable axes in the corner of the picture, and a grid on the ground.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/orbit.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

struct OrientationState {
    bool axes = true, grid = false;
    int hovered = -1;  // in `ends`
    float below = 0;   // height of a comparison's labels, below which the axes are drawn
};

/// One end of an axis, and the view from that end.
struct AxisEnd {
    glm::dvec3 way;
    const char* name;
    ViewFrom from;
    CommandId key;
};
constexpr std::array<AxisEnd, 6> ends{{{{1, 0, 0}, "x", ViewFrom::Right, CommandId::ViewRight},
                                       {{-1, 0, 0}, "", ViewFrom::Left, CommandId::ViewLeft},
                                       {{0, 1, 0}, "y", ViewFrom::Top, CommandId::ViewTop},
                                       {{0, -1, 0}, "", ViewFrom::Bottom, CommandId::ViewBottom},
                                       {{0, 0, 1}, "z", ViewFrom::Front, CommandId::ViewFront},
                                       {{0, 0, -1}, "", ViewFrom::Back, CommandId::ViewBack}}};
constexpr float arm = 26, end_radius = 8, margin = 46;  // logical pixels

/// Whether the visible part of the picture is large enough for the axes.
bool has_room(const Rect& picture) { return std::min(picture.size().x, picture.size().y) >= px(240); }

ImVec2 middle_of_axes(const UiState& state) {
    const Rect picture = picture_in_sight(state);
    return {picture.high.x - px(margin), picture.low.y + px(margin) + state.get<OrientationState>().below};
}

ImVec2 place_of(const AxisEnd& end, ImVec2 middle, const ScreenMap& map) {
    const glm::dvec3 in_view(map.view_from_world * glm::dvec4(end.way, 0));
    return middle + px(arm) * ImVec2(float(in_view.x), float(-in_view.y));
}

double depth_of(const AxisEnd& end, const ScreenMap& map) {
    return -glm::dvec3(map.view_from_world * glm::dvec4(end.way, 0)).z;
}

bool is_shown(const UiState& state) {
    return state.get<OrientationState>().axes && has_room(picture_in_sight(state)) && !is_held(state) &&
           !state.layout.hides_all && state.on_screen.refusal().empty();
}

bool hover_axes(ToolFrame& frame) {
    OrientationState& orientation = frame.state.get<OrientationState>();
    orientation.hovered = -1;
    if (!frame.over || !is_shown(frame.state)) return false;
    const ImVec2 mouse = ImGui::GetIO().MousePos, middle = middle_of_axes(frame.state);
    for (int i = 0; i < static_cast<int>(ends.size()); ++i) {
        const AxisEnd& end = ends[static_cast<std::size_t>(i)];
        const ImVec2 away = mouse - place_of(end, middle, frame.view.map);
        const bool is_nearer =
            orientation.hovered < 0 ||
            depth_of(end, frame.view.map) <
                depth_of(ends[static_cast<std::size_t>(orientation.hovered)], frame.view.map);
        if (length_of(away) <= px(12) && is_nearer) orientation.hovered = i;
    }
    if (orientation.hovered >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return orientation.hovered >= 0;
}

int press_axes(ToolFrame& frame) {
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return not_taken;
    run_command(frame.state, ends[static_cast<std::size_t>(frame.state.get<OrientationState>().hovered)].key);
    return not_taken;
}

std::string axes_hint(const UiState& state) {
    const int hovered = state.get<OrientationState>().hovered;
    if (hovered < 0) return {};
    const CommandId id = ends[static_cast<std::size_t>(hovered)].key;
    return std::string("Click: ") + command(id).name + " (" + keys_of(id) + ")";
}

const Tool axes_tool{.hover = hover_axes, .press = press_axes, .hint = axes_hint};

void draw_axes(ImDrawList& list, const UiState& state, const PictureView& view) {
    static constexpr std::array<ImU32, 3> colours{IM_COL32(235, 92, 92, 255), IM_COL32(120, 200, 90, 255),
                                                  IM_COL32(92, 150, 245, 255)};
    const ImVec2 middle = middle_of_axes(state);
    std::array<int, 6> order{0, 1, 2, 3, 4, 5};  // farthest first
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return depth_of(ends[static_cast<std::size_t>(a)], view.map) >
               depth_of(ends[static_cast<std::size_t>(b)], view.map);
    });
    for (const int i : order) {
        const AxisEnd& end = ends[static_cast<std::size_t>(i)];
        const ImU32 colour = colours[static_cast<std::size_t>(i / 2)];
        const ImVec2 at = place_of(end, middle, view.map);
        const bool lit = state.get<OrientationState>().hovered == i, named = *end.name != 0;
        if (named) cased_line(list, middle, at, colour, 1.6f);
        rimmed_disc(list, at, named || lit ? end_radius : 4, colour, named || lit ? 1.0f : 0.55f);
        const ImVec2 size = ImGui::CalcTextSize(end.name);
        if (named) list.AddText(at - size / 2, IM_COL32(15, 15, 15, 255), end.name);
        const ImVec2 reach = px(1) * ImVec2(12, 12);
        list_control(command(end.key).name, "axis", {at - reach, at + reach});
    }
}

/// Returns the distance between lines: 1, 2 or 5 times a power of ten, at least a twelfth of the scene's
/// width.
double grid_step(double width) {
    const double least = width / 12, ten = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * ten >= least) return factor * ten;
    return 10 * ten;
}

/// Draws lines at ground_height(), hidden where a surface is in front of them.
void draw_grid(ImDrawList& list, const UiState& state, const PictureView& view) {
    constexpr int lines = 12, pieces = 48;  // lines on either side of the middle; segments per line
    const Bounds& bounds = view.bounds;
    const glm::dvec3 low(bounds.min), high(bounds.max);
    const double step = grid_step(std::max({high.x - low.x, high.z - low.z, 1e-6}));
    const glm::dvec2 middle{std::round((low.x + high.x) / 2 / step) * step,
                            std::round((low.z + high.z) / 2 / step) * step};
    const double ground = ground_height(state.editor.scene());
    const Renderer* const renderer = renderer_of_open_scene(state, view.map.size);
    const auto is_hidden = [&](const ProjectedPoint& at) {
        if (renderer == nullptr || !is_inside(view.map.size, at.pixel)) return false;
        const double depth = renderer->depth_at(int(at.pixel.x), int(at.pixel.y));
        return depth > 0 && depth < at.depth * 0.995;
    };
    for (int axis = 0; axis < 2; ++axis)
        for (int line = -lines; line <= lines; ++line)
            for (int piece = 0; piece < pieces; ++piece) {
                const auto at = [&](double along) {
                    const double a = (2 * along / pieces - 1) * lines * step, b = line * step;
                    return project(view.map,
                                   {middle.x + (axis == 0 ? a : b), ground, middle.y + (axis == 0 ? b : a)});
                };
                const ProjectedPoint from = at(piece), to = at(piece + 1), half = at(piece + 0.5);
                if (!from.in_front || !to.in_front || is_hidden(half)) continue;
                list.AddLine(view.to_window(from.pixel), view.to_window(to.pixel),
                             IM_COL32(255, 255, 255, line == 0 ? 130 : 60), px(1));
            }
}

void draw_orientation(ImDrawList& list, UiState& state, const PictureView& view) {
    if (state.get<OrientationState>().grid) draw_grid(list, state, view);
    if (is_shown(state)) draw_axes(list, state, view);
}

template <bool OrientationState::*shown> WindowCommand toggle(const char* name, const char* words) {
    return {.name = name,
            .section = Section::ViewWindow,
            .run = [](UiState& s) { s.get<OrientationState>().*shown ^= true; },
            .is_on = [](const UiState& s) { return s.get<OrientationState>().*shown; },
            .quiet = true,
            .words = words};
}

}  // namespace

extern const Feature orientation_feature;
const Feature orientation_feature{
    .begin = [](UiState& s, const UiInput&) { s.get<OrientationState>().below = s.label_height; },
    .tool = &axes_tool,
    .overlay = draw_orientation,
    .commands =
        [] {
            return std::vector<WindowCommand>{
                toggle<&OrientationState::axes>("Axes in the corner", "gizmo view cube orientation"),
                toggle<&OrientationState::grid>("Ground grid", "floor lines")};
        },
    .write_settings = [](const UiState& s, Json& json) { json["axes"] = s.get<OrientationState>().axes; },
    .read_settings =
        [](UiState& s, const Json& json) {
            s.get<OrientationState>() = {};
            read_member(json, "axes", s.get<OrientationState>().axes);
        }};

}  // namespace glint
