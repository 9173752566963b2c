#pragma once
// The scenes that come with the program, each with a picture and a caption, in lecture order.

#include <string>
#include <vector>

#include "ui/features/views/small_pictures.h"

namespace glint {

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
    int chosen = -1;  // with the arrow keys
    std::vector<Example> list;
    SmallPictures pictures;  // of the list, with the captions; started when the dialog first opens
};

}  // namespace glint
