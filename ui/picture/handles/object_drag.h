#pragma once
// An object is moved, rotated and scaled by hand: where its gizmo is, what of it is under the cursor, and
// what a drag makes of the transform. Pure functions; M = T Rz Ry Rx S (models/scene/transform.h).

#include <imgui.h>

#include <array>
#include <glm/mat3x3.hpp>
#include <optional>

#include "models/scene/scene.h"
#include "ui/picture/handles/drag_math.h"
#include "ui/picture/screen.h"

namespace glint {

enum class GizmoMode { None, Move, Rotate, Scale };

/// X, Y, Z: an axis. PlaneX, PlaneY, PlaneZ: the plane at right angles to it. Free: moves in the view plane,
/// turns round the line of sight, scales all axes alike.
enum class GizmoPart { X, Y, Z, PlaneX, PlaneY, PlaneZ, Free };

/// Where the gizmo stands, world coordinates.
struct ObjectGizmo {
    glm::dvec3 origin{0};              // where it stands: what it turns and scales the object about
    glm::dvec3 anchor{0};              // the same as a place of the object, object coordinates
    std::array<glm::dvec3, 3> axes{};  // unit: the world's, or (Scale) the object's own
    double length = 1;                 // of an axis: the same on the screen wherever the object is
    glm::dvec3 to_eye{0, 0, 1};        // unit, from the origin
};

/// Its rotation alone.
[[nodiscard]] glm::dmat3 rotation_of(const Transform& transform);

/// The place of an object on which its gizmo stands, object coordinates: its origin, or the middle of its
/// bounds where the origin lies outside of them, or outside of the picture while the middle is in it.
[[nodiscard]] glm::dvec3 gizmo_anchor(const Object& object, const PictureView& view);

/// Where a gizmo stands. `pivot`: what Rotate turns about, world coordinates, in place of the anchor; other
/// modes ignore it. gizmo_of() returns nothing under None, or if the gizmo would not be in front of the eye.
struct GizmoPlace {
    glm::dvec3 anchor{0};  // object coordinates
    std::optional<glm::dvec3> pivot = {};
};
[[nodiscard]] std::optional<ObjectGizmo> gizmo_of(const Transform& transform, GizmoMode mode,
                                                  const PictureView& view, const GizmoPlace& place = {});

/// Returns the part under the cursor (pixels of the picture), Free before axes before planes (Rotate: last).
[[nodiscard]] std::optional<GizmoPart> gizmo_under(const ObjectGizmo& gizmo, GizmoMode mode,
                                                   const PictureView& view, glm::dvec2 cursor_px);

struct ObjectDrag {
    Transform start;
    ObjectGizmo gizmo;  // as it was then
    GizmoMode mode = GizmoMode::Move;
    GizmoPart part = GizmoPart::Free;
    glm::dvec2 grabbed_px{0};
};

/// The transform after the cursor went to `cursor_px`. `snap`: places to multiples of the view's step,
/// turns to multiples of 15 degrees, scales to tenths. Where the motion has no answer (an axis seen end on,
/// a plane edge on) it is what the drag began with. Scales stay away from 0. A turned or scaled object keeps
/// the gizmo's place where it is: where that is not its origin, it is moved along.
[[nodiscard]] Transform dragged_object(const ObjectDrag& drag, const DragView& view, glm::dvec2 cursor_px,
                                       bool snap);

/// Returns angles x, y, z in degrees with Rz Ry Rx = `rotation`; of several solutions, the nearest to
/// `near_deg`. At y = +-90 degrees, where x and z turn round the same axis, x is that of `near_deg`.
[[nodiscard]] glm::vec3 euler_deg(const glm::dmat3& rotation, glm::vec3 near_deg);

/// The small squares between two axes by which an object is moved in a plane: from this to this share of the
/// axes' length.
inline constexpr double plane_from = 0.28, plane_to = 0.46;

// The gizmo of the selected object: arrows, rings or boxes, each axis in its colour with its letter.

/// `in_hand`: the part that is under the cursor or being dragged.
void draw_object_gizmo(ImDrawList& list, const PictureView& view, const ObjectGizmo& gizmo, GizmoMode mode,
                       std::optional<GizmoPart> in_hand);

}  // namespace glint
