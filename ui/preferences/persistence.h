#pragma once
// What outlives the window: recent files, preferences, and a copy of unsaved work.

#include <future>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "models/problem.h"
#include "models/scene/camera.h"
#include "ui/preferences/autosave.h"
#include "ui/shell/layout.h"
#include "ui/views/compare_view.h"

namespace glint {

struct UiState;

// What the window remembers from one day to the next: theme, columns, its size, how the picture is looked at.
// It stands in a small JSON file, which is read as untrusted.

/// How the picture is looked at, and the views kept by hand. What stands over the picture or in place of it
/// (comparison, scope, debug views, needles) begins switched off: a picture that begins in false colours
/// reads as a broken one.
struct ViewPreferences {
    CompareChoice compare;  // off, and without its B: a scene is not a preference
    glm::dvec2 scope_from{0.02, 0.5}, scope_to{0.98, 0.5};  // shares of the picture's size
    bool scope_channels = false, scope_eye = false;
    std::vector<Camera> kept;  // at most max_views
    bool operator==(const ViewPreferences&) const = default;
};

[[nodiscard]] ViewPreferences views_to_remember(const UiState& state);
/// Looks at the picture that way; a stored B stays.
void recall_views(UiState& state, const ViewPreferences& memory);

struct Preferences {
    bool dark = true;
    LayoutState layout;
    int width = 0, height = 0;  // of the window, in its own units; 0: as the display suggests
    bool maximized = false;
    ViewPreferences views;
    bool operator==(const Preferences&) const = default;
};

/// Writes them as JSON that ends with a newline. What is written reads back equal.
[[nodiscard]] std::string preferences_text(const Preferences& preferences);

/// Reads untrusted JSON: invalid or missing members keep their defaults, and numbers out of their range are
/// brought into it.
[[nodiscard]] Preferences read_preferences(const std::string& text);

// The files opened or saved last, newest first: a list in an untrusted file that several windows share.

inline constexpr std::size_t max_recent_files = 12;

/// Reads the list from JSON: absolute paths without control characters, each once, at most max_recent_files.
/// Anything else is left out.
[[nodiscard]] std::vector<std::string> read_recent_files(const std::string& text);
[[nodiscard]] std::string recent_files_text(const std::vector<std::string>& paths);

/// `paths` with `path`, made absolute, in front. "-" and an empty path are not remembered.
[[nodiscard]] std::vector<std::string> with_recent_file(std::vector<std::string> paths,
                                                        const std::string& path);

struct Persistence {
    std::string folder;                // empty: nothing is remembered
    std::optional<Problem> no_folder;  // why begin_persistence() found none
    std::vector<std::string> recent;   // newest first
    Preferences preferences, written;  // as they are; as the file has them
    std::optional<Preferences>
        tried;                       // that were to be written last: it is not tried again until they change
    double preferences_changed = 0;  // ImGui's time
    std::string opened;              // the path of the open file, that stands first among the recent ones
    std::optional<AutosaveLock> autosave;  // of the unsaved work, while there is some
    std::optional<Scene> autosaved_scene;  // what it holds, or will when it is written
    double autosaved_at = -1e9;            // ImGui's time
    std::future<Result<std::monostate>> autosave_writing;
    bool autosave_failed = false;           // and the user was told so
    bool told_not_kept = false;             // that what was asked to be kept is not
    std::vector<OrphanedAutosave> orphans;  // by windows that are gone: offered one by one
    std::set<std::string> offered;          // their paths, of those found at the start
    bool looked_again = false;              // for copies, a moment after the start

    /// The path of a file in the folder. Precondition: there is one.
    [[nodiscard]] std::string file(const char* name) const;
    /// Whether the copy is of `scene`.
    [[nodiscard]] bool has_copy_of(const Scene& scene) const {
        return autosaved_scene && same_description(*autosaved_scene, scene);
    }
};

/// $XDG_STATE_HOME/glint, else ~/.local/state/glint; empty when there is neither.
/// Source: XDG Base Directory Specification 0.8 (a relative path is to be ignored).
[[nodiscard]] std::string state_folder();

/// Makes the folder if it is not there; why it cannot be used.
[[nodiscard]] std::optional<Problem> why_no_folder(const std::string& folder);

/// Says once in a window that something which the user counts on cannot be kept: "What is answered".
void tell_not_kept(UiState& state, const std::string& what, const Problem& why);
/// Whether there is a folder to keep something in that the user counts on; where one was asked for and there
/// is none, says so.
[[nodiscard]] bool can_keep(UiState& state, const std::string& what);

/// Reads what is remembered in `folder`, making it if need be. Before the first frame. Where there is no such
/// folder nothing is remembered, and the first unsaved edit says that it is not kept.
void begin_persistence(UiState& state, const std::string& folder);

/// Once a frame: saves preferences that have been unchanged for a second, the recent files, and unsaved work.
void poll_persistence(UiState& state);

/// Writes at once what would be written later of preferences and recent files. The copy of the unsaved work
/// goes, unless `keeps_copy`.
void end_persistence(UiState& state, bool keeps_copy = false);

/// Columns, theme, sizes and views as in a first window; kept views stay.
void reset_layout(UiState& state);

// The copy of unsaved work (unsaved_work.cpp).

/// Once a frame, where there is a folder: writes the copy, and looks for those of windows that are gone.
void poll_unsaved_work(UiState& state);

/// Says that there can be no copy, once until one could be written again.
void tell_no_copy(UiState& state, const Problem& problem);

/// Removes the copy once the scene is saved or given up, also when the window closes.
void drop_autosave(UiState& state);

/// Writes the copy of the unsaved work, if there is any, for a window that cannot go on. Returns true if
/// there is a copy for the next window to offer.
bool keep_unsaved_work(UiState& state);

/// The copy that a window left behind and that is in hand now becomes this window's own.
void keep_orphan(UiState& state, const std::string& path);

}  // namespace glint
