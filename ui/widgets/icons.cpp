#include "ui/widgets/icons.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Draws in a square with edges of length 2 round the origin, which is placed at a position and scaled.
struct Pen {
    ImDrawList& list;
    ImVec2 centre;
    float unit, width;
    ImU32 colour;

    [[nodiscard]] ImVec2 at(float x, float y) const { return {centre.x + x * unit, centre.y + y * unit}; }
    void line(float x0, float y0, float x1, float y1) const {
        list.AddLine(at(x0, y0), at(x1, y1), colour, width);
    }
    void ring(float x, float y, float r) const { list.AddCircle(at(x, y), r * unit, colour, 0, width); }
    void disc(float x, float y, float r) const { list.AddCircleFilled(at(x, y), r * unit, colour); }
    void arc(float x, float y, float r, float from, float to) const {
        list.PathArcTo(at(x, y), r * unit, from, to);
        list.PathStroke(colour, 0, width);
    }
    void box(float x0, float y0, float x1, float y1) const {
        list.AddRect(at(x0, y0), at(x1, y1), colour, 0.2f * unit, 0, width);
    }
};

void draw_bulb(const Pen& pen) {
    pen.disc(0, -0.25f, 0.62f);
    pen.line(-0.3f, 0.58f, 0.3f, 0.58f);
    pen.line(-0.22f, 0.86f, 0.22f, 0.86f);
}

void draw_sun(const Pen& pen) {
    pen.disc(0, 0, 0.42f);
    for (int i = 0; i < 8; ++i) {
        const float a = float(i) * pi / 4, x = std::cos(a), y = std::sin(a);
        pen.line(0.64f * x, 0.64f * y, 0.95f * x, 0.95f * y);
    }
}

void draw_spot(const Pen& pen) {
    pen.list.AddTriangleFilled(pen.at(0, -0.85f), pen.at(0.72f, 0.5f), pen.at(-0.72f, 0.5f), pen.colour);
    pen.list.PathArcTo(pen.at(0, 0.5f), 0.72f * pen.unit, 0, pi, 12);
    pen.list.PathFillConvex(pen.colour);
}

void draw_area(const Pen& pen) {
    pen.list.AddQuadFilled(pen.at(-0.45f, -0.6f), pen.at(0.95f, -0.6f), pen.at(0.45f, 0.6f),
                           pen.at(-0.95f, 0.6f), pen.colour);
}

void draw_camera(const Pen& pen) {
    pen.box(-0.95f, -0.5f, 0.3f, 0.55f);
    pen.list.AddTriangleFilled(pen.at(0.38f, 0.02f), pen.at(0.95f, -0.45f), pen.at(0.95f, 0.5f), pen.colour);
}

void draw_object(const Pen& pen) {
    const ImVec2 top = pen.at(0, -0.95f), right = pen.at(0.82f, -0.47f), left = pen.at(-0.82f, -0.47f);
    const ImVec2 middle = pen.at(0, 0), low = pen.at(0, 0.95f);
    const ImVec2 outline[] = {top, right, pen.at(0.82f, 0.47f), low, pen.at(-0.82f, 0.47f), left};
    pen.list.AddPolyline(outline, 6, pen.colour, ImDrawFlags_Closed, pen.width);
    pen.list.AddLine(left, middle, pen.colour, pen.width);
    pen.list.AddLine(right, middle, pen.colour, pen.width);
    pen.list.AddLine(low, middle, pen.colour, pen.width);
}

void draw_shading(const Pen& pen) {  // a ball with one half lit
    pen.ring(0, 0, 0.82f);
    pen.list.PathArcTo(pen.at(0, 0), 0.82f * pen.unit, pi / 2, 3 * pi / 2, 16);
    pen.list.PathFillConvex(pen.colour);
}

void draw_display(const Pen& pen) {
    pen.box(-0.95f, -0.75f, 0.95f, 0.45f);
    pen.line(-0.4f, 0.85f, 0.4f, 0.85f);
    pen.line(0, 0.45f, 0, 0.85f);
}

void draw_eye(const Pen& pen, bool open) {
    if (open) {
        pen.arc(0, 0.62f, 1.1f, pi * 1.19f, pi * 1.81f);
        pen.arc(0, -0.62f, 1.1f, pi * 0.19f, pi * 0.81f);
        pen.disc(0, 0, 0.3f);
    } else {
        pen.arc(0, -0.55f, 1.05f, pi * 0.19f, pi * 0.81f);
        for (const float x : {-0.6f, 0.0f, 0.6f}) pen.line(0.9f * x, 0.38f, 1.1f * x, 0.68f);
    }
}

