#pragma once
// What the picture shows and why, and what is explained of it: decided once a frame, before it is drawn.

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "renderer/explain/explanation.h"
#include "renderer/picture.h"
#include "ui/document/scene_edit.h"
#include "ui/picture/screen.h"
#include "ui/widgets/shortcut.h"

namespace glint {

struct Feature;
struct UiState;

/// A scene that is shown in place of the edited one. Nothing of it reaches the history or a file.
struct OtherScene {
    Scene scene;
    const char* name = "";            // in a sentence: "the frozen picture"
    std::string label = {};           // over a part of a comparison
    std::string note = {};            // on the badge
    CommandId key = CommandId::None;  // of the command that ends it
    void (*end)(UiState&) = nullptr;  // ends it; null: it ends when the mouse moves on
    bool passes = false;              // it is a preview while the mouse hovers over something
    bool is_partial = false;          // it is the edited scene with something left out
    bool of_edited = false;           // made of the edited scene, whose handles can be dragged in it
    Selection selection = {};         // whose handles are drawn, where it is not of the edited scene
    std::string refusal = {},
                hint = {};  // why neither view nor picked pixel change in it, and the status line
    const Feature* by = nullptr;
    void (*press)(UiState&) = nullptr;  // takes a press of the left button; null: the hand has it
};

struct OnScreen {
    std::optional<OtherScene> resting;  // in place of the edited scene, until the user ends it
    std::optional<OtherScene> passing;  // in place of that, while the mouse hovers over something
    // Of the picked pixel, in what rests on the screen or in a part of a comparison:
    std::optional<Explanation> explanation;
    std::optional<OtherScene> explained_other;    // the scene that it is about; none: the edited one
    glm::ivec2 pixel{0};                          // in the whole picture
    PictureSize explained_size, explained_drawn;  // of the whole picture, and of the one that was drawn

    /// The scene that is drawn next, in place of the edited one; null: the edited one.
    [[nodiscard]] const OtherScene* drawn() const {
        return passing ? &*passing : resting ? &*resting : nullptr;
    }
    /// Whether the picture shows a scene that a hand in it does not edit.
    [[nodiscard]] bool is_out_of_hand() const { return resting && !resting->of_edited; }
    /// Why neither the view nor the picked pixel can be changed; empty: they can.
    [[nodiscard]] std::string refusal() const { return resting ? resting->refusal : std::string(); }
};

/// Decides which features show a scene: OnScreen::resting and OnScreen::passing.
void decide_shown(OnScreen& shown, const UiState& state);
/// What rests on the screen below whatever `feature` and those before it show.
[[nodiscard]] std::optional<OtherScene> resting_below(const UiState& state, const Feature& feature);
/// Whether no feature before `feature` shows something.
[[nodiscard]] bool has_turn(const UiState& state, const Feature& feature);

/// The scene that the picture shows, previews aside: what is copied or exported of it.
[[nodiscard]] const Scene& shown_scene(const UiState& state);
/// The scene that the explanation is about.
[[nodiscard]] const Scene& explained_scene(const UiState& state);
/// The same scene to be edited; null where it is not the edited one.
[[nodiscard]] Scene* editable_scene(UiState& state);
/// Whether there is an explanation and it is about the edited scene: its lights and objects can be selected.
[[nodiscard]] bool is_explained(const UiState& state);

/// Explains the picked pixel: in a smaller picture a larger pixel, whose colour is the one on the screen.
void explain_picked(UiState& state, const PictureView& view);

/// Whether the pixel under the cursor is explained and not the picked one: while Alt is held over the
/// picture.
[[nodiscard]] bool asks_at_cursor(const UiState& state);

}  // namespace glint
