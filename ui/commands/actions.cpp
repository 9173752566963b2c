#include "ui/commands/actions.h"

#include <filesystem>

#include "ui/commands/palette.h"
#include "ui/export/clipboard.h"
#include "ui/export/command_text.h"
#include "ui/picture/camera_actions.h"
#include "ui/picture/draw_picture.h"
#include "ui/views/views.h"

namespace glint {
namespace {

void set_mode(UiState& state, ShadingMode mode) { state.editor.scene().shading.mode = mode; }

void frame(UiState& state, int object) {
    Scene& scene = state.editor.scene();
    if (!scene.objects.empty()) frame_camera(scene, object);
}

void add_bulb(UiState& state) {
    if (const auto index = add_light(state.editor.scene(), LightKind::Point))
        state.editor.selection = {Selection::Kind::Light, *index};
}

void copy_command(UiState& state) {
    const std::string command =
        render_command_text(state.editor.document, state.editor.saved, state.picture->size, 1,
                            std::filesystem::path(offered_name(state, ".png")).filename().string());
    ImGui::SetClipboardText(command.c_str());
    state.notifications.add(Tone::Done, "The command that draws this picture is on the clipboard");
}

/// The key of the gizmo that shows takes it away.
void choose_gizmo(UiState& state, GizmoMode mode) {
    GizmoMode& shown = state.viewport.gizmo;
    shown = shown == mode && !state.viewport.pivot ? GizmoMode::None : mode;
    state.viewport.pivot.reset();
}

/// The point stays where it was picked, so that the pixel there goes on showing it while all else turns.
void rotate_about_picked(UiState& state) {
    state.editor.selection = {Selection::Kind::Object, state.why->object_index};
    state.viewport.gizmo = GizmoMode::Rotate;
    state.viewport.pivot = glm::dvec3(state.why->spaces.world);
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
        return state.files.ask(FilePurpose::SaveScene, offered_name(state, ".json"));
    case Action::SavePicture:
        return state.files.ask(FilePurpose::SavePicture, offered_name(state, ".png"));
    case Action::ExportPicture:
        state.exporting.open = true;
        return;
    case Action::CopyPicture:
        return begin_copy(state);
    case Action::CopyCommand:
        return copy_command(state);
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
    case Action::MoveByHand:
        return choose_gizmo(state, GizmoMode::Move);
    case Action::RotateByHand:
        return choose_gizmo(state, GizmoMode::Rotate);
    case Action::RotateAboutPicked:
        return rotate_about_picked(state);
    case Action::ScaleByHand:
        return choose_gizmo(state, GizmoMode::Scale);
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
    case Action::FrameSelected: {
        const Selection& selected = state.editor.selection;
        return frame(state, selected.kind == Selection::Kind::Object ? selected.index : -1);
    }
    case Action::Fold:
        state.layout.folded = !state.layout.folded;
        return;
    case Action::Vectors:
        state.why_column.shows_vectors ^= true;
        return;
    case Action::TypeNumbers:
        state.layout.left = state.types_into_panel = true;
        state.layout.folded = state.left_shows_why = false;
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
    case Action::ResetLayout:
        return reset_layout(state);
    case Action::Shortcuts:
        state.shows_shortcuts = !state.shows_shortcuts;
        return;
    case Action::Palette:
        return open_palette(state);
    default:
        return;
    }
}

bool is_item(const Selection& s) {
    return s.kind == Selection::Kind::Light || s.kind == Selection::Kind::Object;
}

}  // namespace

std::string why_not(const UiState& state, Action action) {
    const auto unless = [](bool possible, const char* reason) { return std::string(possible ? "" : reason); };
    switch (action) {
    case Action::Undo:
        return unless(state.editor.history.can_undo(), "Nothing to undo");
    case Action::Redo:
        return unless(state.editor.history.can_redo(), "Nothing to redo");
    case Action::MoveByHand:
    case Action::RotateByHand:
    case Action::ScaleByHand:
        return unless(state.editor.selection.kind == Selection::Kind::Object,
                      "No object is selected: double-click one");
    case Action::RotateAboutPicked:
        return unless(is_explained(state) && state.why->hit, "No point is picked: click one");
    case Action::Duplicate:
    case Action::Delete:
        return unless(is_item(state.editor.selection), "No light and no object is selected");
    case Action::FrameAll:
    case Action::FrameSelected:
        return unless(!state.editor.scene().objects.empty(), "The scene has no object");
    case Action::NextView:
        return unless(!state.kept_views.empty(), "No view is kept yet: Shift+U keeps this one");
    case Action::SavedCamera:
        return unless(state.editor.scene().camera != state.editor.saved.camera,
                      "The camera is the saved one already");
    case Action::SavePicture:
    case Action::CopyCommand:
        return unless(state.picture != nullptr, "There is no picture yet");
    case Action::ExportPicture:
        return unless(!state.exporting.job, "Another picture is being written");
    case Action::CopyPicture:
        if (state.exporting.job) return "Another picture is being written";
        return state.picture == nullptr ? "There is no picture yet" : why_no_clipboard();
    default:
        return views_why_not(state, action) + lecture_why_not(state, action);
    }
}

std::optional<bool> is_on(const UiState& state, Action action) {
    const Shading& shading = state.editor.scene().shading;
    switch (action) {
    case Action::MoveByHand:
        return state.viewport.gizmo == GizmoMode::Move;
    case Action::RotateByHand:
        return state.viewport.gizmo == GizmoMode::Rotate && !state.viewport.pivot;
    case Action::RotateAboutPicked:
        return state.viewport.gizmo == GizmoMode::Rotate && state.viewport.pivot;
    case Action::ScaleByHand:
        return state.viewport.gizmo == GizmoMode::Scale;
    case Action::Fold:
        return state.layout.folded;
    case Action::Vectors:
        return state.why_column.shows_vectors;
    case Action::LeftColumn:
        return state.layout.left && !state.layout.folded;
    case Action::RightColumn:
        return state.layout.right && !state.layout.folded;
    case Action::SwitchTheme:
        return !state.dark;
    case Action::Shortcuts:
        return state.shows_shortcuts;
    case Action::Flat:
        return shading.mode == ShadingMode::Flat;
    case Action::Facet:
        return shading.mode == ShadingMode::Facet;
    case Action::Gouraud:
        return shading.mode == ShadingMode::Gouraud;
    case Action::Phong:
        return shading.mode == ShadingMode::Phong;
    case Action::Emission:
        return shading.terms.emission;
    case Action::Ambient:
        return shading.terms.ambient;
    case Action::Diffuse:
        return shading.terms.diffuse;
    case Action::Specular:
        return shading.terms.specular;
    default:
        if (const auto on = lecture_is_on(state, action)) return on;
        return views_is_on(state, action);
    }
}

void run_action(UiState& state, Action action) {
    if (!can_run(state, action)) return;
    if (run_camera_action(state, action)) return;
    run_file_action(state, action);
    run_edit_action(state, action);
    run_view_action(state, action);
    run_views_action(state, action);
    run_lecture_action(state, action);
}

}  // namespace glint
