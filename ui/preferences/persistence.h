#pragma once
// Data that persists after the window closes: its settings, and a copy of unsaved work.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/json/json.h"
#include "models/problem.h"
#include "models/scene/scene.h"
#include "ui/document/job.h"
#include "ui/preferences/autosave.h"
#include "ui/shell/layout.h"

namespace glint {

struct UiState;

// The window's settings: theme, columns, size, saved views, settings of features, recent files. Stored in one
// small JSON file, which is read as untrusted. Overlays and replacements of the picture start switched off: a
// picture that starts in false colours looks broken.

inline constexpr std::size_t max_recent_files = 12;

struct Preferences {
    bool dark = true;
    LayoutState layout;
    int width = 0, height = 0;  // size of the window, in its own units; 0: the default for the display
    bool maximized = false;
    std::vector<Camera> kept_views;   // at most max_views
    Json features = Json::object();   // written by features (Feature::write_settings)
    std::vector<std::string> recent;  // opened or saved files, newest first: at most max_recent_files
    bool operator==(const Preferences&) const = default;
};

[[nodiscard]] Json features_to_remember(const UiState& state);
/// Passes each feature its stored settings. The JSON is untrusted.
void recall_features(UiState& state, const Json& json);

/// Returns JSON that ends with a newline and parses to equal preferences.
[[nodiscard]] std::string preferences_text(const Preferences& preferences);

/// Reads untrusted JSON: invalid or missing members keep their defaults, and numbers are clamped to their
/// range.
[[nodiscard]] Preferences read_preferences(const std::string& text);

// Members of untrusted JSON: an invalid or missing one leaves the value as it is.

void read_member(const Json& json, const char* name, bool& value);
/// Clamps the value to [low, high].
void read_member(const Json& json, const char* name, int& value, int low, int high);
void read_member(const Json& json, const char* name, float& value, float low, float high);
/// A position in the picture, as a fraction of its size. A position outside the picture is clamped to its
/// edge.
[[nodiscard]] Json share_json(glm::dvec2 share);
void read_share(const Json& json, const char* name, glm::dvec2& value);

/// Returns `paths` with `path`, made absolute, at the front. Does not add "-", an empty path or a path with
/// control characters.
[[nodiscard]] std::vector<std::string> with_recent_file(const std::vector<std::string>& paths,
                                                        const std::string& path);

struct Persistence {
    std::string folder;                    // empty: nothing is remembered
    std::optional<Problem> no_folder;      // why begin_persistence() could not use the folder
    Preferences preferences, written;      // current; as last written to the file
    double preferences_changed = 0;        // ImGui time
    std::string opened;                    // path of the open file, the first of the recent files
    std::optional<AutosaveLock> autosave;  // lock of this process's copy, while work is unsaved
    std::optional<Scene> autosaved_scene;  // the scene in the copy, or in the copy being written
    double autosaved_at = -1e9;            // ImGui time
    JobPtr<std::monostate> autosave_writing;
    bool autosave_failed = false;           // a write failed, and the user has been notified
    bool told_not_kept = false;             // the user knows that a requested setting cannot be kept
    std::vector<OrphanedAutosave> orphans;  // left behind by processes that have ended; offered one by one

    /// Returns the path of a file in the folder. Precondition: there is a folder.
    [[nodiscard]] std::string file(const char* name) const;
    /// Whether the copy contains `scene`.
    [[nodiscard]] bool has_copy_of(const Scene& scene) const {
        return autosaved_scene && same_description(*autosaved_scene, scene);
    }
};

/// Returns $XDG_STATE_HOME/glint, else ~/.local/state/glint; empty if neither is available. Source: XDG Base
/// Directory Specification 0.8 (relative paths are to be ignored).
[[nodiscard]] std::string state_folder();

/// Creates the folder if it is missing; returns why it cannot be used.
[[nodiscard]] std::optional<Problem> why_no_folder(const std::string& folder);

/// Reports once per window that something cannot be kept although the user expects it to be. `what`: the
/// subject of the message, such as "Answers".
void tell_not_kept(UiState& state, const std::string& what, const Problem& why);
/// Returns whether there is a folder for something that the user expects to be kept. Reports a missing folder
/// if one was requested.
[[nodiscard]] bool can_keep(UiState& state, const std::string& what);

/// Reads the settings in `folder`, which is created if needed. Call this before the first frame. Without a
/// usable folder nothing is remembered, and the first unsaved edit reports that no copy is kept.
void begin_persistence(UiState& state, const std::string& folder);

/// Called once per frame: saves settings that have been unchanged for a second, and unsaved work.
void poll_persistence(UiState& state);

/// Writes changed settings at once. Removes the copy of the unsaved work unless `keeps_copy`.
void end_persistence(UiState& state, bool keeps_copy = false);

/// Resets columns, theme, sizes and the settings of features, but not the saved views.
void reset_layout(UiState& state);

// The copy of unsaved work (unsaved_work.cpp).

/// Called once per frame if there is a folder: writes the copy every few seconds while something is unsaved,
/// and removes it when the scene is saved or discarded.
void poll_unsaved_work(UiState& state);

/// Reports that no copy can be written, but only once until a copy can be written again.
void tell_no_copy(UiState& state, const Problem& problem);

void drop_autosave(UiState& state);

/// Writes the copy of unsaved work, if there is any, when the window has to close immediately. Returns true
/// if there is a copy that the next window can offer.
bool keep_unsaved_work(UiState& state);

/// Makes the orphaned copy `path`, which has been opened, this process's own copy.
void keep_orphan(UiState& state, const std::string& path);

}  // namespace glint
