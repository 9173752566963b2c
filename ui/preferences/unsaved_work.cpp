// The copy of unsaved work: when it is written, said to be impossible, and removed.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "models/io/file.h"
#include "models/memory_limit.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_between_copies = 5;

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
        tell_no_copy(state, *problem);
    else
        memory.autosave_failed = false;
    return true;
}

/// Takes a name for this window's copy, if it has none yet, in a folder that is made again where it has gone.
/// Returns why there can be none.
std::optional<Problem> why_no_autosave_name(Persistence& memory) {
    if (auto problem = why_no_folder(memory.folder)) return problem;
    if (memory.autosave && !memory.autosave->stands()) {
        const std::string path = memory.autosave->path();
        memory.autosave.reset();
        memory.autosave = AutosaveLock::take(path);  // what is there of the copy stays this window's
    }
    if (!memory.autosave) memory.autosave = new_autosave(memory.folder);
    if (memory.autosave) return {};
    return Problem{memory.folder, "", "cannot be written", "a folder of your own"};
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
    std::optional<Problem> failed = why_no_autosave_name(memory);
    if (!failed) failed = begin_writing(memory, document_as_made(state));
    if (!failed) return;
    tell_no_copy(state, *failed);
    redraw_within(seconds_between_copies);
}

/// A window that was killed a moment before this one began may have held its copy's lock still.
void look_again_for_copies(Persistence& memory) {
    constexpr double a_moment = 2;  // seconds
    if (memory.looked_again) return;
    if (ImGui::GetTime() < a_moment) return redraw_within(a_moment - ImGui::GetTime());
    memory.looked_again = true;
    for (OrphanedAutosave& copy : orphaned_autosaves(memory.folder))
        if (!memory.offered.contains(copy.lock.path())) memory.orphans.push_back(std::move(copy));
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

}  // namespace

void tell_no_copy(UiState& state, const Problem& problem) {
    state.persistence.autosaved_scene.reset();  // the next one is tried in its time
    if (std::exchange(state.persistence.autosave_failed, true)) return;
    state.notifications.add(Tone::Warning,
                            fmt::format("No copy of the unsaved work can be kept: {}; save it to "
                                        "keep it in case of a crash",
                                        problem.text()));
}

void poll_unsaved_work(UiState& state) {
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

bool keep_unsaved_work(UiState& state) {
    Persistence& memory = state.persistence;
    if (memory.folder.empty() || !state.editor.unsaved()) return false;
    if (memory.autosave_writing.valid()) memory.autosave_writing.wait();  // it writes the same file
    try {
        if (why_no_autosave_name(memory)) return false;
        const std::string text = autosave_text(document_as_made(state), memory.folder);
        return problem_of(write_file_at_once(memory.autosave->path(), text)) == nullptr;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

}  // namespace glint
