#include "ui/document/document_actions.h"

#include <fmt/core.h>

#include <filesystem>

namespace glint {

void begin_pending(UiState& state, Pending pending) {
    state.pending = std::move(pending);
    if (state.editor.unsaved())
        state.pending.asking = true;
    else
        finish_pending(state);
}

void take_scene(UiState& state, SceneDocument document) {
    (void)cancel_gesture(state.viewport, state.editor.scene());
    take_document(state.editor, std::move(document));
    state.viewport.probe.reset();
    state.viewport.pivot.reset();
    state.viewport.hovered_grip = {};
    state.explanation.reset();
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
}

std::string offered_name(const UiState& state, const char* ending) {
    const std::filesystem::path path(state.editor.document.path);
    if (path.empty() || path == "-") return std::string("scene") + ending;
    return std::filesystem::path(path).replace_extension(ending).string();
}

bool save(UiState& state) {
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

bool save_over(UiState& state) {
    if (const auto problem = save_file(state.editor, state.editor.document.path)) {
        state.notifications.add(*problem);
        state.pending = {};
        return false;
    }
    state.notifications.add(Tone::Done, fmt::format("Saved {}", state.editor.title()));
    return true;
}

void reload(UiState& state) {
    state.pending = {};
    begin_open(state, state.editor.document.path);
}

}  // namespace glint
