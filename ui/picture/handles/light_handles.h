#pragma once
// Draws lights in the picture, and defines their draggable parts and the effect of a drag. A handle has the
// light's own colour, shows its kind, and is on a stem so that its depth can be judged.

#include <imgui.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "ui/picture/handles/drag_math.h"
#include "ui/picture/handles/light_place.h"
#include "ui/picture/screen.h"
#include "ui/widgets/area.h"

namespace glint {

struct SurfaceView;

/// Two lines for the note at the cursor.
struct HandNote {
    std::string title, numbers;
};

struct Handle {
    int light = 0;
    glm::dvec3 place{0};  // world
    ProjectedPoint at;
    bool in_picture = false;  // else `at.pixel` is on the picture's border, in the direction of the light
};

/// Returns the handles of the scene's lights, in order: of the first 300, more than can be distinguished, and
/// of `selected` (-1: none).
[[nodiscard]] std::vector<Handle> light_handles(const Scene& scene, const PictureView& view, int selected);

/// The nearest handle under the cursor (in the picture's pixels), or null.
[[nodiscard]] const Handle* handle_under(const std::vector<Handle>& handles, glm::dvec2 cursor_px,
                                         const PictureView& view);

/// The state in which a handle is drawn.
struct HandleLook {
    bool selected = false, hovered = false;
    bool hidden = false;   // behind an object
    bool stem = true;      // down to the ground; among many lights only the active one has it
    bool matters = false;  // it contributes most of the light under the cursor
    std::optional<glm::dvec3> shape_in_hand;  // the part of its shape being hovered or dragged, world
};
void draw_handle(ImDrawList& list, const PictureView& view, const Light& light, const Handle& handle,
                 HandleLook look);

/// The disc of a light, with a dark rim: a ring when it is off. `radius`: logical pixels.
void draw_light_disc(ImDrawList& list, ImVec2 at, float radius, const Light& light, ImU32 colour,
                     float opacity);

/// A note next to the cursor: a title and lines of figures. It stays inside the picture and, if there is
/// room, clear of `clear`, the part of the window where the effect of the drag is visible.
void draw_note(ImDrawList& list, ImVec2 at, const HandNote& note, const std::optional<Rect>& clear);

// A light has a shape in addition to its position: a spot's cone, a panel's rectangle. These pure functions
// compute its position in the world, its draggable parts, and the effect of a drag.

/// The part of a cone that is drawn, world coordinates.
struct ConeShape {
    glm::dvec3 place{0}, axis{0, -1, 0}, u{1, 0, 0}, v{0, 0, 1};  // unit, perpendicular
    double slant = 1;                                             // from the apex to the rim
    double angle = 0;                                             // from the axis to the rim, radians
    double inner = 4;  // to the soft edge; none if not below `angle`

    /// A point of the circle at `from_axis`, and its middle; radians, `azimuth` from u to v.
    [[nodiscard]] glm::dvec3 ring(double azimuth, double from_axis) const;
    [[nodiscard]] glm::dvec3 middle(double from_axis) const {
        return place + slant * std::cos(from_axis) * axis;
    }
    [[nodiscard]] glm::dvec3 rim(double azimuth) const { return ring(azimuth, angle); }
    [[nodiscard]] bool is_soft() const { return inner < angle; }
    [[nodiscard]] glm::dvec3 tip() const { return place + slant * axis; }  // where the aim is grabbed
};
/// Nothing for a light without a cone (another kind, or a cutoff of 180 degrees).
[[nodiscard]] std::optional<ConeShape> cone_of(const Light& light, const Dome& dome, const ScreenMap& map);

/// A panel, world coordinates: half-edges, and the end of the stick that turns it.
struct PanelShape {
    glm::dvec3 place{0}, u{1, 0, 0}, v{0, 0, 1};

