#pragma once
// Checks a lesson by running it: every claim, the answer to every prediction, the solution of every task, and
// some variants of every exercise. Also checks that no page shows an answer before its question.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/exercise_sheet.h"
#include "lessons/run_lesson.h"

namespace glint {

enum class CheckedKind { Prediction, Task, Claim, Exercise };
/// The kind's name, such as "claim".
[[nodiscard]] const char* name_of(CheckedKind kind);

struct Checked {
    CheckedKind kind = CheckedKind::Claim;
    int line = 0;      // in the lesson's file, from 1
    std::string says;  // the claim, the question or the task
    bool holds = false;
    std::string why;  // the reason for a failure, with its numbers; empty if the check succeeded
};

/// Checks all parts of a lesson in order, or only its claims. Returns a problem if the scene cannot be opened
/// or a step cannot be applied.
[[nodiscard]] Result<std::vector<Checked>> check_lesson(LessonRunner& runner, const Lesson& lesson,
                                                        bool claims_only = false);

/// A page as a student sees it before answering a question. On paper the pictures of all steps are visible.
struct StudentPage {
    std::string text;                  // the text of its step, including titles and questions
    SceneDocument document, asked;     // the step's scene; the scene that its picture shows
    std::vector<SceneDocument> paper;  // the scenes of all pictures of the printed lesson
    const Reveal* reveal = nullptr;    // the reveal of this question, or null
};

/// Describes how the page shows the answer to that question; nothing if it does not. Draws the page's
/// pictures and compares them with the pictures drawn by the question's runs.
[[nodiscard]] Result<std::optional<std::string>> answer_shown(LessonRunner& runner, const Lesson& lesson,
                                                              const Prediction& question,
                                                              const RightAnswer& right,
                                                              const StudentPage& page);

/// The numbers in a text: "−0.5", "1/3", "½", "a quarter", "twice"; "25 %" gives both 25 and 0.25. Returns
/// only angles if `angles` is true, otherwise only the other numbers. Ignores coordinates such as (0, 1, 0)
/// and digits in names.
[[nodiscard]] std::vector<double> numbers_in(std::string_view text, bool angles);

}  // namespace glint
