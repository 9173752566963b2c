#pragma once
// What outlives the window: recent files, settings, and a copy of unsaved work.

#include <future>
#include <optional>
#include <string>
#include <vector>

#include "models/problem.h"
#include "ui/preferences/autosave.h"
#include "ui/preferences/settings.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

struct Memory {
    std::string folder;                // empty: nothing is remembered
    std::vector<std::string> recent;   // newest first
    Settings settings, written;        // as they are; as the file has them
    double settings_changed = 0;       // ImGui's time
    std::string opened;                // the document's path that stands first among the recent ones
    std::optional<AutosaveLock> copy;  // of the unsaved work, while there is some
    std::optional<Scene> copied;       // what it holds, or will when `copying` has come to its end
    double copied_at = -1e9;           // ImGui's time
    std::future<Result<std::monostate>> copying;
    bool copy_failed = false;    // and the user was told so
    std::vector<LeftCopy> left;  // by windows that are gone: offered one by one
};

/// $XDG_STATE_HOME/glint, else ~/.local/state/glint; empty when there is neither.
/// Source: XDG Base Directory Specification 0.8 (a relative path is to be ignored).
[[nodiscard]] std::string state_folder();

/// Reads what is remembered in `folder`, making it if need be. Before the first frame.
void begin_memory(UiState& state, const std::string& folder);

/// Once a frame: notes what changed, writes what has come to rest.
void tend_memory(UiState& state);

/// The scene was saved, or is given up: its copy goes. For a window that closes too.
void drop_copy(UiState& state);

/// Writes at once what would be written later.
void end_memory(UiState& state);

/// For a window that cannot go on: writes the copy of the unsaved work, if there is any, before it returns.
/// True when there is a copy for the next window to offer.
bool keep_unsaved_work(UiState& state);

/// Columns, theme, sizes and views as on the first day; kept views stay.
void reset_layout(UiState& state);

/// The offer to take up the work that a crash interrupted.
void recovery_panel(UiState& state, const Rect& picture);

/// Takes up a copy that a window left behind: its scene is in hand, not saved.
void take_up_copy(UiState& state, const std::string& path);

}  // namespace glint
