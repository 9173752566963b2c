// What a hand is told: in the status line and beside the cursor.
#include <fmt/core.h>

#include "ui/hands/hand.h"

namespace glint {
namespace {

const Light& light_of(const Grip& grip, const Scene& scene) {
    return scene.lights[static_cast<std::size_t>(grip.item)];
}

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

std::string motion_words(const Held& held) {
    const bool turns = held.grip.kind == GripKind::Light &&
                       std::get<LightDrag>(held.drag).start.kind == LightKind::Directional;
    switch (held.grip.kind) {
    case GripKind::None:
        return {};
    case GripKind::Light:
        return along_words(std::get<LightDrag>(held.drag).along, turns);
    case GripKind::Highlight:
        return held.astray ? "cannot shine there" : "by its highlight";
    case GripKind::Terminator:
        return held.astray ? "cannot end there" : "by its terminator, n·l = 0";
    }
    return {};  // not reached
}

}  // namespace

std::string hint_of(const Grip& grip, const Scene& scene) {
    switch (grip.kind) {
    case GripKind::None:
        return {};
    case GripKind::Light:
        return fmt::format("{}: drag in the view plane · Shift: in depth · X Y Z: axis · Ctrl: snap",
                           light_of(grip, scene).name);
    case GripKind::Highlight:
        return fmt::format("Drag the highlight of {} · Click: why this colour · Alt+drag: orbit",
                           light_of(grip, scene).name);
    case GripKind::Terminator:
        return fmt::format("Drag the terminator of {}, where n·l = 0 · Alt+drag: orbit",
                           light_of(grip, scene).name);
    }
    return {};  // not reached
}

std::string hint_of(const Held& held) {
    switch (held.grip.kind) {
    case GripKind::None:
        return {};
    case GripKind::Light:
        return "Shift: in depth · X Y Z: along an axis · Ctrl: snap · Esc: cancel";
    case GripKind::Highlight:
        return held.astray ? "No light could shine there: the light waits · Esc: cancel"
                           : "The light stands where v is mirrored at n, as far away as before · Esc: cancel";
    case GripKind::Terminator:
        return held.astray ? "No surface there: the light waits · Esc: cancel"
                           : "The light lies in the plane that touches the surface here · Esc: cancel";
    }
    return {};  // not reached
}

HandNote note_of(const Grip& grip, const Scene& scene) {
    const Light& light = light_of(grip, scene);
    switch (grip.kind) {
    case GripKind::None:
        return {};
    case GripKind::Light:
        if (!grip.in_picture) return {"Outside the picture", light.name};
        return {light.enabled ? "Drag to move" : "Off; drag to move", light.name};
    case GripKind::Highlight:
        return {"Drag the highlight", light.name};
    case GripKind::Terminator:
        return {"Drag the terminator", light.name};
    }
    return {};  // not reached
}

HandNote note_of(const Held& held, const Scene& scene) {
    const Light& light = light_of(held.grip, scene);
    const glm::vec4 p = light.position;
    return {fmt::format("{} {}, {} coordinates", light.name, motion_words(held),
                        light.space == LightSpace::World ? "world" : "camera"),
            fmt::format("{:7.2f} {:7.2f} {:7.2f}", p.x, p.y, p.z)};
}

}  // namespace glint
