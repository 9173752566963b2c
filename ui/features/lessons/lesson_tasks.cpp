// A task for the user to carry out: its fields, and its condition, which is evaluated on the current scene in
// the background.
#include <algorithm>
#include <utility>

#include "models/fields/scene_numbers.h"
#include "models/json/json_pointer.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/equation/words.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/features/lessons/lesson_progress.h"
#include "ui/ui.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

std::vector<const Task*> tasks_of(const Station& station) {
    std::vector<const Task*> tasks;
    for (const StationPart& part : station.after)
        if (part.task != nullptr) tasks.push_back(part.task);
    return tasks;
}

/// `runner` belongs to the job until it has ended.
Result<std::vector<bool>> done_tasks(const WatchedTasks& asked, LessonRunner& runner) {
    std::vector<bool> all_done;
    SceneDocument document = asked.course->document;
    document.scene = asked.of;
    for (const Task* task : tasks_of(asked.course->stations[asked.station])) {
        const Result<NamedValues> values = runner.answers(document, asked.course->lesson, task->runs);
        if (const Problem* problem = problem_of(values)) return *problem;
        const Result<bool> done = task->done.holds(std::get<NamedValues>(values));
        // A condition that cannot be evaluated in this scene, for example because its light was deleted,
        // counts as not met.
        const bool* holds = std::get_if<bool>(&done);
        all_done.push_back(holds != nullptr && *holds);
    }
    return all_done;
}

void begin_watching(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    if (!lesson.runner) lesson.runner = std::make_unique<LessonRunner>(1);
    lesson.asked_of = {lesson.course, state.editor.scene(), lesson.progress.station, {}};
    lesson.watching = state.jobs.start<std::vector<bool>>(
        lesson.course->lesson.title, [asked = lesson.asked_of, runner = lesson.runner.get()](LoadProgress&) {
            return done_tasks(asked, *runner);
        });
}

void take_watched(UiState& state) {
    LessonState& lesson = state.get<LessonState>();
    Result<std::vector<bool>> result = lesson.watching->take();
    lesson.watching.reset();
    WatchedTasks asked = std::exchange(lesson.asked_of, {});
    if (asked.course != lesson.course) return;  // tasks of different lessons are unrelated
    // If there is a problem, `done` stays empty: the conditions cannot be evaluated in this scene.
    if (problem_of(result) == nullptr) asked.done = std::get<std::vector<bool>>(std::move(result));
    lesson.watched = std::move(asked);
    if (lesson.watched->station != lesson.progress.station) return;
    std::vector<bool>& done = lesson.progress.tasks[lesson.progress.station];
    for (std::size_t i = 0; i < std::min(done.size(), lesson.watched->done.size()); ++i)
        done[i] = done[i] || lesson.watched->done[i];
}

/// Edits must be visible, so the lesson's animation ends. The Animate panel has its own button for that.
void end_motion(UiState& state) {
    if (!state.get<AnimateState>().open) state.get<AnimateState>().playing = false;
}

}  // namespace

void poll_lesson(UiState& state) {
    constexpr double look_again = 0.03;  // seconds
    LessonState& lesson = state.get<LessonState>();
    if (lesson.watching && lesson.watching->done()) take_watched(state);
    if (lesson.watching) redraw_within(look_again);
    if (!lesson.course) return;
    keep_progress(state);
    if (state.viewport.gesture != Gesture::None) end_motion(state);
    const bool asks = !open_question(lesson) && !tasks_of(lesson.station()).empty();
    if (!asks || lesson.watching || awaits_mesh(state)) return;
    if (lesson.watched && lesson.watched->station == lesson.progress.station &&
        lesson.watched->of == state.editor.scene())
        return;
    begin_watching(state);
    redraw_within(look_again);
}

namespace {

/// Draws a field for the number, under the label of its panel. True when it was edited; then `value` has
/// changed.
bool field_of(const SceneNumber& number, const char* label, double& value) {
    const Help help{number.help, number.pointer};
    if (number.count) {
        int count = static_cast<int>(number.value);
        const bool edited =
            integer_field(label, count, *number.count, static_cast<int>(number.initial), help);
        value = count;
        return edited;
    }
    auto real = static_cast<float>(number.value);
    const bool edited = number_field(label, real, number.kind, static_cast<float>(number.initial), help);
    value = double(real);
    return edited;
}

/// The numbers that the task lets the user edit, if they are few.
void task_fields(UiState& state, const Task& task) {
    constexpr int most_numbers = 6;
    Scene& scene = state.editor.scene();
    int shown = 0;
    for (const SceneNumber& number : numbers_of(scene)) {
        const auto holds_it = [&number](const std::string& control) {
            return is_within(number.pointer, control);
        };
        if (number.is_w || std::none_of(task.controls.begin(), task.controls.end(), holds_it)) continue;
        if (++shown > most_numbers) return;
        ImGui::PushID(number.pointer.c_str());
        double value = 0;
        if (field_of(number, named_number(number.pointer, scene).what.c_str(), value)) {
            end_motion(state);
            state.editor.edits_camera |= number.pointer.starts_with("/camera");
            if (const auto problem = set_number(scene, number.pointer, value))
                refuse_edit(with_expected(problem->what, problem->expected));
        }
        ImGui::PopID();
    }
}

}  // namespace

void task_box(UiState& state, const Task& task, bool done, bool holds_now) {
    const char* const words = holds_now ? "✓ Done: the condition holds now" : done ? "✓ Done" : "Not yet";
    coloured(done ? theme().accent : theme().dim_text, words);
    list_control(done ? "Task done" : "Task open", "", last_item());
    task_fields(state, task);
}

}  // namespace glint
