#include "ui/picture/handles/hand.h"

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "models/scene/reflection.h"
#include "renderer/explain/equation_text.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

constexpr float line_reach = 4;  // distance to a terminator or a highlight's rim, in logical pixels

/// Returns the surfaces of the last picture, which must exist.
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
    // When a modifier key changes, the drag restarts here, so that nothing jumps.
    if (const DragAlong along = drag_along(keys); along != drag.along) drag = {light, along, last_px};
    light = dragged(drag, held.view, cursor_px, keys.ctrl);
}

/// Aims at the surface point under the cursor; over the background, at a point at the depth of the last aim.
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
    if (is_aim && keys.shift != drag.free) {  // a key has changed: restart the drag, so that nothing jumps
        drag.start = light;
        drag.grip.place = place_of(drag.grip, light, held.view.dome, held.view.map);
        drag.grabbed_px = last_px;
        drag.free = keys.shift;
    }
    drag.aimed.reset();
    light = is_aim && !drag.free ? aimed(drag, held, frame, cursor_px, keys.ctrl)
                                 : dragged_shape(drag, held.view, cursor_px, keys.ctrl);
}

/// Changes the intensity: dragging up makes the light brighter. The light and its highlight do not move; a
/// later drag restarts here.
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

// Texts that describe a grip, for the status line and the note at the cursor.

namespace {

/// {0} is the light's name, {1} the material property that sets a highlight's width.
struct GripText {
    const char* hover;       // status line
    const char* note;        // note at the cursor
    const char* drag;        // status line
    const char* impossible;  // in the status line if the drag has no solution
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
     "The light is in the direction of v mirrored about n · Shift: in depth · Ctrl+Shift: brightness",
     "No light can have its highlight there: the light does not move"},
    {"Drag the rim of {0}'s highlight, at half its peak: {1} follows · Click: why · Alt+drag: orbit",
     "Size of the highlight", "Under the cursor, the highlight has half its peak value",
     "No highlight there: the material does not change"},
    {"Drag the terminator of {0}, where n·l = 0 · Ctrl+Shift: brightness · Alt+drag: orbit",
     "Drag the terminator", "The light is in the tangent plane at this point",
     "No surface there: the light does not move"},
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
    constexpr const char* texts[] = {"Open or close the cone", "Start of the soft edge", "Aim",
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
    if (info_of(reflection_of(object.material, scene.shading.reflection)).uses_shininess())
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
    const auto by_shininess = [&scene](const Object& o) {
        return info_of(reflection_of(o.material, scene.shading.reflection)).uses_shininess();
    };
    const bool all = std::ranges::all_of(scene.objects, by_shininess);
    const bool none = std::ranges::none_of(scene.objects, by_shininess);
    return fmt::format(fmt::runtime(text_of(grip.kind).hover), name,
                       all    ? "the shininess"
                       : none ? "the roughness"
                              : "the shininess or roughness");
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
