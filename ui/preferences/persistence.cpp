#include "ui/preferences/persistence.h"

#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "models/io/file.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_of_rest = 1;
constexpr std::size_t longest_file = 1 << 18;
constexpr const char* settings_file = "window.json";

Preferences remembered(const Persistence& memory) {
    const Result<std::string> text = read_file(memory.file(settings_file), longest_file);
    return read_preferences(problem_of(text) == nullptr ? std::get<std::string>(text) : "");
}

Result<std::monostate> write_settings(const Persistence& memory) {
    if (auto problem = why_no_folder(memory.folder))
        return *problem;  // the file may have been removed in the meantime
    return write_file_at_once(memory.file(settings_file), preferences_text(memory.preferences));
}

void note_recent(UiState& state) {
    Persistence& memory = state.persistence;
    // The path is the lesson's until its scene is saved under another name.
    const std::string& scene = state.editor.document.path;
    const std::string& path = scene.empty() ? state.editor.source.path : scene;
    if (path == memory.opened) return;
    memory.opened = path;
    memory.preferences.recent = with_recent_file(memory.preferences.recent, path);
}

/// Writes the preferences. If several windows are open, the last one to write wins.
void write_preferences(UiState& state) {
    Persistence& memory = state.persistence;
    if (memory.preferences == memory.written) return;
    memory.written = memory.preferences;  // a failed write is retried after the next change
    const Result<std::monostate> written = write_settings(memory);
    if (const Problem* problem = problem_of(written)) tell_not_kept(state, "The window's settings", *problem);
}

void note_preferences(UiState& state) {
    Persistence& memory = state.persistence;
    Preferences now = memory.preferences;
    now.dark = state.dark;
    now.layout = state.layout;
    now.kept_views = state.kept_views;
    now.features = features_to_remember(state);
    LayoutState& layout = now.layout;  // hidden bars and projector mode are temporary
    layout.lesson = layout.hides_columns = layout.hides_all = false;
    if (std::exchange(layout.projector, false)) {
        layout.left = std::exchange(layout.left_before, true);
        layout.right = std::exchange(layout.right_before, true);
    }
    const double time = ImGui::GetTime();
    if (!(now == memory.preferences)) memory.preferences_changed = time;
    memory.preferences = now;
    if (memory.preferences == memory.written) return;
    const double rest = memory.preferences_changed + seconds_of_rest - time;
    if (rest > 0) return redraw_within(rest);
    write_preferences(state);
}

}  // namespace

std::string state_folder() {
    const char* given = std::getenv("XDG_STATE_HOME");
    if (given != nullptr && fs::path(given).is_absolute()) return (fs::path(given) / "glint").string();
    const char* home = std::getenv("HOME");
    if (home == nullptr || !fs::path(home).is_absolute()) return {};
    return (fs::path(home) / ".local" / "state" / "glint").string();
}

std::optional<Problem> why_no_folder(const std::string& folder) {
    const char* const expected = "a folder of your own";
    if (folder.empty())
        return Problem{"", "", "neither $XDG_STATE_HOME nor $HOME is set to an absolute path", expected};
    std::error_code failed;
    // Only the user may read a copy of unsaved work, because the scene's own file may be private.
    if (fs::create_directories(folder, failed)) fs::permissions(folder, fs::perms::owner_all, failed);
    if (failed) return Problem{folder, "", "cannot be created: " + failed.message(), expected};
    return {};
}

std::string Persistence::file(const char* name) const { return (fs::path(folder) / name).string(); }

bool can_keep(UiState& state, const std::string& what) {
    const Persistence& memory = state.persistence;
    if (memory.folder.empty() && memory.no_folder) tell_not_kept(state, what, *memory.no_folder);
    return !memory.folder.empty();
}

void tell_not_kept(UiState& state, const std::string& what, const Problem& why) {
    if (std::exchange(state.persistence.told_not_kept, true)) return;
    state.notifications.add(Tone::Warning, fmt::format("{} cannot be remembered: {}", what, why.text()));
}

Json features_to_remember(const UiState& state) {
    Json json = Json::object();
    for (const Feature* feature : features())
        if (feature->write_settings != nullptr) feature->write_settings(state, json);
    return json;
}

void recall_features(UiState& state, const Json& json) {
    for (const Feature* feature : features())
        if (feature->read_settings != nullptr) feature->read_settings(state, json);
}

void begin_persistence(UiState& state, const std::string& folder) {
    Persistence& memory = state.persistence;
    memory.no_folder = why_no_folder(folder);
    if (memory.no_folder) return;
    memory.folder = folder;
    memory.preferences = remembered(memory);
    state.dark = memory.preferences.dark;
    state.layout = memory.preferences.layout;
    state.kept_views = memory.preferences.kept_views;
    recall_features(state, memory.preferences.features);
    memory.preferences.features = features_to_remember(state);
    memory.written = memory.preferences;
    memory.orphans = orphaned_autosaves(folder);
}

void poll_persistence(UiState& state) {
    if (const auto& why = state.persistence.no_folder; why && state.editor.unsaved())
        tell_no_copy(state, *why);
    if (state.persistence.folder.empty()) return;
    note_recent(state);
    note_preferences(state);
    poll_unsaved_work(state);
}

void end_persistence(UiState& state, bool keeps_copy) {
    Persistence& memory = state.persistence;
    if (memory.folder.empty()) return;
    if (!keeps_copy) drop_autosave(state);
    note_recent(state);
    write_preferences(state);
}

void reset_layout(UiState& state) {
    state.layout = {};
    state.dark = true;
    put_away(state);
    recall_features(state, Json::object());
    state.persistence.preferences.width = state.persistence.preferences.height = 0;
    state.persistence.preferences.maximized = false;
}

}  // namespace glint
