#include "ui/document/document_actions.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <new>
#include <utility>

#include "models/io/file.h"
#include "models/memory_limit.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/games/match.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/outside_view.h"
#include "ui/features/inspector/sensitivity.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/predict_mode.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/features/views/scope.h"
#include "ui/features/views/term_grid.h"
#include "ui/features/views/views.h"
#include "ui/picture/picture_notes.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"

namespace glint {
namespace {

/// Whatever draws beside the one picture, or wants more of it than its bytes.
void put_views_away(UiState& state) {
    CompareState& compare = state.get<CompareState>();
    compare.choice.on = compare.choice.shows_stored = compare.b_turned = false;
    forget_parts(compare);
    state.get<DebugViewState>() = {};
    state.get<ScopeState>().open = false;
    TermGridState& grid = state.get<TermGridState>();
    grid.renderer.reset();
    grid.solo.reset();
    grid.muted.clear();
    state.get<InspectorState>().instead.reset();
    state.explanation.reset();
    state.displayed = state.rendered;
    ++state.picture_serial;
}

/// Whether the picture that was drawn last shows a state of the document in hand.
bool knows_drawn(const UiState& state) { return state.rendered_is_edited && !state.editor.before; }

/// B outlives its document: makes its mesh paths relative to the next one's folder.
void lead_meshes_from(UiState& state, const std::string& next_dir) {
    const std::string& dir = state.editor.document.mesh_dir;
    if (dir == next_dir) return;
    std::shared_ptr<const Scene>& stored = state.get<CompareState>().choice.stored;
    if (stored) stored = std::make_shared<const Scene>(with_mesh_paths_from(*stored, dir, next_dir));
}

/// Restores the edited scene as it was drawn last, or as the history's newest step has it. A scene that was
/// drawn already stays.
void take_scene_back(UiState& state) {
    Editor& editor = state.editor;
    if (knows_drawn(state) && state.rendered_scene == editor.scene()) return;
    (void)cancel_gesture(state.viewport, editor.scene());
    if (state.persistence.autosave && state.persistence.has_copy_of(editor.scene()))
        state.persistence.autosave.reset();  // the file stays: what it holds is in no other
    if (editor.before) {
        AskedScene& asked = state.get<LectureState>().asked;
        asked.failed |= asked.path == editor.document.path;
        lead_meshes_from(state, editor.before->document.mesh_dir);
        const std::unique_ptr<Editor> before = std::move(editor.before);
        editor = std::move(*before);
    } else if (knows_drawn(state)) {
        editor.scene() = state.rendered_scene;
    } else {
        editor.scene() = editor.history.present();
    }
    editor.selection = valid_selection(editor.selection, editor.scene());
}

}  // namespace

void begin_pending(UiState& state, Pending::What what, const std::string& path, std::size_t left_out) {
    state.pending = {what, path, left_out, state.editor.unsaved()};
    if (!state.pending.asking) finish_pending(state);
}

void take_scene(UiState& state, SceneDocument document) {
    if (document.path.empty() || document.path != state.editor.document.path) {  // another scene
        put_picture_away(state);
        lay_level(state.get<ScopeState>());
        end_picture_notes(state);
    }
    leave_dialogs_of_scene(state);
    leave_lesson(state);
    end_prediction(state);
    end_match(state);
    (void)cancel_gesture(state.viewport, state.editor.scene());
    let_go_of_fields();
    lead_meshes_from(state, document.mesh_dir);
    take_document(state.editor, std::move(document));
    if (given_scene_beside(state.get<LectureState>().given_scenes, state.editor.document.path, 0))
        state.get<LectureState>().last_given = state.editor.document.path;
    state.get<OutsideState>().placed = false;
    state.viewport.probe.reset();
    state.viewport.probe_before.reset();
    state.viewport.pivot.reset();
    state.viewport.hovered_grip = {};
    state.explanation.reset();
    state.get<SensitivityState>().forget();
    state.mesh_for_object = -1;
    state.palette.open = false;
}

void finish_pending(UiState& state) {
    const Pending now = std::move(state.pending);
    state.pending = {};
    (void)cancel_gesture(state.viewport, state.editor.scene());
    if (now.what == Pending::What::Quit) state.quits = true;
    if (now.what == Pending::What::New) {
        cancel_loads(state);
        take_scene(state, first_scene());
    }
    if (now.what == Pending::What::Recover) recover_autosave(state, now.path);
    if (now.what == Pending::What::Open) begin_open(state, now.path);
    if (now.left_out > 0) state.notifications.add(Tone::Warning, only_first_of_several);
    finish_in_lesson(state, now);
    if (now.what == Pending::What::Match) begin_match(state, std::strtoull(now.path.c_str(), nullptr, 10));
}

std::string offered_name(const UiState& state, const char* ending) {
    const std::filesystem::path path(state.editor.document.path);
    if (path.empty() || path == "-") return std::string("scene") + ending;
    return std::filesystem::path(path).replace_extension(ending).string();
}

bool is_among_shipped(const UiState& state, const std::string& path) {
    if (state.shipped_scenes.empty()) return false;
    std::error_code failed;
    const std::string replaced = replaced_file(path);  // wherever links lead
    const std::filesystem::path folder =
        std::filesystem::path(replaced.empty() ? path : replaced).parent_path();
    return std::filesystem::equivalent(folder.empty() ? "." : folder, state.shipped_scenes, failed);
}

void ask_mesh(UiState& state, int object) {
    state.mesh_for_object = object;
    state.files.ask(FilePurpose::OpenMesh, state.editor.document.path);
}

bool save(UiState& state) {
    if (state.editor.has_scene_file() && is_among_shipped(state, state.editor.document.path)) {
        // The user's files do not belong in the folder of the examples, so the dialog offers the folder in
        // which the program was started.
        const std::filesystem::path name = std::filesystem::path(state.editor.document.path).filename();
        state.files.ask(FilePurpose::SaveScene, name.string());
        state.notifications.add(Tone::Warning, "This is a built-in example. Choose where to save your copy.");
        return false;
    }
    if (!state.editor.has_scene_file()) {
        state.files.ask(FilePurpose::SaveScene, offered_name(state, ".json"));
        return false;
    }
    if (changed_by_another(state.editor)) {
        state.asks_overwrite = true;
        return false;
    }
    return save_over(state);
}

namespace {

/// Warns where a mesh that the scene names is not there any more, of the first one.
void say_missing_mesh(UiState& state) {
    const SceneDocument& document = state.editor.document;
    for (const Object& object : document.scene.objects) {
        const auto* const named = std::get_if<MeshFile>(&object.source);
        if (named == nullptr) continue;
        const auto why = why_no_mesh_file(path_from(document.mesh_dir, named->path));
        if (!why) continue;
        return state.notifications.add(Tone::Warning,
                                       fmt::format("The scene opens again when \"{}\" is there: {}",
                                                   on_one_line(named->path), why->what));
    }
}

}  // namespace

bool save_as(UiState& state, const std::string& path) {
    const Scene saved = as_made(state, state.editor.scene());
    if (saved == state.editor.scene())
        remember_step(state.editor, false);  // undo leads back to what is saved
    if (const auto problem = save_file(state.editor, path, saved)) {
        state.notifications.add(*problem);
        state.pending = {};
        return false;
    }
    const char* awaited = "";
    if (awaits_mesh(state)) {
        awaited = ", with the mesh as it was: the new one is being built";
        state.pending = {};  // the scene in hand is not given up before it is whole
    }
    const std::string named = notes_of_edited(state).in_file;
    state.notifications.add(Tone::Done, fmt::format("Saved {}{}{}", state.editor.title(), awaited,
                                                    named.empty() ? "" : " (" + named + ")"));
    say_missing_mesh(state);
    return true;
}

bool save_over(UiState& state) { return save_as(state, state.editor.document.path); }

void reload(UiState& state) {
    state.pending = {};
    begin_open(state, state.editor.document.path);
}

void draw_scene_before(UiState& state, bool previewed) {
    if (state.rendered == nullptr) throw;
    const PictureSize size = state.rendered->size;
    if (!previewed) take_scene_back(state);
    state.rendered = nullptr;
    state.rendered = &state.renderer->render(state.editor.scene(), size);
    state.rendered_scene = state.editor.scene();
    state.rendered_is_edited = true;
}

void give_up_frame(UiState& state, const std::exception& error) {
    if (state.rendered == nullptr) throw;
    // Ending open windows does not pop the fonts that they have pushed.
    GImGui->FontStack.resize(0);
    ImGui::SetCurrentFont(ImGui::GetDefaultFont());
    ImGui::ErrorCheckEndFrameRecover(nullptr);
    put_views_away(state);
    state.notifications.add(problem_from(error));
}

}  // namespace glint
