#pragma once
// A concept inventory: a lesson whose questions are all multiple choice. It can be written as a page to
// answer, evaluated for a class, and exported to a learning platform. Its first questions may be in plain
// language, for use before and after the lessons; the others are only for after them. Parallel forms are in
// separate files.

#include <optional>
#include <string>
#include <vector>

#include "lessons/run_lesson.h"
#include "renderer/picture.h"

namespace glint {

// Exports questions to learning platforms as an IMS QTI 2.1 package or as Moodle XML.

/// A multiple-choice question if it has options, otherwise a numeric one.
struct ExportedQuestion {
    struct Option {
        std::string text, feedback;  // the misconception of a student who chooses it, or empty
        bool is_right = false;
    };
    std::string title, text;  // plain text
    std::optional<Picture> picture;
    std::string alt;  // alternative text of the picture
    std::vector<Option> options;
    double answer = 0, tolerance = 0;
    std::string unit;
    std::string feedback;  // shown after any answer: the working, or empty
};

/// A zip file with a manifest, a test, and a file for each question and picture. Source: IMS Question and
/// Test Interoperability 2.1, 2012; the zip entries are stored, not compressed (PKWARE APPNOTE 6.3).
[[nodiscard]] std::string qti_package(const std::string& title,
                                      const std::vector<ExportedQuestion>& questions);

/// Source: Moodle XML format, https://docs.moodle.org/en/Moodle_XML_format.
[[nodiscard]] std::string moodle_xml(const std::string& title,
                                     const std::vector<ExportedQuestion>& questions);

/// QTI if `out` ends in .zip, otherwise Moodle XML.
[[nodiscard]] std::string exported(const std::string& out, const std::string& title,
                                   const std::vector<ExportedQuestion>& questions);

/// A self-contained HTML page: a picture and the options of each question, and a button that saves the
/// answers as JSON (docs/lessons.md). With `key` it has no buttons, but marks the right option and explains
/// the misconception behind each wrong one. Without `key` the page does not contain the right options.
[[nodiscard]] Result<std::string> quiz_html(LessonRunner& runner, const Lesson& lesson, bool key);

/// All questions with their pictures and right options.
[[nodiscard]] Result<std::vector<ExportedQuestion>> quiz_questions(LessonRunner& runner,
                                                                   const Lesson& lesson);

/// One person's answers, as saved by the page.
struct QuizAnswers {
    bool after = false;                               // true: after the lessons; false: before them
    std::vector<std::optional<std::size_t>> options;  // chosen for each question, from 0; empty if none
    std::string person = {};                          // a number or code for the person, or empty
    std::vector<double> seconds = {};                 // for each question; an empty list if unknown
    bool operator==(const QuizAnswers&) const = default;
};

/// The answers as JSON, in the format that the page saves and read_answers() reads.
[[nodiscard]] Json answers_json(const Lesson& lesson, const QuizAnswers& answers);
/// Reads answers saved by the page. `file` is used in messages. Returns a problem for any other content.
[[nodiscard]] Result<QuizAnswers> read_answers(const Lesson& lesson, std::string_view text,
                                               const std::string& file);
/// Whether the member "quiz" of the JSON text is the title of this quiz.
[[nodiscard]] bool names_quiz(const Lesson& lesson, std::string_view text);

/// For each question, the number of times each option was chosen before and after the lessons, with the
/// misconception behind the option. Also the share of right answers before and after, with the gain (after −
/// before) / (1 − before), Hake 1998. Shares and gain include only the questions in plain language.
[[nodiscard]] Result<Json> quiz_statistics(LessonRunner& runner, const Lesson& lesson,
                                           const std::vector<QuizAnswers>& all);

/// A form of a quiz and all answers to it.
struct AnsweredForm {
    Lesson lesson;
    std::vector<QuizAnswers> answers;
};
/// A table as text. For each question of each form, before and after: the share of right answers
/// (difficulty), and the correlation of a right answer with the score on all others (discrimination). For
/// each form, its reliability (Kuder-Richardson 20). Finally the mean gain of everyone who answered before
/// and after, in whichever form.
[[nodiscard]] Result<std::string> quiz_analysis(LessonRunner& runner, const std::vector<AnsweredForm>& forms);
/// One line per answer: person,form,when,item,answer,right,seconds.
[[nodiscard]] Result<std::string> quiz_csv(LessonRunner& runner, const std::vector<AnsweredForm>& forms);

}  // namespace glint
