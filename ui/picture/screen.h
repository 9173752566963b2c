#pragma once
// Maps the world to the pixels of a picture and to the window, and back, for one camera and one size.
// Handles, the probe and the drags use it, so that they agree with what the renderer drew. Pixels: x right, y
// down, the first row at the top; pixel (x, y) has its centre at (x + 1/2, y + 1/2).

#include <imgui.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <utility>

#include "models/mesh/mesh.h"
#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "renderer/picture.h"
#include "renderer/renderer.h"
#include "ui/document/scene_edit.h"
#include "ui/widgets/shortcut.h"

namespace glint {

struct ScreenMap {
    glm::dmat4 view_from_world{1}, world_from_view{1}, clip_from_view{1}, clip_from_world{1};
    PictureSize size;
};

[[nodiscard]] ScreenMap screen_map(const Camera& camera, PictureSize size);

struct ProjectedPoint {
    glm::dvec2 pixel{0};
    double depth = 0;       // distance in front of the camera in scene units: -z in camera coordinates
    bool in_front = false;  // false: at or behind the eye; then `pixel` is meaningless
};

/// Returns where a point of the world appears, which may be outside the picture.
[[nodiscard]] ProjectedPoint project(const ScreenMap& map, glm::dvec3 world);

/// Returns the point of the world that appears at `pixel`, `depth` in front of the camera. Inverse of
/// project().
[[nodiscard]] glm::dvec3 unproject(const ScreenMap& map, glm::dvec2 pixel, double depth);

struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, -1};  // world coordinates; direction is a unit vector
};

/// Returns the line of sight through a pixel: from the eye or, if orthographic, from the plane of the eye.
[[nodiscard]] Ray ray_through(const ScreenMap& map, glm::dvec2 pixel);

/// Converts a point (w = 1) or direction (w = 0) from camera coordinates to the world.
[[nodiscard]] glm::dvec3 in_world(const ScreenMap& map, glm::vec3 camera, double w);

[[nodiscard]] bool is_inside(PictureSize size, glm::dvec2 pixel);
/// Returns the integer pixel at `pixel`, clamped to the picture.
[[nodiscard]] glm::ivec2 nearest_pixel(PictureSize size, glm::dvec2 pixel);

/// The sphere on which directional lights are shown and dragged.
struct Dome {
    glm::dvec3 centre{0};
    double radius = 1;
};

/// Returns the pixel in a picture of size `to` at the position of a pixel in a picture of the same view with
/// size `from`.
[[nodiscard]] glm::ivec2 pixel_at_place(glm::ivec2 pixel, PictureSize from, PictureSize to);

/// The picture's rectangle in the window, in ImGui's units, and the camera that drew it.
struct PictureView {
    ImVec2 origin;
    float units_per_pixel = 1;
    ScreenMap map;
    Dome dome;
    Bounds bounds;  // bounds of the scene, world

    [[nodiscard]] ImVec2 to_window(glm::dvec2 pixel) const {
        return {origin.x + float(pixel.x) * units_per_pixel, origin.y + float(pixel.y) * units_per_pixel};
    }
    [[nodiscard]] glm::dvec2 to_pixel(ImVec2 at) const {
        return {(at.x - origin.x) / units_per_pixel, (at.y - origin.y) / units_per_pixel};
    }
    /// Returns where a point of the world appears; it must be in front of the eye.
    [[nodiscard]] ImVec2 shown(glm::dvec3 world) const { return to_window(project(map, world).pixel); }
    /// Returns the ends of a world segment in the window, clipped at the eye; nullopt if it is behind the
    /// eye.
    [[nodiscard]] std::optional<std::pair<ImVec2, ImVec2>> shown(glm::dvec3 a, glm::dvec3 b) const;
    /// The window position of the picture's lower right corner.
    [[nodiscard]] ImVec2 end() const { return to_window({map.size.width, map.size.height}); }
    /// Converts a length of `units` of the design to the picture's pixels.
    [[nodiscard]] double pixels(float units) const;
};

/// Draws lines in the world over the picture.
struct WorldPen {
    ImDrawList& list;
    const PictureView& view;

