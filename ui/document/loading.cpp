#include "ui/document/loading.h"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "models/io/file.h"
#include "ui/document/averaged_normals.h"
#include "ui/document/document_actions.h"
#include "ui/document/recently_changed.h"
#include "ui/feature.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Opens a loaded document: a file's, or an orphaned copy, which is unsaved and from now on belongs to this
/// window.
void take_loaded(UiState& state, SceneDocument document) {
    Loading& loading = state.loading;
    // If the new scene cannot be drawn, the present one is restored: nothing in it may be waiting then.
    (void)cancel_gesture(state.viewport, state.editor.scene());
    give_up_meshes(state);
    std::optional<Recovery> recovery = std::exchange(loading.recovery, std::nullopt);
    if (recovery) drop_autosave(state);
    take_scene(state, std::move(document));
    if (recovery) {  // before anything that may fail: the present document is unsaved
        state.editor.saved_edited_camera = recovery->in_file->camera;
        state.editor.saved = std::move(*recovery->in_file);
        keep_orphan(state, recovery->autosave);
    }
    state.notifications.add(state.editor.document.warnings);
    tell_averaged_normals(state);
    if (const auto opened = std::exchange(loading.opened, nullptr)) opened(state);
}

/// The problem with a file of unknown kind also lists the other kinds that the window opens.
Problem with_all_that_opens(Problem problem) {
    if (problem.expected == opened_files)
        problem.expected = fmt::format(
            "{}, a lesson (.md) or a picture that another program drew (.png, .pfm, .exr)", opened_files);
    return problem;
}

/// A picture of another program cannot be opened, but compared with the scene.
void offer_comparison(UiState& state) {
    const std::string ending = lower_extension(state.loading.failed);
    if (ending != ".png" && ending != ".pfm" && ending != ".exr" && ending != ".glsl") return;
    Notification& note = state.notifications.list.back();
    note.button = "Compare with the open scene";
    note.press = [path = state.loading.failed](UiState& s) {
        for (const Feature* feature : features())
            if (feature->drop != nullptr && feature->drop(s, path)) return;
    };
}

void poll_document(UiState& state) {
    Loading& loading = state.loading;
    // The user cancelled: the loaded document is dropped. After "save" it also waits for the name: read again
    // from its file, it would lack the assignments, or would not be a lesson.
    if (!state.pending.then) loading.loaded.reset();
    if (!loading.document || !loading.document->done()) return;
    if (state.pending.asking) return;  // the question is about the present scene
    Result<SceneDocument> result = loading.document->take();
    loading.document.reset();
    if (const Problem* problem = problem_of(result)) {
        loading.failed = loading.path;
        state.notifications.add(with_all_that_opens(*problem));
        return offer_comparison(state);
    }
    auto& document = std::get<SceneDocument>(result);
    if (same_description(state.editor.scene(), loading.scene_then) || !state.editor.unsaved() ||
        drops_changes(state))
        return take_loaded(state, std::move(document));
    // Edits were made during loading: ask before discarding them.
    loading.loaded = std::move(document);
    state.pending = {[](UiState& s) {
                         if (auto loaded = std::exchange(s.loading.loaded, std::nullopt))
                             take_loaded(s, *std::move(loaded));
                     },
                     true};
}

/// Waits for a document, replacing the one being loaded.
void await_document(UiState& state, Opening opening, std::optional<Recovery> recovery) {
    Loading& loading = state.loading;
    leave(loading.document);
    loading.loaded.reset();
    loading.recovery = std::move(recovery);
    loading.opened = std::move(opening.opened);
    loading.path = std::move(opening.path);
    loading.failed.clear();
    loading.scene_then = state.editor.scene();
    loading.since = ImGui::GetTime();
    loading.document = state.jobs.add(std::move(opening.job));
}

}  // namespace

void begin_open(UiState& state, const std::string& path) { await_opening(state, opening_of(path)); }

void await_opening(UiState& state, Opening opening) { await_document(state, std::move(opening), {}); }

Opening opening_of(const std::string& path, const std::vector<Assignment>& assignments) {
    for (const Feature* feature : features())
        if (feature->open != nullptr)
            if (std::optional<Opening> opening = feature->open(path)) return *std::move(opening);
    const auto work = [path, assignments](LoadProgress&) { return open_document(path, assignments); };
    return {path, std::make_shared<LoadJob>(fs::path(path).filename().string(), work), nullptr};
}

void recover_autosave(UiState& state, const std::string& path) {
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
