#pragma once
// Finds what the cursor can grab in the picture, and edits the scene during a drag. Lists all kinds of grips;
// pure functions in the neighbouring files define each drag.

#include <array>
#include <string>
#include <variant>

#include "renderer/renderer.h"
#include "ui/document/scene_edit.h"
#include "ui/picture/handles/highlight_drag.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/object_drag.h"

namespace glint {

/// The scene and the view that one frame of the viewport works on.
struct ViewportFrame {
    Scene& scene;
    Selection& selection;
    const Renderer* renderer = nullptr;  // the renderer of the last picture; null before the first one
    PictureView view;
    GizmoMode gizmo = GizmoMode::Move;  // gizmo of the selected object
    std::optional<glm::dvec3>
        pivot{};  // the pivot of Rotate, in world coordinates; default: the gizmo's anchor
};

/// Modifier keys pressed during a drag.
struct HandKeys {
    bool shift = false, ctrl = false, alt = false;
    std::array<bool, 3> axis{};  // X, Y, Z
};

enum class GripKind { None, Light, Shape, Object, Highlight, HighlightRim, Terminator };

/// Something that can be dragged.
struct Grip {
    GripKind kind = GripKind::None;
    int item = -1;                     // index of the light or, under Object, of the object
    bool in_picture = true;            // false: an arrow at the picture's border points to it
    ShapeGrip shape = {};              // under Shape: a light's cone or rectangle
    GizmoPart part = GizmoPart::Free;  // under Object, with
    GizmoMode mode = GizmoMode::None;
    bool operator==(const Grip&) const = default;

    explicit operator bool() const { return kind != GripKind::None; }
    /// Whether it is a mark drawn on the picture, which consumes clicks. Clicks elsewhere pick a pixel.
    [[nodiscard]] bool is_mark() const {
        return kind == GripKind::Light || kind == GripKind::Shape || kind == GripKind::Object;
    }
};

/// Whether the scene has, or still has, the grip's light or object.
[[nodiscard]] bool exists(const Grip& grip, const Scene& scene);

/// Returns the grip under the cursor, which is in pixels of the picture: marks first, then the selected
/// light's terminator, then highlights, their rims before their centres.
[[nodiscard]] Grip grip_under(const ViewportFrame& frame, glm::dvec2 cursor_px);

/// A grip being dragged. `view` must not change during the drag.
struct Held {
    Grip grip;
    DragView view;
    std::variant<std::monostate, LightDrag, ShapeDrag, ObjectDrag, HighlightDrag, TerminatorDrag, SizeDrag>
        drag;
    bool no_solution = false;  // the drag has no solution at the cursor: the scene does not change
    bool dims = false;         // the drag changes the light's intensity, not its position
};

/// Returns the gizmo of the selected object; nullopt if no object is selected, or it is hidden. While `held`
/// drags the object, the gizmo stays at the point of the object at which it was grabbed.
[[nodiscard]] std::optional<ObjectGizmo> selected_gizmo(const ViewportFrame& frame,
                                                        const Held* held = nullptr);

/// Begins a drag of `grip` at a cursor position. Precondition: the grip exists() in the scene.
[[nodiscard]] Held take_hold(const ViewportFrame& frame, Grip grip, glm::dvec2 cursor_px,
                             const HandKeys& keys);

/// Edits the scene for the cursor's new position; `last_px` is the previous one.
void drag_held(Held& held, ViewportFrame& frame, glm::dvec2 cursor_px, glm::dvec2 last_px,
               const HandKeys& keys);

/// Returns what a drag would do, or does, for the status line.
[[nodiscard]] std::string hint_of(const Grip& grip, const Scene& scene);
[[nodiscard]] std::string hint_of(const Held& held);

/// Returns the text of the note at the cursor.
[[nodiscard]] HandNote note_of(const Grip& grip, const Scene& scene);
[[nodiscard]] HandNote note_of(const Held& held, const Scene& scene);
/// Returns the note "Bulb DONE, world coordinates" with the light's position.
[[nodiscard]] HandNote note_of(const Light& light, const std::string& done);

}  // namespace glint
