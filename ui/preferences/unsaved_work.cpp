// The copy of unsaved work: writing it, reporting that it cannot be written, and removing it.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "models/io/file.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"

namespace glint {
namespace {

constexpr double seconds_between_copies = 5;

/// Locks a copy for this process if it has none, and creates the folder if it is missing. Returns a problem
/// if no copy is possible.
std::optional<Problem> why_no_autosave(Persistence& memory) {
    if (auto problem = why_no_folder(memory.folder)) return problem;
    if (!memory.autosave) memory.autosave = new_autosave(memory.folder);
    if (memory.autosave) return {};
    return Problem{memory.folder, "", "cannot be written", "a folder of your own"};
}

/// Starts writing the copy on a separate thread, since writing may wait for the disk.
void write_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    memory.autosaved_at = ImGui::GetTime();
    redraw_within(seconds_between_copies);
    if (const auto problem = why_no_autosave(memory)) return tell_no_copy(state, *problem);
    SceneDocument document = document_as_made(state);
    memory.autosaved_scene = document.scene;
    const auto work = [document = std::move(document), folder = memory.folder,
                       path = memory.autosave->path](LoadProgress&) {
        return write_file_at_once(path, autosave_text(document, folder));
    };
    memory.autosave_writing = state.jobs.start<std::monostate>(memory.autosave->path, work);
}

/// Reports a failed write once the thread has ended.
void take_written_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    if (!memory.autosave_writing || !memory.autosave_writing->done()) return;
    const Result<std::monostate> written = memory.autosave_writing->take();
    memory.autosave_writing.reset();
    if (const Problem* problem = problem_of(written)) return tell_no_copy(state, *problem);
    memory.autosave_failed = false;
}

}  // namespace

void tell_no_copy(UiState& state, const Problem& problem) {
    state.persistence.autosaved_scene.reset();  // so that the next frame tries again
    if (std::exchange(state.persistence.autosave_failed, true)) return;
    state.notifications.add(
        Tone::Error,
        fmt::format("The unsaved work cannot be backed up: {}; save it so that it is not lost in a crash",
                    problem.text()));
}

void poll_unsaved_work(UiState& state) {
    Persistence& memory = state.persistence;
    if (!state.editor.unsaved()) return drop_autosave(state);
    take_written_autosave(state);
    const Scene& scene = state.editor.scene();
    const bool copied =
        awaits_mesh(state) ? memory.has_copy_of(as_made(state, scene)) : memory.has_copy_of(scene);
    if (copied || state.viewport.gesture != Gesture::None) return;
    const double rest = memory.autosaved_at + seconds_between_copies - ImGui::GetTime();
    if (rest > 0) return redraw_within(rest);
    if (memory.autosave_writing) return redraw_within(0.2);
    write_autosave(state);
}

void drop_autosave(UiState& state) {
    Persistence& memory = state.persistence;
    if (!memory.autosave) return;
    if (memory.autosave_writing) std::exchange(memory.autosave_writing, nullptr)->wait();
    std::error_code failed;
    std::filesystem::remove(memory.autosave->path, failed);
    memory.autosaved_scene.reset();
    if (!failed) memory.autosave.reset();  // else the next frame tries again
}

void keep_orphan(UiState& state, const std::string& path) {
    Persistence& memory = state.persistence;
    const auto copy = std::find_if(memory.orphans.begin(), memory.orphans.end(),
                                   [&path](const OrphanedAutosave& o) { return o.lock.path == path; });
    if (copy == memory.orphans.end()) return;
    memory.autosaved_scene = state.editor.scene();
    memory.autosave = copy->lock;
    memory.orphans.erase(copy);
}

bool keep_unsaved_work(UiState& state) {
    Persistence& memory = state.persistence;
    if (memory.folder.empty() || !state.editor.unsaved()) return false;
    if (memory.autosave_writing)  // the thread writes to the same file
        std::exchange(memory.autosave_writing, nullptr)->wait();
    if (why_no_autosave(memory)) return false;
    const std::string text = autosave_text(document_as_made(state), memory.folder);
    return problem_of(write_file_at_once(memory.autosave->path, text)) == nullptr;
}

}  // namespace glint
