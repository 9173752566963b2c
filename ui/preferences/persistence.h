#pragma once
// What outlives the window: its settings, and a copy of unsaved work.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/json/json.h"
#include "models/problem.h"
#include "models/scene/camera.h"
#include "ui/document/job.h"
#include "ui/preferences/autosave.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

// The window's settings: theme, columns, its size, views kept by hand, what features remember, recent files.
// They are in one small JSON file, which is read as untrusted. What is over the picture or in place of it
// begins switched off: a picture that begins in false colours reads as a broken one.

inline constexpr std::size_t max_recent_files = 12;

struct Preferences {
    bool dark = true;
    LayoutState layout;
    int width = 0, height = 0;  // of the window, in its own units; 0: as the display suggests
    bool maximized = false;
    std::vector<Camera> kept_views;   // at most max_views
    Json features = Json::object();   // as features write it (Feature::write_settings)
    std::vector<std::string> recent;  // files opened or saved, newest first: at most max_recent_files
    bool operator==(const Preferences&) const = default;
};

[[nodiscard]] Json features_to_remember(const UiState& state);
/// Gives each feature what it remembers. Untrusted.
void recall_features(UiState& state, const Json& json);

/// Writes them as JSON that ends with a newline. What is written reads back equal.
[[nodiscard]] std::string preferences_text(const Preferences& preferences);

/// Reads untrusted JSON: invalid or missing members keep their defaults, and numbers out of their range are
/// brought into it.
[[nodiscard]] Preferences read_preferences(const std::string& text);

// Members of untrusted JSON: an invalid or missing one leaves the value as it is.

void read_member(const Json& json, const char* name, bool& value);
/// Clamped to low .. high.
void read_member(const Json& json, const char* name, int& value, int low, int high);
void read_member(const Json& json, const char* name, float& value, float low, float high);
/// A place on the picture, in shares of its size. One that waits outside of the picture comes to its edge.
[[nodiscard]] Json share_json(glm::dvec2 share);
void read_share(const Json& json, const char* name, glm::dvec2& value);

/// `paths` with `path`, made absolute, in front. "-", an empty path and one with control characters are not
/// remembered.
[[nodiscard]] std::vector<std::string> with_recent_file(const std::vector<std::string>& paths,
                                                        const std::string& path);

struct Persistence {
    std::string folder;                    // empty: nothing is remembered
    std::optional<Problem> no_folder;      // why begin_persistence() found none
    Preferences preferences, written;      // as they are; as last written to the file
    double preferences_changed = 0;        // ImGui's time
    std::string opened;                    // the path of the open file, the first of the recent ones
    std::optional<AutosaveLock> autosave;  // of this process, while work is unsaved
    std::optional<Scene> autosaved_scene;  // in the copy, or will be when it is written
    double autosaved_at = -1e9;            // ImGui's time
    JobPtr<std::monostate> autosave_writing;
    bool autosave_failed = false;           // and the user was told so
    bool told_not_kept = false;             // that what was asked to be kept is not
    std::vector<OrphanedAutosave> orphans;  // by processes that are gone: offered one by one

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

/// Once a frame: saves settings that have been unchanged for a second, and unsaved work.
void poll_persistence(UiState& state);

/// Writes changed settings at once. Removes the copy of the unsaved work, unless `keeps_copy`.
void end_persistence(UiState& state, bool keeps_copy = false);

/// Columns, theme, sizes and what features remember as in a first window; kept views stay.
void reset_layout(UiState& state);

// The copy of unsaved work (unsaved_work.cpp).

/// Once a frame, where there is a folder: writes the copy every few seconds while something is unsaved, and
/// removes it when the scene is saved or given up.
void poll_unsaved_work(UiState& state);

/// Reports that there can be no copy, once until one could be written again.
void tell_no_copy(UiState& state, const Problem& problem);

/// Removes the copy.
void drop_autosave(UiState& state);

/// Writes the copy of the unsaved work, if there is any, for a window that cannot go on. Returns true if
/// there is a copy for the next window to offer.
bool keep_unsaved_work(UiState& state);

/// The left copy `path`, which has been opened, becomes this process's own.
void keep_orphan(UiState& state, const std::string& path);

}  // namespace glint
