#pragma once
// Draws lights in the picture, and defines their draggable parts and the effect of a drag. A handle has the
// light's own colour, shows its kind, and has a stem from which its depth can be judged.

#include <imgui.h>

#include <array>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/screen.h"
#include "ui/widgets/area.h"

namespace glint {

// Maps a cursor position back to a point on a line, a plane, a sphere or a circle, for all drags. All
// positions are in world coordinates.

/// Returns `v` rotated by `angle` (radians, right-handed) about the unit vector `axis`.
[[nodiscard]] glm::dvec3 rotated(glm::dvec3 v, glm::dvec3 axis, double angle);

/// Returns the smallest rotation that takes one unit vector to another; for opposite vectors, any half turn.
[[nodiscard]] glm::dmat4 rotation_between(glm::dvec3 from, glm::dvec3 to);

struct Across {
    glm::dvec3 u, v;  // unit vectors, perpendicular to a direction and to each other
};
[[nodiscard]] Across across(glm::dvec3 direction);

/// Returns the t for which `place` + t `axis` is nearest to the cursor on the screen; 0 if the line is seen
/// end-on, or if the cursor is beyond its vanishing point.
[[nodiscard]] double along_line(const ScreenMap& map, glm::dvec3 place, glm::dvec3 axis,
                                glm::dvec2 cursor_px);

/// Returns the point where the line of sight meets a sphere, on the near half or on the far half; if it
/// misses, the nearest point on the rim.
[[nodiscard]] glm::dvec3 on_dome(const Dome& dome, const Ray& ray, bool nearer);

/// Returns the point where the line of sight through the cursor meets the plane through `place` with unit
/// normal `normal`. nullopt if the plane is within 2 degrees of edge-on, or the point is behind the eye.
[[nodiscard]] std::optional<glm::dvec3> on_plane(const ScreenMap& map, glm::dvec3 place, glm::dvec3 normal,
                                                 glm::dvec2 cursor_px);

/// Returns the angle, -pi to pi, by which rotating centre + radius * `direction` about `axis` moves it
/// closest to the cursor. `direction` and `axis` are unit vectors.
[[nodiscard]] double turn_towards(const ScreenMap& map, const Dome& circle, glm::dvec3 direction,
                                  glm::dvec3 axis, glm::dvec2 cursor_px);

/// Returns the direction with its elevation and its azimuth about y rounded to multiples of 15 degrees.
[[nodiscard]] glm::dvec3 snapped_direction(glm::dvec3 direction);

/// The view in which a drag takes place. It must not change during a drag.
struct DragView {
    ScreenMap map;
    Dome dome;
    double snap_step = 0.25;  // scene units
};

// Computes a light's position in the world, and its numbers after a move or a change of coordinate system. A
// directional light has no position; it is shown on a dome around the scene.

/// Returns the bounding box of all visible objects, in world coordinates; a cube of side 2 at the target if
/// there are none.
[[nodiscard]] Bounds scene_bounds(const Scene& scene);

/// Returns the height of the widest horizontal object, such as a floor; without one, the height of the
/// scene's lowest point.
[[nodiscard]] double ground_height(const Scene& scene);

/// Returns a dome around the camera's target that is small enough to stay inside the view, so that every
/// directional light has a visible handle, and at most twice the scene's size.
[[nodiscard]] Dome sun_dome(glm::vec3 target, const Bounds& bounds, const ScreenMap& map);

/// Returns the position of the light's handle in world coordinates: the light's own, or the one on the dome
/// for a directional light.
[[nodiscard]] glm::dvec3 handle_of(const Light& light, const Dome& dome, const ScreenMap& map);

/// Returns the unit vector from the dome's centre to the handle, in world coordinates.
[[nodiscard]] glm::dvec3 direction_of(const Light& light, const ScreenMap& map);

/// Returns the light with its handle at `place` in the world. A directional light is turned towards `place`;
/// it is unchanged if that is the centre.
[[nodiscard]] Light placed_at(Light light, glm::dvec3 place, const Dome& dome, const ScreenMap& map);

/// Converts a vector (w = 0) or position (w = 1) from the light's own coordinates to the world.
[[nodiscard]] glm::dvec3 to_world(const Light& light, glm::dvec3 own, double w, const ScreenMap& map);

/// The inverse of to_world().
[[nodiscard]] glm::dvec3 to_own(const Light& light, glm::dvec3 world, double w, const ScreenMap& map);

/// Turns a spot's axis or a panel's edges by a rotation of the world.
void turn_shape(Light& light, const glm::dmat4& turn, const ScreenMap& map);

/// Expresses the light in a different coordinate system; its current position, shape and axis do not change.
[[nodiscard]] Light in_space(Light light, LightSpace space, const Camera& camera);

/// Changes the light's kind: a position becomes the direction from the dome's centre, or the reverse.
[[nodiscard]] Light as_kind(Light light, LightKind kind, const Dome& dome, const ScreenMap& map);

struct SurfaceView;

/// The two lines of the note at the cursor.
struct HandNote {
    std::string title, numbers;
};

struct Handle {
    int light = 0;
    glm::dvec3 place{0};  // world
    ProjectedPoint at;
    bool in_picture = false;  // false: `at.pixel` is on the picture's border, in the direction of the light
};

/// Returns the handles of the scene's lights, in order: those of the first 300 lights, which is more than can
/// be distinguished, and that of `selected` (-1: none).
[[nodiscard]] std::vector<Handle> light_handles(const Scene& scene, const PictureView& view, int selected);

/// Returns the nearest handle under the cursor, which is in the picture's pixels, or null.
[[nodiscard]] const Handle* handle_under(const std::vector<Handle>& handles, glm::dvec2 cursor_px,
                                         const PictureView& view);

/// The state in which a handle is drawn.
struct HandleLook {
    bool selected = false, hovered = false;
    bool hidden = false;   // behind an object
    bool stem = true;      // a line down to the ground; of many lights, only the active one has it
    bool matters = false;  // the light contributes more than any other under the cursor
    std::optional<glm::dvec3> shape_in_hand;  // the part of its shape that is hovered or dragged, world
};
void draw_handle(ImDrawList& list, const PictureView& view, const Light& light, const Handle& handle,
                 HandleLook look);

/// Draws the disc of a light with a dark rim, or a ring when the light is off. `radius`: logical pixels.
void draw_light_disc(ImDrawList& list, ImVec2 at, float radius, const Light& light, ImU32 colour,
                     float opacity);

/// Draws a note next to the cursor: a title and lines of figures. It stays inside the picture and, if there
/// is room, outside `clear`, the part of the window where the effect of the drag is visible.
void draw_note(ImDrawList& list, ImVec2 at, const HandNote& note, const std::optional<Rect>& clear);

// A light has a shape in addition to its position: a spot's cone, a panel's rectangle. These pure functions
// compute its position in the world, its draggable parts, and the effect of a drag.

/// The part of a cone that is drawn, in world coordinates.
struct ConeShape {
    glm::dvec3 place{0}, axis{0, -1, 0}, u{1, 0, 0}, v{0, 0, 1};  // unit vectors
    double slant = 1;                                             // from the apex to the rim
    double angle = 0;                                             // from the axis to the rim, radians
    double inner = 4;  // from the axis to the soft edge; no soft edge unless below `angle`

