#pragma once
// A feature of the window takes part in a frame through one row of functions; those that it does not need are
// null. Its state is defined in its own folder and accessed with UiState::get. ui/features.cpp lists all
// features; the core of the window includes none of their headers.

#include <imgui.h>

#include <glm/vec2.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint {

using Json = nlohmann::ordered_json;
struct ItemPlaces;
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

/// Properties of the next picture that features require.
struct PictureNeeds {
    bool linear = false;     // Picture::linear
    bool full_size = false;  // even during motion
};

/// How positions in the picture, as fractions of its size, change with its aspect ratio.
struct Reshape {
    glm::dvec2 scale{1};      // factors for distances from the picture's centre, as fractions
    glm::vec2 in_heights{1};  // factors for the same distances in units of the picture's height
    void follow(glm::dvec2& share) const { share = (share - 0.5) * scale + 0.5; }
};

/// A modal dialog: ui/shell/modal.h.
struct Dialog {
    bool (*is_open)(const UiState&) = nullptr;
    void (*close)(UiState&) = nullptr;  // closes the dialog without an answer, as Escape does
    void (*draw)(UiState&, const UiInput&) = nullptr;
    bool is_about_scene = false;  // the dialog closes when another scene replaces the current one
};

/// A column that replaces the scene's list in the left column.
struct LeftColumn {
    const char* (*name)(const UiState&) = nullptr;  // the label of its tab; null if closed
    void (*draw)(UiState&) = nullptr;
    void (*close)(UiState&) = nullptr;
    void (*button)(UiState&,
                   float right) = nullptr;  // draws a button next to the tabs, with its right edge at `right`
};

struct Feature {
    // Called once per frame, in this order.
    void (*begin)(UiState&, const UiInput&) = nullptr;  // before any window is drawn
    void (*settle)(UiState&) = nullptr;                 // after the panels, before the picture is drawn
    void (*compose)(UiState&) = nullptr;                // changes the displayed picture
    void (*update)(UiState&) = nullptr;                 // after the picked pixel has been explained
    void (*draw)(UiState&, const Layout&) = nullptr;    // draws its own windows
    void (*end)(UiState&) = nullptr;                    // after the frame's edits have become an undo step

    // On the picture.
    std::optional<OtherScene> (*shows)(const UiState&) =
        nullptr;  // the scene shown in place of the edited one
    PictureNeeds (*needs)(const UiState&) = nullptr;
    const Tool* tool = nullptr;
    void (*overlay)(ImDrawList&, UiState&, const PictureView&) = nullptr;
    bool overlay_stays = false;  // drawn even over a picture without bars, and during a question
    std::optional<PictureNote> (*note)(const UiState&, const Scene&) = nullptr;
    void (*reshape)(UiState&, const Reshape&) = nullptr;

    // Around the picture.
    LeftColumn column = {};
    bool (*why)(UiState&, const PictureView&) = nullptr;  // draws in WHY; false: nothing may be drawn below
    float (*status)(UiState&, ImVec2 right) = nullptr;    // draws in the status line; returns its width
    std::optional<std::string> (*caption)(const UiState&) = nullptr;  // replaces the scene's own caption
    Dialog dialog = {};
    PictureSheet* (*sheet)(UiState&) = nullptr;  // a sheet to be kept as a texture

    // Keys and commands.
    std::vector<WindowCommand> (*commands)() = nullptr;
    void (*palette)(std::vector<PaletteEntry>&, UiState&) = nullptr;
    bool (*key)(UiState&, KeyPress) = nullptr;  // true: the key is consumed
    bool (*escape)(UiState&) = nullptr;         // true: something was closed

    // Files and settings.
    std::optional<Opening> (*open)(const std::string& path) =
        nullptr;  // nullopt for file types that it does not support
    bool (*drop)(UiState&, const std::string& path) = nullptr;  // handles a file that is not a document
    void (*write_settings)(const UiState&, Json&) = nullptr;
    void (*read_settings)(UiState&, const Json&) = nullptr;  // untrusted; missing settings are reset

    // Interaction with other features.
    std::string (*why_held)(const UiState&) =
        nullptr;  // why the scene cannot be edited or a pixel picked; else empty
    bool (*is_presented)(const UiState&) = nullptr;         // an audience is watching, so nothing may pop up
    void (*follow)(UiState&, const ItemPlaces&) = nullptr;  // lights or objects were added or deleted
    void (*leave_document)(UiState&, const SceneDocument& next) = nullptr;
    void (*put_away)(UiState&) = nullptr;  // closes everything shown in place of the picture or over it
};

/// All features. If several features request the same thing (the picture, the mouse, Escape), the first one
/// gets it. Earlier features are drawn over later ones.
[[nodiscard]] std::span<const Feature* const> features();

/// Returns the combined needs of all features.
[[nodiscard]] PictureNeeds picture_needs(const UiState& state);

/// Returns why a feature currently prevents editing the scene and picking pixels; empty if none does.
[[nodiscard]] std::string why_held(const UiState& state);
[[nodiscard]] bool is_held(const UiState& state);

}  // namespace glint
