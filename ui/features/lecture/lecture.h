#pragma once
// Features for a lecture: large type, a clean picture, freezing, a pen and a step wedge.

#include <imgui.h>

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/scene/scene.h"
#include "ui/document/scene_edit.h"
#include "ui/features/views/small_pictures.h"
#include "ui/picture/screen.h"
#include "ui/picture/tool.h"
#include "ui/widgets/area.h"

namespace glint {

struct UiState;

// A pen that draws over the picture, as on a blackboard. Strokes are not part of the scene or the saved
// picture.

/// A pen stroke. Positions are relative to the picture's centre, in units of its height, so that a stroke
/// stays in place when the window is resized.
struct PenLine {
    std::vector<glm::vec2> places;
    int colour = 0;  // index into pen_colours
    bool operator==(const PenLine&) const = default;
};

struct PenState {
    bool on = false;
    int colour = 0;
    std::vector<PenLine> lines;
};

inline constexpr int pen_colour_count = 5;

void draw_pen(ImDrawList& list, const PenState& pen, const PictureView& view);

/// Draws the pen's colours and its undo and erase buttons at the upper edge of `picture`, the visible part of
/// the picture, while the pen is active.
void pen_bar(PenState& pen, const Rect& picture);

extern const Tool pen_tool;

/// Freezes the shown scene and its selection, until LectureState::frozen is reset.
void freeze(UiState& state);

// The wedge's patches differ little from their background: in a given room, a projector shows only some of
// these differences.

/// Differences in steps of 1/255 of the display's range.
inline constexpr std::array<int, 10> wedge_steps{1, 2, 3, 4, 6, 8, 12, 16, 24, 32};

/// The patches on one background, and the smallest visible difference.
struct WedgeRow {
    const char* name;  // "black"
    int ground;        // 0 .. 255
    int sign;          // patches are ground + sign * step
    int seen = -1;     // index of the smallest visible step; -1: no answer yet; wedge_steps.size(): none
    bool operator==(const WedgeRow&) const = default;
};

struct WedgeState {
    bool open = false;
    std::array<WedgeRow, 3> rows{{{"black", 0, 1}, {"grey", 128, 1}, {"white", 255, -1}}};
};

/// Describes the answer for a row: "On black this projector loses steps below 6/255: colours 0.016 apart look
/// the same"
[[nodiscard]] std::string wedge_words(const WedgeRow& row);

// The scenes of a folder: those listed in its lecture_order.txt, then the others in natural order.

/// The scene files (.json) of a folder in that order, as paths. Hidden files are left out. Returns an empty
/// list if the folder cannot be read.
[[nodiscard]] std::vector<std::string> folder_scenes(const std::string& folder);

/// Returns the scene `step` positions after `path` (before it if `step` is negative) in its folder. If `path`
/// is not in the list, counts from where it would be in sorted order. Empty if there is none.
[[nodiscard]] std::string scene_beside(const std::string& path, int step);

/// The scale of text and widgets: the smallest text grows from 13 units high to 18.
inline constexpr float projector_scale = 1.4f;

/// The scene last requested by PgDn or PgUp.
struct AskedScene {
    std::string from;  // path of the document open at that time
    std::string path;
    int step = 0;  // 1: by PgDn; -1: by PgUp. If opening fails, the next one in that direction is tried
};

struct LectureState {
    std::optional<Scene> frozen;  // shown regardless of edits; set by freeze()
    Selection frozen_selection;   // selection in the frozen scene
    /// The scenes on the command line, a lecture in the user's own order: PgDn and PgUp step through these
    /// while one of them is open, otherwise through the open scene's folder.
    std::vector<std::string> given_scenes;
    /// The last of `given_scenes` that was opened: PgDn and PgUp continue from it if the open scene has no
    /// file.
    std::string last_given;
    AskedScene asked;
};

// The scenes that come with the program, each with a picture and a caption, in lecture order.

struct UiInput;
struct UiState;

struct Example {
    std::string path;   // path of the scene file
    std::string title;  // "Lost highlight", of lost-highlight.json
    bool operator==(const Example&) const = default;
};

/// The scene files of `folder`: those listed in its lecture_order.txt, in that order, then the others by
/// name.
[[nodiscard]] std::vector<Example> examples_in(const std::string& folder);

struct ExamplesState {
    bool open = false;
    int chosen = -1;  // index chosen with the arrow keys; -1: none
    std::vector<Example> list;
    SmallPictures pictures;  // the pictures in the list, with captions; started when the dialog first opens
};

}  // namespace glint
