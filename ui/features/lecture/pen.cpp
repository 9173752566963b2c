#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "ui/features/lecture/lecture.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float line_width = 3.5f;           // logical pixels
constexpr double least_step = 1.5;           // pixels between points of a line
constexpr std::size_t max_places = 100'000;  // points in all lines together
constexpr std::size_t drawn_at_once = 4000;  // points: ImGui's indices address up to 65,536 vertices

glm::vec2 to_place(glm::dvec2 pixel, const PictureView& view) {
    const double height = view.map.size.height;
    return {(pixel.x - view.map.size.width / 2.0) / height, (pixel.y - height / 2) / height};
}

ImVec2 to_window(glm::vec2 place, const PictureView& view) {
    const double height = view.map.size.height;
    return view.to_window({view.map.size.width / 2.0 + place.x * height, height / 2 + place.y * height});
}

/// Returns whether the pen has reached its limit, and reports it if so.
bool is_used_up(UiState& state) {
    std::size_t places = 0;
    for (const PenLine& line : state.get<PenState>().lines) places += line.places.size();
    if (places < max_places) return false;
    state.notifications.tell(fmt::format("The pen has reached its limit for a picture: {} erases everything",
                                         keys_of(CommandId::WipePen)),
                             Tone::Warning);
    return true;
}

bool begin_line(UiState& state, glm::vec2 place) {
    if (is_used_up(state)) return false;
    PenState& pen = state.get<PenState>();
    pen.lines.push_back({{place}, pen.colour});
    return true;
}

/// The other mouse buttons and the wheel still move the camera.
bool pen_hover(ToolFrame& frame) {
    const ImGuiIO& io = ImGui::GetIO();
    return frame.state.get<PenState>().on && frame.over && !io.MouseDown[ImGuiMouseButton_Right] &&
           !io.MouseDown[ImGuiMouseButton_Middle] && io.MouseWheel == 0;
}

int pen_press(ToolFrame& frame) {
    const bool begins = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                        begin_line(frame.state, to_place(frame.pixel, frame.view));
    return begins ? ImGuiMouseButton_Left : not_taken;
}

bool pen_drag(ToolFrame& frame) {
    PenState& pen = frame.state.get<PenState>();
    if (!pen.on || pen.lines.empty()) return false;
    auto& places = pen.lines.back().places;
    const glm::vec2 place = to_place(frame.pixel, frame.view);
    const float step = glm::distance(place, places.back()) * float(frame.view.map.size.height);
    if (step < float(least_step)) return true;
    if (is_used_up(frame.state)) return false;
    places.push_back(place);
    return true;
}

/// Draws the first points of a line; the next piece begins at the last of them.
void draw_piece(ImDrawList& list, std::span<const glm::vec2> places, ImU32 colour, const PictureView& view) {
    std::vector<ImVec2> corners;
    for (const glm::vec2 place : places.first(std::min(places.size(), drawn_at_once)))
        corners.push_back(to_window(place, view));
    cased_outline(list, corners, colour, line_width, false);
}

ImVec4 pen_colour(int index) {
    // Okabe and Ito's yellow, sky blue, vermillion and green; and white. They are drawn on a picture, so they
    // do not depend on the theme.
    static const ImVec4 colours[pen_colour_count] = {{0.94f, 0.89f, 0.26f, 1},
                                                     {0.34f, 0.71f, 0.91f, 1},
                                                     {0.84f, 0.37f, 0, 1},
                                                     {0, 0.62f, 0.45f, 1},
                                                     {1, 1, 1, 1}};
    return colours[index];
}

}  // namespace

const Tool pen_tool{.hover = pen_hover, .press = pen_press, .drag = pen_drag};

void draw_pen(ImDrawList& list, const PenState& pen, const PictureView& view) {
    for (const PenLine& line : pen.lines) {
        const ImU32 colour = to_u32(pen_colour(line.colour));
        if (line.places.size() == 1)
            rimmed_disc(list, to_window(line.places[0], view), 0.75f * line_width, colour);
        for (std::size_t first = 0; first + 1 < line.places.size(); first += drawn_at_once - 1)
            draw_piece(list, std::span(line.places).subspan(first), colour, view);
    }
}

void pen_bar(PenState& pen, const Rect& picture) {
    if (!pen.on) return;
    ImGui::SetNextWindowPos(picture.top() + ImVec2(0, px(8)), ImGuiCond_Always, {0.5f, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    ImGui::Begin("##pen", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    const float size = ImGui::GetFrameHeight();
    for (int i = 0; i < pen_colour_count; ++i) {
        ImGui::PushID(i);
        if (hit_area("##colour", {size, size})) pen.colour = i;
        const ImVec2 middle = last_item().middle();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddCircleFilled(middle, size * 0.32f, to_u32(pen_colour(i)));
        list.AddCircle(middle, size * 0.32f, to_u32(theme().dim_text), 0,
                       px(1));  // so that white is visible on white
        if (pen.colour == i) list.AddCircle(middle, size * 0.45f, to_u32(theme().text), 0, px(1.5f));
        tooltip("Pen", "Draws in this colour over the picture");
        ImGui::PopID();
        ImGui::SameLine(0, px(2));
    }
    ImGui::SameLine(0, px(10));
    ImGui::BeginDisabled(pen.lines.empty());
    if (icon_button("##back", Icon::Undo)) pen.lines.pop_back();
    tooltip("Last stroke", "Undoes the last stroke");
    ImGui::SameLine(0, px(4));
    if (ImGui::Button("Wipe")) pen.lines.clear();
    tooltip("Wipe", "Erases all strokes", "", keys_of(CommandId::WipePen));
    ImGui::EndDisabled();
    ImGui::SameLine(0, px(4));
    if (icon_button("##away", Icon::Close)) pen.on = false;
    tooltip("Put the pen away", "The strokes stay until they are erased", "",
            keys_of(CommandId::Pen) + ", Esc");
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace glint
