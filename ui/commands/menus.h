#pragma once
// The menus, the shortcuts sheet and the palette, all built from the table of commands.

#include <imgui.h>

#include <functional>
#include <string>
#include <vector>

#include "ui/document/scene_edit.h"

namespace glint {

struct UiState;
struct UiInput;

/// An entry of the palette.
struct PaletteEntry {
    std::string name, group;  // "Phong shading", "Action": the shown name, and the kind of entry
    std::string keys;         // shortcut, or empty
    std::string refused;      // the reason why it is disabled; empty if it is enabled
    std::function<void(UiState&)> run;
    std::string words = "";  // search terms: also found by the beginnings of these words
    bool quiet = false;      // allowed during a question
};

struct PaletteState {
    bool open = false;
    bool takes_keyboard = false;  // request for the next frame: focus the text
    std::string text;
    int chosen = -1;  // index in the matches; -1: none, until something is typed or an arrow key pressed
    std::vector<PaletteEntry> entries;
    std::vector<int> matches;          // entries that match the text
    ItemCounts made_for;               // scene that the entries' light and object numbers refer to
    float width = 0;                   // required by its entries
    bool has_keyboard = false;         // whether the text had focus in the previous frame
    std::vector<ImWchar> typed_ahead;  // letters typed before the text has focus
};

/// Draws the menus; called between ImGui::BeginMenuBar() and EndMenuBar().
void menu_bar(UiState& state);

/// Draws the sheet of keys and mouse actions (F1 or ?) while it is open.
void shortcuts_sheet(UiState& state);

// The palette (Ctrl+K) finds every action of the window from a few typed letters.

/// Lists all possible actions in this state: commands, fields of the scene, choices and switches of shading
/// and display, mistakes, presets for the selected object, lights to switch, items to select and scenes to
/// open.
[[nodiscard]] std::vector<PaletteEntry> palette_entries(UiState& state);

/// Adds the entries generated from the rows of models/fields/scene_fields.h.
void add_field_entries(std::vector<PaletteEntry>& entries, const UiState& state);

/// Returns the indices of the matching entries, best first, ties in table order; all indices for an empty
/// text.
[[nodiscard]] std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries,
                                               const std::string& text);

void open_palette(UiState& state);
void palette(UiState& state, const UiInput& input);

}  // namespace glint
