// Words that tell a hand what it can do and does, in the status line and beside the cursor.
#include <fmt/core.h>

#include <glm/geometric.hpp>

#include "models/scene/reflection.h"
#include "ui/picture/handles/hand.h"

namespace glint {
namespace {

const Light& light_of(const Grip& grip, const Scene& scene) {
    return scene.lights[static_cast<std::size_t>(grip.item)];
}

const Object& object_of(const Grip& grip, const Scene& scene) {
    return scene.objects[static_cast<std::size_t>(grip.item)];
}

const char* shape_words(ShapePart part) {
    switch (part) {
    case ShapePart::Rim:
        return "Open or close the cone";
    case ShapePart::Aim:
        return "Aim";
    case ShapePart::Corner:
        return "Size of the panel";
    case ShapePart::Edge:
        return "Edge of the panel";
    }
    return "";  // not reached
}

const char* part_words(GizmoPart part) {
    constexpr const char* words[] = {"X", "Y", "Z", "Y and Z", "Z and X", "X and Y", "freely"};
    return words[static_cast<int>(part)];
}

/// Says what dragging a part of the gizmo does: "Move along X".
std::string action_text(GizmoMode mode, GizmoPart part) {
    const bool free = part == GizmoPart::Free;
    switch (mode) {
    case GizmoMode::None:
        return {};
    case GizmoMode::Move:
        return free ? "Move in the view plane" : fmt::format("Move along {}", part_words(part));
    case GizmoMode::Rotate:
        return free ? "Rotate round the line of sight" : fmt::format("Rotate round {}", part_words(part));
    case GizmoMode::Scale:
        return free ? "Scale as a whole" : fmt::format("Scale along its own {}", part_words(part));
    }
    return {};  // not reached
}

std::string three_numbers(glm::vec3 v) { return fmt::format("{:7.2f} {:7.2f} {:7.2f}", v.x, v.y, v.z); }

const char* along_words(DragAlong along, bool turns) {
    switch (along) {
    case DragAlong::ViewPlane:
        return turns ? "on its dome" : "in the view plane";
    case DragAlong::Depth:
        return turns ? "past the rim" : "in depth";
    case DragAlong::X:
        return turns ? "round X" : "along X";
    case DragAlong::Y:
        return turns ? "round Y" : "along Y";
    case DragAlong::Z:
        return turns ? "round Z" : "along Z";
    }
    return "";  // not reached
}

/// Says how the light that is held moves.
std::string motion_words(const Held& held) {
    switch (held.grip.kind) {
    case GripKind::None:
    case GripKind::Shape:
    case GripKind::Object:
        return {};
    case GripKind::Light: {
        const auto& drag = std::get<LightDrag>(held.drag);
        return along_words(drag.along, drag.start.kind == LightKind::Directional);
    }
    case GripKind::Highlight:
        return held.no_solution ? "cannot shine there" : "by its highlight";
    case GripKind::HighlightRim:
        return {};
    case GripKind::Terminator:
        return held.no_solution ? "cannot end there" : "by its terminator, n·l = 0";
    }
    return {};  // not reached
}

HandNote shape_note(const Light& light, ShapePart part) {
    switch (part) {
    case ShapePart::Rim:
        return {fmt::format("{}: cutoff, from the axis to the edge", light.name),
                fmt::format("{:5.1f}°", light.spot.cutoff_deg)};
    case ShapePart::Aim:
        if (light.kind == LightKind::Area) return {fmt::format("{} turned", light.name), ""};
        return {fmt::format("{} aimed", light.name), three_numbers(light.spot.direction)};
    case ShapePart::Corner:
    case ShapePart::Edge:
        return {
            fmt::format("{}, half-edges", light.name),
            fmt::format("{:.2f} × {:.2f}", glm::length(light.area.edge_u), glm::length(light.area.edge_v))};
    }
    return {};  // not reached
}

/// The number of the material that says how wide a highlight is.
const char* width_words(Reflection reflection) {
    return info_of(reflection).uses_shininess() ? "the shininess" : "the roughness";
}

HandNote size_note(const SizeDrag& drag, const Scene& scene) {
    if (static_cast<std::size_t>(drag.object) >= scene.objects.size()) return {};
    const Object& object = scene.objects[static_cast<std::size_t>(drag.object)];
    const bool power = info_of(scene.shading.reflection).uses_shininess();
    return {fmt::format("{} of {}", power ? "Shininess" : "Roughness", object.name),
            power ? fmt::format("{:.1f}", object.material.shininess)
                  : fmt::format("{:.3f}", object.material.roughness)};
}

HandNote object_note(const ObjectDrag& drag, const Transform& t, const std::string& title) {
    switch (drag.mode) {
    case GizmoMode::None:
    case GizmoMode::Move:
        return {title, three_numbers(t.translate)};
    case GizmoMode::Rotate:
        return {title + ", x y z",
                fmt::format("{:7.1f}° {:7.1f}° {:7.1f}°", t.rotate_deg.x, t.rotate_deg.y, t.rotate_deg.z)};
    case GizmoMode::Scale:
        return {title, three_numbers(t.scale)};
    }
    return {};  // not reached
}

}  // namespace

std::string hint_of(const Grip& grip, const Scene& scene) {
    switch (grip.kind) {
    case GripKind::None:
        return {};
    case GripKind::Light:
        if (!grip.in_picture)
            return fmt::format("{}, outside the picture · Click: select", light_of(grip, scene).name);
        return fmt::format(
            "{}: drag in the view plane · Shift: in depth · X Y Z: axis · Ctrl: snap · Ctrl+Shift: "
            "brightness",
            light_of(grip, scene).name);
    case GripKind::Shape:
        if (grip.shape.part == ShapePart::Aim)
            return fmt::format("{}: aim at what is under the cursor · Ctrl: snap · Shift: turn freely",
                               light_of(grip, scene).name);
        return fmt::format("{}: {} · Ctrl: snap", light_of(grip, scene).name, shape_words(grip.shape.part));
    case GripKind::Object:
        return fmt::format("{}{} · Ctrl: snap · G R T: move, rotate, scale",
                           action_text(grip.mode, grip.part),
                           grip.mode == GizmoMode::Scale ? "" : " · X Y Z: axis");
    case GripKind::Highlight:
        return fmt::format(
            "Drag the highlight of {} · Shift: in depth · Ctrl+Shift: brightness · Click: why · Alt+drag: "
            "orbit",
            light_of(grip, scene).name);
    case GripKind::HighlightRim:
        return fmt::format(
            "Drag the rim of {}'s highlight, where it is half: {} follows · Click: why · Alt+drag: orbit",
            light_of(grip, scene).name, width_words(scene.shading.reflection));
    case GripKind::Terminator:
        return fmt::format(
            "Drag the terminator of {}, where n·l = 0 · Ctrl+Shift: brightness · Alt+drag: orbit",
            light_of(grip, scene).name);
    }
    return {};  // not reached
}

std::string hint_of(const Held& held) {
    if (held.dims)
        return "Up: brighter, down: darker; by a factor of e per third of the picture · Esc: cancel";
    switch (held.grip.kind) {
    case GripKind::None:
        return {};
    case GripKind::Light:
        return "Shift: in depth · X Y Z: along an axis · Ctrl: snap · Ctrl+Shift: brightness · Esc: cancel";
    case GripKind::Shape:
        return held.grip.shape.part == ShapePart::Aim
                   ? "It shines at what is under the cursor · Ctrl: snap · Shift: turn freely · Esc: cancel"
                   : "Ctrl: snap · Esc: cancel";
    case GripKind::Object:
        return held.grip.mode == GizmoMode::Scale
                   ? "Ctrl: snap · Esc: cancel"
                   : "X Y Z: along or round an axis · Ctrl: snap · Esc: cancel";
    case GripKind::Highlight:
        return held.no_solution
                   ? "No light can have its highlight there: the light stays as it is · Esc: cancel"
                   : "The light stands where v is mirrored at n · Shift: in depth · Ctrl+Shift: "
                     "brightness · Esc: cancel";
    case GripKind::HighlightRim:
        return held.no_solution ? "No highlight there: the material stays as it is · Esc: cancel"
                                : "The highlight is half of its peak under the cursor · Esc: cancel";
    case GripKind::Terminator:
        return held.no_solution ? "No surface there: the light stays as it is · Esc: cancel"
                                : "The light lies in the plane that touches the surface here · Esc: cancel";
    }
    return {};  // not reached
}

HandNote note_of(const Grip& grip, const Scene& scene) {
    if (!grip) return {};
    const std::string& name =
        grip.kind == GripKind::Object ? object_of(grip, scene).name : light_of(grip, scene).name;
    switch (grip.kind) {
    case GripKind::None:
        break;
    case GripKind::Light:
        if (!grip.in_picture) return {"Outside the picture", name};
        return {light_of(grip, scene).enabled ? "Drag to move" : "Off; drag to move", name};
    case GripKind::Shape:
        return {shape_words(grip.shape.part), name};
    case GripKind::Object:
        return {action_text(grip.mode, grip.part), name};
    case GripKind::Highlight:
        return {"Drag the highlight", name};
    case GripKind::HighlightRim:
        return {"Size of the highlight", name};
    case GripKind::Terminator:
        return {"Drag the terminator", name};
    }
    return {};  // not reached
}

HandNote note_of(const Held& held, const Scene& scene) {
    if (!exists(held.grip, scene) || held.drag.index() == 0) return {};
    if (const auto* drag = std::get_if<ObjectDrag>(&held.drag))
        return object_note(*drag, object_of(held.grip, scene).transform,
                           action_text(held.grip.mode, held.grip.part));
    const Light& light = light_of(held.grip, scene);
    if (held.dims) return {fmt::format("{}, intensity", light.name), fmt::format("{:.3f}", light.intensity)};
    if (held.grip.kind == GripKind::Shape) return shape_note(light, held.grip.shape.part);
    if (const auto* drag = std::get_if<SizeDrag>(&held.drag)) return size_note(*drag, scene);
    return note_of(light, motion_words(held));
}

HandNote note_of(const Light& light, const std::string& done) {
    const char* space = light.space == LightSpace::World ? "world" : "camera";
    return {fmt::format("{} {}, {} coordinates", light.name, done, space), three_numbers(light.position)};
}

}  // namespace glint
