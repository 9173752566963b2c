#include <algorithm>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/picture/draw_picture.h"

namespace glint {
namespace {

/// Removes messages about what keys did: after undo or redo they are outdated.
void forget_told(Notifications& notifications) {
    std::erase_if(notifications.list, [](const Notification& note) { return note.of_key; });
}

void add_bulb(UiState& state) { add_light(state.editor.scene(), state.editor.selection, LightKind::Point); }

template <LightEffect effect> void follow_by_effect(UiState& state) {
    begin_effect(state.viewport, state.editor.scene(), state.editor.selection, effect);
}

constexpr const char* is_of_another = "The picture is not showing the scene you are editing";

std::string unless_light(const UiState& state) {
    if (state.on_screen.is_out_of_hand()) return is_of_another;
    return unless(!state.editor.scene().lights.empty(), "The scene has no light");
}

/// Returns the light that contributes most under the cursor, or else at the picked point.
std::optional<MainLight> light_that_matters(const UiState& state) {
    if (state.viewport.main_light) return state.viewport.main_light;
    return is_explained(state) ? main_light(*state.on_screen.explanation) : std::nullopt;
}

std::string unless_item(const UiState& state) {
    const Selection::Kind kind = state.editor.selection.kind;
    return unless(kind == Selection::Kind::Light || kind == Selection::Kind::Object,
                  "No light or object is selected");
}

std::string why_no_light(const UiState& state) {
    return unless(state.editor.scene().lights.size() < max_lights, is_full);
}

std::string why_no_duplicate(const UiState& state) {
    const Scene& scene = state.editor.scene();
    if (state.editor.selection.kind == Selection::Kind::Light) return why_no_light(state);
    const bool is_object = state.editor.selection.kind == Selection::Kind::Object;
    return is_object && scene.objects.size() >= max_objects ? is_full : unless_item(state);
}

std::string unless_object(const UiState& state) {
    return unless(state.editor.selection.kind == Selection::Kind::Object,
                  "No object is selected: double-click one");
}

/// Shows a gizmo, or hides it if it is already visible.
void choose_gizmo(UiState& state, GizmoMode mode) {
    GizmoMode& shown = state.viewport.gizmo;
    shown = shown == mode && !state.viewport.pivot ? GizmoMode::None : mode;
    state.viewport.pivot.reset();
}

/// Makes the picked point the pivot: it stays at its pixel while everything else turns.
void rotate_about_picked(UiState& state) {
    state.editor.selection = {Selection::Kind::Object, state.on_screen.explanation->object_index};
    state.viewport.gizmo = GizmoMode::Rotate;
    state.viewport.pivot = glm::dvec3(state.on_screen.explanation->spaces.world);
}

void type_numbers(UiState& state) {
    state.layout.left = state.types_into_panel = true;
    state.layout.hides_columns = state.left_shows_inspector = false;
}

}  // namespace

std::vector<WindowCommand> edit_commands() {
    return {
        {.name = "Undo",
         .keys = {{Key::Z, ctrl}},
         .section = Section::Edit,
         .run =
             [](UiState& s) {
                 forget_told(s.notifications);
                 if (awaits_mesh(s)) return undo_awaiting(s);
                 s.notifications.tell("Undone: " + s.editor.history.undo_name());
                 undo(s.editor);
             },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.editor.history.can_undo() || awaits_mesh(s),
                               "Nothing to undo. Alt+Left returns to the previous view");
             },
         .id = CommandId::Undo},
        {.name = "Redo",
         .keys = {{Key::Z, ctrl, shift}, {Key::Y, ctrl}},
         .section = Section::Edit,
         .run =
             [](UiState& s) {
                 forget_told(s.notifications);
                 s.notifications.tell("Redone: " + s.editor.history.redo_name());
                 redo(s.editor);
             },
         .why_disabled =
             [](const UiState& s) {
                 if (!s.editor.history.can_redo()) return std::string("Nothing to redo");
                 // Edits made in the meantime are not yet an undo step and would be lost.
                 return unless(!awaits_mesh(s), "A mesh is being built: wait for it, or press Esc");
             },
         .id = CommandId::Redo},
        {.name = "Duplicate",
         .keys = {{Key::D, ctrl}},
         .section = Section::Edit,
         .run = [](UiState& s) { duplicate(s.editor.scene(), s.editor.selection); },
         .why_disabled = why_no_duplicate,
         .id = CommandId::Duplicate,
         .line_above = true,
         .words = "copy clone"},
        {.name = "Delete",
         .keys = {{Key::Delete}},
         .section = Section::Edit,
         .run = [](UiState& s) { remove(s.editor.scene(), s.editor.selection); },
         .why_disabled = unless_item,
         .id = CommandId::Delete,
         .words = "remove"},
        {.name = "Add a light",
         .keys = {{Key::L, !ctrl, shift}},
         .section = Section::Edit,
         .run = add_bulb,
         .why_disabled = why_no_light,
         .id = CommandId::AddLight},
    };
}

