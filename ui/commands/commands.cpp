// The commands of the Edit menu, of the scene and of the View menu.

#include <imgui.h>

#include <algorithm>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/magnifier.h"
#include "ui/picture/orbit.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"

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
    return unless(!state.editor.scene().lights.empty(), "The scene has no lights");
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

/// Makes the picked point the pivot: it stays at its pixel while the object turns around it.
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
/// that folder contains no scene.
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

// Commands that set a value of the scene: its camera (the View menu, and view directions that have only
// keys), and the shading mode and terms of the equation, which are in the tool bar but not in any menu.

namespace {

/// Frames the object at index `object`, or all objects for -1.
void frame(UiState& state, int object) {
    if (frame_camera(state.editor.scene(), object)) {
        if (state.rendered != nullptr) fill_picture(state.editor.scene(), object, state.full_size);
        return;
    }
    state.notifications.add(Tone::Warning, "The camera would have to be too far away to show all of it");
}

void frame_selected(UiState& state) {
    const Selection& selected = state.editor.selection;
    frame(state, selected.kind == Selection::Kind::Object ? selected.index : -1);
}

template <ViewFrom side> void look_from(UiState& state) {
    Scene& scene = state.editor.scene();
    const Camera before = scene.camera;
    scene.camera = seen_from(scene.camera, side);
    keep_depth_range(scene.camera, before, scene_bounds(scene));
}

void switch_projection(UiState& state) {
    Camera& camera = state.editor.scene().camera;
    if (state.rendered != nullptr) camera = other_projection(camera, state.rendered->size);
}

/// Goes one view back or forward. This moves within the view history and adds nothing to it.
void go_to_view(UiState& state, Camera (ViewHistory::*step)(const Camera&)) {
    Editor& editor = state.editor;
    editor.scene().camera = (editor.views.*step)(editor.scene().camera);
    editor.history.look(editor.scene().camera);
}

void keep_this_view(UiState& state) {
    keep_view(state.kept_views, state.editor.scene().camera);
    state.notifications.tell("View kept: " + keys_of(CommandId::NextView) + " returns to it");
}

void show_next_view(UiState& state) {
    Camera& camera = state.editor.scene().camera;
    if (const auto view = next_view(state.kept_views, camera)) camera = *view;
}

template <ShadingMode mode> WindowCommand mode_command(const char* name, Key key, const char* sets) {
    return {.name = name,
            .keys = {{key}},
            .run = [](UiState& s) { s.editor.scene().shading.mode = mode; },
            .is_on = [](const UiState& s) { return s.editor.scene().shading.mode == mode; },
            .sets = sets};
}

template <bool Terms::*term>
WindowCommand term_command(const char* name, const char* noun, Key key, const char* sets) {
    return {.name = name,
            .keys = {{key, !ctrl, shift}},
            .run = [](UiState& s) { s.editor.scene().shading.terms.*term ^= true; },
            .is_on = [](const UiState& s) { return s.editor.scene().shading.terms.*term; },
            .noun = noun,
            .sets = sets};
}

}  // namespace

std::string unless_objects(const UiState& state) {
    return unless(!state.editor.scene().objects.empty(), "The scene has no objects");
}

