#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "ui/picture/handles/drag_math.h"
#include "ui/picture/handles/object_drag.h"
#include "ui/picture/world_pen.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

const std::array axis_colours{ImVec4{0.93f, 0.42f, 0.35f, 1}, ImVec4{0.52f, 0.78f, 0.35f, 1},
                              ImVec4{0.42f, 0.65f, 1.0f, 1}};
constexpr const char* letters[] = {"X", "Y", "Z"};
const ImVec4 white{1, 1, 1, 1};

struct GizmoPen {
    WorldPen pen;
    const ObjectGizmo& gizmo;
    std::optional<GizmoPart> in_hand;

    [[nodiscard]] ImU32 colour(std::size_t axis, GizmoPart part) const {
        return to_u32(in_hand == part ? white : axis_colours[axis]);
    }
    [[nodiscard]] ImVec2 shown(glm::dvec3 place) const {
        return pen.view.to_window(project(pen.view.map, place).pixel);
    }
    void thick(glm::dvec3 a, glm::dvec3 b, ImU32 c, bool held) const {
        pen.line(a, b, to_u32({0, 0, 0, 1}, 0.5f), px(4.5f));
        pen.line(a, b, c, px(held ? 3 : 2.2f));
    }
    void letter(std::size_t axis, glm::dvec3 at) const {
        const ImVec2 p = shown(at);
        const ImFont* type = fonts().small;
        const float size = type->FontSize * ImGui::GetIO().FontGlobalScale;
        const ImVec2 half{0.3f * size, 0.5f * size};
        for (const ImVec2 aside : {ImVec2{1, 1}, ImVec2{-1, 1}, ImVec2{1, -1}, ImVec2{-1, -1}})
            pen.list.AddText(type, size, {p.x - half.x + aside.x, p.y - half.y + aside.y},
                             to_u32({0, 0, 0, 1}, 0.6f), letters[axis]);
        pen.list.AddText(type, size, {p.x - half.x, p.y - half.y}, to_u32(axis_colours[axis]), letters[axis]);
    }
    void head(std::size_t axis, GizmoMode mode) const {
        const auto part = static_cast<GizmoPart>(axis);
        const glm::dvec3 end = gizmo.origin + gizmo.length * gizmo.axes[axis];
        const ImVec2 tip = shown(end), from = shown(gizmo.origin);
        const float dx = tip.x - from.x, dy = tip.y - from.y, length = std::hypot(dx, dy);
        if (mode == GizmoMode::Scale || length < px(6)) {
            const float r = px(4.5f);
            pen.list.AddRectFilled({tip.x - r - 1, tip.y - r - 1}, {tip.x + r + 1, tip.y + r + 1},
                                   to_u32({0, 0, 0, 1}, 0.6f));
            pen.list.AddRectFilled({tip.x - r, tip.y - r}, {tip.x + r, tip.y + r}, colour(axis, part));
            return;
        }
        const ImVec2 way{dx / length, dy / length}, side{-way.y, way.x};
        const float l = px(13), w = px(5);
        pen.list.AddTriangleFilled(
            {tip.x + way.x * l * 0.5f, tip.y + way.y * l * 0.5f},
            {tip.x - way.x * l * 0.5f + side.x * w, tip.y - way.y * l * 0.5f + side.y * w},
            {tip.x - way.x * l * 0.5f - side.x * w, tip.y - way.y * l * 0.5f - side.y * w},
            colour(axis, part));
    }
    void axis(std::size_t i, GizmoMode mode) const {
        const auto part = static_cast<GizmoPart>(i);
        const glm::dvec3 way = gizmo.length * gizmo.axes[i];
        thick(gizmo.origin + 0.14 * way, gizmo.origin + way, colour(i, part), in_hand == part);
        head(i, mode);
        letter(i, gizmo.origin + 1.22 * way);
    }
    void plane(std::size_t i) const {
        const auto part = static_cast<GizmoPart>(i + 3);
        const glm::dvec3 a = gizmo.length * gizmo.axes[(i + 1) % 3],
                         b = gizmo.length * gizmo.axes[(i + 2) % 3];
        if (std::abs(glm::dot(gizmo.axes[i], gizmo.to_eye)) < 0.12) return;  // edge on
        const ImVec2 corners[] = {shown(gizmo.origin + plane_from * a + plane_from * b),
                                  shown(gizmo.origin + plane_to * a + plane_from * b),
                                  shown(gizmo.origin + plane_to * a + plane_to * b),
                                  shown(gizmo.origin + plane_from * a + plane_to * b)};
        const ImVec4 tint = in_hand == part ? white : axis_colours[i];
        pen.list.AddConvexPolyFilled(corners, 4, to_u32(tint, 0.45f));
        pen.list.AddPolyline(corners, 4, to_u32(tint), ImDrawFlags_Closed, px(1.2f));
    }
    /// The half turned away is thin.
    void ring(glm::dvec3 axis, double radius, ImU32 c, bool held, bool whole) const {
        const auto [u, v] = across(axis);
        constexpr int sides = 64;
        const auto out = [&, u = u, v = v](int k) {
            const double angle = 2 * 3.14159265358979 * k / sides;
            return std::cos(angle) * u + std::sin(angle) * v;
        };
        for (int i = 0; i < sides; ++i) {
            const glm::dvec3 a = gizmo.origin + radius * out(i), b = gizmo.origin + radius * out(i + 1);
            if (whole || glm::dot(out(i), gizmo.to_eye) > -0.05)
                thick(a, b, c, held);
            else
                pen.line(a, b, (c & 0x00FFFFFFu) | 0x60000000u, px(1));
        }
    }
};

}  // namespace

void draw_object_gizmo(ImDrawList& list, const PictureView& view, const ObjectGizmo& gizmo, GizmoMode mode,
                       std::optional<GizmoPart> in_hand) {
    const GizmoPen pen{{list, view}, gizmo, in_hand};
    if (mode == GizmoMode::Rotate) {
        const bool free = in_hand == GizmoPart::Free;
        pen.ring(gizmo.to_eye, 1.18 * gizmo.length, to_u32(white, free ? 1.0f : 0.55f), free, true);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto part = static_cast<GizmoPart>(i);
            pen.ring(gizmo.axes[i], gizmo.length, pen.colour(i, part), in_hand == part, false);
        }
        return;
    }
    if (mode == GizmoMode::Move)
        for (std::size_t i = 0; i < 3; ++i) pen.plane(i);
    for (std::size_t i = 0; i < 3; ++i) pen.axis(i, mode);
    const ImVec2 middle = pen.shown(gizmo.origin);
    list.AddCircleFilled(middle, px(7), to_u32({0, 0, 0, 1}, 0.5f));
    list.AddCircle(middle, px(6), to_u32(white, in_hand == GizmoPart::Free ? 1.0f : 0.8f), 0,
                   px(in_hand == GizmoPart::Free ? 3 : 2));
}

}  // namespace glint
