#pragma once
// Lights drawn where they are: a handle in the light's own colour, what kind it is, and a stem to its foot on
// the ground so that depth can be judged.

#include <imgui.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/picture/handles/light_drag.h"
#include "ui/picture/picture_view.h"

namespace glint {

struct Handle {
    int light = 0;
    glm::dvec3 place{0};  // world
    OnScreen at;
    bool in_picture = false;  // else `at.pixel` is on the picture's border, towards where the light is
};

/// Handles of the scene's lights, in their order: of the first 300, which is more than an eye tells apart,
/// and of `selected` (-1: none).
[[nodiscard]] std::vector<Handle> light_handles(const Scene& scene, const PictureView& view, int selected);

/// The handle under the cursor (in the picture's pixels), or null; the nearest wins.
[[nodiscard]] const Handle* handle_under(const std::vector<Handle>& handles, glm::dvec2 cursor_px,
                                         const PictureView& view);

/// How a handle is to be drawn.
struct HandleLook {
    bool selected = false, hovered = false;
    bool hidden = false;  // behind an object
    bool stem = true;     // down to the ground; among many lights only the one in hand has it
    std::optional<glm::dvec3> shape_in_hand;  // the part of its shape under the hand, world
};
void draw_handle(ImDrawList& list, const PictureView& view, const Light& light, const Handle& handle,
                 HandleLook look);

/// A note beside the cursor: a title and lines of figures, kept inside the picture.
void draw_note(ImDrawList& list, const PictureView& view, ImVec2 at, const std::string& title,
               const std::string& numbers);

// What a light has beside its place: a spot's cone, a panel's rectangle. Where they are in the world, what of
// them can be dragged, and what a drag makes of them. Pure functions.

/// The part of a cone that is drawn, world coordinates.
struct ConeShape {
    glm::dvec3 place{0}, axis{0, -1, 0}, u{1, 0, 0}, v{0, 0, 1};  // unit, at right angles
    double slant = 1;                                             // from the place to the rim
    double angle = 0;                                             // from the axis to the rim, radians

    [[nodiscard]] glm::dvec3 middle() const;                               // of the rim's circle
    [[nodiscard]] glm::dvec3 rim(double azimuth) const;                    // radians from u to v
    [[nodiscard]] glm::dvec3 tip() const { return place + slant * axis; }  // where the aim is grabbed
};
/// Nothing for a light without a cone (another kind, a cutoff of 180 degrees).
[[nodiscard]] std::optional<ConeShape> cone_of(const Light& light, const Dome& dome, const ScreenMap& map);

/// A panel, world coordinates: half-edges, and the end of the stick by which it is turned.
struct PanelShape {
    glm::dvec3 place{0}, u{1, 0, 0}, v{0, 0, 1};

    /// `at`: -1 to 1 along both edges.
    [[nodiscard]] glm::dvec3 point(glm::dvec2 at) const { return place + at.x * u + at.y * v; }
    [[nodiscard]] glm::dvec3 normal() const;
    [[nodiscard]] glm::dvec3 tip() const;
};
[[nodiscard]] std::optional<PanelShape> panel_of(const Light& light, const ScreenMap& map);

/// What of a shape can be dragged. A panel's corners and edges are told apart by where they are on it.
enum class ShapePart { Rim, Aim, Corner, Edge };

struct ShapeGrip {
    ShapePart part = ShapePart::Aim;
    double azimuth = 0;   // of a rim: where it was taken hold of
    glm::dvec2 at{0};     // of a corner or an edge: (-1, 1), (0, 1), ...
    glm::dvec3 place{0};  // world
    bool operator==(const ShapeGrip&) const = default;
};

/// Where a grip is now, world.
[[nodiscard]] glm::dvec3 place_of(const ShapeGrip& grip, const Light& light, const Dome& dome,
                                  const ScreenMap& map);

/// The marks to draw: aim, four of the rim; corners and edges.
[[nodiscard]] std::vector<ShapeGrip> shape_grips(const Light& light, const Dome& dome, const ScreenMap& map);

/// The grip under the cursor (pixels of the picture); the rim can be taken hold of all round.
[[nodiscard]] std::optional<ShapeGrip> shape_under(const Light& light, const PictureView& view,
                                                   glm::dvec2 cursor_px);

struct ShapeDrag {
    Light start;
    ShapeGrip grip;
    glm::dvec2 grabbed_px{0};
};

/// The light after the cursor went to `cursor_px`. The aim stays under the cursor; the rim opens and closes
/// towards it; a corner or an edge of a panel follows it, the middle stays. `snap`: cutoff to multiples of 5
/// degrees, half-edges to the view's step, an aim as a directional light's.
[[nodiscard]] Light dragged_shape(const ShapeDrag& drag, const DragView& view, glm::dvec2 cursor_px,
                                  bool snap);

/// The light turned so that it shines at a place in the world; as it was where it stands there.
[[nodiscard]] Light aimed_at(const Light& light, glm::dvec3 place, const DragView& view);

}  // namespace glint
