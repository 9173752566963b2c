#pragma once
// The scenes that come with the program, each with its picture and its caption, in the order of the lecture.

#include <memory>
#include <string>
#include <vector>

#include "ui/document/job.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

struct UiState;

struct Example {
    std::string path;   // of the scene file
    std::string title;  // "Lost highlight", of lost-highlight.json
    std::string about;  // the scene's caption; empty until it has been read
    bool operator==(const Example&) const = default;
};

/// The scene files of `folder`: those that its lecture_order.txt names, in that order, then the others by
/// name.
[[nodiscard]] std::vector<Example> examples_in(const std::string& folder);

/// A scene that was read and drawn beside.
struct DrawnExample {
    std::string about;
    Picture picture;
};
struct DrawnExamples;  // what the job has finished so far

struct ExamplesState {
    bool open = false;
    std::vector<Example> list;
    PictureSheet sheet;  // of the list, drawn beside while the dialog is open for the first time
    std::shared_ptr<DrawnExamples> drawn;
    std::unique_ptr<Job<int>> job;
    int taken = 0;  // of the list, onto the sheet
};

/// Opens the dialog; a click in it opens a scene.
void open_examples(UiState& state);
/// Draws it. Precondition: it is open.
void examples_dialog(UiState& state);

}  // namespace glint
