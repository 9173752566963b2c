#include "ui/features/lessons/lesson.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "ui/document/document_actions.h"
#include "ui/document/editor.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/sensitivity.h"
#include "ui/features/lessons/course.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/scope.h"
#include "ui/features/views/views.h"
#include "ui/picture/picture_notes.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Sets a scene of the lesson as an undo step that does not count as an unsaved edit. It belongs to no file,
/// even if the previous scene was saved under a name.
void set_scene(UiState& state, const Scene& scene) {
    Editor& editor = state.editor;
    (void)cancel_gesture(state.viewport, editor.scene());
    let_go_of_fields();
    give_up_meshes(state);  // the visible meshes belong to the previous step
    remember_step(editor, false);
    editor.scene() = scene;
    state.get<SensitivityState>().forget();
    editor.followed.reset();  // the new scene's lights are unrelated to the previous ones
    editor.document.path.clear();
    editor.document.stamp = {};
    editor.edits_camera = true;
    remember_step(editor, false);
    editor.saved = scene;
    editor.saved_edited_camera = editor.history.edited_camera();
    editor.selection = valid_selection(editor.selection, scene);
}

void forget_input(LessonState& lesson) {
    lesson.typed.clear();
    lesson.reason.clear();
    lesson.chosen = {};
    lesson.sketched.reset();
}

/// Selects the item that the first task edits, so that its handles are visible.
void select_for_tasks(UiState& state) {
    for (const StationPart& part : state.get<LessonState>().station().after) {
        if (part.task == nullptr) continue;
        for (const std::string& pointer : part.task->controls) {
            const std::optional<Selection> item = selection_in(pointer);
            if (!item) continue;
            state.editor.selection = valid_selection(*item, state.editor.scene());
            // The gizmo would cover the view; it is needed only if the task moves the object itself.
            if (pointer.find("/transform") == std::string::npos) state.viewport.gizmo = GizmoMode::None;
            return;
        }
    }
}

constexpr int frames_of_layout = 3;  // until the picture has its new size

void show_reveal(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    const Station& station = lesson.station();
    set_scene(state, station.revealed);
    lesson.scrolls_down = !station.questions.empty();
    if (station.reveal == nullptr) return select_for_tasks(state);
    lesson.lays_line = frames_of_layout;
    if (station.reveal->pick) {
        state.get<InspectorState>().tab = InspectorTab::Equation;
        ask_about(state.viewport, share_of_lesson_pixel(state, glm::dvec2(*station.reveal->pick) + 0.5));
        for (const StationQuestion& question : station.questions)
            if (!question.asks->term.empty()) mark_in_equation(state, *question.asks);
    }
    if (station.reveal->along) {
        state.get<ScopeState>().open = true;
    }
    if (!station.reveal->play.empty()) play_reveal(state);
    select_for_tasks(state);
}

/// Shows the station of the current progress.
void arrive(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    forget_input(lesson);
    put_away(state);
    ask_about(state.viewport, {});
    lesson.watched.reset();
    state.left_shows_scene = false;
    lesson.scrolls_up = lesson.takes_keys = true;
    state.left_shows_inspector = false;
    if (is_answered(lesson.progress, lesson.progress.station))
        show_reveal(state);
    else
        set_scene(state, lesson.station().asked);
}

/// Calls `what` on the open lesson at once, or asks first whether to save. It asks if a scene that was saved
/// under a name has unsaved changes, because those are the user's work; edits to the lesson's own scene are
/// not.
void ask_in_lesson(UiState& state, const std::function<void(UiState&)>& what) {
    const auto then = [what](UiState& s) {
        if (s.get<LessonState>().course) what(s);
    };
    if (!state.editor.document.path.empty() && state.editor.unsaved()) return ask_first(state, then);
    then(state);
}

}  // namespace

void begin_lesson(UiState& state, std::shared_ptr<const Course> course) {
    LessonState& lesson = state.get<LessonState>();
    end_prediction(state);
    if (const Editor* before = state.editor.before.get(); before != nullptr && before->source.title.empty())
        lesson.before = SceneBefore{before->document, before->saved, before->saved_edited_camera,
                                    before->history, before->selection};
    lesson.course = std::move(course);
    state.editor.source = {lesson.course->lesson.title, lesson.course->lesson.path};
    lesson.progress = lesson.written = recall_progress(state, *lesson.course);
    state.layout.hides_columns = state.layout.hides_all = false;
    arrive(state);
    state.editor.history.reset(state.editor.scene());
}

void leave_lesson(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    if (!lesson.course) return;
    keep_progress(state);
    state.get<AnimateState>().playing = false;
    forget_input(lesson);
    lesson.course.reset();
    lesson.watched.reset();
    state.editor.source = {};
}

void close_lesson(UiState& state) {
    Editor& editor = state.editor;
    const std::string title = editor.source.title;
    std::optional<SceneBefore> before = std::exchange(state.get<LessonState>().before, std::nullopt);
    leave_lesson(state);
    if (!before || !editor.document.path.empty()) return;
    if (editor.unsaved()) keep_changes(state, title);
    put_away(state);
    take_scene(state, std::move(before->document));
    editor.saved = std::move(before->saved);
    editor.saved_edited_camera = before->saved_edited_camera;
    editor.history = std::move(before->history);
    editor.selection = before->selection;
}