std::vector<WindowCommand> camera_commands() {
    return {
        {.name = "Frame the selected object, or all",
         .keys = {{Key::F}, {Key::PadPoint}},
         .section = Section::ViewCamera,
         .run = frame_selected,
         .why_disabled = unless_objects,
         .words = "zoom fit focus"},
        {.name = "Frame all",
         .keys = {{Key::F, !ctrl, shift}},
         .section = Section::ViewCamera,
         .run = [](UiState& s) { frame(s, -1); },
         .why_disabled = unless_objects},
        {.name = "Perspective or parallel",
         .keys = {{Key::Pad5}},
         .section = Section::ViewCamera,
         .run = switch_projection,
         .words = "orthographic projection"},
        {.name = "Back to the saved camera",
         .keys = {{Key::Pad0}},
         .section = Section::ViewCamera,
         .run = [](UiState& s) { s.editor.scene().camera = s.editor.saved.camera; },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.editor.scene().camera != s.editor.saved.camera,
                               "The camera already matches the saved one");
             }},
        {.name = "Previous view",
         .keys = {{Key::Left, !ctrl, !shift, alt}},
         .section = Section::ViewCamera,
         .run = [](UiState& s) { go_to_view(s, &ViewHistory::back); },
         .why_disabled =
             [](const UiState& s) { return unless(s.editor.views.can_go_back(), "No previous view"); }},
        {.name = "Next view",
         .keys = {{Key::Right, !ctrl, !shift, alt}},
         .section = Section::ViewCamera,
         .run = [](UiState& s) { go_to_view(s, &ViewHistory::forward); },
         .why_disabled =
             [](const UiState& s) { return unless(s.editor.views.can_go_forward(), "No next view"); }},
        {.name = "Keep this view",
         .keys = {{Key::U, !ctrl, shift}},
         .section = Section::ViewCamera,
         .run = keep_this_view,
         .id = CommandId::KeepView},
        {.name = "Next kept view",
         .keys = {{Key::U}},
         .section = Section::ViewCamera,
         .run = show_next_view,
         .why_disabled =
             [](const UiState& s) {
                 return s.kept_views.empty()
                            ? "No view is kept yet: " + keys_of(CommandId::KeepView) + " keeps this one"
                            : std::string();
             },
         .id = CommandId::NextView},
        {.name = "View from the front",
         .keys = {{Key::Pad1}},
         .run = look_from<ViewFrom::Front>,
         .id = CommandId::ViewFront},
        {.name = "View from behind",
         .keys = {{Key::Pad1, ctrl}},
         .run = look_from<ViewFrom::Back>,
         .id = CommandId::ViewBack},
        {.name = "View from the right",
         .keys = {{Key::Pad3}},
         .run = look_from<ViewFrom::Right>,
         .id = CommandId::ViewRight},
        {.name = "View from the left",
         .keys = {{Key::Pad3, ctrl}},
         .run = look_from<ViewFrom::Left>,
         .id = CommandId::ViewLeft},
        {.name = "View from above",
         .keys = {{Key::Pad7}},
         .run = look_from<ViewFrom::Top>,
         .id = CommandId::ViewTop},
        {.name = "View from below",
         .keys = {{Key::Pad7, ctrl}},
         .run = look_from<ViewFrom::Bottom>,
         .id = CommandId::ViewBottom},
    };
}

std::vector<WindowCommand> shading_commands() {
    return {
        mode_command<ShadingMode::Flat>("Flat shading", Key::Digit1, "/shading/mode = \"flat\""),
        mode_command<ShadingMode::Facet>("Facet shading", Key::Digit2, "/shading/mode = \"facet\""),
        mode_command<ShadingMode::Gouraud>("Gouraud shading", Key::Digit3, "/shading/mode = \"gouraud\""),
        mode_command<ShadingMode::Phong>("Phong shading", Key::Digit4, "/shading/mode = \"phong\""),
        term_command<&Terms::emission>("Emission on or off", "Emission", Key::E, "/shading/terms/emission"),
        term_command<&Terms::ambient>("Ambient on or off", "Ambient", Key::A, "/shading/terms/ambient"),
        term_command<&Terms::diffuse>("Diffuse on or off", "Diffuse", Key::D, "/shading/terms/diffuse"),
        term_command<&Terms::specular>("Specular on or off", "Specular", Key::S, "/shading/terms/specular"),
    };
}

// The commands of the View menu, except those for the camera and those of features.

