// Lambert's cosine: the beam that spreads over more surface the more it slants, and the curve with its clamp.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "renderer/inspect/reflectance/lobes.h"
#include "ui/inspector/equation/parts.h"
#include "ui/plots/plot.h"
#include "ui/plots/plots_tab.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float beam_units = 40;  // width of the beam, of the design

/// A beam that meets a surface: points of the window.
struct Beam {
    ImVec2 foot, to_light, across;  // its middle on the surface; unit, y down
};

Beam beam_at(const Rect& room, double deg) {
    const auto angle = static_cast<float>(glm::radians(deg));
    return {{room.low.x + 0.56f * room.size().x, room.high.y - px(26)},
            {-std::sin(angle), -std::cos(angle)},
            {std::cos(angle), -std::sin(angle)}};
}

ImVec2 plus(ImVec2 a, ImVec2 b, float times) { return {a.x + times * b.x, a.y + times * b.y}; }

/// Both rims of the beam run on until they meet the surface, which is level.
void draw_beam(ImDrawList& list, const Rect& room, double deg) {
    const Beam beam = beam_at(room, deg);
    const float half = px(beam_units) / 2, far = room.size().x + room.size().y;
    const float foot = half / -beam.to_light.y;  // half of d / cos
    const ImVec2 left{beam.foot.x - foot, beam.foot.y}, right{beam.foot.x + foot, beam.foot.y};
    const ImU32 light = to_u32(theme()[Symbol::L]);
    list.AddQuadFilled(left, right, plus(right, beam.to_light, far), plus(left, beam.to_light, far),
                       to_u32(theme()[Symbol::L], 0.22f));
    list.AddLine(left, plus(left, beam.to_light, far), light, px(1.2f));
    list.AddLine(right, plus(right, beam.to_light, far), light, px(1.2f));
    // The beam's width, at right angles to it, a little above the surface.
    const ImVec2 middle = plus(beam.foot, beam.to_light, px(54));
    list.AddLine(plus(middle, beam.across, -half), plus(middle, beam.across, half), light, px(2));
    plot_text(list, plus(middle, beam.to_light, px(9)), theme().text, "d", true);
    list.AddLine(left, right, to_u32(theme()[Symbol::Diffuse]), px(4));
    plot_text(list, {beam.foot.x, beam.foot.y + px(13)}, theme()[Symbol::Diffuse],
              fmt::format("d / cos θ = {:.2f} d", 1 / std::cos(glm::radians(deg))), true);
}

void draw_surface(ImDrawList& list, const Rect& room, double deg) {
    const Beam beam = beam_at(room, deg);
    list.AddRectFilled({room.low.x, beam.foot.y}, room.high, to_u32(theme().field));
    list.AddLine({room.low.x, beam.foot.y}, {room.high.x, beam.foot.y}, to_u32(theme().text), px(1.2f));
    const ImVec2 top{beam.foot.x, room.low.y + px(14)};
    list.AddLine(beam.foot, top, to_u32(theme()[Symbol::N]), px(1.4f));
    plot_text(list, {top.x + px(5), top.y - px(6)}, theme()[Symbol::N], "n");
}

void beam_drawing(double deg) {
    const Rect room = plot_room(120);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(room.low, room.high, to_u32(theme().window));
    list.PushClipRect(room.low, room.high, true);
    draw_surface(list, room, deg);
    if (deg < 90) draw_beam(list, room, deg);
    list.PopClipRect();
    list.AddRect(room.low, room.high, to_u32(theme().line));
}

/// What a white matt surface reflects of a light at this angle: the equation's own diffuse term.
double diffuse_at(double light_deg) {
    Reflector white;
    white.reflection = Reflection::Lambert;
    white.material.diffuse = glm::vec3(1);
    return double(reflected(white, in_plane(-light_deg), {0, 0, 1}).diffuse.x);
}

void cosine_curve(double deg) {
    std::vector<glm::dvec2> curve;
    for (int at = 0; at <= 180; at += 2) curve.emplace_back(at, diffuse_at(at));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotArea area = draw_axes(list, plot_room(96), {0, 180}, {0, 1.1},
                                    {"θ between n and l", "degrees", true, 45}, {"", ""});
    draw_upright(list, area, 90, theme().dim_text);
    draw_curve(list, area, curve, theme()[Symbol::Diffuse]);
    const double here = diffuse_at(deg);
    draw_mark(list, area, {deg, here}, theme()[Symbol::Diffuse], fmt::format("{:.3f}", here));
}

}  // namespace

void cosine_section(PlotsState& plots, const PlotSubject& subject) {
    section_heading("Lambert's cosine: a slanting beam spreads");
    const bool picked = subject.point.light != nullptr;
    if (picked) plots.beam_deg = static_cast<float>(local_directions(subject.point).light_deg);
    ImGui::BeginDisabled(picked);
    (void)number_field(
        "Light", plots.beam_deg,
        {.range = half_turn_deg, .unit = "degrees", .step = 0.25f, .format = "%.1f", .usual_max = 180}, 50,
        {"Between n and l: that of the picked point where one is picked", ""});
    ImGui::EndDisabled();
    const auto deg = double(plots.beam_deg);
    beam_drawing(deg);
    if (deg >= 90) warning_text("From 90° on the light is behind the surface: nothing arrives.");
    cosine_curve(deg);
    small_dim("max(n·l, 0): what arrives, as a share of what arrives head on. The same seen from anywhere.");
}

}  // namespace glint
