#pragma once
// A concept inventory: a lesson whose questions are all choices, as a page to answer and as statistics of a
// class.

#include <string>
#include <vector>

#include "lessons/run_lesson.h"

namespace glint {

/// A self-contained HTML page: a picture and the options of each question, and a button that saves the
/// answers as JSON (docs/lessons.md). With `key` it has no buttons, but marks the right option and explains
/// the belief behind each wrong one. Without `key` the page does not contain the right options.
[[nodiscard]] Result<std::string> quiz_html(LessonRunner& runner, const Lesson& lesson, bool key);

/// One person's answers, as the page saves them.
struct QuizAnswers {
    bool after = false;                               // after the lessons; else before them
    std::vector<std::optional<std::size_t>> options;  // of each question, from 0; nothing if none was chosen
    bool operator==(const QuizAnswers&) const = default;
};

/// The answers as JSON, in the page's format, which read_answers() reads.
[[nodiscard]] Json answers_json(const Lesson& lesson, const QuizAnswers& answers);
/// Reads answers that the page has saved. `file` is for messages. Any other content is a problem.
[[nodiscard]] Result<QuizAnswers> read_answers(const Lesson& lesson, std::string_view text,
                                               const std::string& file);

/// For each question, how many chose each option before and after, with the belief behind the option; and the
/// share of right answers before and after, with the gain (after − before) / (1 − before), Hake 1998.
[[nodiscard]] Result<Json> quiz_statistics(LessonRunner& runner, const Lesson& lesson,
                                           const std::vector<QuizAnswers>& all);

}  // namespace glint
