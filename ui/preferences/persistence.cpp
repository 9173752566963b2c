#include "ui/preferences/persistence.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "models/io/file.h"
#include "models/memory_limit.h"
#include "ui/picture/orbit.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_between_copies = 5, seconds_of_rest = 1, seconds_between_asking = 0.02;
constexpr std::size_t longest_memory = 1 << 16;

constexpr const char* kept_views_words = "Kept views";

std::string text_of(const Persistence& memory, const char* name) {
    const Result<std::string> text = read_file(memory.file(name), longest_memory);
    return problem_of(text) == nullptr ? std::get<std::string>(text) : "";
}

/// Why it was not written. Of most that cannot be remembered this is not worth a word: nothing that the user
/// made is lost.
std::optional<Problem> write(const Persistence& memory, const char* name, const std::string& text) {
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

/// Says that the copy failed, once until a copy could be written again.
void tell_failed_autosave(UiState& state, const Problem& problem) {
    state.persistence.autosaved_scene.reset();  // the next one is tried in its time
    if (std::exchange(state.persistence.autosave_failed, true)) return;
    state.notifications.add(Tone::Warning,
                            fmt::format("No copy of the unsaved work can be kept: {}; save it to "
                                        "keep it over a crash",
                                        problem.text()));
}

/// Returns the result of the writing; a problem if there was no memory for it. Precondition: it is valid.
Result<std::monostate> result_of(std::future<Result<std::monostate>>& writing) {
    try {
        return writing.get();
    } catch (const std::bad_alloc& error) {
        return memory_problem(error);
    }
}

/// The result of the copy that was being written, when it has come to its end. False while it has not.
bool take_written_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    if (!memory.autosave_writing.valid()) return true;
    if (memory.autosave_writing.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    const Result<std::monostate> written = result_of(memory.autosave_writing);
    if (const Problem* problem = problem_of(written))
        tell_failed_autosave(state, *problem);
    else
        memory.autosave_failed = false;
    return true;
}

/// Takes a name for this window's copy, if it has none yet. False when the folder cannot be written.
bool has_autosave_name(Persistence& memory) {
    if (!memory.autosave) memory.autosave = new_autosave(memory.folder);
    return memory.autosave.has_value();
}

/// Begins to write the copy on a thread of its own, as writing waits for the disk. Returns why it cannot.
/// Precondition: the copy has a name.
std::optional<Problem> begin_writing(Persistence& memory, SceneDocument document) {
    const std::string path = memory.autosave->path();
    Scene scene = document.scene;
    try {
        memory.autosave_writing =
            std::async(std::launch::async, [document = std::move(document), folder = memory.folder, path] {
                return write_file_at_once(path, autosave_text(document, folder));
            });
    } catch (const std::system_error& error) {
        return Problem{path, "", "no thread can write it: " + error.code().message(), ""};
    }
    memory.autosaved_scene = std::move(scene);
    return {};
}

void write_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    memory.autosaved_at = ImGui::GetTime();
    std::optional<Problem> failed =
        has_autosave_name(memory) ? begin_writing(memory, document_as_made(state))
                                  : Problem{memory.folder, "", "cannot be written", "a folder of your own"};
    if (!failed) return;
    tell_failed_autosave(state, *failed);
    redraw_within(seconds_between_copies);
}

/// A window that was killed a moment before this one began may have held its copy's lock still.
void look_again_for_copies(Persistence& memory) {
    constexpr double a_moment = 2;  // seconds
    if (memory.looked_again) return;
    if (ImGui::GetTime() < a_moment) return redraw_within(a_moment - ImGui::GetTime());
    memory.looked_again = true;
    for (OrphanedAutosave& copy : orphaned_autosaves(memory.folder))
        memory.orphans.push_back(std::move(copy));
}

void note_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    if (!state.editor.unsaved()) return drop_autosave(state);
    const bool ended = take_written_autosave(state);
    const Scene& scene = state.editor.scene();
    const bool copied =
        awaits_mesh(state) ? memory.has_copy_of(as_made(state, scene)) : memory.has_copy_of(scene);
    if (copied || state.viewport.gesture != Gesture::None) return;
    const double rest = memory.autosaved_at + seconds_between_copies - ImGui::GetTime();
    if (rest > 0) return redraw_within(rest);
    if (!ended) return redraw_within(0.2);
    write_autosave(state);
}

/// Makes the folder if it is not there; why it cannot be used.
std::optional<Problem> why_no_folder(const std::string& folder) {
    const char* const expected = "a folder of your own";
    if (folder.empty())
        return Problem{"", "", "neither $XDG_STATE_HOME nor $HOME is set to an absolute path", expected};
    std::error_code failed;
    // A copy of unsaved work must not be readable by whom the scene's file keeps out.
    if (fs::create_directories(folder, failed)) fs::permissions(folder, fs::perms::owner_all, failed);
    if (failed) return Problem{folder, "", "cannot be made: " + failed.message(), expected};
    return {};
}

}  // namespace

std::string state_folder() {
    const char* given = std::getenv("XDG_STATE_HOME");
    if (given != nullptr && fs::path(given).is_absolute()) return (fs::path(given) / "glint").string();
    const char* home = std::getenv("HOME");
    if (home == nullptr || !fs::path(home).is_absolute()) return {};
    return (fs::path(home) / ".local" / "state" / "glint").string();
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
}

void poll_persistence(UiState& state) {
    if (const auto& why = state.persistence.no_folder) {
        if (state.editor.unsaved()) tell_failed_autosave(state, *why);
        if (!state.kept_views.empty()) tell_not_kept(state, kept_views_words, *why);
    }
    if (state.persistence.folder.empty()) return;
    if (!note_recent(state)) redraw_within(seconds_between_asking);
    note_preferences(state);
    look_again_for_copies(state.persistence);
    note_autosave(state);
}

void drop_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    if (!memory.autosave) return;
    if (memory.autosave_writing.valid()) (void)result_of(memory.autosave_writing);
    std::error_code failed;
    fs::remove(memory.autosave->path(), failed);
    memory.autosaved_scene.reset();
    if (!failed) memory.autosave.reset();  // else it is tried again, and the next copy takes its place
}

void keep_orphan(UiState& state, const std::string& path) {
    Persistence& memory = state.persistence;
    const auto copy = std::find_if(memory.orphans.begin(), memory.orphans.end(),
                                   [&path](const OrphanedAutosave& o) { return o.lock.path() == path; });
    if (copy == memory.orphans.end()) return;
    memory.autosaved_scene = state.editor.scene();
    memory.autosave = std::move(copy->lock);
    memory.orphans.erase(copy);
}

void end_persistence(UiState& state, bool keeps_copy) {
    Persistence& memory = state.persistence;
    if (memory.folder.empty()) return;
    if (!keeps_copy) drop_autosave(state);
    (void)note_recent(state, patience_at_end);
    (void)write_preferences(state, patience_at_end);
}

bool keep_unsaved_work(UiState& state) {
    Persistence& memory = state.persistence;
    if (memory.folder.empty() || !state.editor.unsaved()) return false;
    if (memory.autosave_writing.valid()) memory.autosave_writing.wait();  // it writes the same file
    try {
        if (!has_autosave_name(memory)) return false;
        const std::string text = autosave_text(document_as_made(state), memory.folder);
        return problem_of(write_file_at_once(memory.autosave->path(), text)) == nullptr;
    } catch (const std::bad_alloc&) {
        return false;
    }
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
