// Texts about a grip, for the status line and the note at the cursor.
#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <iterator>

#include "models/scene/reflection.h"
#include "renderer/explain/printed_number.h"
#include "ui/picture/handles/hand.h"

namespace glint {
namespace {

/// {0} is the light's name, {1} the material property that sets a highlight's width.
struct GripText {
    const char* hover;       // status line
    const char* note;        // at the cursor
    const char* drag;        // status line
    const char* impossible;  // status line if the drag has no solution
};

constexpr const char* cancel = " · Esc: cancel";

constexpr GripText grip_texts[] = {
    {"", "", "", ""},
    {"{0}: drag in the view plane · Shift: in depth · X Y Z: axis · Ctrl: snap · Ctrl+Shift: brightness",
     "Drag to move", "Shift: in depth · X Y Z: along an axis · Ctrl: snap · Ctrl+Shift: brightness", ""},
    {"", "", "Ctrl: snap", ""},
    {"", "", "X Y Z: along or round an axis · Ctrl: snap", ""},
    {"Drag the highlight of {0} · Shift: in depth · Ctrl+Shift: brightness · Click: why · Alt+drag: orbit",
     "Drag the highlight",
     "The light is in the direction of v mirrored at n · Shift: in depth · Ctrl+Shift: brightness",
     "No light can have its highlight there: the light stays as it is"},
    {"Drag the rim of {0}'s highlight, where it is half: {1} follows · Click: why · Alt+drag: orbit",
     "Size of the highlight", "The highlight is half of its peak under the cursor",
     "No highlight there: the material stays as it is"},
    {"Drag the terminator of {0}, where n·l = 0 · Ctrl+Shift: brightness · Alt+drag: orbit",
     "Drag the terminator", "The light is in the tangent plane at this point",
     "No surface there: the light stays as it is"},
};
static_assert(std::size(grip_texts) == static_cast<int>(GripKind::Terminator) + 1);

const GripText& text_of(GripKind kind) { return grip_texts[static_cast<int>(kind)]; }

const Light& light_of(const Grip& grip, const Scene& scene) {
    return scene.lights[static_cast<std::size_t>(grip.item)];
}

const Object& object_of(const Grip& grip, const Scene& scene) {
    return scene.objects[static_cast<std::size_t>(grip.item)];
}

const char* text_of(ShapePart part) {
    constexpr const char* texts[] = {"Open or close the cone", "Where the soft edge begins", "Aim",
                                     "Size of the panel", "Edge of the panel"};
    return texts[static_cast<int>(part)];
}

/// Describes the effect of dragging a part of the gizmo: "Move along X".
std::string text_of(GizmoMode mode, GizmoPart part) {
    constexpr const char* free[] = {"", "Move in the view plane", "Rotate round the line of sight",
                                    "Scale uniformly"};
    constexpr const char* along[] = {"", "Move along", "Rotate round", "Scale along its own"};
    constexpr const char* parts[] = {"X", "Y", "Z", "Y and Z", "Z and X", "X and Y"};
    const int row = static_cast<int>(mode);
    if (part == GizmoPart::Free || mode == GizmoMode::None) return free[row];
    return fmt::format("{} {}", along[row], parts[static_cast<int>(part)]);
}

std::string three_numbers(glm::vec3 v, int decimals = 2, const char* unit = "") {
    const auto text = [&](float x) { return fmt::format("{:>7}{}", fixed_text(double(x), decimals), unit); };
    return fmt::format("{} {} {}", text(v.x), text(v.y), text(v.z));
}

/// Describes the motion of the dragged light.
std::string motion_text(const Held& held) {
    if (const auto* drag = std::get_if<LightDrag>(&held.drag)) {
        constexpr const char* moves[] = {"in the view plane", "in depth", "along X", "along Y", "along Z"};
        constexpr const char* turns[] = {"on its dome", "past the rim", "round X", "round Y", "round Z"};
        const auto along = static_cast<int>(drag->along);
        return (drag->start.kind == LightKind::Directional ? turns : moves)[along];
    }
    if (held.grip.kind == GripKind::Highlight)
        return held.no_solution ? "cannot shine there" : "by its highlight";
    return held.no_solution ? "cannot end there" : "by its terminator, n·l = 0";
}

HandNote shape_note(const Light& light, ShapePart part) {
    if (part == ShapePart::Rim)
        return {fmt::format("{}: cutoff, from the axis to the edge", light.name),
                fmt::format("{:5.1f}°", light.spot.cutoff_deg)};
    if (part == ShapePart::Inner)
        return {fmt::format("{}: inner, from the axis to the soft edge", light.name),
                fmt::format("{:5.1f}°", light.spot.inner_deg)};
    if (part != ShapePart::Aim)
        return {
            fmt::format("{}, half-edges", light.name),
            fmt::format("{:.2f} × {:.2f}", glm::length(light.area.edge_u), glm::length(light.area.edge_v))};
    if (light.kind == LightKind::Area) return {fmt::format("{} turned", light.name), ""};
    return {fmt::format("{} aimed", light.name), three_numbers(light.spot.direction)};
}

HandNote size_note(const SizeDrag& drag, const Scene& scene) {
    if (static_cast<std::size_t>(drag.object) >= scene.objects.size()) return {};
    const Object& object = scene.objects[static_cast<std::size_t>(drag.object)];
    if (info_of(scene.shading.reflection).uses_shininess())
        return {"Shininess of " + object.name, fmt::format("{:.1f}", object.material.shininess)};
    return {"Roughness of " + object.name, fmt::format("{:.3f}", object.material.roughness)};
}

HandNote object_note(GizmoMode mode, const Transform& t, const std::string& title) {
    if (mode == GizmoMode::Rotate) return {title + ", x y z", three_numbers(t.rotate_deg, 1, "°")};
    return {title, three_numbers(mode == GizmoMode::Scale ? t.scale : t.translate)};
}

}  // namespace

std::string hint_of(const Grip& grip, const Scene& scene) {
    if (!grip) return {};
    if (grip.kind == GripKind::Object)
        return fmt::format("{}{} · Ctrl: snap · G R T: move, rotate, scale", text_of(grip.mode, grip.part),
                           grip.mode == GizmoMode::Scale ? "" : " · X Y Z: axis");
    const std::string& name = light_of(grip, scene).name;
    if (!grip.in_picture) return name + ", outside the picture · Click: select";
    if (grip.kind == GripKind::Shape && grip.shape.part == ShapePart::Aim)
        return name + ": aim at the point under the cursor · Ctrl: snap · Shift: turn freely";
    if (grip.kind == GripKind::Shape)
        return fmt::format("{}: {} · Ctrl: snap", name, text_of(grip.shape.part));
    const bool power = info_of(scene.shading.reflection).uses_shininess();
    return fmt::format(fmt::runtime(text_of(grip.kind).hover), name,
                       power ? "the shininess" : "the roughness");
}

std::string hint_of(const Held& held) {
    if (held.dims)
        return "Up: brighter, down: darker; by a factor of e per third of the picture · Esc: cancel";
    const Grip& grip = held.grip;
    if (!grip) return {};
    if (grip.kind == GripKind::Shape && grip.shape.part == ShapePart::Aim)
        return "It shines at the point under the cursor · Ctrl: snap · Shift: turn freely · Esc: cancel";
    if (grip.kind == GripKind::Object && grip.mode == GizmoMode::Scale) return "Ctrl: snap · Esc: cancel";
    const GripText& text = text_of(grip.kind);
    return (held.no_solution ? text.impossible : text.drag) + std::string(cancel);
}

HandNote note_of(const Grip& grip, const Scene& scene) {
    if (!grip) return {};
    if (grip.kind == GripKind::Object) return {text_of(grip.mode, grip.part), object_of(grip, scene).name};
    const Light& light = light_of(grip, scene);
    if (!grip.in_picture) return {"Outside the picture", light.name};
    if (grip.kind == GripKind::Shape) return {text_of(grip.shape.part), light.name};
    if (grip.kind == GripKind::Light && !light.enabled) return {"Off; drag to move", light.name};
    return {text_of(grip.kind).note, light.name};
}

HandNote note_of(const Held& held, const Scene& scene) {
    const Grip& grip = held.grip;
    if (!exists(grip, scene) || held.drag.index() == 0) return {};
    if (const auto* drag = std::get_if<ObjectDrag>(&held.drag))
        return object_note(drag->mode, object_of(grip, scene).transform, text_of(grip.mode, grip.part));
    const Light& light = light_of(grip, scene);
    if (held.dims)
        return {fmt::format("{}, intensity", light.name), significant_text(double(light.intensity), 3)};
    if (grip.kind == GripKind::Shape) return shape_note(light, grip.shape.part);
    if (const auto* drag = std::get_if<SizeDrag>(&held.drag)) return size_note(*drag, scene);
    return note_of(light, motion_text(held));
}

HandNote note_of(const Light& light, const std::string& done) {
    const char* space = light.space == LightSpace::World ? "world" : "camera";
    return {fmt::format("{} {}, {} coordinates", light.name, done, space), three_numbers(light.position)};
}

}  // namespace glint
