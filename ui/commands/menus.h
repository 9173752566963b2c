#pragma once
// The menus, the sheet of keys and the palette, which are filled from the table of commands.

#include <imgui.h>

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
    std::string words = "";  // what it is about: found by the beginnings of these words, too
    bool quiet = false;      // allowed while a question waits
};

struct PaletteState {
    bool open = false;
    bool takes_keyboard = false;  // in the next frame: it appears, or Enter took the keyboard from its text
    std::string text;
    int chosen = -1;  // of those that match; -1: none, until something is typed or an arrow key pressed
    std::vector<PaletteEntry> entries;
    std::vector<int> matches;          // of the entries, for the text
    ItemCounts made_for;               // of the scene: entries name its lights and objects by number
    bool has_keyboard = false;         // its text, since the frame before
    std::vector<ImWchar> typed_ahead;  // until then
};

/// Draws the menus; called between ImGui::BeginMenuBar() and EndMenuBar().
void menu_bar(UiState& state);

/// The sheet of keys and of what the mouse does (F1 or ?), while it is open.
void shortcuts_sheet(UiState& state);

// The palette (Ctrl+K) finds anything that the window can do from a few typed letters.

/// Lists everything that can be done in this state: actions, fields of the scene, choices and switches of
/// shading and display, mistakes, presets for the selected object, lights to switch, items to select and
/// scenes to open.
[[nodiscard]] std::vector<PaletteEntry> palette_entries(UiState& state);

/// Adds the entries that follow from the rows of models/fields/scene_fields.h.
void add_field_entries(std::vector<PaletteEntry>& entries, const UiState& state);

/// Returns the indices of the entries that match, best first, equal ones in their order; for an empty text
/// all of them.
[[nodiscard]] std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries,
                                               const std::string& text);

void open_palette(UiState& state);
void palette(UiState& state, const UiInput& input);

}  // namespace glint