    /// Draws a line, clipped at the eye. `width` is in ImGui's units.
    void line(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float width) const;
    /// Draws a bright line on a dark one, visible on every picture; `width` in logical pixels.
    void cased(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float opacity, float width = 1.3f) const;
    /// Draws the circle centre + cos(t) u + sin(t) v.
    void circle(glm::dvec3 centre, glm::dvec3 u, glm::dvec3 v, ImU32 colour, float opacity) const;
    /// Draws a small disc with a dark rim; it is larger while hovered.
    void mark(glm::dvec3 place, ImU32 colour, float opacity, bool hovered) const;
};

// Decides once per frame, before drawing, what the picture shows and why, and which pixel is explained.

struct Feature;
struct UiState;

/// A scene shown in place of the edited one. It is never stored in the history or in a file.
struct OtherScene {
    Scene scene;
    const char* name = "";            // name within a sentence: "the frozen picture"
    std::string label = {};           // label over a part of a comparison
    std::string note = {};            // text on the badge
    CommandId key = CommandId::None;  // the command that ends it
    void (*end)(UiState&) = nullptr;  // ends it; null: it ends when the mouse moves on
    bool passes = false;              // a preview while the mouse hovers over something
    bool is_partial = false;          // the edited scene with something left out
    bool of_edited = false;           // derived from the edited scene, so its handles can be dragged here
    Selection selection = {};         // item whose handles are drawn, unless `of_edited`
    std::string refusal = {},
                hint = {};  // why its view and picked pixel cannot change, and a hint; in the status line
    const Feature* by = nullptr;
    void (*press)(UiState&) = nullptr;  // handles a press of the left button; null: the viewport does
};

struct OnScreen {
    std::optional<OtherScene> resting;  // in place of the edited scene, until the user ends it
    std::optional<OtherScene> passing;  // shown in place of that, while the mouse hovers over something
    // About the picked pixel, in the scene on the screen or in a part of a comparison:
    std::optional<Explanation> explanation;
    std::optional<OtherScene> explained_other;    // the explained scene; nullopt: the edited one
    const Renderer* explained_by = nullptr;       // the renderer that explains it; null during a preview
    glm::ivec2 pixel{0};                          // position in the full picture
    PictureSize explained_size, explained_drawn;  // size of the full picture, and of the drawn one

    /// The scene to draw in place of the edited one; null: the edited one.
    [[nodiscard]] const OtherScene* drawn() const {
        return passing ? &*passing : resting ? &*resting : nullptr;
    }
    /// Whether the picture shows a scene that cannot be edited by dragging in it.
    [[nodiscard]] bool is_out_of_hand() const { return resting && !resting->of_edited; }
    /// Why the view and the picked pixel cannot be changed; empty if they can.
    [[nodiscard]] std::string refusal() const { return resting ? resting->refusal : std::string(); }
};

/// Decides which features show a scene: OnScreen::resting and OnScreen::passing.
void decide_shown(OnScreen& shown, const UiState& state);
/// Returns the scene that would be shown without `feature` and those before it.
[[nodiscard]] std::optional<OtherScene> resting_below(const UiState& state, const Feature& feature);
/// Returns whether no feature before `feature` shows a scene.
[[nodiscard]] bool has_turn(const UiState& state, const Feature& feature);

/// Returns the scene in the picture, ignoring previews: the one that is copied or exported.
[[nodiscard]] const Scene& shown_scene(const UiState& state);
/// Returns the explained scene.
[[nodiscard]] const Scene& explained_scene(const UiState& state);
/// Returns the explained scene for editing; null if it is not the edited one.
[[nodiscard]] Scene* editable_scene(UiState& state);
/// Returns whether the explanation is of the edited scene, whose lights and objects can be selected.
[[nodiscard]] bool is_explained(const UiState& state);

/// Explains the picked pixel. In a temporarily smaller picture, that is the larger pixel whose colour is on
/// the screen.
void explain_picked(UiState& state, const PictureView& view);

/// Whether the explanation is of the pixel under the cursor instead of the picked one, as it is while Alt is
/// held over the picture.
[[nodiscard]] bool asks_at_cursor(const UiState& state);

}  // namespace glint
