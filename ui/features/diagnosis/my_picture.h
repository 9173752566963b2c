#pragma once
// The user's own program drew a picture of the open scene: it joins the comparison, a diagnosis runs in the
// background, and the findings are listed, tried on the scene, and written into the equation.

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/diagnose.h"
#include "renderer/explain/explanation.h"
#include "renderer/renderer.h"
#include "ui/document/file_dialog.h"
#include "ui/document/job.h"
#include "ui/features/views/compare_view.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

struct UiState;
struct PictureView;

/// What a diagnosis has to show.
struct PictureAnswer {
    Diagnosis diagnosis;
    std::shared_ptr<const Picture> mine;  // bytes, with what happened at the display taken away
    std::vector<Picture> thumbnails;      // of the scene under each candidate, as small as thumbnail_size()
};

/// An experiment that was applied to the scene, and the scene that it made, without mistakes.
struct TriedExperiment {
    Experiment experiment;
    Scene scene;
};

/// A picture as its file has it, and as bytes (see as_shown()): the same if the file holds bytes.
struct BroughtPicture {
    std::string path;
    std::shared_ptr<const Picture> file, shown;
    Display display;  // that made the bytes
};

struct MyPictureState {
    std::string path, name;                // of the file that was brought last; empty: none was
    std::shared_ptr<const Picture> shown;  // its bytes; null: there is no picture
    std::shared_ptr<const Picture> file;   // as the file has it
    Display display;                       // that made the bytes of a linear one
    bool pairs = false;                    // two mistakes at once are looked for, too
    JobPtr<BroughtPicture> reading;
    double reading_since = 0;  // ImGui's time when it began
    JobPtr<PictureAnswer> job;
    JobPtr<PictureAnswer> ending;         // the diagnosis cancelled last
    Scene asked_of;                       // the open scene without mistakes, as it is diagnosed, or will be
    double asked_since = 0;               // ImGui's time when it became so
    bool settled = false;                 // `asked_of` was diagnosed, or somebody gave that up
    bool current = false;                 // `answer` is of `asked_of`
    std::optional<PictureAnswer> answer;  // the last one
    std::optional<TriedExperiment> tried;
    std::size_t chosen = 0;                     // candidate that the equation shows
    PictureSheet sheet;                         // of the candidates
    std::unique_ptr<Renderer> right, mistaken;  // what the equation asks at the picked pixel
};

extern const FilePurpose my_picture_purpose;
/// Begins to read a picture drawn by any program; once complete it replaces the one before. If it cannot be
/// read, a notification says so and everything stays.
void bring_picture(UiState& state, const std::string& path);
/// Removes the picture, restores the comparison and the tab from before it, and cancels what is being
/// computed.
void put_picture_away(UiState& state);
/// The picture that is being read is not brought.
void cancel_reading(MyPictureState& mine);
/// Gives the diagnosis up until the scene changes, or ask_again().
void cancel_diagnosis(MyPictureState& mine);
void ask_again(MyPictureState& mine);
/// The diagnosis anew, of every two mistakes at once, which takes longer.
void ask_for_pairs(MyPictureState& mine);
/// Why there is no need for that; empty: no single mistake explains the picture, and two may.
[[nodiscard]] std::string why_no_pairs(const MyPictureState& mine);

/// Call this once a frame. It takes finished results, and begins a new diagnosis when the scene, apart from
/// its mistakes, has changed and stood still for a moment.
void poll_my_picture(UiState& state);

/// Whether the file is a picture without a scene that Glint could open.
[[nodiscard]] bool is_bare_picture(const std::string& path);

/// The size of a small picture of a candidate, for a picture of that size.
[[nodiscard]] PictureSize thumbnail_size(PictureSize size);

/// "Normals flipped + gamma twice", as the Mistakes tab names them.
[[nodiscard]] std::string title_of(const MistakeSet& mistakes);

/// Switches these mistakes on and all others off; if just these are on, switches them off.
void switch_mistakes(Scene& scene, const MistakeSet& mistakes);

/// Applies the experiment to the scene and picks the pixel that tells, as one step to undo. A notification
/// says if it cannot be applied.
void try_experiment(UiState& state, const Experiment& experiment);
/// The experiment of the answer, where the scene is as it was asked about and does not show it yet; null:
/// none.
[[nodiscard]] const Experiment* offered_experiment(const UiState& state);
/// The experiment that the open scene shows now; null: none.
[[nodiscard]] const Experiment* shown_experiment(const UiState& state);

/// The tab that lists what was found. Resting on a candidate shows the scene under it, a click keeps it.
void my_picture_tab(UiState& state, const PictureView& view);

/// The picked pixel: in the user's picture, as it should be, and as the chosen candidate makes it.
struct PixelOfMine {
    glm::ivec2 place{0};  // in the picture
    Rgb mine{};           // with what happened at the display taken away
    Explanation right;
    std::optional<Explanation> mistaken;  // nothing without a candidate
};
/// Returns nothing if there is no picture, no pixel is picked, or the picture does not reach there.
[[nodiscard]] std::optional<PixelOfMine> pixel_of_mine(UiState& state);
/// Draws it into the equation tab, term by term; nothing without a picture.
void my_pixel(UiState& state);

/// Draws a colour with its bytes, and what it is.
void colour_line(const char* what, Rgb colour);

}  // namespace glint
