#include "ui/document/document_actions.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "models/io/file.h"
#include "models/memory_limit.h"
#include "ui/document/editor.h"
#include "ui/feature.h"
#include "ui/picture/magnifier.h"
#include "ui/picture/picture_notes.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"

namespace glint {
namespace {

/// Whether the last drawn picture shows the open document, in any of its states.
bool knows_drawn(const UiState& state) { return state.rendered_is_edited && !state.editor.before; }

void leave_document(UiState& state, const SceneDocument& next) {
    for (const Feature* feature : features())
        if (feature->leave_document != nullptr) feature->leave_document(state, next);
}

/// Restores the edited scene as it was last drawn, or else the history's newest step. A scene that has
/// already been drawn does not change.
void take_scene_back(UiState& state) {
    Editor& editor = state.editor;
    if (knows_drawn(state) && state.rendered_scene == editor.scene()) return;
    (void)cancel_gesture(state.viewport, editor.scene());
    if (state.persistence.autosave && state.persistence.has_copy_of(editor.scene()))
        state.persistence.autosave.reset();  // the file is kept, because nothing else has its contents
    if (editor.before) {
        state.loading.failed = editor.document.path;
        leave_document(state, editor.before->document);
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

std::filesystem::path pictures_folder() {
    const char *const config = std::getenv("XDG_CONFIG_HOME"), *const home = std::getenv("HOME");
    if (home == nullptr) return {};
    const std::filesystem::path folder =
        config != nullptr && *config == '/' ? config : std::filesystem::path(home) / ".config";
    constexpr std::size_t longest = 1 << 16;  // bytes
    const Result<std::string> read = read_file((folder / "user-dirs.dirs").string(), longest);
    const auto* const text = std::get_if<std::string>(&read);
    constexpr std::string_view key = "XDG_PICTURES_DIR=\"";
    const std::size_t at = text != nullptr ? text->find(key) : std::string::npos;
    if (at == std::string::npos) return {};
    std::string path = text->substr(at + key.size());
    path.resize(std::min(path.find('"'), path.size()));
    if (path.starts_with("$HOME")) path.replace(0, 5, home);
    std::error_code failed;
    return path.starts_with('/') && std::filesystem::is_directory(path, failed) ? path : "";
}

void ask_first(UiState& state, std::function<void(UiState&)> then) {
    state.pending = {std::move(then), state.editor.unsaved() && !drops_changes(state)};
    if (!state.pending.asking) finish_pending(state);
}

void ask_to_open(UiState& state, const std::string& path, std::size_t left_out) {
    ask_first(state, [path, left_out](UiState& s) {
        begin_open(s, path);
        if (left_out > 0) s.notifications.add(Tone::Warning, only_first_of_several);
    });
}

void finish_pending(UiState& state) {
    const Pending now = std::exchange(state.pending, {});
    (void)cancel_gesture(state.viewport, state.editor.scene());
    if (now.then) now.then(state);
}

bool is_another(const UiState& state, const SceneDocument& next) {
    return next.path.empty() || next.path != state.editor.document.path;
}

void put_away(UiState& state) {
    for (const Feature* feature : features())
        if (feature->put_away != nullptr) feature->put_away(state);
    state.get<MagnifierState>() = {};
    state.on_screen.explanation.reset();
    state.displayed = state.unpainted = state.rendered;
    ++state.picture_serial;
}

void take_scene(UiState& state, SceneDocument document) {
    leave_dialogs_of_scene(state);
    leave_document(state, document);
    (void)cancel_gesture(state.viewport, state.editor.scene());
    let_go_of_fields();
    take_document(state.editor, std::move(document));
    state.viewport.probe.reset();
    state.viewport.probe_before.reset();
    state.viewport.pivot.reset();
    state.viewport.hovered_grip = {};
    state.on_screen.explanation.reset();
    state.mesh_for_object = -1;
    state.palette.open = false;
}

namespace {

/// The path is stored as absolute: saving makes it relative.
void use_mesh(UiState& state, const std::string& path) {
    const int object = std::exchange(state.mesh_for_object, -1);
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::absolute(path, failed);
    if (failed)  // the working directory was deleted
        return state.notifications.add(
            Problem{path, "", "cannot be made absolute: " + failed.message(), "an absolute path"});
    begin_mesh(state, MeshFile{whole.string()}, object);
}

void save_to(UiState& state, const std::string& path) {
    if (!is_among_shipped(state, path)) {
        if (save_as(state, path)) finish_pending(state);
        return;
    }
    state.files.ask(save_purpose, std::filesystem::path(path).filename().string());
    state.notifications.add(
        Problem{path, "", "is in the folder of Glint's examples", "a folder of your own"});
}

}  // namespace

const FilePurpose open_purpose{.title = "Open",
                               .button = "Open",
                               .hint =
                                   "Scenes (.json .glb .gltf), pictures by Glint (.png), meshes (.obj .ply "
                                   ".off .stl), lessons (.md)",
                               .nothing = "No folders or scenes here",
                               .extensions = {".json", ".png", ".md"},
                               .takes_meshes = true,
                               .is_about_scene = false,
                               .use = [](UiState& s, const std::string& path) { ask_to_open(s, path); }};

const FilePurpose mesh_purpose{.title = "Choose a mesh",
                               .button = "Choose",
                               .hint = "Meshes (.obj .ply .off .stl .glb .gltf)",
                               .nothing = "No folders or mesh files here",
                               .takes_meshes = true,
                               .use = use_mesh};

const FilePurpose save_purpose{.title = "Save the scene",
                               .button = "Save",
                               .hint = "Scene file (.json)",
                               .extensions = {".json"},
                               .saves = true,
                               .use = save_to};

std::string offered_name(const UiState& state, const char* ending) {
    const std::filesystem::path path(state.editor.document.path);
    const bool has_file = !path.empty() && path != "-";
    std::filesystem::path offered = has_file ? path : std::filesystem::path("scene");
    offered.replace_extension(ending);
    if (has_file && !is_among_shipped(state, path.string())) return offered.string();
    const bool is_picture = ending != std::string_view(".json");
    return ((is_picture ? pictures_folder() : "") / offered.filename()).string();
}

bool is_among_shipped(const UiState& state, const std::string& path) {
    if (state.shipped_scenes.empty()) return false;
    std::error_code failed;
    const std::string replaced = replaced_file(path);  // with symbolic links resolved
    const std::filesystem::path folder =
        std::filesystem::path(replaced.empty() ? path : replaced).parent_path();
    return std::filesystem::equivalent(folder.empty() ? "." : folder, state.shipped_scenes, failed);
}

void ask_mesh(UiState& state, int object) {
    state.mesh_for_object = object;
    state.files.ask(mesh_purpose, state.editor.document.path);
}

bool save(UiState& state) {
    if (state.editor.has_scene_file() && is_among_shipped(state, state.editor.document.path)) {
        // The user's files do not belong in the folder of the examples, so the dialog offers the working
        // directory.
        const std::filesystem::path name = std::filesystem::path(state.editor.document.path).filename();
        state.files.ask(save_purpose, name.string());
        state.notifications.add(Tone::Warning, "This is a built-in example. Choose where to save your copy.");
        return false;
    }
    if (!state.editor.has_scene_file()) {
        state.files.ask(save_purpose, offered_name(state, ".json"));
        return false;
    }
    if (changed_by_another(state.editor)) {
        state.asks_overwrite = true;
        return false;
    }
    return save_over(state);
}

namespace {

/// Warns about the first missing mesh file of the scene.
void say_missing_mesh(UiState& state) {
    const SceneDocument& document = state.editor.document;
    for (const Object& object : document.scene.objects) {
        const auto* const named = std::get_if<MeshFile>(&object.source);
        if (named == nullptr) continue;
        const auto why = why_no_mesh_file(path_from(document.mesh_dir, named->path));
        if (!why) continue;
        return state.notifications.add(Tone::Warning,
                                       fmt::format("The scene cannot be opened again until \"{}\" exists: {}",
                                                   on_one_line(named->path), why->what));
    }
}

}  // namespace

bool save_as(UiState& state, const std::string& path) {
    const Scene saved = as_made(state, state.editor.scene());
    if (saved == state.editor.scene())
        remember_step(state.editor, false);  // so that undo can return to the saved state
    if (const auto problem = save_file(state.editor, path, saved)) {
        state.notifications.add(*problem);
        state.pending = {};
        return false;
    }
    const char* awaited = "";
    if (awaits_mesh(state)) {
        awaited = " with the old mesh: the new one is still being built";
        state.pending = {};  // the current scene stays until the next one is complete
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
    state.refinement = {};
    state.rendered = &state.refinement.begin(*state.renderer, state.editor.scene(), size, false, false);
    state.rendered_scene = state.editor.scene();
    state.rendered_is_edited = true;
}

void give_up_frame(UiState& state, const std::exception& error) {
    if (state.rendered == nullptr) throw;
    // Ending the open windows does not pop the fonts pushed in them.
    GImGui->FontStack.resize(0);
    ImGui::SetCurrentFont(ImGui::GetDefaultFont());
    ImGui::ErrorCheckEndFrameRecover(nullptr);
    put_away(state);
    state.notifications.add(problem_from(error));
}

}  // namespace glint
