#pragma once
// Decides once a frame, before drawing, what the picture shows and why, and which pixel is explained.

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "renderer/picture.h"
#include "renderer/renderer.h"
#include "ui/document/scene_edit.h"
#include "ui/picture/screen.h"
#include "ui/widgets/shortcut.h"

namespace glint {

struct Feature;
struct UiState;

/// A scene shown in place of the edited one. It is never part of the history or a file.
struct OtherScene {
    Scene scene;
    const char* name = "";                // name within a sentence: "the frozen picture"
    std::string label = {};               // over a part of a comparison
    std::string note = {};                // on the badge
    CommandId key = CommandId::None;      // the command that ends it
    void (*end)(UiState&) = nullptr;      // ends it; null: it ends when the mouse moves on
    bool passes = false;                  // a preview while the mouse hovers over something
    bool is_partial = false;              // the edited scene with something left out
    bool of_edited = false;               // made from the edited scene, whose handles can be dragged in it
    Selection selection = {};             // its handles are drawn if it is not made from the edited scene
    std::string refusal = {}, hint = {};  // why its view and picked pixel cannot change; in the status line
    const Feature* by = nullptr;
    void (*press)(UiState&) = nullptr;  // handles a press of the left button; null: the viewport does
};

struct OnScreen {
    std::optional<OtherScene> resting;  // in place of the edited scene, until the user ends it
    std::optional<OtherScene> passing;  // in place of that, while the mouse hovers over something
    // Of the picked pixel, in the scene on the screen or in a part of a comparison:
    std::optional<Explanation> explanation;
    std::optional<OtherScene> explained_other;    // the explained scene; none: the edited one
    const Renderer* explained_by = nullptr;       // renderer that explains it; null during a preview
    glm::ivec2 pixel{0};                          // position in the full picture
    PictureSize explained_size, explained_drawn;  // size of the full picture, and of the drawn one

    /// The scene to draw in place of the edited one; null: the edited one.
    [[nodiscard]] const OtherScene* drawn() const {
        return passing ? &*passing : resting ? &*resting : nullptr;
    }
    /// Whether the picture shows a scene that cannot be edited by dragging in the picture.
    [[nodiscard]] bool is_out_of_hand() const { return resting && !resting->of_edited; }
    /// Why the view and the picked pixel cannot be changed; empty: they can.
    [[nodiscard]] std::string refusal() const { return resting ? resting->refusal : std::string(); }
};

/// Decides which features show a scene: OnScreen::resting and OnScreen::passing.
void decide_shown(OnScreen& shown, const UiState& state);
/// The scene shown without `feature` and those before it.
[[nodiscard]] std::optional<OtherScene> resting_below(const UiState& state, const Feature& feature);
/// Whether no feature before `feature` shows a scene.
[[nodiscard]] bool has_turn(const UiState& state, const Feature& feature);

/// The scene in the picture, without previews: the one that is copied or exported.
[[nodiscard]] const Scene& shown_scene(const UiState& state);
/// The explained scene.
[[nodiscard]] const Scene& explained_scene(const UiState& state);
/// The explained scene for editing; null if it is not the edited one.
[[nodiscard]] Scene* editable_scene(UiState& state);
/// Whether there is an explanation of the edited scene: its lights and objects can be selected.
[[nodiscard]] bool is_explained(const UiState& state);

/// Explains the picked pixel: in a temporarily smaller picture, the larger pixel whose colour is on the
/// screen.
void explain_picked(UiState& state, const PictureView& view);

/// Whether the explanation follows the cursor instead of the picked pixel: while Alt is down over the
/// picture.
[[nodiscard]] bool asks_at_cursor(const UiState& state);

}  // namespace glint