std::optional<std::size_t> open_question(const LessonState& lesson) {
    if (!lesson.course) return {};
    const std::vector<GivenAnswer>& given = lesson.given();
    const auto open = std::find_if(given.begin(), given.end(), [](const auto& g) { return !g.is_over(); });
    if (open == given.end()) return {};
    return static_cast<std::size_t>(open - given.begin());
}

void page_lesson(UiState& state, int steps) {
    if (state.get<LessonState>().lecturer && steps > 0 && open_question(state.get<LessonState>()))
        return reveal_unanswered(state);
    go_on(state, steps);
}

namespace {

void turn_page(UiState& state, int steps) {
    LessonState& lesson = state.get<LessonState>();
    const auto wanted = static_cast<std::ptrdiff_t>(lesson.progress.station) + steps;
    if (wanted < 0) return state.notifications.tell("This is the start of the lesson");
    if (wanted >= std::ssize(lesson.course->stations))
        return state.notifications.tell("This is the end of the lesson");
    lesson.progress.station = static_cast<std::size_t>(wanted);
    arrive(state);
}

void become_student(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    lesson.lecturer = false;
    const std::size_t station = lesson.progress.station;
    lesson.progress = lesson.written;
    lesson.progress.station = station;
    arrive(state);
}

void restart(UiState& state) {
    state.get<LessonState>().progress = fresh_progress(*state.get<LessonState>().course);
    arrive(state);
}

void restore_scene(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    state.get<AnimateState>().playing = false;
    set_scene(state, open_question(lesson) ? lesson.station().asked : lesson.station().revealed);
}

}  // namespace

void switch_lecturer(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    if (lesson.lecturer) return ask_in_lesson(state, become_student);
    keep_progress(state);
    lesson.lecturer = true;
    lesson.written = lesson.progress;  // the state to return to
}

void go_on(UiState& state, int steps) {
    ask_in_lesson(state, [steps](UiState& s) { turn_page(s, steps); });
}

void begin_again(UiState& state) { ask_in_lesson(state, restart); }

void back_to_scene(UiState& state) { ask_in_lesson(state, restore_scene); }

void lock_in(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    if (!can_lock(lesson)) return;
    const std::size_t open = *open_question(lesson);
    const bool is_number = lesson.station().questions[open].asks->kind == PredictionKind::Number;
    lesson.given()[open] = {is_number ? Json(calculated(lesson.typed, 0).value) : lesson.chosen, true, false,
                            lesson.reason};
    forget_input(lesson);
    lesson.takes_keys = true;
    if (!open_question(lesson)) show_reveal(state);
}

void reveal_unanswered(UiState& state) {
    for (GivenAnswer& given : state.get<LessonState>().given()) given.skipped |= !given.locked;
    forget_input(state.get<LessonState>());
    show_reveal(state);
}

bool has_strayed(const UiState& state) {
    const LessonState& lesson = state.get<LessonState>();
    return !open_question(lesson) && !(state.editor.scene() == lesson.station().revealed);
}

void play_reveal(UiState& state) {
    const Reveal& reveal = *state.get<LessonState>().station().reveal;
    AnimateState& animate = state.get<AnimateState>();
    constexpr int frames = 75;  // three seconds back and forth
    animate.playing = !animate.playing;
    animate.animation = {Motion::PingPong, reveal.play, reveal.play_from, reveal.play_to, frames};
    animate.number.clear();
    animate.frames_a_second = 25;
    animate.began = ImGui::GetTime();
}

namespace {

void lay_line(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    if (lesson.lays_line <= 0 || state.rendered == nullptr) return;
    --lesson.lays_line;
    redraw_within(0);
    const Reveal* reveal = lesson.course ? lesson.station().reveal : nullptr;
    if (reveal == nullptr || open_question(lesson)) return;
    if (reveal->pick && state.viewport.probe)
        state.viewport.probe = share_of_lesson_pixel(state, glm::dvec2(*reveal->pick) + 0.5);
    if (!reveal->along) return;
    ScopeState& scope = state.get<ScopeState>();
    scope.from = share_of_lesson_pixel(state, glm::dvec2(reveal->along->first) + 0.5);
    scope.to = share_of_lesson_pixel(state, glm::dvec2(reveal->along->second) + 0.5);
}

}  // namespace

void hold_lesson(UiState& state) {
    lay_line(state);
    const auto open = open_question(state.get<LessonState>());
    if (!open) return;
    Editor& editor = state.editor;
    const Scene& asked = state.get<LessonState>().station().asked;
    if (!(editor.scene() == asked)) {
        (void)cancel_gesture(state.viewport, editor.scene());
        editor.scene() = asked;
    }
    state.get<InspectorState>().instead.reset();
    state.viewport.touched = true;
    if (state.viewport.probe) ask_about(state.viewport, {});
}

}  // namespace glint
