#pragma once
// Decides once per frame, before drawing, what the picture shows and why, and which pixel is explained.

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

/// A scene shown in place of the edited one. It is never stored in the history or in a file.
struct OtherScene {
    Scene scene;
    const char* name = "";            // name within a sentence: "the frozen picture"
    std::string label = {};           // shown over a part of a comparison
    std::string note = {};            // shown on the badge
    CommandId key = CommandId::None;  // the command that ends it
    void (*end)(UiState&) = nullptr;  // ends it; null: it ends when the mouse moves on
    bool passes = false;              // a preview while the mouse hovers over something
    bool is_partial = false;          // the edited scene with something left out
    bool of_edited = false;           // derived from the edited scene, whose handles can be dragged in it
    Selection selection = {};  // its handles are drawn, unless the scene is derived from the edited one
    std::string refusal = {},
                hint = {};  // why its view and picked pixel cannot change, and a hint; in the status line
    const Feature* by = nullptr;
    void (*press)(UiState&) = nullptr;  // handles a press of the left button; null: the viewport does
};

struct OnScreen {
    std::optional<OtherScene> resting;  // shown in place of the edited scene, until the user ends it
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
