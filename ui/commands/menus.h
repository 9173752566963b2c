#pragma once
// What is filled from the table of commands: the menus, the sheet of keys, and the palette.

#include <functional>
#include <string>
#include <vector>

#include "ui/document/scene_edit.h"

namespace glint {

struct UiState;
struct UiInput;

/// One thing that the palette can do.
struct PaletteEntry {
    std::string name, group;  // "Phong shading", "Action": what is shown, and what kind of thing it is
    std::string keys;         // that do the same; or empty
    std::string refused;      // why it cannot be done now; empty when it can
    std::function<void(UiState&)> run;
    std::string words = "";  // what it is about: found by whole words of it, after all names
};

struct PaletteState {
    bool open = false, appearing = false;
    std::string text;
    int chosen = 0;  // of those that match
    std::vector<PaletteEntry> entries;
    ItemCounts made_for;  // of the scene: entries name its lights and objects by number
};

/// Between ImGui::BeginMenuBar() and EndMenuBar().
void menu_bar(UiState& state);

/// The sheet of keys and of what the mouse does (F1 or ?), while it is open.
void shortcuts_sheet(UiState& state);

// Ctrl+K: type a few letters of anything that the window can do.

/// Everything there is to do in this state: the actions, the fields of the scene, the choices and switches of
/// shading and display, mistakes, presets for the selected object, lights to switch and items to select,
/// scenes to open.
[[nodiscard]] std::vector<PaletteEntry> palette_entries(const UiState& state);

/// Indices of the entries that match, best first; all of them, in their order, for an empty text. By names,
/// then by names with their groups, then by words that begin so.
[[nodiscard]] std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries,
                                               const std::string& text);
/// Where nothing matches: the word of a name that is written most like the text; empty where not even half of
/// the letters agree.
[[nodiscard]] std::string nearest_word(const std::vector<PaletteEntry>& entries, const std::string& text);

void open_palette(UiState& state);
void palette(UiState& state, const UiInput& input);

}  // namespace glint