std::vector<WindowCommand> light_commands() {
    return {
        {.name = "Brightest here: the light follows the cursor",
         .keys = {{Key::H}},
         .section = Section::Edit,
         .run = follow_by_effect<LightEffect::Brightest>,
         .why_disabled = unless_light,
         .line_above = true},
        {.name = "Rim light here: it comes from behind the cursor",
         .keys = {{Key::H, !ctrl, shift}},
         .section = Section::Edit,
         .run = follow_by_effect<LightEffect::Rim>,
         .why_disabled = unless_light},
        {.name = "Select the light that matters most here",
         .keys = {{Key::K}},
         .section = Section::Edit,
         .run =
             [](UiState& s) {
                 s.editor.selection = {Selection::Kind::Light, light_that_matters(s)->light};
                 s.left_shows_inspector = false;
             },
         .why_disabled =
             [](const UiState& s) {
                 if (s.on_screen.is_out_of_hand()) return std::string(is_of_another);
                 return unless(light_that_matters(s).has_value(),
                               "No light contributes under the cursor or at a picked point");
             },
         .id = CommandId::SelectMainLight},
    };
}

std::vector<WindowCommand> hand_commands() {
    return {
        {.name = "Move the object by hand",
         .keys = {{Key::G}},
         .section = Section::Edit,
         .run = [](UiState& s) { choose_gizmo(s, GizmoMode::Move); },
         .is_on = [](const UiState& s) { return s.viewport.gizmo == GizmoMode::Move; },
         .why_disabled = unless_object,
         .id = CommandId::MoveByHand,
         .line_above = true,
         .words = "translate gizmo"},
        {.name = "Rotate the object by hand",
         .keys = {{Key::R}},
         .section = Section::Edit,
         .run = [](UiState& s) { choose_gizmo(s, GizmoMode::Rotate); },
         .is_on = [](const UiState& s) { return s.viewport.gizmo == GizmoMode::Rotate && !s.viewport.pivot; },
         .why_disabled = unless_object,
         .id = CommandId::RotateByHand,
         .words = "turn gizmo"},
        {.name = "Rotate the object about the picked point",
         .keys = {{Key::R, !ctrl, shift}},
         .section = Section::Edit,
         .run = rotate_about_picked,
         .is_on = [](const UiState& s) { return s.viewport.gizmo == GizmoMode::Rotate && s.viewport.pivot; },
         .why_disabled =
             [](const UiState& s) {
                 return unless(is_explained(s) && s.on_screen.explanation->hit,
                               "No point is picked: click one");
             }},
        {.name = "Scale the object by hand",
         .keys = {{Key::T}},
         .section = Section::Edit,
         .run = [](UiState& s) { choose_gizmo(s, GizmoMode::Scale); },
         .is_on = [](const UiState& s) { return s.viewport.gizmo == GizmoMode::Scale; },
         .why_disabled = unless_object,
         .id = CommandId::ScaleByHand,
         .words = "size gizmo"},
        {.name = "Type into the panel's fields",
         .keys = {{Key::Tab}},
         .section = Section::Edit,
         .run = type_numbers,
         .line_above = true},
        {.name = "Find an action…",
         .keys = {{Key::K, ctrl}},
         .section = Section::Edit,
         .run = open_palette,
         .id = CommandId::Palette,
         .quiet = true},
    };
}

namespace {

/// Opens the dialog in the folder of the open scene, or in the working directory; in the examples' folder if
/// that contains no scene.
void ask_scene(UiState& state) {
    const std::string& path = state.editor.document.path;
    state.files.ask(open_purpose, path);
    const auto is_file = [](const FolderEntry& entry) { return !entry.folder; };
    const bool fits = std::any_of(state.files.entries.begin(), state.files.entries.end(), is_file);
    if (!fits && !state.shipped_scenes.empty()) state.files.ask(open_purpose, state.shipped_scenes + "/");
}

void begin_anew(UiState& state) {
    cancel_loads(state);
    take_scene(state, first_scene());
}

}  // namespace

std::vector<WindowCommand> file_commands() {
    return {
        {.name = "New scene",
         .keys = {{Key::N, ctrl}},
         .section = Section::FileOpen,
         .run = [](UiState& s) { ask_first(s, begin_anew); }},
        {.name = "Open…",
         .keys = {{Key::O, ctrl}},
         .section = Section::FileOpen,
         .run = ask_scene,
         .id = CommandId::Open,
         .words = "load import"},
        {.name = "Save",
         .keys = {{Key::S, ctrl}},
         .section = Section::FileSave,
         .run = [](UiState& s) { save(s); },
         .line_above = true},
        {.name = "Save as…",
         .keys = {{Key::S, ctrl, shift}},
         .section = Section::FileSave,
         .run = [](UiState& s) { s.files.ask(save_purpose, offered_name(s, ".json")); }},
        {.name = "Quit",
         .keys = {{Key::Q, ctrl}},
         .section = Section::FileQuit,
         .run = [](UiState& s) { ask_first(s, [](UiState& now) { now.quits = true; }); },
         .id = CommandId::Quit,
         .line_above = true,
         .words = "exit close"},
    };
}

}  // namespace glint
