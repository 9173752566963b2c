#pragma once
// The user's picture of the open scene, drawn by their own program or shader: it joins the comparison, a
// diagnosis runs in the background, and the findings are listed, tried out on the scene, and shown in the
// equation. The file is watched: when it changes, it is read or drawn and diagnosed again.

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/diagnose.h"
#include "models/io/child_process.h"
#include "models/io/file.h"
#include "renderer/explain/explain.h"
#include "renderer/renderer.h"
#include "ui/document/file_dialog.h"
#include "ui/document/job.h"
#include "ui/features/views/compare_view.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

struct UiState;
struct PictureView;

/// The result of a diagnosis.
struct PictureAnswer {
    Diagnosis diagnosis;
    std::shared_ptr<const Picture> mine;  // the user's picture as bytes, without its display mistakes
    std::vector<Picture> thumbnails;      // the scene with each candidate's mistakes, at thumbnail_size()
};

/// An experiment that was applied to the scene, and the resulting scene, without mistakes.
struct TriedExperiment {
    Experiment experiment;
    Scene scene;
};

/// A picture as stored in its file, and as bytes (see as_shown() and as_arrived()).
struct BroughtPicture {
    std::string path;
    std::shared_ptr<const Picture> file, shown;  // null for a shader that cannot be drawn
    Display display;                             // used to convert the picture to bytes
    std::string arrived = {};                    // what as_arrived() undid
    std::optional<WatchedFile> watched = {};     // a watch that began before the file was read
    // For a shader: its text, and its errors and warnings with line numbers (0 if unknown).
    std::string text = {};
    std::vector<Problem> messages = {};
};

/// The text of a shader in the panel.
struct ShaderEditor {
    std::string text, saved;  // `saved`: the text in the file
    bool is_active = false;   // whether the editor has keyboard focus
};

struct MyPictureState {
    std::string path, name;                // of the last file loaded; empty if none
    std::shared_ptr<const Picture> shown;  // the picture as bytes; null without a picture
    std::shared_ptr<const Picture> file;   // the picture as stored in the file
    Display display;                       // used to convert a linear picture to bytes
    std::string arrived;                   // what as_arrived() undid
    bool pairs = false;                    // also search for two mistakes at once
    std::vector<std::string> conventions;  // names in convention_names() that the program is known to follow
    JobPtr<BroughtPicture> reading;
    double reading_since = 0;         // ImGui time when `reading` began
    bool follows = false;             // `reading` reloads the file, and only the picture changes
    JobPtr<std::monostate> watching;  // finishes when the file changes
    bool is_outdated = false;         // the current file cannot be shown; `messages` gives the reason
    std::vector<Problem> messages;    // about the file
    Scene drawn_of;                   // the scene, without mistakes, that the shader is drawing or has drawn
    ShaderEditor editor;
    ChildLimits shader_limits;
    std::vector<std::string> verdicts;  // the newest three, newest first, with their times
    JobPtr<PictureAnswer> job;
    JobPtr<PictureAnswer> ending;         // the last cancelled diagnosis
    Scene asked_of;                       // the open scene, without mistakes, that is or will be diagnosed
    double asked_since = 0;               // ImGui time when `asked_of` was set
    bool settled = false;                 // `asked_of` was diagnosed, or the user cancelled
    bool current = false;                 // `answer` belongs to `asked_of`
    std::optional<PictureAnswer> answer;  // the last result
    std::optional<TriedExperiment> tried;
    std::size_t chosen = 0;                     // index of the candidate shown in the equation
    PictureSheet sheet;                         // thumbnails of the candidates
    std::unique_ptr<Renderer> right, mistaken;  // draw the picked pixel for the equation
};

extern const FilePurpose my_picture_purpose, my_shader_purpose, blank_shader_purpose;
/// Starts loading a picture drawn by any program, or drawing a shader (docs/shader.md); once complete, it
/// replaces the previous one. If it cannot be read, a notification reports that and nothing changes.
void bring_picture(UiState& state, const std::string& path);
/// Starts reloading the picture's file.
void read_again(UiState& state);
/// Removes the picture, restores the previous comparison and tab, and cancels running computations.
void put_picture_away(UiState& state);
/// Cancels the diagnosis. The next one begins when the scene changes or ask_again() is called.
void cancel_diagnosis(MyPictureState& mine);
void ask_again(MyPictureState& mine);
/// Starts a new diagnosis of all pairs of mistakes, which takes longer.
void ask_for_pairs(MyPictureState& mine);
/// Why no search for two mistakes is needed; empty if no single mistake explains the picture but two might.
[[nodiscard]] std::string why_no_pairs(const MyPictureState& mine);

[[nodiscard]] bool is_shader(const std::string& path);
/// Draws the scene with the shader in the file `path`. Problem: the file cannot be read, or shaders cannot
/// draw the scene.
[[nodiscard]] Result<BroughtPicture> drawn_by_shader(const std::string& path, const Scene& scene,
                                                     PictureSize size, const ChildLimits& limits);
/// Draws the editor of the shader, initially folded.
void shader_editor(UiState& state);
/// Writes the editor's text to the file and draws it.
void save_shader(UiState& state);

/// The size of a candidate's thumbnail, for a picture of size `size`.
[[nodiscard]] PictureSize thumbnail_size(PictureSize size);

/// The mistakes' titles as in the Mistakes tab: "Normals flipped + gamma twice".
[[nodiscard]] std::string title_of(const MistakeSet& mistakes);
[[nodiscard]] std::string title_of(const Candidate& candidate);

/// Switches these mistakes on and all others off; if exactly these are on, switches them off.
void switch_mistakes(Scene& scene, const MistakeSet& mistakes);

/// The finding in short: "no mistake", "Normals flipped".
[[nodiscard]] std::string finding_of(const Diagnosis& diagnosis);

/// Picks the pixel that corresponds to this pixel of the user's picture.
void pick_pixel_of_mine(UiState& state, glm::ivec2 pixel);
/// Applies the experiment to the scene and picks the decisive pixel, as one undo step. A notification reports
/// if it cannot be applied.
void try_experiment(UiState& state, const Experiment& experiment);
/// The answer's experiment; null if there is none, if the open scene is not the diagnosed one, or if
/// the experiment has already been applied.
[[nodiscard]] const Experiment* offered_experiment(const UiState& state);
/// The experiment that is applied to the open scene; null: none.
[[nodiscard]] const Experiment* shown_experiment(const UiState& state);

/// The tab that lists the findings. Hovering over a candidate previews the scene with its mistakes;
/// clicking switches them on.
void my_picture_tab(UiState& state, const PictureView& view);

/// The picked pixel in the user's picture, when shaded correctly, and with the chosen candidate's mistakes.
struct PixelOfMine {
    glm::ivec2 place{0};  // in the user's picture
    Rgb mine{};           // with display mistakes removed
    Explanation right;
    std::optional<Explanation> mistaken;  // nullopt without a candidate
};
/// Returns nothing without a picture or a picked pixel, or if the picture does not cover the pixel.
[[nodiscard]] std::optional<PixelOfMine> pixel_of_mine(UiState& state);
/// Draws the picked pixel into the equation tab, term by term; nothing without a picture.
void my_pixel(UiState& state);

/// Draws a colour with its bytes and a label.
void colour_line(const char* what, Rgb colour);

}  // namespace glint
