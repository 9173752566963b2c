// The features of lessons: the open lesson, the list of them, and *Predict*.
#include <fmt/core.h>

#include <filesystem>

#include "ui/commands/command.h"
#include "ui/commands/match.h"
#include "ui/commands/menus.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/features/lessons/lessons_dialog.h"
#include "ui/features/lessons/predict_mode.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

const char* column_name(const UiState& state) { return state.get<LessonState>().course ? "Lesson" : nullptr; }

void lecturer_button(UiState& state, float right) {
    const float width = ImGui::CalcTextSize("Lecturer").x + px(16);
    ImGui::SameLine(right - width);
    if (chosen_button("Lecturer", state.get<LessonState>().lecturer, width)) switch_lecturer(state);
    tooltip("Lecturer", "Shows questions without answer fields, for an audience; nothing is recorded");
}

/// The lesson describes its scene: in its column, or here if the column is hidden.
std::optional<std::string> caption(const UiState& state) {
    if (!state.get<LessonState>().course) return {};
    return state.layout.hides_columns ? lesson_caption(state) : std::string();
}

std::optional<Opening> open_file(const std::string& path) {
    if (!is_lesson_file(path)) return {};
    return opening_of_lesson(path);
}

std::string why_lesson_holds(const UiState& state) {
    return open_question(state.get<LessonState>()) ? "First answer the lesson's question" : "";
}

std::vector<WindowCommand> lesson_commands() {
    return {
        {.name = "Lecturer: a lesson's questions without its answers",
         .section = Section::LectureLesson,
         .run = switch_lecturer,
         .is_on = [](const UiState& s) { return s.get<LessonState>().lecturer; },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.get<LessonState>().course != nullptr, "No lesson is open");
             },
         .quiet = true},
    };
}

std::vector<WindowCommand> list_commands() {
    return {
        {.name = "Lessons…",
         .keys = {{Key::L, ctrl}},
         .section = Section::FileOpen,
         .run = open_lessons,
         .why_disabled =
             [](const UiState& s) {
                 return unless(!s.get<LessonState>().folder.empty() || s.get<LessonState>().course,
                               "The lessons of Glint are not installed");
             }},
    };
}

/// Adds lessons by number, title and topic, and by the words of the file's name.
void add_lessons(std::vector<PaletteEntry>& entries, UiState& state) {
    if (state.get<LessonListState>().own.empty()) list_own_lessons(state);
    for (const LessonEntry& lesson : state.get<LessonListState>().own) {
        const std::string file = with_spaces(std::filesystem::path(lesson.path).stem().string());
        const std::string name =
            lesson.title.empty() ? file : fmt::format("{} {}", number_of(lesson), lesson.title);
        entries.push_back({"Lesson: " + name, "Glint's lessons", "", "",
                           [path = lesson.path](UiState& s) { ask_to_open(s, path); },
                           file + " " + lesson.topic, true});
    }
}

std::vector<WindowCommand> predict_commands() {
    return {
        {.name = "Predict a colour in a frozen picture",
         .keys = {{Key::Q}},
         .section = Section::LecturePredict,
         .run = switch_prediction,
         .is_on = [](const UiState& s) { return s.get<PredictState>().stage != PredictStage::Off; },
         .why_disabled = [](const UiState& s) { return unless_drawn(s.rendered); },
         .line_above = true,
         .noun = "Predict a colour"},
    };
}

bool leave_prediction(UiState& state) {
    if (state.get<PredictState>().stage == PredictStage::Off) return false;
    end_prediction(state);
    return true;
}

}  // namespace

Opening opening_of_lesson(const std::string& path) {
    const auto course = std::make_shared<std::shared_ptr<const Course>>();
    const auto work = [path, course](LoadProgress&) -> Result<SceneDocument> {
        Result<std::shared_ptr<const Course>> opened = open_course(path);
        if (const Problem* problem = problem_of(opened)) return *problem;
        *course = std::get<std::shared_ptr<const Course>>(std::move(opened));
        return (*course)->document;
    };
    return {path, std::make_shared<LoadJob>(std::filesystem::path(path).filename().string(), work),
            [course](UiState& state) { begin_lesson(state, *course); }};
}

extern const Feature lesson_feature, lesson_list_feature, prediction_feature;

const Feature lesson_feature{.settle = hold_lesson,
                             .end = poll_lesson,
                             .tool = &lesson_tool,
                             .overlay = draw_lesson,
                             .column = {column_name, lesson_column, close_lesson, lecturer_button},
                             .caption = caption,
                             .commands = lesson_commands,
                             .key = answer_by_key,
                             .open = open_file,
                             .why_held = why_lesson_holds,
                             .leave_document = [](UiState& s, const SceneDocument&) { leave_lesson(s); }};

const Feature lesson_list_feature{
    .dialog = {[](const UiState& s) { return s.get<LessonListState>().open; },
               [](UiState& s) { s.get<LessonListState>().open = false; }, lessons_dialog},
    .commands = list_commands,
    .palette = add_lessons};

const Feature prediction_feature{
    .update = poll_prediction,
    .reshape =
        [](UiState& s, const Reshape& reshape) {
            if (auto& probe = s.get<PredictState>().probe) reshape.follow(*probe);
        },
    .why = [](UiState& s, const PictureView&) { return predict_panel(s); },
    .commands = predict_commands,
    .key = predict_by_key,
    .escape = leave_prediction,
    .leave_document = [](UiState& s, const SceneDocument&) { end_prediction(s); }};

}  // namespace glint