namespace {

void switch_magnifier(UiState& state) {
    zoom_about(state.get<MagnifierState>(), state.get<MagnifierState>().zoom > 1 ? 1 : usual_zoom,
               state.viewport.probe.value_or(glm::dvec2(0.5)));
}

/// An arrow key picks the pixel next to the picked one; with Shift, ten pixels away.
template <int right, int down> WindowCommand step_command(const char* name, Key key) {
    return {.name = name,
            .keys = {{key}, {key, !ctrl, shift}},
            .run =
                [](UiState& s) {
                    const int pixels = ImGui::GetIO().KeyShift ? 10 : 1;
                    step_probe(s.viewport, s.rendered->size, pixels * glm::ivec2(right, down));
                    s.left_shows_inspector = true;
                },
            .why_disabled =
                [](const UiState& s) {
                    const std::string refusal = s.on_screen.refusal();
                    return refusal.empty() ? unless_drawn(s.rendered) : refusal;
                },
            .words = "pick probe step"};
}

std::vector<WindowCommand> stepping_commands() {
    return {step_command<-1, 0>("Pick the pixel to the left", Key::Left),
            step_command<1, 0>("Pick the pixel to the right", Key::Right),
            step_command<0, -1>("Pick the pixel above", Key::Up),
            step_command<0, 1>("Pick the pixel below", Key::Down)};
}

std::vector<WindowCommand> looking_commands() {
    return {
        {.name = "Back to the point picked before",
         .keys = {{Key::V, !ctrl, shift}},
         .section = Section::InspectProbe,
         .run = [](UiState& s) { ask_as_before(s.viewport); },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.viewport.probe_before.has_value(), "No other point has been picked yet");
             }},
        {.name = "Big pixels",
         .keys = {{Key::M}},
         .section = Section::InspectPixels,
         .run = switch_magnifier,
         .is_on = [](const UiState& s) { return s.get<MagnifierState>().zoom > 1; },
         .id = CommandId::Magnify,
         .changes_picture = true},
    };
}

bool is_narrow_now() { return is_narrow(ImGui::GetIO().DisplaySize, px(1)); }

// In a narrow window the two columns are tabs of one column: showing a column selects its tab.

bool shows_scene_column(const UiState& s) {
    return s.layout.left && !s.layout.hides_columns && !(is_narrow_now() && s.left_shows_inspector);
}
bool shows_why_column(const UiState& s) {
    return s.layout.right && !s.layout.hides_columns && (!is_narrow_now() || s.left_shows_inspector);
}

void switch_scene_column(UiState& s) {
    s.layout.left = !shows_scene_column(s);
    s.layout.hides_columns = false;
    s.left_shows_inspector = !s.layout.left;
}

void switch_why_column(UiState& s) {
    s.layout.right = !shows_why_column(s);
    s.layout.hides_columns = false;
    s.left_shows_inspector = s.layout.right;
}

std::vector<WindowCommand> layout_commands() {
    return {
        {.name = "Keys and mouse",
         .keys = {{Key::F1}, {Key::Question, !ctrl, shift}},
         .section = Section::Help,
         .run = [](UiState& s) { s.shows_shortcuts ^= true; },
         .is_on = [](const UiState& s) { return s.shows_shortcuts; },
         .words = "help shortcuts keyboard"},
        {.name = "Scene column",
         .section = Section::ViewWindow,
         .run = switch_scene_column,
         .is_on = shows_scene_column,
         .line_above = true},
        {.name = "Why column",
         .section = Section::ViewWindow,
         .run = switch_why_column,
         .is_on = shows_why_column},
        {.name = "Picture alone",
         .keys = {{Key::F11}},
         .section = Section::ViewWindow,
         .run = [](UiState& s) { s.layout.hides_columns ^= true; },
         .is_on = [](const UiState& s) { return s.layout.hides_columns; },
         .quiet = true,
         .words = "fullscreen columns"},
        {.name = "Caption of the scene",
         .section = Section::ViewWindow,
         .run = [](UiState& s) { s.layout.caption ^= true; },
         .is_on = [](const UiState& s) { return s.layout.caption; },
         .quiet = true},
        {.name = "Light theme",
         .section = Section::ViewWindow,
         .run = [](UiState& s) { s.dark ^= true; },
         .is_on = [](const UiState& s) { return !s.dark; },
         .line_above = true,
         .quiet = true,
         .words = "dark mode colours"},
        {.name = "Reset the window",
         .section = Section::ViewWindow,
         .run = reset_layout,
         .words = "layout columns default"},
    };
}

}  // namespace

std::vector<WindowCommand> view_commands() {
    std::vector<WindowCommand> all;
    for (const auto rows : {looking_commands, stepping_commands, layout_commands})
        for (WindowCommand& row : rows()) all.push_back(std::move(row));
    return all;
}

}  // namespace glint
