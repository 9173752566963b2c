#pragma once
// Finds what the cursor can take hold of in the picture, and edits the scene while that is dragged. This is
// the closed list of grips; pure functions in the files beside say how each is dragged.

#include <array>
#include <string>
#include <variant>

#include "renderer/renderer.h"
#include "ui/document/scene_edit.h"
#include "ui/picture/handles/highlight_drag.h"
#include "ui/picture/handles/highlight_size.h"
#include "ui/picture/handles/light_effects.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/object_drag.h"

namespace glint {

/// The scene and the view that one frame of the viewport works on.
struct ViewportFrame {
    Scene& scene;
    Selection& selection;
    const Renderer* renderer = nullptr;  // of the last picture; null before the first
    PictureView view;
    GizmoMode gizmo = GizmoMode::Move;  // of the selected object
    std::optional<glm::dvec3> pivot{};  // what Rotate turns it about, world coordinates; else its anchor
};

/// The keys that the other hand holds.
struct HandKeys {
    bool shift = false, ctrl = false, alt = false;
    std::array<bool, 3> axis{};  // X, Y, Z
};

enum class GripKind { None, Light, Shape, Object, Highlight, HighlightRim, Terminator };

/// Something that can be dragged.
struct Grip {
    GripKind kind = GripKind::None;
    int item = -1;                     // number of the light, or (Object) of the object
    bool in_picture = true;            // else its place is outside and an arrow at the border points to it
    ShapeGrip shape = {};              // under Shape: a light's cone or rectangle
    GizmoPart part = GizmoPart::Free;  // under Object, with
    GizmoMode mode = GizmoMode::None;
    bool operator==(const Grip&) const = default;

    explicit operator bool() const { return kind != GripKind::None; }
    /// A mark drawn on the picture, which takes clicks for itself; a click on the surface asks why.
    [[nodiscard]] bool is_mark() const {
        return kind == GripKind::Light || kind == GripKind::Shape || kind == GripKind::Object;
    }
};

/// Whether the scene (still) has the light or object that the grip belongs to.
[[nodiscard]] bool exists(const Grip& grip, const Scene& scene);

/// The grip that the cursor (pixels of the picture) is over: marks first, then the selected light's
/// terminator, then highlights, their rims before their middles.
[[nodiscard]] Grip grip_under(const ViewportFrame& frame, glm::dvec2 cursor_px);

/// A grip in hand. `view` must not change while it is held.
struct Held {
    Grip grip;
    DragView view;
    std::variant<std::monostate, LightDrag, ShapeDrag, ObjectDrag, HighlightDrag, TerminatorDrag, SizeDrag>
        drag;
    bool no_solution = false;  // the cursor is where the drag has no answer: the scene waits as it is
    bool dims = false;         // the hand changes how bright the light is, and it stays where it is
};

/// Returns the gizmo of the selected object; nothing if no object is selected or it is not shown. While
/// `held` drags the object, the gizmo stays at the point of the object at which it was taken hold of.
[[nodiscard]] std::optional<ObjectGizmo> selected_gizmo(const ViewportFrame& frame,
                                                        const Held* held = nullptr);

/// Takes hold of `grip` at a place of the cursor. Precondition: the grip exists in the scene.
[[nodiscard]] Held take_hold(const ViewportFrame& frame, Grip grip, glm::dvec2 cursor_px,
                             const HandKeys& keys);

/// Edits the scene to where the cursor went; `last_px` is where it was before.
void drag_held(Held& held, ViewportFrame& frame, glm::dvec2 cursor_px, glm::dvec2 last_px,
               const HandKeys& keys);

/// Says for the status line what a drag would do, or does.
[[nodiscard]] std::string hint_of(const Grip& grip, const Scene& scene);
[[nodiscard]] std::string hint_of(const Held& held);

/// Returns what the note at the hand says.
[[nodiscard]] HandNote note_of(const Grip& grip, const Scene& scene);
[[nodiscard]] HandNote note_of(const Held& held, const Scene& scene);
/// "Bulb DONE, world coordinates", and where it is.
[[nodiscard]] HandNote note_of(const Light& light, const std::string& done);

}  // namespace glint
