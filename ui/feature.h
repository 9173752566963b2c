#pragma once
// A feature of the window takes part in a frame by one row of functions; those that it does not need are
// null. Its state is defined in its own folder and reached by UiState::get. ui/features.cpp lists all
// features; the core of the window includes nothing of theirs.

#include <imgui.h>

#include <glm/vec2.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint {

using Json = nlohmann::ordered_json;
struct KeyPress;
struct Layout;
struct Opening;
struct OtherScene;
struct PaletteEntry;
struct PictureNote;
struct Scene;
struct PictureSheet;
struct PictureView;
struct SceneDocument;
struct Tool;
struct UiInput;
struct UiState;
struct WindowCommand;

/// What the next picture has to have for what is read off it.
struct PictureNeeds {
    bool linear = false;     // Picture::linear
    bool full_size = false;  // also while something moves
};

/// How places on the picture, as shares of its size, change when it gets another shape.
struct Reshape {
    glm::dvec2 scale{1};      // of distances from its middle, in shares
    glm::vec2 in_heights{1};  // likewise, in heights of the picture
    void follow(glm::dvec2& share) const { share = (share - 0.5) * scale + 0.5; }
};

/// A modal dialog: ui/shell/modal.h.
struct Dialog {
    bool (*is_open)(const UiState&) = nullptr;
    void (*close)(UiState&) = nullptr;  // as Escape does: nothing happens
    void (*draw)(UiState&, const UiInput&) = nullptr;
    bool is_about_scene = false;  // it is closed when another scene replaces the present one
};

/// What takes the place of the scene's list in the left column.
struct LeftColumn {
    const char* (*name)(const UiState&) = nullptr;  // of its tab; null: it is closed
    void (*draw)(UiState&) = nullptr;
    void (*close)(UiState&) = nullptr;
    void (*button)(UiState&, float right) = nullptr;  // draws one that ends at `right`, beside the tabs
};

struct Feature {
    // Once a frame, in this order.
    void (*begin)(UiState&, const UiInput&) = nullptr;  // before any window is drawn
    void (*settle)(UiState&) = nullptr;                 // after the panels, before the picture is drawn
    void (*compose)(UiState&) = nullptr;                // changes what is displayed of the picture
    void (*update)(UiState&) = nullptr;                 // the picked pixel is explained
    void (*draw)(UiState&, const Layout&) = nullptr;    // its own windows
    void (*end)(UiState&) = nullptr;                    // the frame's edits have become a step

    // On the picture.
    std::optional<OtherScene> (*shows)(const UiState&) = nullptr;  // in place of the edited scene
    PictureNeeds (*needs)(const UiState&) = nullptr;
    const Tool* tool = nullptr;
    void (*overlay)(ImDrawList&, UiState&, const PictureView&) = nullptr;
    bool overlay_stays = false;  // also over a clean picture, and while a question waits
    std::optional<PictureNote> (*note)(const UiState&, const Scene&) = nullptr;
    void (*reshape)(UiState&, const Reshape&) = nullptr;

    // Around the picture.
    LeftColumn column = {};
    bool (*why)(UiState&, const PictureView&) = nullptr;  // in the WHY column; false: nothing below it
    float (*status)(UiState&, ImVec2 right) = nullptr;    // in the status line; returns its width
    std::optional<std::string> (*caption)(const UiState&) = nullptr;  // in place of the scene's own
    Dialog dialog = {};
    PictureSheet* (*sheet)(UiState&) = nullptr;  // that the window keeps as a texture

    // Keys and commands.
    std::vector<WindowCommand> (*commands)() = nullptr;
    void (*palette)(std::vector<PaletteEntry>&, UiState&) = nullptr;
    bool (*key)(UiState&, KeyPress) = nullptr;  // true: the key is used up
    bool (*escape)(UiState&) = nullptr;         // true: it had something to leave

    // Files and settings.
    std::optional<Opening> (*open)(const std::string& path) = nullptr;  // where it knows that kind of file
    bool (*drop)(UiState&, const std::string& path) = nullptr;          // a file that is no document
    void (*write_settings)(const UiState&, Json&) = nullptr;
    void (*read_settings)(UiState&, const Json&) = nullptr;  // untrusted; what is missing is reset

    // Together with others.
    std::string (*why_held)(const UiState&) = nullptr;  // why the scene cannot be changed or asked; or empty
    bool (*is_presented)(const UiState&) = nullptr;     // to others: nothing pops up by itself
    void (*leave_document)(UiState&, const SceneDocument& next) = nullptr;
    void (*put_away)(UiState&) = nullptr;  // ends what is shown in place of the picture or over it
};

/// All of them. Where several want the same (the picture, the mouse, Escape), the first one has it. Those
/// further up are drawn over the others.
[[nodiscard]] std::span<const Feature* const> features();

/// What all of them need together.
[[nodiscard]] PictureNeeds picture_needs(const UiState& state);

/// Why a feature keeps the scene from being changed and the picture from being asked; empty: none does.
[[nodiscard]] std::string why_held(const UiState& state);
[[nodiscard]] bool is_held(const UiState& state);

}  // namespace glint
