#include "ui/picture/handles/hand.h"

#include <cmath>

#include "ui/widgets/theme.h"

namespace glint {
namespace {

constexpr float line_reach = 4;  // of a terminator, of a highlight's rim: logical pixels

/// The surfaces of the last picture, which must exist.
SurfaceView surface_of(const ViewportFrame& frame) {
    return {frame.scene, *frame.renderer, frame.view.map, frame.view.dome};
}

Light& light_of(const ViewportFrame& frame, const Grip& grip) {
    return frame.scene.lights[static_cast<std::size_t>(grip.item)];
}

DragAlong drag_along(const HandKeys& keys) {
    if (keys.axis[0]) return DragAlong::X;
    if (keys.axis[1]) return DragAlong::Y;
    if (keys.axis[2]) return DragAlong::Z;
    return keys.shift ? DragAlong::Depth : DragAlong::ViewPlane;
}

bool has_terminator_under(const ViewportFrame& frame, int light, glm::dvec2 cursor_px) {
    if (light < 0 || !frame.scene.shading.terms.diffuse) return false;
    const Light& selected = frame.scene.lights[static_cast<std::size_t>(light)];
    return selected.enabled &&
           terminator_under(surface_of(frame), selected, cursor_px, frame.view.pixels(line_reach));
}

void drag_light(LightDrag& drag, const Held& held, const ViewportFrame& frame, glm::dvec2 cursor_px,
                glm::dvec2 last_px, const HandKeys& keys) {
    Light& light = light_of(frame, held.grip);
    // When a modifier key changes, the drag restarts from here, so that nothing jumps.
    if (const DragAlong along = drag_along(keys); along != drag.along) drag = {light, along, last_px};
    light = dragged(drag, held.view, cursor_px, keys.ctrl);
}

/// Aims at the surface point under the cursor; over the background, at the depth of the last aim.
Light aimed(ShapeDrag& drag, const Held& held, const ViewportFrame& frame, glm::dvec2 cursor_px, bool snap) {
    const ScreenMap& map = held.view.map;
    if (frame.renderer != nullptr)
        if (const auto point = seen_at(*frame.renderer, map.size, cursor_px))
            drag.depth = -double(point->position.z);
    if (drag.depth <= 0) drag.depth = project(map, drag.grip.place).depth;
    drag.aimed = unproject(map, cursor_px, drag.depth);
    return aimed_at(drag.start, *drag.aimed, held.view, snap);
}

void drag_shape(ShapeDrag& drag, const Held& held, const ViewportFrame& frame, glm::dvec2 cursor_px,
                glm::dvec2 last_px, const HandKeys& keys) {
    Light& light = light_of(frame, held.grip);
    const bool is_aim = drag.grip.part == ShapePart::Aim;
    if (is_aim && keys.shift != drag.free) {  // a key changed: restart the drag, so that nothing jumps
        drag.start = light;
        drag.grip.place = place_of(drag.grip, light, held.view.dome, held.view.map);
        drag.grabbed_px = last_px;
        drag.free = keys.shift;
    }
    drag.aimed.reset();
    light = is_aim && !drag.free ? aimed(drag, held, frame, cursor_px, keys.ctrl)
                                 : dragged_shape(drag, held.view, cursor_px, keys.ctrl);
}

/// Changes the intensity: upwards is brighter. The light keeps its position, and a highlight too: the drag
/// restarts from here.
void dim_light(Held& held, const ViewportFrame& frame, glm::dvec2 cursor_px, glm::dvec2 last_px) {
    Light& light = light_of(frame, held.grip);
    light.intensity = dimmed(light.intensity, last_px.y - cursor_px.y, held.view.map.size.height);
    if (auto* by_handle = std::get_if<LightDrag>(&held.drag))
        *by_handle = {light, by_handle->along, cursor_px};
    if (auto* line = std::get_if<TerminatorDrag>(&held.drag)) line->start = light;
    if (auto* by_highlight = std::get_if<HighlightDrag>(&held.drag)) {
        by_highlight->start.intensity = light.intensity;
        if (!by_highlight->stays_at) by_highlight->beside -= cursor_px - last_px;
    }
}

bool can_dim(GripKind kind) {
    return kind == GripKind::Light || kind == GripKind::Highlight || kind == GripKind::Terminator;
}

/// Changes the highlight's size, which is part of the material.
void drag_size(const SizeDrag& drag, Held& held, const ViewportFrame& frame, glm::dvec2 cursor_px) {
    const auto material = sized_highlight(drag, surface_of(frame), cursor_px);
    held.no_solution = !material;
    if (material) frame.scene.objects[static_cast<std::size_t>(drag.object)].material = *material;
}

/// Moves the light so that its effect appears at the cursor.
void drag_on_surface(Held& held, const ViewportFrame& frame, glm::dvec2 cursor_px, glm::dvec2 last_px,
                     bool in_depth) {
    std::optional<Light> light;
    if (auto* drag = std::get_if<HighlightDrag>(&held.drag))
        light = moved_highlight(*drag, surface_of(frame), cursor_px, last_px, in_depth);
    else if (const auto* line = std::get_if<TerminatorDrag>(&held.drag))
        light = dragged_terminator(*line, surface_of(frame), cursor_px);
    held.no_solution = !light;
    if (light) light_of(frame, held.grip) = *light;
}

/// A pressed axis key takes precedence over the grabbed part.
void drag_object(ObjectDrag drag, Held& held, const ViewportFrame& frame, glm::dvec2 cursor_px,
                 const HandKeys& keys) {
    for (std::size_t i = 0; i < 3; ++i)
        if (keys.axis[i] && drag.mode != GizmoMode::Scale) drag.part = static_cast<GizmoPart>(i);
    held.grip.part = drag.part;  // the part that is highlighted and named
    frame.scene.objects[static_cast<std::size_t>(held.grip.item)].transform =
        dragged_object(drag, held.view, cursor_px, keys.ctrl);
}

std::optional<Grip> object_grip_under(const ViewportFrame& frame, glm::dvec2 cursor_px) {
    const auto gizmo = selected_gizmo(frame);
    if (!gizmo) return {};
    const auto part = gizmo_under(*gizmo, frame.gizmo, frame.view, cursor_px);
    if (!part) return {};
    return Grip{.kind = GripKind::Object, .item = frame.selection.index, .part = *part, .mode = frame.gizmo};
}

std::optional<Grip> shape_grip_under(const ViewportFrame& frame, int light, glm::dvec2 cursor_px) {
    if (light < 0) return {};
    const auto shape =
        shape_under(frame.scene.lights[static_cast<std::size_t>(light)], frame.view, cursor_px);
    if (!shape) return {};
    return Grip{.kind = GripKind::Shape, .item = light, .shape = *shape};
}

}  // namespace

std::optional<ObjectGizmo> selected_gizmo(const ViewportFrame& frame, const Held* held) {
    if (frame.selection.kind != Selection::Kind::Object) return {};
    const auto index = static_cast<std::size_t>(frame.selection.index);
    if (index >= frame.scene.objects.size() || !frame.scene.objects[index].visible) return {};
    const Object& object = frame.scene.objects[index];
    const auto* drag = held != nullptr ? std::get_if<ObjectDrag>(&held->drag) : nullptr;
    const glm::dvec3 anchor = drag != nullptr ? drag->gizmo.anchor : gizmo_anchor(object, frame.view);
    return gizmo_of(object.transform, frame.gizmo, frame.view, {anchor, frame.pivot});
}

bool exists(const Grip& grip, const Scene& scene) {
    const std::size_t count = grip.kind == GripKind::Object ? scene.objects.size() : scene.lights.size();
    return grip && static_cast<std::size_t>(grip.item) < count;
}

Grip grip_under(const ViewportFrame& frame, glm::dvec2 cursor_px) {
    const int selected = selected_light(frame.selection);
    if (const auto object = object_grip_under(frame, cursor_px)) return *object;
    const std::vector<Handle> handles = light_handles(frame.scene, frame.view, selected);
    if (const Handle* handle = handle_under(handles, cursor_px, frame.view))
        return {.kind = GripKind::Light, .item = handle->light, .in_picture = handle->in_picture};
    if (const auto shape = shape_grip_under(frame, selected, cursor_px)) return *shape;
    if (frame.renderer == nullptr) return {};
    if (has_terminator_under(frame, selected, cursor_px))
        return {.kind = GripKind::Terminator, .item = selected};
    if (const auto rim = highlight_rim_under(surface_of(frame), cursor_px, frame.view.pixels(line_reach)))
        return {.kind = GripKind::HighlightRim, .item = *rim};
    if (const auto highlight = highlight_under(surface_of(frame), cursor_px))
        return {.kind = GripKind::Highlight, .item = highlight->light};
    return {};
}

Held take_hold(const ViewportFrame& frame, Grip grip, glm::dvec2 cursor_px, const HandKeys& keys) {
    Held held{.grip = grip,
              .view = {frame.view.map, frame.view.dome, snap_step_for(frame.view.bounds)},
              .drag = {}};
    switch (grip.kind) {
    case GripKind::None:
        break;
    case GripKind::Light:
        held.drag = LightDrag{light_of(frame, grip), drag_along(keys), cursor_px};
        break;
    case GripKind::Shape:
        held.drag = ShapeDrag{light_of(frame, grip), grip.shape, cursor_px};
        break;
    case GripKind::Object: {
        const Transform& start = frame.scene.objects[static_cast<std::size_t>(grip.item)].transform;
        if (const auto gizmo = selected_gizmo(frame))
            held.drag = ObjectDrag{start, *gizmo, frame.gizmo, grip.part, cursor_px};
        break;
    }
    case GripKind::Highlight:
        if (frame.renderer == nullptr) break;
        if (const auto drag = grab_highlight(surface_of(frame), light_of(frame, grip), cursor_px))
            held.drag = *drag;
        break;
    case GripKind::HighlightRim:
        if (frame.renderer == nullptr) break;
        if (const auto point = seen_at(*frame.renderer, frame.view.map.size, cursor_px))
            held.drag = SizeDrag{light_of(frame, grip), point->object,
                                 frame.scene.objects[static_cast<std::size_t>(point->object)].material};
        break;
    case GripKind::Terminator:
        held.drag = TerminatorDrag{light_of(frame, grip)};
        break;
    }
    return held;
}

void drag_held(Held& held, ViewportFrame& frame, glm::dvec2 cursor_px, glm::dvec2 last_px,
               const HandKeys& keys) {
    held.dims = keys.shift && keys.ctrl && can_dim(held.grip.kind);
    if (held.dims) return dim_light(held, frame, cursor_px, last_px);
    if (auto* drag = std::get_if<LightDrag>(&held.drag))
        return drag_light(*drag, held, frame, cursor_px, last_px, keys);
    if (const auto* drag = std::get_if<ObjectDrag>(&held.drag))
        return drag_object(*drag, held, frame, cursor_px, keys);
    if (auto* drag = std::get_if<ShapeDrag>(&held.drag))
        return drag_shape(*drag, held, frame, cursor_px, last_px, keys);
    if (frame.renderer == nullptr) return;
    if (const auto* drag = std::get_if<SizeDrag>(&held.drag)) return drag_size(*drag, held, frame, cursor_px);
    drag_on_surface(held, frame, cursor_px, last_px, keys.shift);
}

}  // namespace glint