/// Draws a half circle that ends in an arrow, at its left (undo) or its right (redo).
void draw_turn(const Pen& pen, float way) {
    pen.arc(0, 0.3f, 0.62f, pi, 2 * pi);
    const float x = way * 0.62f;
    pen.list.AddTriangleFilled(pen.at(x - 0.42f, 0.18f), pen.at(x + 0.42f, 0.18f), pen.at(x, 0.78f),
                               pen.colour);
}

void draw_folder(const Pen& pen) {
    pen.list.AddRectFilled(pen.at(-0.85f, -0.6f), pen.at(0, 0), pen.colour, 0.15f * pen.unit);
    pen.list.AddRectFilled(pen.at(-0.85f, -0.4f), pen.at(0.85f, 0.65f), pen.colour, 0.15f * pen.unit);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
    const Pen pen{list, centre, size / 2, std::max(1.0f, size / 12), colour};
    switch (icon) {
    case Icon::Bulb:
        return draw_bulb(pen);
    case Icon::Sun:
        return draw_sun(pen);
    case Icon::Spot:
        return draw_spot(pen);
    case Icon::Area:
        return draw_area(pen);
    case Icon::Camera:
        return draw_camera(pen);
    case Icon::Object:
        return draw_object(pen);
    case Icon::Shading:
        return draw_shading(pen);
    case Icon::Display:
        return draw_display(pen);
    case Icon::Eye:
        return draw_eye(pen, true);
    case Icon::EyeOff:
        return draw_eye(pen, false);
    case Icon::Plus:
        return pen.line(-0.6f, 0, 0.6f, 0), pen.line(0, -0.6f, 0, 0.6f);
    case Icon::Undo:
        return draw_turn(pen, -1);
    case Icon::Redo:
        return draw_turn(pen, 1);
    case Icon::Close:
        return pen.line(-0.5f, -0.5f, 0.5f, 0.5f), pen.line(-0.5f, 0.5f, 0.5f, -0.5f);
    case Icon::More:
        for (const float x : {-0.55f, 0.0f, 0.55f}) pen.disc(x, 0, 0.16f);
        return;
    case Icon::Folder:
        return draw_folder(pen);
    case Icon::File:
        return pen.box(-0.55f, -0.8f, 0.55f, 0.8f);
    case Icon::Up:
        return pen.line(0, 0.7f, 0, -0.6f), pen.line(0, -0.65f, -0.5f, -0.1f),
               pen.line(0, -0.65f, 0.5f, -0.1f);
    }
}

Icon icon_of(LightKind kind) {
    switch (kind) {
    case LightKind::Directional:
        return Icon::Sun;
    case LightKind::Point:
        return Icon::Bulb;
    case LightKind::Spot:
        return Icon::Spot;
    case LightKind::Area:
        return Icon::Area;
    }
    return Icon::Bulb;  // not reached
}

ImVec4 colour_of(const Light& light) {
    const glm::vec3 d = light.diffuse, s = light.specular;
    const glm::vec3 own = d.x + d.y + d.z > 0 ? d : s;
    const float largest = std::max({own.x, own.y, own.z});
    if (!(largest > 0)) return {0.5f, 0.5f, 0.5f, 1};
    return {own.x / largest, own.y / largest, own.z / largest, 1};
}

ImVec4 legible(ImVec4 colour) {
    constexpr double enough = 3;  // contrast of an icon, which is larger than text. Source: WCAG 2.1, 1.4.11
    // The icon is also legible on a selected row of a list, which is darker than the panel.
    constexpr float tint = 0.3f;
    const ImVec4 &panel = theme().panel, &accent = theme().accent;
    const auto mixed = [](float a, float b) { return (1 - tint) * a + tint * b; };
    const ImVec4 chosen{mixed(panel.x, accent.x), mixed(panel.y, accent.y), mixed(panel.z, accent.z), 1};
    while (!theme().dark && contrast(colour, chosen) < enough)
        colour = {0.93f * colour.x, 0.93f * colour.y, 0.93f * colour.z, colour.w};
    return colour;
}

bool icon_button(const char* id, Icon icon, bool on) {
    const float size = ImGui::GetFrameHeight();
    const bool pressed = hit_area(id, {size, size});
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float opacity = ImGui::GetStyle().Alpha;
    const bool hovered = ImGui::IsItemHovered();
    if (on || hovered)
        list.AddRectFilled(low, high, to_u32(on ? theme().accent : theme().field_hovered, opacity),
                           ImGui::GetStyle().FrameRounding);
    const ImVec4& ink = on ? theme().accent_text : hovered ? theme().text : theme().dim_text;
    draw_icon(list, icon, {(low.x + high.x) / 2, (low.y + high.y) / 2}, size * 0.58f, to_u32(ink, opacity));
    return pressed;
}

}  // namespace glint
