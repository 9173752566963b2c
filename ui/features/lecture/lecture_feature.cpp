// The features of a lecture: freeze and pages, the step wedge, the pen, a picture without bars.
#include <utility>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// Returns the next scene on the command line, else the next one in the folder; for a scene without a file,
/// of the scenes that come with the program. Skips a scene that could not be opened.
std::string other_scene(const UiState& state, int step) {
    const AskedScene& asked = state.get<LectureState>().asked;
    const std::string& open = state.editor.document.path;
    const bool failed = !asked.path.empty() && state.loading.failed == asked.path;
    const bool goes_on = failed && asked.step == step && asked.from == open;
    const std::string& path = goes_on ? asked.path : open;
    const bool has_file = !path.empty() && path != "-";
    const std::string& place = has_file ? path : state.get<LectureState>().last_given;
    if (const auto given = given_scene_beside(state.get<LectureState>().given_scenes, place, step))
        return *given;
    if (has_file) return scene_beside(path, step);
    const auto scenes = folder_scenes(state.shipped_scenes);
    if (state.shipped_scenes.empty() || scenes.empty()) return {};
    return step > 0 ? scenes.front() : scenes.back();
}

void open_other(UiState& state, int step) {
    if (state.get<LessonState>().course) return page_lesson(state, step);
    const std::string path = other_scene(state, step);
    if (path.empty())
        return state.notifications.tell(step > 0 ? "This is the last scene" : "This is the first scene");
    state.get<LectureState>().asked = {state.editor.document.path, path, step};
    ask_to_open(state, path);
}

void switch_projector(UiState& state) {
    LayoutState& layout = state.layout;
    layout.projector = !layout.projector;
    if (layout.projector) {
        layout.left_before = layout.left;
        layout.right_before = layout.right;
    }
    // The equation stays, enlarged, in the space of the scene's list; a lesson keeps its own column.
    layout.left = !layout.projector && layout.left_before;
    layout.right = layout.projector || layout.right_before;
    if (!layout.lesson) state.left_shows_inspector |= layout.projector;
}

void switch_frozen(UiState& state) {
    if (state.get<LectureState>().frozen)
        state.get<LectureState>().frozen.reset();
    else
        freeze(state);
}

std::optional<OtherScene> show_frozen(const UiState& state) {
    const LectureState& lecture = state.get<LectureState>();
    if (!lecture.frozen) return {};
    const std::string key = keys_of(CommandId::Freeze);
    return OtherScene{
        .scene = *lecture.frozen,
        .name = "the frozen picture",
        .label = "Frozen",
        .note = "Frozen picture",
        .key = CommandId::Freeze,
        .end = [](UiState& s) { s.get<LectureState>().frozen.reset(); },
        .selection = lecture.frozen_selection,
        .refusal = "The picture is frozen: " + key + " unfreezes it",
        .hint = "Frozen · " + key + ": unfreeze",
        .press = [](UiState& s) { s.notifications.tell(s.on_screen.refusal(), Tone::Warning); }};
}

std::vector<WindowCommand> lecture_commands() {
    return {
        {.name = "Next scene of the folder",
         .keys = {{Key::PageDown}},
         .section = Section::LecturePages,
         .run = [](UiState& s) { open_other(s, 1); },
         .quiet = true},
        {.name = "Previous scene of the folder",
         .keys = {{Key::PageUp}},
         .section = Section::LecturePages,
         .run = [](UiState& s) { open_other(s, -1); },
         .quiet = true},
        {.name = "Projector: large type, strong contrast",
         .keys = {{Key::F9}},
         .section = Section::LectureShow,
         .run = switch_projector,
         .is_on = [](const UiState& s) { return s.layout.projector; },
         .line_above = true,
         .quiet = true,
         .words = "presentation font size beamer"},
        {.name = "Clean picture: no handles, no panels",
         .keys = {{Key::F10}},
         .section = Section::LectureShow,
         .run = [](UiState& s) { s.layout.hides_all ^= true; },
         .is_on = [](const UiState& s) { return s.layout.hides_all; },
         .quiet = true},
        {.name = "Freeze the picture",
         .keys = {{Key::F8}},
         .section = Section::LectureShow,
         .run = switch_frozen,
         .is_on = [](const UiState& s) { return s.get<LectureState>().frozen.has_value(); },
         .why_disabled = [](const UiState& s) { return unless_drawn(s.rendered); },
         .id = CommandId::Freeze,
         .words = "pause hold"},
    };
}

