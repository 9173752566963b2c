#pragma once
// A concept inventory: a lesson whose questions are all choices, as a page to answer, as statistics of a
// class, and for a learning platform. Its first questions may be in plain language, for before and after the
// lessons; the others are for after them. It may have parallel forms, in files of their own.

#include <string>
#include <vector>

#include "lessons/question_export.h"
#include "lessons/run_lesson.h"

namespace glint {

/// A self-contained HTML page: a picture and the options of each question, and a button that saves the
/// answers as JSON (docs/lessons.md). With `key` it has no buttons, but marks the right option and explains
/// the belief behind each wrong one. Without `key` the page does not contain the right options.
[[nodiscard]] Result<std::string> quiz_html(LessonRunner& runner, const Lesson& lesson, bool key);

/// The questions with their pictures and right options.
[[nodiscard]] Result<std::vector<ExportedQuestion>> quiz_questions(LessonRunner& runner,
                                                                   const Lesson& lesson);

/// One person's answers, as the page saves them.
struct QuizAnswers {
    bool after = false;                               // after the lessons; else before them
    std::vector<std::optional<std::size_t>> options;  // of each question, from 0; nothing if none was chosen
    std::string person = {};                          // a number or code of the person; or empty
    std::vector<double> seconds = {};                 // for each question; empty: unknown
    bool operator==(const QuizAnswers&) const = default;
};

/// The answers as JSON, in the page's format, which read_answers() reads.
[[nodiscard]] Json answers_json(const Lesson& lesson, const QuizAnswers& answers);
/// Reads answers that the page has saved. `file` is for messages. Any other content is a problem.
[[nodiscard]] Result<QuizAnswers> read_answers(const Lesson& lesson, std::string_view text,
                                               const std::string& file);
/// Whether the text names that quiz as its own.
[[nodiscard]] bool names_quiz(const Lesson& lesson, std::string_view text);

/// For each question, how many chose each option before and after, with the belief behind the option; and the
/// share of right answers before and after, with the gain (after − before) / (1 − before), Hake 1998. Shares
/// and gain are of the questions in plain language.
[[nodiscard]] Result<Json> quiz_statistics(LessonRunner& runner, const Lesson& lesson,
                                           const std::vector<QuizAnswers>& all);

/// A form of a quiz and the answers to it.
struct AnsweredForm {
    Lesson lesson;
    std::vector<QuizAnswers> answers;
};
/// A table for people. For each question of each form, before and after: the share of right answers
/// (difficulty), and the correlation of a right answer with the score of all others (discrimination); for
/// each form its reliability (Kuder-Richardson 20). Last, the mean of the gains of all who answered before
/// and after, in whichever form.
[[nodiscard]] Result<std::string> quiz_analysis(LessonRunner& runner, const std::vector<AnsweredForm>& forms);
/// A line for each answer: person,form,when,item,answer,right,seconds.
[[nodiscard]] Result<std::string> quiz_csv(LessonRunner& runner, const std::vector<AnsweredForm>& forms);

}  // namespace glint
