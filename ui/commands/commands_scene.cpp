// Commands that set a value of the scene: its camera (the View menu, and view directions that have only
// keys), and the shading mode and terms of the equation, which are in the tool bar but not in any menu.
#include "ui/commands/command.h"
#include "ui/picture/orbit.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// Frames the object at index `object`, or all objects for -1.
void frame(UiState& state, int object) {
    if (frame_camera(state.editor.scene(), object)) {
        if (state.rendered != nullptr) fill_picture(state.editor.scene(), object, state.full_size);
        return;
    }
    state.notifications.add(Tone::Warning, "No camera can show all of it: it would have to be too far away");
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
    state.notifications.tell("This view is kept: " + keys_of(CommandId::NextView) + " returns to it");
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
    return unless(!state.editor.scene().objects.empty(), "The scene has no object");
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
                               "The camera is already the saved one");
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

}  // namespace glint