void leave_with_lecture(UiState& state, const SceneDocument& next) {
    LectureState& lecture = state.get<LectureState>();
    if (is_another(state, next)) lecture.frozen.reset();
    if (given_scene_beside(lecture.given_scenes, next.path, 0)) lecture.last_given = next.path;
}

std::string unless_drawn_on(const UiState& state) {
    return unless(!state.get<PenState>().lines.empty(), "Nothing is drawn");
}

std::vector<WindowCommand> pen_commands() {
    return {
        {.name = "Pen",
         .keys = {{Key::W, !ctrl, shift}},
         .section = Section::LectureShow,
         .run = [](UiState& s) { s.get<PenState>().on ^= true; },
         .is_on = [](const UiState& s) { return s.get<PenState>().on; },
         .id = CommandId::Pen,
         .line_above = true,
         .quiet = true,
         .words = "draw annotate"},
        {.name = "Erase all pen strokes",
         .keys = {{Key::W, !ctrl, !shift, alt}},
         .section = Section::LectureShow,
         .run = [](UiState& s) { s.get<PenState>().lines.clear(); },
         .why_disabled = unless_drawn_on,
         .id = CommandId::WipePen,
         .quiet = true},
        {.name = "Pen: undo the last stroke",
         .run = [](UiState& s) { s.get<PenState>().lines.pop_back(); },
         .why_disabled = unless_drawn_on,
         .quiet = true,
         .words = "undo"},
        {.name = "Pen: the next colour",
         .run =
             [](UiState& s) { s.get<PenState>().colour = (s.get<PenState>().colour + 1) % pen_colour_count; },
         .why_disabled =
             [](const UiState& s) { return unless(s.get<PenState>().on, "The pen is not active"); },
         .quiet = true},
    };
}

void reshape_pen(UiState& state, const Reshape& reshape) {
    for (PenLine& line : state.get<PenState>().lines)
        for (glm::vec2& place : line.places) place *= reshape.in_heights;
}

std::vector<WindowCommand> wedge_commands() {
    return {
        {.name = "Step wedge: what does this projector show?",
         .section = Section::LectureWedge,
         .run = [](UiState& s) { s.get<WedgeState>().open ^= true; },
         .is_on = [](const UiState& s) { return s.get<WedgeState>().open; },
         .line_above = true,
         .quiet = true},
    };
}

}  // namespace

void freeze(UiState& state) {
    LectureState& lecture = state.get<LectureState>();
    // If B or an animation is shown, nothing is selected.
    lecture.frozen_selection = state.on_screen.is_out_of_hand()
                                   ? Selection{}
                                   : valid_selection(state.editor.selection, state.rendered_scene);
    lecture.frozen = as_made(state, state.rendered_scene);
}

extern const Feature lecture_feature, pen_feature, wedge_feature, clean_picture_feature;

const Feature lecture_feature{
    .shows = show_frozen,
    .commands = lecture_commands,
    .is_presented =
        [](const UiState& s) { return s.layout.projector || s.get<LectureState>().frozen.has_value(); },
    .leave_document = leave_with_lecture,
    .put_away = [](UiState& s) { s.get<LectureState>().frozen.reset(); }};

const Feature pen_feature{
    .draw = [](UiState& s, const Layout&) { pen_bar(s.get<PenState>(), picture_in_sight(s)); },
    .tool = &pen_tool,
    .overlay = [](ImDrawList& list, UiState& s,
                  const PictureView& view) { draw_pen(list, s.get<PenState>(), view); },
    .overlay_stays = true,
    .reshape = reshape_pen,
    .commands = pen_commands,
    .escape = [](UiState& s) { return std::exchange(s.get<PenState>().on, false); },
    .is_presented = [](const UiState& s) { return s.get<PenState>().on; }};

const Feature wedge_feature{
    .draw = [](UiState& s, const Layout&) { step_wedge(s.get<WedgeState>()); },
    .commands = wedge_commands,
    .escape = [](UiState& s) { return std::exchange(s.get<WedgeState>().open, false); }};

const Feature clean_picture_feature{
    .escape = [](UiState& s) { return std::exchange(s.layout.hides_all, false); }};

}  // namespace glint
