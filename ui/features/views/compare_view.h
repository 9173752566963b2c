#pragma once
// A comparison shows several settings of one scene in one picture, side by side with draggable lines between
// them, or their difference. Lecture: "Shading Models" (flat, Gouraud and Phong side by side).

#include <imgui.h>

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/image/compare.h"
#include "renderer/renderer.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/screen.h"
#include "ui/picture/tool.h"

namespace glint {

struct UiState;

// The settings in which the parts of a comparison differ. A variant is the edited scene, unchanged or with
// one choice changed; the stored scene; or a picture that the user opened.

struct Variant {
    enum class Kind { Edited, Mode, Reflection, Interpolation, LightPaths, Stored, Mine };
    Kind kind = Kind::Edited;
    int index = 0;  // in choices<ShadingMode>, <Reflection>, <Interpolation> or <TransportModel>
    bool operator==(const Variant&) const = default;
};

[[nodiscard]] Variant variant_of(ShadingMode mode);
[[nodiscard]] Variant variant_of(Reflection reflection);
[[nodiscard]] Variant variant_of(TransportModel model);

/// All variants, in the order in which lists show them. Includes Stored and Mine whether or not there is such
/// a scene or picture.
[[nodiscard]] std::vector<Variant> all_variants();

/// The variant's name in a file: "mode gouraud", "edited", "stored".
[[nodiscard]] std::string word_of(Variant variant);
/// Inverse of word_of(); nullopt for an unknown word.
[[nodiscard]] std::optional<Variant> variant_named(const std::string& word);

/// The variant's label in the window: "Gouraud", "As edited", "B".
[[nodiscard]] std::string label_of(Variant variant);

/// Returns the scene of a variant, seen by the edited scene's camera. Mine, and Stored without a stored scene
/// (null), show the edited scene.
[[nodiscard]] Scene scene_under(Variant variant, const Scene& edited, const Scene* stored);

/// The chosen comparison; changes to it change the picture.
struct CompareChoice {
    bool on = false;
    std::vector<Variant> parts{variant_of(ShadingMode::Flat), variant_of(ShadingMode::Gouraud),
                               variant_of(ShadingMode::Phong)};  // 2 or 3, from left to right
    std::vector<double> wipes{1.0 / 3, 2.0 / 3};  // one fewer than parts, ascending: fractions of the length
    bool stacked = false;     // parts from top to bottom, with horizontal lines; the length is the height
    bool difference = false;  // shows the difference between the first and the last part instead
    int gain = 1;             // gain of the difference: 1, 2, 4 ... 64
    std::shared_ptr<const Scene> stored;  // "B": shared, as choices are copied and compared in every frame
    bool shows_stored = false;            // B alone in place of the picture
    std::shared_ptr<const Picture> mine;  // the user's picture, as bytes; null: none
    bool operator==(const CompareChoice&) const = default;
};
inline constexpr int max_gain = 64;
/// Doubles the difference's gain; wraps from the largest to 1.
inline void double_gain(CompareChoice& choice) {
    choice.gain = choice.gain >= max_gain ? 1 : 2 * choice.gain;
}

/// Whether a part should show the stored B, or the user's picture, but there is none; it then shows the
/// edited scene.
[[nodiscard]] bool lacks_stored(const CompareChoice& choice, Variant variant);
[[nodiscard]] bool lacks_picture(const CompareChoice& choice, Variant variant);

/// A part of the picture that shows a scene, and its renderer.
struct DrawnPart {
    const Renderer* renderer = nullptr;
    PartRect rect;
    Variant variant;  // Edited if it is the entire picture
};

struct CompareState {
    CompareChoice choice;
    std::optional<CompareChoice> own;  // the user's choice, while a game or a picture shows a different one
    int borrowers = 0;                 // the number of games and pictures that show one of their own
    int dragged = -1, under = -1;      // index of a wipe line
    int label_under = -1, asked = -1;  // the part whose label is under the mouse; whose variants are listed
    std::vector<std::unique_ptr<Renderer>> renderers;  // of the parts that are not the edited scene
    std::vector<Refinement> refinements;               // refine the pictures of `renderers`
    std::vector<const Picture*> pictures;              // one per part, of the last composition
    std::vector<const Renderer*> drawn_by;
    Picture fitted;             // CompareChoice::mine, at the size of the other parts
    Picture picture;            // the composed picture
    Comparison numbers;         // of the difference
    double ms = 0;              // time spent drawing the parts in the last composition
    Variant asked_part;         // the variant at the picked pixel; Edited if there is none
    std::string label_of_mine;  // label of `mine` with the newest verdict; if empty, label_of() is used
    std::string
        resting;  // name of the scene shown in place of the edited one (OtherScene::label); empty: none
    // The key that shows or hides B, while it may still be down:
    bool b_turned = false;
    double b_since = 0;  // ImGui time when the key was pressed
    int b_frames = 0;    // number of frames in which it was down
};

/// Saves the user's comparison until it is restored; B is kept.
void borrow_comparison(CompareState& state);
void give_comparison_back(CompareState& state);

/// The name of B where its numbers are shown.
inline constexpr const char* name_of_stored = "B, the stored scene";

/// The label over a part in the picture: the label of its variant, or a note that there is nothing to show.
[[nodiscard]] std::string part_label(const CompareState& state, std::size_t part);

/// The picture on the screen and its renderer, from which the parts are drawn.
struct DrawnScene {
    const Scene& scene;
    const Picture& picture;
    const Renderer& renderer;
    int threads = 0;
};

/// The length of the picture in the direction in which the parts are arranged.
[[nodiscard]] int length_of(const CompareChoice& choice, PictureSize size);
/// First column (row if stacked) of part `part`; the length for one past the last part.
[[nodiscard]] int first_of(const CompareChoice& choice, int part, int length);
/// The part at this column (row if stacked).
[[nodiscard]] int part_at(const CompareChoice& choice, int along, int length);

/// The pixels of a part.
[[nodiscard]] PartRect part_rect(const CompareChoice& choice, int part, PictureSize size);

/// Draws every part and composes them: each pixel is taken from the full picture of the part that
/// contains it. A difference compares the first part with the last and fills `numbers`. Linear colours are
/// composed if `drawn` has them.
const Picture& compose(CompareState& state, const DrawnScene& drawn);

/// Refines the parts in the background, once a frame; true if one has improved. Sets `progress`.
bool refine_parts(CompareState& state, Jobs& jobs, int threads, float& progress);

/// Drops the composed picture and its renderers: pixels belong to no part until the next composition.
void forget_parts(CompareState& state);

/// The part that contains pixel (x, y) of the composed picture; -1 if no parts are shown.
[[nodiscard]] int part_of(const CompareState& state, glm::ivec2 pixel, PictureSize size);

/// The renderer that drew pixel (x, y) of the composed picture; null if that is the drawn scene's renderer
/// or if there is none.
[[nodiscard]] const Renderer* part_renderer(const CompareState& state, glm::ivec2 pixel, PictureSize size);

/// The parts of the composed picture that show scenes; if there are none, the entire picture, as drawn by
/// `drawn`.
[[nodiscard]] std::vector<DrawnPart> drawn_parts(const CompareState& state, const Renderer& drawn,
                                                 PictureSize size);

/// Draws the comparison's controls into the row above the picture; nothing while it is off.
void compare_controls(CompareState& state);

extern const Tool compare_tool;
/// Draws lines and labels; after a click on a label, the list of the part's settings.
void draw_compare(ImDrawList& list, UiState& ui, const PictureView& view);

/// Sets the parts and spaces their lines evenly.
void set_parts(CompareChoice& choice, std::vector<Variant> parts);

}  // namespace glint
