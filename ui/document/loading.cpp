#include "ui/document/loading.h"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "ui/document/averaged_normals.h"
#include "ui/document/document_actions.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Puts a loaded document in hand: a file's, or the copy that a window left behind, which is not saved and
/// from now on is this window's own.
void take_loaded(UiState& state, SceneDocument document) {
    Loading& loading = state.loading;
    // If the new scene cannot be drawn, the present one comes back: nothing in it may be waiting then.
    (void)cancel_gesture(state.viewport, state.editor.scene());
    give_up_meshes(state);
    std::optional<Recovery> recovery = std::exchange(loading.recovery, std::nullopt);
    if (recovery) drop_autosave(state);
    take_scene(state, std::move(document));
    if (recovery) {  // before anything that may fail: what is in hand is not saved
        state.editor.saved_edited_camera = recovery->in_file->camera;
        state.editor.saved = std::move(*recovery->in_file);
        keep_orphan(state, recovery->autosave);
    }
    state.notifications.add(state.editor.document.warnings);
    tell_averaged_normals(state);
    if (const auto course = std::exchange(loading.course, nullptr)) begin_lesson(state, *course);
}

/// The problem of a file that is neither a scene nor a mesh names what else the window takes.
Problem with_all_that_opens(Problem problem) {
    if (problem.expected == opened_files)
        problem.expected = fmt::format(
            "{}, a lesson (.md) or a picture that another program drew (.png, .pfm, .exr)", opened_files);
    return problem;
}

void poll_document(UiState& state) {
    Loading& loading = state.loading;
    // The user cancelled: the loaded document is dropped. After "save" it waits for the name, too: read again
    // from its file, it would lack the assignments, or would not be a lesson.
    if (state.pending.what == Pending::What::Nothing) loading.loaded.reset();
    if (!loading.document || !loading.document->done()) return;
    if (state.pending.asking) return;  // the question is about the scene in hand
    Result<SceneDocument> result = loading.document->take();
    loading.document.reset();
    if (const Problem* problem = problem_of(result)) {
        AskedScene& asked = state.get<LectureState>().asked;
        asked.failed |= asked.path == loading.path;
        return state.notifications.add(with_all_that_opens(*problem));
    }
    auto& document = std::get<SceneDocument>(result);
    if (same_description(state.editor.scene(), loading.scene_then) || !state.editor.unsaved())
        return take_loaded(state, std::move(document));
    // Work went on while it was loading: it is not thrown away unasked.
    state.pending =
        loading.recovery
            ? Pending{.what = Pending::What::Recover, .path = loading.recovery->autosave, .asking = true}
            : Pending{.what = Pending::What::Open, .path = loading.path, .asking = true};
    loading.loaded = std::move(document);
}

/// Waits for a document, in place of the one that was being loaded.
void await_document(UiState& state, Opening opening, std::optional<Recovery> recovery) {
    Loading& loading = state.loading;
    leave(loading.document);
    loading.loaded.reset();
    loading.recovery = std::move(recovery);
    loading.course = std::move(opening.course);
    loading.path = std::move(opening.path);
    loading.scene_then = state.editor.scene();
    loading.since = ImGui::GetTime();
    loading.document = state.jobs.add(std::move(opening.job));
}

}  // namespace

void begin_open(UiState& state, const std::string& path) {
    Loading& loading = state.loading;
    if (loading.loaded && !loading.recovery && loading.path == path)
        return take_loaded(state, *std::exchange(loading.loaded, std::nullopt));
    await_opening(state, opening_of(path));
}

void await_opening(UiState& state, Opening opening) { await_document(state, std::move(opening), {}); }

Opening opening_of(const std::string& path, const std::vector<Assignment>& assignments) {
    if (is_lesson_file(path)) return opening_of_lesson(path);
    const auto work = [path, assignments](LoadProgress&) { return open_document(path, assignments); };
    return {path, std::make_shared<LoadJob>(fs::path(path).filename().string(), work), nullptr};
}

Opening opening_of_lesson(const std::string& path) {
    const auto course = std::make_shared<std::shared_ptr<const Course>>();
    const auto work = [path, course](LoadProgress&) -> Result<SceneDocument> {
        Result<std::shared_ptr<const Course>> opened = open_course(path);
        if (const Problem* problem = problem_of(opened)) return *problem;
        *course = std::get<std::shared_ptr<const Course>>(std::move(opened));
        return (*course)->document;
    };
    return {path, std::make_shared<LoadJob>(fs::path(path).filename().string(), work), course};
}

void recover_autosave(UiState& state, const std::string& path) {
    Loading& loading = state.loading;
    if (loading.loaded && loading.recovery && loading.recovery->autosave == path)
        return take_loaded(state, *std::exchange(loading.loaded, std::nullopt));
    const auto in_file = std::make_shared<Scene>();
    const auto work = [path, in_file](LoadProgress&) -> Result<SceneDocument> {
        Result<SceneDocument> copy = open_autosave(path);
        if (problem_of(copy) != nullptr) return copy;
        const Result<SceneDocument> file = open_document(std::get<SceneDocument>(copy).path);
        if (const auto* document = std::get_if<SceneDocument>(&file)) *in_file = document->scene;
        return copy;
    };
    await_document(state, {path, std::make_shared<LoadJob>("Copy of the unsaved work", work), nullptr},
                   Recovery{path, in_file});
}

void poll_loads(UiState& state) {
    poll_document(state);
    poll_meshes(state);
}

void cancel_loads(UiState& state) {
    give_up_meshes(state);
    leave(state.loading.document);
    state.loading.loaded.reset();
}

}  // namespace glint
