#include "ui/actions.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <array>
#include <filesystem>

#include "ui/shading_panel.h"
#include "ui/theme.h"

namespace glint {
namespace {

constexpr bool ctrl = true, shift = true;

constexpr std::array table{
    ActionInfo{Action::New, "New scene", "Ctrl+N", {Key::N, ctrl}},
    ActionInfo{Action::Open, "Open…", "Ctrl+O", {Key::O, ctrl}},
    ActionInfo{Action::Save, "Save", "Ctrl+S", {Key::S, ctrl}},
    ActionInfo{Action::SaveAs, "Save as…", "Ctrl+Shift+S", {Key::S, ctrl, shift}},
    ActionInfo{Action::SavePicture, "Save picture…", "F12", {Key::F12}},
    ActionInfo{Action::Quit, "Quit", "Ctrl+Q", {Key::Q, ctrl}},
    ActionInfo{Action::Undo, "Undo", "Ctrl+Z", {Key::Z, ctrl}},
    ActionInfo{Action::Redo, "Redo", "Ctrl+Shift+Z", {Key::Z, ctrl, shift}},
    ActionInfo{Action::Redo, "Redo", "Ctrl+Y", {Key::Y, ctrl}},
    ActionInfo{Action::Duplicate, "Duplicate", "Ctrl+D", {Key::D, ctrl}},
    ActionInfo{Action::Delete, "Delete", "Del", {Key::Delete}},
    ActionInfo{Action::AddLight, "Add a light", "L", {Key::L}},
    ActionInfo{Action::FrameAll, "Frame all", "F", {Key::F}},
    ActionInfo{Action::FrameSelected, "Frame the selected object", "Shift+F", {Key::F, !ctrl, shift}},
    ActionInfo{Action::Fold, "Picture alone", "F11", {Key::F11}},
    ActionInfo{Action::LeftColumn, "Scene column", "", {}},
    ActionInfo{Action::RightColumn, "Why column", "", {}},
    ActionInfo{Action::SwitchTheme, "Light theme", "", {}},
    ActionInfo{Action::Shortcuts, "Keys and mouse", "F1", {Key::F1}},
    ActionInfo{Action::Shortcuts, "Keys and mouse", "?", {Key::Question, !ctrl, shift}},
    ActionInfo{Action::Flat, "Flat shading", "1", {Key::Digit1}},
    ActionInfo{Action::Facet, "Facet shading", "2", {Key::Digit2}},
    ActionInfo{Action::Gouraud, "Gouraud shading", "3", {Key::Digit3}},
    ActionInfo{Action::Phong, "Phong shading", "4", {Key::Digit4}},
    ActionInfo{Action::Emission, "Emission on or off", "E", {Key::E}},
    ActionInfo{Action::Ambient, "Ambient on or off", "A", {Key::A}},
    ActionInfo{Action::Diffuse, "Diffuse on or off", "D", {Key::D}},
    ActionInfo{Action::Specular, "Specular on or off", "S", {Key::S}},
};

void set_mode(UiState& state, ShadingMode mode) {
    Shading trial = state.editor.scene().shading;
    trial.mode = mode;
    if (refused_shading(trial).empty()) state.editor.scene().shading = trial;
}

void frame(UiState& state, int object) {
    Scene& scene = state.editor.scene();
    if (!scene.objects.empty()) frame_camera(scene, object);
}

void add_bulb(UiState& state) {
    if (const auto index = add_light(state.editor.scene(), LightKind::Point))
        state.editor.selection = {Selection::Kind::Light, *index};
}

/// A name to offer: the document's own, with the ending that fits.
std::string offered(const UiState& state, const char* ending) {
    const std::filesystem::path path(state.editor.document.path);
    if (path.empty() || path == "-") return std::string("scene") + ending;
    return std::filesystem::path(path).replace_extension(ending).string();
}

void run_file_action(UiState& state, Action action) {
    switch (action) {
    case Action::New:
        return begin_pending(state, {Pending::What::New, "", false});
    case Action::Open:
        return state.files.ask(FilePurpose::OpenScene, state.editor.document.path);
    case Action::Save:
        save(state);
        return;
    case Action::SaveAs:
        return state.files.ask(FilePurpose::SaveScene, offered(state, ".json"));
    case Action::SavePicture:
        return state.files.ask(FilePurpose::SavePicture, offered(state, ".png"));
    case Action::Quit:
        return begin_pending(state, {Pending::What::Quit, "", false});
    default:
        return;
    }
}

void run_edit_action(UiState& state, Action action) {
    Scene& scene = state.editor.scene();
    switch (action) {
    case Action::Undo:
        undo(state.editor);
        return;
    case Action::Redo:
        redo(state.editor);
        return;
    case Action::Duplicate:
        return duplicate(scene, state.editor.selection);
    case Action::Delete:
        return remove(scene, state.editor.selection);
    case Action::AddLight:
        return add_bulb(state);
    case Action::Flat:
        return set_mode(state, ShadingMode::Flat);
    case Action::Facet:
        return set_mode(state, ShadingMode::Facet);
    case Action::Gouraud:
        return set_mode(state, ShadingMode::Gouraud);
    case Action::Phong:
        return set_mode(state, ShadingMode::Phong);
    case Action::Emission:
        scene.shading.terms.emission ^= true;
        return;
    case Action::Ambient:
        scene.shading.terms.ambient ^= true;
        return;
    case Action::Diffuse:
        scene.shading.terms.diffuse ^= true;
        return;
    case Action::Specular:
        scene.shading.terms.specular ^= true;
        return;
    default:
        return;
    }
}

void run_view_action(UiState& state, Action action) {
    switch (action) {
    case Action::FrameAll:
        return frame(state, -1);
    case Action::FrameSelected:
        return frame(state, state.editor.selection.index);
    case Action::Fold:
        state.layout.folded = !state.layout.folded;
        return;
    case Action::LeftColumn:
        state.layout.left = !state.layout.left, state.layout.folded = false;
        return;
    case Action::RightColumn:
        state.layout.right = !state.layout.right, state.layout.folded = false;
        return;
    case Action::SwitchTheme:
        state.dark = !state.dark;
        return;
    case Action::Shortcuts:
        state.shows_shortcuts = !state.shows_shortcuts;
        return;
    default:
        return;
    }
}

bool is_item(const Selection& s) {
    return s.kind == Selection::Kind::Light || s.kind == Selection::Kind::Object;
}

/// Escape leaves the innermost thing: a drag, a dialog, a sheet.
void escape(UiState& state) {
    if (cancel_gesture(state.viewport, state.editor.scene())) return;
    const bool dialog = state.files.open || state.pending.asking;
    if (!dialog && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return ImGui::ClosePopupToLevel(0, true);
    if (state.files.open)
        state.files.open = false, state.pending = {};
    else if (state.pending.asking)
        state.pending = {};
    else if (state.shows_shortcuts)
        state.shows_shortcuts = false;
    else if (!ImGui::GetIO().WantTextInput)
        state.viewport.probe.reset();
}

}  // namespace

std::span<const ActionInfo> actions() { return table; }

const ActionInfo& info_of(Action action) {
    for (const ActionInfo& info : table)
        if (info.action == action) return info;
    return table[0];  // not reached: every action is in the table
}

bool can_run(const UiState& state, Action action) {
    switch (action) {
    case Action::Undo:
        return state.editor.history.can_undo();
    case Action::Redo:
        return state.editor.history.can_redo();
    case Action::Duplicate:
    case Action::Delete:
        return is_item(state.editor.selection);
    case Action::FrameAll:
        return !state.editor.scene().objects.empty();
    case Action::FrameSelected:
        return state.editor.selection.kind == Selection::Kind::Object;
    case Action::SavePicture:
        return state.picture != nullptr;
    default:
        return true;
    }
}

void run_action(UiState& state, Action action) {
    if (!can_run(state, action)) return;
    run_file_action(state, action);
    run_edit_action(state, action);
    run_view_action(state, action);
}

void run_keys(UiState& state, const UiInput& input) {
    const bool busy =
        state.viewport.gesture != Gesture::None || (ImGui::IsAnyMouseDown() && ImGui::IsAnyItemActive());
    for (const KeyPress& press : input.presses) {
        if (press.key == Key::Escape) escape(state);
        if (busy || state.files.open || state.pending.asking) continue;
        // While text is typed its keys are text; Ctrl+S still saves.
        const bool typing = ImGui::GetIO().WantTextInput;
        if (typing && !(press.ctrl && press.key == Key::S)) continue;
        for (const ActionInfo& info : table)
            if (info.press.key != Key::Other && info.press == press) {
                run_action(state, info.action);
                break;
            }
    }
}

void begin_pending(UiState& state, Pending pending) {
    state.pending = std::move(pending);
    if (state.editor.unsaved())
        state.pending.asking = true;
    else
        finish_pending(state);
}

void finish_pending(UiState& state) {
    const Pending now = std::move(state.pending);
    state.pending = {};
    (void)cancel_gesture(state.viewport, state.editor.scene());
    if (now.what == Pending::What::Quit) state.quits = true;
    if (now.what == Pending::What::New) take_document(state.editor, first_scene());
    if (now.what == Pending::What::Open) {
        if (const auto problem = open_file(state.editor, now.path)) return state.notifications.add(*problem);
        state.notifications.add(state.editor.document.warnings);
    }
    if (now.what != Pending::What::Nothing) state.viewport.probe.reset();
}

bool save(UiState& state) {
    if (!state.editor.has_scene_file()) {
        state.files.ask(FilePurpose::SaveScene, offered(state, ".json"));
        return false;
    }
    if (const auto problem = save_file(state.editor, state.editor.document.path)) {
        state.notifications.add(*problem);
        state.pending = {};
        return false;
    }
    state.notifications.add(Tone::Done, fmt::format("Saved {}", state.editor.title()));
    return true;
}

}  // namespace glint