    /// A point on the circle at the angle `from_axis`, and the circle's centre. Angles are in radians;
    /// `azimuth` is measured from u to v.
    [[nodiscard]] glm::dvec3 ring(double azimuth, double from_axis) const;
    [[nodiscard]] glm::dvec3 middle(double from_axis) const {
        return place + slant * std::cos(from_axis) * axis;
    }
    [[nodiscard]] glm::dvec3 rim(double azimuth) const { return ring(azimuth, angle); }
    [[nodiscard]] bool is_soft() const { return inner < angle; }
    [[nodiscard]] glm::dvec3 tip() const { return place + slant * axis; }  // where the aim is grabbed
};
/// Returns nullopt for a light without a cone (a different kind, or a cutoff of 180 degrees).
[[nodiscard]] std::optional<ConeShape> cone_of(const Light& light, const Dome& dome, const ScreenMap& map);

/// A panel in world coordinates: half-edges, and the end of the stick that turns it.
struct PanelShape {
    glm::dvec3 place{0}, u{1, 0, 0}, v{0, 0, 1};

    /// `at`: from -1 to 1 along each edge.
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
    double azimuth = 0;   // azimuth at which the rim or the inner circle was grabbed
    glm::dvec2 at{0};     // position of a corner or an edge: (-1, 1), (0, 1), ...
    glm::dvec3 place{0};  // world
    bool operator==(const ShapeGrip&) const = default;
};

/// Returns the current position of a grip, in world coordinates.
[[nodiscard]] glm::dvec3 place_of(const ShapeGrip& grip, const Light& light, const Dome& dome,
                                  const ScreenMap& map);

/// Returns the marks to draw: for a cone the aim, four points on the rim and two on the soft edge; for a
/// panel the aim, corners and edges.
[[nodiscard]] std::vector<ShapeGrip> shape_grips(const Light& light, const Dome& dome, const ScreenMap& map);

/// Returns the grip under the cursor, which is in pixels of the picture. A cone's circles can be grabbed
/// at any point.
[[nodiscard]] std::optional<ShapeGrip> shape_under(const Light& light, const PictureView& view,
                                                   glm::dvec2 cursor_px);

struct ShapeDrag {
    Light start;
    ShapeGrip grip;
    glm::dvec2 grabbed_px{0};
    // An aim turns freely on its sphere (`free`), or points at a target at this depth in front of the camera
    // (0: the grip's depth).
    bool free = false;
    std::optional<glm::dvec3> aimed = {};  // world
    double depth = 0;
};

/// Returns the light after the cursor has moved to `cursor_px`. The aim stays under the cursor; the rim opens
/// and closes towards it; a corner or an edge of a panel follows it, while the centre stays. `snap`: rounds
/// the cutoff to multiples of 5 degrees and half-edges to multiples of the view's step; an aim snaps like a
/// directional light.
[[nodiscard]] Light dragged_shape(const ShapeDrag& drag, const DragView& view, glm::dvec2 cursor_px,
                                  bool snap);

/// Returns the light turned to shine at a point in the world; unchanged if the light is at that point.
/// `snap`: turns it to the nearest direction to which a directional light snaps.
[[nodiscard]] Light aimed_at(const Light& light, glm::dvec3 place, const DragView& view, bool snap = false);

// Drags a light by its handle, which stays under the cursor as exactly as float can represent the position.
// Pure functions.

/// The plane, direction or axis along which a light is moved. ViewPlane: parallel to the picture. Depth:
/// along the line of sight, away when the cursor goes up (a directional light turns about the picture's axes
/// instead, past the rim of its dome). X, Y, Z: along an axis of the light's own coordinates (a directional
/// light turns about that axis).
enum class DragAlong { ViewPlane, Depth, X, Y, Z };

/// The state of a drag since it began, or since its DragAlong last changed.
struct LightDrag {
    Light start;
    DragAlong along = DragAlong::ViewPlane;
    glm::dvec2 grabbed_px{0};  // the cursor at that moment; its offset from the handle does not change
};

/// Returns the light after the cursor has moved to `cursor_px`. `snap`: rounds coordinates to multiples of
/// the view's step, and the angles of a direction to multiples of 15 degrees. Returns the initial light if
/// the motion has no solution (along an axis seen end-on, or behind the eye).
[[nodiscard]] Light dragged(const LightDrag& drag, const DragView& view, glm::dvec2 cursor_px, bool snap);

/// Returns a step of 1, 2 or 5 times a power of ten, near a twentieth of the scene's size.
[[nodiscard]] double snap_step_for(const Bounds& bounds);

// Drags a light by its terminator, the line on a surface where n.l = 0: the light moves, by as little as
// possible, into the tangent plane under the cursor.

struct TerminatorDrag {
    Light start;
};

/// Whether the light's terminator passes within `reach` pixels of `pixel`.
[[nodiscard]] bool terminator_under(const SurfaceView& view, const Light& light, glm::dvec2 pixel,
                                    double reach);

/// Returns the light with its terminator through `pixel`: a position drops onto the tangent plane, a
/// direction is turned into it. Returns nullopt on the background, or if the light is straight above the
/// pixel.
[[nodiscard]] std::optional<Light> dragged_terminator(const TerminatorDrag& drag, const SurfaceView& view,
                                                      glm::dvec2 pixel);

// Positions a light by its effect at a surface point: brightest there, or lit from behind so that the outline
// shines. Also finds the light that contributes most there. Pure functions.

/// The effect of a light at the point under the cursor.
enum class LightEffect { Brightest, Rim };

struct LightEffectInfo {
    LightEffect effect;
    const char* done;   // note at the cursor, after the light's name
    const char* means;  // text for the status line: where the light is then
    const char* waits;  // text for the status line if no position of the light has the effect
};
[[nodiscard]] const LightEffectInfo& info_of(LightEffect effect);

/// For a rim light, the angle between n and l in degrees at the point under the cursor: the surface is lit
/// from that point to the outline.
inline constexpr double rim_light_deg = 75;

/// Returns the light moved to have that effect at a pixel. Brightest: n.l = 1. Rim: n.l = cos 75 degrees, l
/// in the plane of n and v on the far side of n. The light keeps its distance from the point (a directional
/// light is turned); a spot or a panel turns to shine at the point. Returns nullopt on the background; for
/// Rim, also where n and v are less than 15 degrees apart, because light from behind cannot reach that point.
[[nodiscard]] std::optional<Light> with_effect(LightEffect effect, const Light& light,
                                               const SurfaceView& view, glm::dvec2 pixel);

/// Returns what a light adds to the sum at one point, per channel, over all terms and all samples of an area
/// light.
[[nodiscard]] glm::vec3 added_by(const ExplainedLight& light);

/// Returns what each light adds to a pixel, per channel, by the light's index; under Gouraud and flat
/// shading, from all corners.
[[nodiscard]] std::map<int, glm::vec3> added_to_pixel(const Explanation& explanation);
/// Returns `added` as a fraction of the pixel's sum over all channels, 0 to 1.
[[nodiscard]] double share_of_pixel(const Explanation& explanation, glm::vec3 added);

/// The light that contributes most to a pixel's sum.
struct MainLight {
    int light = 0;     // index into Scene::lights
    double share = 0;  // fraction of the sum over all channels, 0 to 1
};
/// Returns nullopt if no light contributes.
[[nodiscard]] std::optional<MainLight> main_light(const Explanation& explanation);

/// Returns the intensity after the cursor has moved up by `up_px` in a picture `height` pixels high: a factor
/// of e per third of the height. An intensity of 0 rises as if it were 0.01.
[[nodiscard]] float dimmed(float intensity, double up_px, int height);

}  // namespace glint
