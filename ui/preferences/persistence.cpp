#include "ui/preferences/persistence.h"

#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "models/io/file.h"
#include "models/io/temporary.h"
#include "ui/picture/orbit.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_of_rest = 1, seconds_between_asking = 0.02;
constexpr std::size_t longest_memory = 1 << 16;

constexpr const char* kept_views_words = "Kept views";

std::string text_of(const Persistence& memory, const char* name) {
    const Result<std::string> text = read_file(memory.file(name), longest_memory);
    return problem_of(text) == nullptr ? std::get<std::string>(text) : "";
}

/// Writes a file of the folder; returns why it could not. Most failures are not reported: nothing that
/// the user made is lost.
std::optional<Problem> write(const Persistence& memory, const char* name, const std::string& text) {
    if (auto problem = why_no_folder(memory.folder)) return problem;  // it may have been removed meanwhile
    const Result<std::monostate> written = write_file_at_once(memory.file(name), text);
    const Problem* problem = problem_of(written);
    return problem == nullptr ? std::nullopt : std::optional(*problem);
}

/// The file to open again: a lesson's, as long as what it shows was not saved under a name.
const std::string& open_file(const UiState& state) {
    const std::string& scene = state.editor.document.path;
    return scene.empty() && state.lesson.course ? state.lesson.course->lesson.path : scene;
}

/// False when another window has the list just now, for longer than `patience` seconds.
bool note_recent(UiState& state, double patience = 0) {
    Persistence& memory = state.persistence;
    const std::string& path = open_file(state);
    if (path == memory.opened) return true;
    // Other windows write there too: their files stay in the list.
    const FolderLock lock(memory.folder, patience);
    if (!lock.held()) return false;
    memory.opened = path;
    memory.recent = with_recent_file(read_recent_files(text_of(memory, "recent.json")), path);
    (void)write(memory, "recent.json", recent_files_text(memory.recent));
    return true;
}

/// Views that other windows have kept stay. False when one of them writes for longer than `patience` seconds.
bool write_preferences(UiState& state, double patience = 0) {
    Persistence& memory = state.persistence;
    if (memory.preferences == memory.written) return true;
    const FolderLock lock(memory.folder, patience);
    if (!lock.held()) return false;
    Preferences all = memory.preferences;
    const std::string text = text_of(memory, "window.json");
    if (!text.empty())
        all.views.kept = with_changed_views(read_preferences(text).views.kept, memory.written.views.kept,
                                            memory.preferences.views.kept);
    memory.tried = memory.preferences;
    const std::optional<Problem> failed = write(memory, "window.json", preferences_text(all));
    if (!failed)
        memory.written = memory.preferences;
    else if (memory.preferences.views.kept != memory.written.views.kept)
        tell_not_kept(state, kept_views_words, *failed);
    return true;
}

void note_preferences(UiState& state) {
    Persistence& memory = state.persistence;
    Preferences now = memory.preferences;
    now.dark = state.dark;
    now.layout = state.layout;
    now.views = views_to_remember(state);
    now.layout.lesson = now.layout.hides_columns = now.layout.hides_all =
        false;  // the picture alone is for a moment
    if (state.lecture.projector) {
        now.layout.left = state.lecture.left_before;
        now.layout.right = state.lecture.right_before;
    }
    const double time = ImGui::GetTime();
    if (!(now == memory.preferences)) memory.preferences_changed = time;
    memory.preferences = now;
    if (memory.preferences == memory.written || memory.preferences == memory.tried) return;
    const double rest = memory.preferences_changed + seconds_of_rest - time;
    if (rest > 0) return redraw_within(rest);
    if (!write_preferences(state)) redraw_within(seconds_between_asking);
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
    // A copy of unsaved work must not be readable by people who may not read the scene's own file.
    if (fs::create_directories(folder, failed)) fs::permissions(folder, fs::perms::owner_all, failed);
    if (failed) return Problem{folder, "", "cannot be made: " + failed.message(), expected};
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

void begin_persistence(UiState& state, const std::string& folder) {
    Persistence& memory = state.persistence;
    memory.no_folder = why_no_folder(folder);
    if (memory.no_folder) return;
    memory.folder = folder;
    memory.recent = read_recent_files(text_of(memory, "recent.json"));
    memory.preferences = memory.written = read_preferences(text_of(memory, "window.json"));
    state.dark = memory.preferences.dark;
    state.layout = memory.preferences.layout;
    recall_views(state, memory.preferences.views);
    memory.orphans = orphaned_autosaves(folder);
    for (const OrphanedAutosave& copy : memory.orphans) memory.offered.insert(copy.lock.path());
}

void poll_persistence(UiState& state) {
    if (const auto& why = state.persistence.no_folder) {
        if (state.editor.unsaved()) tell_no_copy(state, *why);
        if (!state.kept_views.empty()) tell_not_kept(state, kept_views_words, *why);
    }
    if (state.persistence.folder.empty()) return;
    if (!note_recent(state)) redraw_within(seconds_between_asking);
    note_preferences(state);
    poll_unsaved_work(state);
}

void end_persistence(UiState& state, bool keeps_copy) {
    Persistence& memory = state.persistence;
    if (memory.folder.empty()) return;
    if (!keeps_copy) drop_autosave(state);
    (void)note_recent(state, patience_at_end);
    (void)write_preferences(state, patience_at_end);
}

void reset_layout(UiState& state) {
    state.layout = {};
    state.dark = true;
    state.views.scope.open = false;
    ViewPreferences first_day;
    first_day.kept = state.kept_views;
    state.views.compare.choice.on = false;
    state.views.debug_view.set = {};
    state.views.lit = {};
    recall_views(state, first_day);
    state.persistence.preferences.width = state.persistence.preferences.height = 0;
    state.persistence.preferences.maximized = false;
}

}  // namespace glint
