// The commands of the menus Lecture and Help.
#include "ui/commands/command_rows.h"
#include "ui/document/document_actions.h"
#include "ui/features/export/animation.h"
#include "ui/features/games/match.h"
#include "ui/features/games/quiz.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/features/lessons/predict_mode.h"
#include "ui/picture/draw_picture.h"

namespace glint {
namespace {

/// Returns the next scene of those that the program was given, else of the folder; for a scene without a
/// file, of those that come with the program. One that cannot be opened is passed over the next time.
std::string other_scene(const UiState& state, int step) {
    const AskedScene& asked = state.get<LectureState>().asked;
    const std::string& open = state.editor.document.path;
    const bool goes_on = asked.failed && asked.step == step && asked.from == open;
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
    state.get<LectureState>().asked = {state.editor.document.path, path, step, false};
    begin_pending(state, Pending::What::Open, path);
}

/// Another one than the last, so that the command played twice plays two.
void new_match(UiState& state) {
    begin_pending(state, Pending::What::Match,
                  std::to_string(state.get<MatchState>().seed + (state.get<MatchState>().on ? 1 : 0)));
}

void switch_projector(UiState& state) {
    LectureState& lecture = state.get<LectureState>();
    LayoutState& layout = state.layout;
    lecture.projector = !lecture.projector;
    if (lecture.projector) {
        lecture.left_before = layout.left;
        lecture.right_before = layout.right;
    }
    // The equation stays, larger, and has the room of the scene's list; a lesson keeps its own.
    layout.left = !lecture.projector && lecture.left_before;
    layout.right = lecture.projector || lecture.right_before;
    if (!state.layout.lesson) state.left_shows_inspector |= lecture.projector;
}

void switch_frozen(UiState& state) {
    if (state.get<LectureState>().frozen)
        state.get<LectureState>().frozen.reset();
    else
        freeze(state);
}

void switch_animate(UiState& state) {
    state.get<AnimateState>().open =
        !state.get<AnimateState>().open ||
        state.get<AnimateState>().job;  // it says how far what is written has come
    state.get<AnimateState>().playing &= state.get<AnimateState>().open;
}

std::string unless_drawn_on(const UiState& state) {
    return unless(!state.get<PenState>().lines.empty(), "Nothing is drawn");
}

/// Scenes one after another, and what is asked about them.
std::vector<WindowCommand> asking_commands() {
    return {
        {.name = "Next scene of the folder",
         .keys = {{Key::PageDown}},
         .menu = Menu::Lecture,
         .run = [](UiState& s) { open_other(s, 1); },
         .quiet = true},
        {.name = "Previous scene of the folder",
         .keys = {{Key::PageUp}},
         .menu = Menu::Lecture,
         .run = [](UiState& s) { open_other(s, -1); },
         .quiet = true},
        {.name = "Predict a colour: the picture stands still",
         .keys = {{Key::Q}},
         .menu = Menu::Lecture,
         .run = switch_prediction,
         .is_on = [](const UiState& s) { return s.get<PredictState>().stage != PredictStage::Off; },
         .why_disabled = [](const UiState& s) { return unless_drawn(s.rendered); },
         .line_above = true,
         .noun = "Predict a colour"},
        {.name = "Match the target", .menu = Menu::Lecture, .run = new_match, .words = "game play"},
        {.name = "Quiz: what do you believe about lighting?",
         .menu = Menu::Lecture,
         .run = open_quiz,
         .why_disabled =
             [](const UiState& s) {
                 return unless(!s.get<LessonState>().inventory.empty(), "The quiz of Glint is not installed");
             },
         .quiet = true,
         .words = "test game"},
        {.name = "Lecturer: a lesson's questions without its answers",
         .menu = Menu::Lecture,
         .run = switch_lecturer,
         .is_on = [](const UiState& s) { return s.get<LessonState>().lecturer; },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.get<LessonState>().course != nullptr, "No lesson is open");
             },
         .quiet = true},
    };
}

/// How the picture stands before an audience.
std::vector<WindowCommand> showing_commands() {
    return {
        {.name = "Projector: large type, strong contrast",
         .keys = {{Key::F9}},
         .menu = Menu::Lecture,
         .run = switch_projector,
         .is_on = [](const UiState& s) { return s.get<LectureState>().projector; },
         .line_above = true,
         .quiet = true,
         .words = "presentation font size beamer"},
        {.name = "Clean picture: no handles, no panels",
         .keys = {{Key::F10}},
         .menu = Menu::Lecture,
         .run = [](UiState& s) { s.layout.hides_all ^= true; },
         .is_on = [](const UiState& s) { return s.layout.hides_all; },
         .quiet = true},
        {.name = "Freeze the picture",
         .keys = {{Key::F8}},
         .menu = Menu::Lecture,
         .run = switch_frozen,
         .is_on = [](const UiState& s) { return s.get<LectureState>().frozen.has_value(); },
         .why_disabled = [](const UiState& s) { return unless_drawn(s.rendered); },
         .id = CommandId::Freeze,
         .words = "pause hold"},
        {.name = "Pen",
         .keys = {{Key::W}},
         .menu = Menu::Lecture,
         .run = [](UiState& s) { s.get<PenState>().on ^= true; },
         .is_on = [](const UiState& s) { return s.get<PenState>().on; },
         .id = CommandId::Pen,
         .line_above = true,
         .quiet = true,
         .words = "draw annotate"},
        {.name = "Wipe what the pen drew",
         .keys = {{Key::W, !ctrl, shift}},
         .menu = Menu::Lecture,
         .run = [](UiState& s) { s.get<PenState>().lines.clear(); },
         .why_disabled = unless_drawn_on,
         .id = CommandId::WipePen,
         .quiet = true},
        {.name = "Pen: take the last line back",
         .run = [](UiState& s) { s.get<PenState>().lines.pop_back(); },
         .why_disabled = unless_drawn_on,
         .quiet = true,
         .words = "undo"},
        {.name = "Pen: the next colour",
         .run =
             [](UiState& s) { s.get<PenState>().colour = (s.get<PenState>().colour + 1) % pen_colour_count; },
         .why_disabled =
             [](const UiState& s) { return unless(s.get<PenState>().on, "The pen is not in hand"); },
         .quiet = true},
        {.name = "Animate: turntable, numbers to and fro…",
         .keys = {{Key::T, ctrl}},
         .menu = Menu::Lecture,
         .run = switch_animate,
         .is_on = [](const UiState& s) { return s.get<AnimateState>().open; },
         .line_above = true,
         .words = "video movie gif webp"},
        {.name = "Step wedge: what does this projector show?",
         .menu = Menu::Lecture,
         .run = [](UiState& s) { s.get<WedgeState>().open ^= true; },
         .is_on = [](const UiState& s) { return s.get<WedgeState>().open; },
         .line_above = true,
         .quiet = true},
        {.name = "Keys and mouse",
         .keys = {{Key::F1}, {Key::Question, !ctrl, shift}},
         .menu = Menu::Help,
         .run = [](UiState& s) { s.shows_shortcuts ^= true; },
         .is_on = [](const UiState& s) { return s.shows_shortcuts; },
         .words = "help shortcuts keyboard"},
    };
}

}  // namespace

std::vector<WindowCommand> lecture_commands() {
    std::vector<WindowCommand> all = asking_commands();
    const std::vector<WindowCommand> showing = showing_commands();
    all.insert(all.end(), showing.begin(), showing.end());
    return all;
}

}  // namespace glint
