#pragma once
// A concept inventory: a lesson all of whose questions are choices, as a page to answer and as statistics of
// a class.

#include <string>
#include <vector>

#include "lessons/run_lesson.h"

namespace glint {

/// A self-contained HTML page: a picture and the options of each question, and a button that saves the
/// answers as JSON (docs/lessons.md). With `key` it has no buttons, but the right option and what each wrong
/// one stands for. Without `key` the right options are not in the page.
[[nodiscard]] Result<std::string> quiz_html(LessonRunner& runner, const Lesson& lesson, bool key);

/// One person's answers, as the page saves them.
struct QuizAnswers {
    bool after = false;  // the lessons; else before them
    std::vector<std::optional<std::size_t>>
        options;  // of each question, from 0; nothing where none was taken
    bool operator==(const QuizAnswers&) const = default;
};

/// The answers as JSON, in the form in which the page saves them and read_answers() reads them.
[[nodiscard]] Json answers_json(const Lesson& lesson, const QuizAnswers& answers);
/// Reads what the page has saved. `file` is for messages. A problem where it is anything else.
[[nodiscard]] Result<QuizAnswers> read_answers(const Lesson& lesson, std::string_view text,
                                               const std::string& file);

/// For each question how many took each option before and after, with what the option stands for; and the
/// share of right answers before and after, with the gain (after − before) / (1 − before), Hake 1998.
[[nodiscard]] Result<Json> quiz_statistics(LessonRunner& runner, const Lesson& lesson,
                                           const std::vector<QuizAnswers>& all);

}  // namespace glint
