// A task for the user to carry out: its fields, and its condition, which is evaluated on the current scene in
// the background.

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/fields/scene_fields.h"
#include "models/json/json.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/lessons/course.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/features/views/small_pictures.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
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

/// Ends the lesson's animation, because edits must be visible. The Animate panel has its own Stop button.
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

/// Draws a field for the number, with the label it has in its panel. Returns the number's value.
double field_of(const SceneNumber& number, const char* label) {
    const Help help{number.help, number.pointer};
    if (number.count) {
        int count = static_cast<int>(number.value);
        integer_field(label, count, *number.count, static_cast<int>(number.initial), help);
        return count;
    }
    auto real = static_cast<float>(number.value);
    number_field(label, real, number.kind, static_cast<float>(number.initial), help);
    return double(real);
}

/// Draws fields for the first few numbers that the task lets the user edit.
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
        const double value = field_of(number, named_number(number.pointer, scene).what.c_str());
        if (value != number.value) {
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

// The lesson's tool on the picture: a click answers a question about a position; everything else is blocked
// during a question. Maps the lesson's pixels to the window's picture; draws sketches.

namespace {

/// The open question of that kind, or else an answered one, with its position or line in the picture.
struct Shown {
    const StationQuestion* question = nullptr;
    const GivenAnswer* given = nullptr;
    bool is_open = false;
};

Shown shown_question(const LessonState& lesson, PredictionKind kind) {
    if (!lesson.course) return {};
    const auto open = open_question(lesson);
    const std::vector<StationQuestion>& questions = lesson.station().questions;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        if (questions[i].asks->kind != kind || (open && *open != i)) continue;
        return {&questions[i], &lesson.given()[i], open == i};
    }
    return {};
}

bool lesson_hover(ToolFrame& frame) {
    if (!open_question(frame.state.get<LessonState>()) || !frame.over) return false;
    const bool clicks = !frame.state.get<LessonState>().lecturer &&
                        shown_question(frame.state.get<LessonState>(), PredictionKind::Click).is_open;
    if (clicks) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return true;  // no other tool receives the mouse
}

int lesson_press(ToolFrame& frame) {
    LessonState& lesson = frame.state.get<LessonState>();
    const bool clicks =
        !lesson.lecturer && ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (!clicks || !shown_question(lesson, PredictionKind::Click).is_open) return not_taken;
    const glm::dvec2 size(frame.view.map.size.width, frame.view.map.size.height);
    const glm::dvec2 at = lesson_pixel_of_share(frame.state, frame.pixel / size);
    lesson.chosen = Json{at.x, at.y};
    return not_taken;
}

std::string lesson_hint(const UiState& state) {
    if (!open_question(state.get<LessonState>())) return {};
    return "The picture is frozen until you have made your prediction";
}

ImVec2 place_of(const UiState& state, const PictureView& view, const Json& pixel) {
    const Json::array_t& at = elements_of(pixel);
    const glm::dvec2 share = share_of_lesson_pixel(state, {at[0].get<double>(), at[1].get<double>()});
    return view.to_window(share * glm::dvec2(view.map.size.width, view.map.size.height));
}

void draw_click(ImDrawList& list, const UiState& state, const PictureView& view) {
    const Shown shown = shown_question(state.get<LessonState>(), PredictionKind::Click);
    if (shown.question == nullptr) return;
    const Json& mine = shown.is_open ? state.get<LessonState>().chosen : shown.given->value;
    const ImU32 own = to_u32(theme().warning), white = to_u32({1, 1, 1, 1});
    const bool has_mine = elements_of(mine).size() == 2;
    if (!shown.is_open) {
        const ImVec2 right = place_of(state, view, shown.question->right.value);
        if (has_mine) cased_line(list, place_of(state, view, mine), right, own);
        for (const ImVec2 way : {ImVec2(1, 1), ImVec2(1, -1)})
            cased_line(list, right - px(8) * way, right + px(8) * way, white, 2);
    }
    if (has_mine) cased_circle(list, place_of(state, view, mine), 9, own, 2.5f);
}

/// The line along which a curve is sketched, with its ends labelled as in the plot.
void draw_sketch_line(ImDrawList& list, const UiState& state, const PictureView& view) {
    const Shown shown = shown_question(state.get<LessonState>(), PredictionKind::Sketch);
    if (shown.question == nullptr) return;
    const auto end = [&](glm::ivec2 pixel) {
        const glm::dvec2 middle = glm::dvec2(pixel) + 0.5;
        return place_of(state, view, Json{middle.x, middle.y});
    };
    const ImVec2 a = end(shown.question->asks->from), b = end(shown.question->asks->to);
    cased_line(list, a, b, to_u32({1, 1, 1, 1}), 1.6f);
    const ImVec2 way = 1 / std::max(length_of(b - a), 1.0f) * (b - a);
    rimmed_text(list, a - px(12) * way, {1, 1, 1, 1}, "A");
    rimmed_text(list, b + px(12) * way, {1, 1, 1, 1}, "B");
}

}  // namespace

const Tool lesson_tool{.hover = lesson_hover, .press = lesson_press, .hint = lesson_hint};

void draw_lesson(ImDrawList& list, UiState& state, const PictureView& view) {
    draw_click(list, state, view);
    draw_sketch_line(list, state, view);
}

glm::dvec2 share_of_lesson_pixel(const UiState& state, glm::dvec2 pixel) {
    const PictureSize size = state.rendered != nullptr ? state.rendered->size : PictureSize{16, 9};
    const PixelsBetween between =
        pixels_between(state.editor.scene().camera, state.get<LessonState>().course->lesson.size, size);
    return between(pixel) / glm::dvec2(size.width, size.height);
}

glm::dvec2 lesson_pixel_of_share(const UiState& state, glm::dvec2 share) {
    const PictureSize size = state.rendered->size;
    return pixels_between(state.editor.scene().camera, size, state.get<LessonState>().course->lesson.size)(
        share * glm::dvec2(size.width, size.height));
}

std::size_t sketch_length(const Prediction& question) {
    const glm::ivec2 way = glm::abs(question.to - question.from);
    return static_cast<std::size_t>(std::max(way.x, way.y)) + 1;
}

void sketch(Json& values, std::size_t count, glm::dvec2 from, glm::dvec2 to) {
    Json::array_t list = elements_of(values);
    list.resize(count);
    if (from.x > to.x) std::swap(from, to);
    const auto last = static_cast<double>(count) - 1;
    const int first = static_cast<int>(std::round(std::clamp(from.x, 0.0, last))),
              end = static_cast<int>(std::round(std::clamp(to.x, 0.0, last)));
    for (int i = first; i <= end; ++i) {
        const double share = to.x > from.x ? (i - from.x) / (to.x - from.x) : 1;
        const double value = from.y + (to.y - from.y) * std::clamp(share, 0.0, 1.0);
        list[static_cast<std::size_t>(i)] = std::max(value, 0.0);
    }
    values = Json(std::move(list));
}

}  // namespace glint
