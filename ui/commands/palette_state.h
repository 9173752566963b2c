#pragma once
// What the command palette remembers between frames.

#include <functional>
#include <string>
#include <vector>

#include "ui/document/scene_edit.h"

namespace glint {

struct UiState;

/// One thing that the palette can do.
struct PaletteEntry {
    std::string name, group;  // "Phong shading", "Action": what is shown, and what kind of thing it is
    std::string keys;         // that do the same; or empty
    std::string refused;      // why it cannot be done now; empty when it can
    std::function<void(UiState&)> run;
};

struct PaletteState {
    bool open = false, appearing = false;
    std::string text;
    int chosen = 0;  // of those that match
    std::vector<PaletteEntry> entries;
    ItemCounts made_for;  // of the scene: entries name its lights and objects by number
};

}  // namespace glint
