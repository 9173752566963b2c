#pragma once
// Everything that a menu item or a key does, once: menus, keys and the sheet of shortcuts read one table.

#include <span>

#include "ui/ui.h"

namespace glint {

enum class Action {
    New,
    Open,
    Save,
    SaveAs,
    SavePicture,
    Quit,
    Undo,
    Redo,
    Duplicate,
    Delete,
    AddLight,
    FrameAll,
    FrameSelected,
    Fold,
    LeftColumn,
    RightColumn,
    SwitchTheme,
    Shortcuts,
    Flat,
    Facet,
    Gouraud,
    Phong,
    Emission,
    Ambient,
    Diffuse,
    Specular
};

struct ActionInfo {
    Action action;
    const char* name;
    const char* keys;  // as shown; empty when there is none
    KeyPress press;    // Key::Other when there is none
};
[[nodiscard]] std::span<const ActionInfo> actions();
[[nodiscard]] const ActionInfo& info_of(Action action);

[[nodiscard]] bool can_run(const UiState& state, Action action);
/// Does it, if can_run().
void run_action(UiState& state, Action action);
void run_keys(UiState& state, const UiInput& input);

/// Opens a file or begins anew, asking first when changes are not saved.
void begin_pending(UiState& state, Pending pending);
/// Goes on with what waited, after the answer or after saving.
void finish_pending(UiState& state);
/// Saves; asks for a name when there is none yet. True when it is saved now.
bool save(UiState& state);

}  // namespace glint