    /// `at`: -1 to 1 along both edges.
    [[nodiscard]] glm::dvec3 point(glm::dvec2 at) const { return place + at.x * u + at.y * v; }
    [[nodiscard]] glm::dvec3 normal() const;
    [[nodiscard]] glm::dvec3 tip() const;
};
[[nodiscard]] std::optional<PanelShape> panel_of(const Light& light, const ScreenMap& map);

/// The parts of a shape that can be dragged. A panel's corners and edges are identified by their position on
/// it.
enum class ShapePart { Rim, Inner, Aim, Corner, Edge };

struct ShapeGrip {
    ShapePart part = ShapePart::Aim;
    double azimuth = 0;   // where a rim or the inner circle was grabbed
    glm::dvec2 at{0};     // position of a corner or an edge: (-1, 1), (0, 1), ...
    glm::dvec3 place{0};  // world
    bool operator==(const ShapeGrip&) const = default;
};

/// The current position of a grip, in world coordinates.
[[nodiscard]] glm::dvec3 place_of(const ShapeGrip& grip, const Light& light, const Dome& dome,
                                  const ScreenMap& map);

/// Returns the marks to draw: aim, four rim points and two of the soft edge for a cone; aim, corners and
/// edges for a panel.
[[nodiscard]] std::vector<ShapeGrip> shape_grips(const Light& light, const Dome& dome, const ScreenMap& map);

/// The grip under the cursor (pixels of the picture); a cone's circles can be grabbed all round.
[[nodiscard]] std::optional<ShapeGrip> shape_under(const Light& light, const PictureView& view,
                                                   glm::dvec2 cursor_px);

struct ShapeDrag {
    Light start;
    ShapeGrip grip;
    glm::dvec2 grabbed_px{0};
    // An aim turns freely on its sphere, or points at a target at this depth in front of the camera (0: the
    // grip's depth).
    bool free = false;
    std::optional<glm::dvec3> aimed = {};  // world
    double depth = 0;
};

/// The light after the cursor moved to `cursor_px`. The aim stays under the cursor; the rim opens and closes
/// towards it; a corner or an edge of a panel follows it, while the centre stays. `snap`: cutoff to multiples
/// of 5 degrees, half-edges to the view's step, an aim like a directional light's.
[[nodiscard]] Light dragged_shape(const ShapeDrag& drag, const DragView& view, glm::dvec2 cursor_px,
                                  bool snap);

/// Returns the light turned to shine at a point of the world; unchanged if it is at that point. `snap`:
/// turned to the nearest direction that a directional light snaps to.
[[nodiscard]] Light aimed_at(const Light& light, glm::dvec3 place, const DragView& view, bool snap = false);

// A drag of a light by its handle, which stays under the cursor as exactly as float can represent the
// position. Pure functions.

/// What a light moves along. ViewPlane: parallel to the picture. Depth: along the line of sight, away when
/// the cursor goes up (a directional light turns round the picture's axes instead, past the rim of its dome).
/// X, Y, Z: along an axis of the light's own coordinates (a directional light turns round it).
enum class DragAlong { ViewPlane, Depth, X, Y, Z };

/// The state of a drag since it began, or since it last changed what it moves along.
struct LightDrag {
    Light start;
    DragAlong along = DragAlong::ViewPlane;
    glm::dvec2 grabbed_px{0};  // the cursor at that moment; its offset from the handle is kept
};

/// The light after the cursor moved to `cursor_px`. `snap`: coordinates to multiples of the view's step,
/// angles of a direction to multiples of 15 degrees. If the motion has no solution (along an axis that is
/// seen end-on, behind the eye), the initial light.
[[nodiscard]] Light dragged(const LightDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap);

/// A step of 1, 2 or 5 times a power of ten, near a twentieth of the scene's size.
[[nodiscard]] double snap_step_for(const Bounds& bounds);

// A drag of a light by its terminator, the line on a surface where n.l = 0: the light moves, as little as
// possible, into the tangent plane under the cursor.

struct TerminatorDrag {
    Light start;
};

/// Whether the light's terminator passes within `reach` pixels of `pixel`.
[[nodiscard]] bool terminator_under(const SurfaceView& view, const Light& light, glm::dvec2 pixel,
                                    double reach);

/// Returns the light with its terminator through `pixel`: a position drops onto the tangent plane, a
/// direction is turned into it. Nothing on the background, or if the light is straight above the pixel.
[[nodiscard]] std::optional<Light> dragged_terminator(const TerminatorDrag& drag, const SurfaceView& view,
                                                      glm::dvec2 pixel);

}  // namespace glint
