#pragma once
// Moves, rotates and scales an object with the mouse: the position of its gizmo, the part under the cursor,
// and the transform after a drag. Pure functions; M = T Rz Ry Rx S (models/scene/scene.h).

#include <imgui.h>

#include <array>
#include <glm/mat3x3.hpp>
#include <optional>

#include "models/scene/scene.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/screen.h"

namespace glint {

enum class GizmoMode { None, Move, Rotate, Scale };

/// X, Y, Z: an axis. PlaneX, PlaneY, PlaneZ: the plane perpendicular to it. Free: move in the view plane,
/// turn about the line of sight, or scale all axes equally.
enum class GizmoPart { X, Y, Z, PlaneX, PlaneY, PlaneZ, Free };

/// The gizmo in world coordinates.
struct ObjectGizmo {
    glm::dvec3 origin{0};              // the gizmo's position, which is the centre of rotation and scaling
    glm::dvec3 anchor{0};              // the same point in object coordinates
    std::array<glm::dvec3, 3> axes{};  // unit vectors: the world's axes or, for Scale, the object's own
    double length = 1;                 // length of an axis; constant on the screen
    glm::dvec3 to_eye{0, 0, 1};        // unit vector from the origin
};

/// Returns the rotation that is part of the transform.
[[nodiscard]] glm::dmat3 rotation_of(const Transform& transform);

/// Returns the point of an object at which its gizmo is drawn, in object coordinates: its origin, or the
/// centre of its bounds if the origin is outside them, or is outside the picture and the centre is not.
[[nodiscard]] glm::dvec3 gizmo_anchor(const Object& object, const PictureView& view);

/// The position of a gizmo. `pivot`: the centre of rotation for Rotate in world coordinates, in place of the
/// anchor; other modes ignore it. gizmo_of() returns nullopt for None, or if the gizmo would not be in front
/// of the eye.
struct GizmoPlace {
    glm::dvec3 anchor{0};  // object coordinates
    std::optional<glm::dvec3> pivot = {};
};
[[nodiscard]] std::optional<ObjectGizmo> gizmo_of(const Transform& transform, GizmoMode mode,
                                                  const PictureView& view, const GizmoPlace& place = {});

/// Returns the part under the cursor, which is in pixels of the picture: Free first, then axes, then planes.
/// For Rotate, Free is last.
[[nodiscard]] std::optional<GizmoPart> gizmo_under(const ObjectGizmo& gizmo, GizmoMode mode,
                                                   const PictureView& view, glm::dvec2 cursor_px);

struct ObjectDrag {
    Transform start;
    ObjectGizmo gizmo;  // the gizmo at the start of the drag
    GizmoMode mode = GizmoMode::Move;
    GizmoPart part = GizmoPart::Free;
    glm::dvec2 grabbed_px{0};
};

/// Returns the transform after the cursor has moved to `cursor_px`. `snap`: rounds positions to multiples of
/// the view's step, rotations to multiples of 15 degrees and scales to tenths. Returns the initial transform
/// if the motion has no solution (an axis seen end-on, a plane seen edge-on). Scales never reach 0. The gizmo
/// of a rotated or scaled object stays in place: if the gizmo is not at the object's origin, the object moves
/// too.
[[nodiscard]] Transform dragged_object(const ObjectDrag& drag, const DragView& view, glm::dvec2 cursor_px,
                                       bool snap);

/// Returns angles x, y, z in degrees with Rz Ry Rx = `rotation`; of several solutions, the nearest to
/// `near_deg`. At y = +-90 degrees, where x and z turn about the same axis, x is that of `near_deg`.
[[nodiscard]] glm::vec3 euler_deg(const glm::dmat3& rotation, glm::vec3 near_deg);

/// The small squares between two axes that move an object in a plane: where they begin and end, as fractions
/// of the axes' length.
inline constexpr double plane_from = 0.28, plane_to = 0.46;

// The gizmo of the selected object: arrows, rings or boxes, each axis in its colour with its letter.

/// `in_hand`: the part under the cursor or being dragged.
void draw_object_gizmo(ImDrawList& list, const PictureView& view, const ObjectGizmo& gizmo, GizmoMode mode,
                       std::optional<GizmoPart> in_hand);

}  // namespace glint
