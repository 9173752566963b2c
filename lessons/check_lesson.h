#pragma once
// Checks a lesson by running it: every claim, the answer of every prediction and that no page shows it before
// its question, the solution of every task, and some values of every exercise.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/exercise_sheet.h"
#include "lessons/run_lesson.h"

namespace glint {

enum class CheckedKind { Prediction, Task, Claim, Exercise };
/// "claim" and so on.
[[nodiscard]] const char* name_of(CheckedKind kind);

struct Checked {
    CheckedKind kind = CheckedKind::Claim;
    int line = 0;      // in the lesson's file
    std::string says;  // the claim, the question or the task
    bool holds = false;
    std::string why;  // the failure, with its numbers; empty if it holds
};

/// Checks all parts of a lesson in order, or only its claims. A problem if its scene fails to open or a step
/// cannot be applied.
[[nodiscard]] Result<std::vector<Checked>> check_lesson(LessonRunner& runner, const Lesson& lesson,
                                                        bool claims_only = false);

/// A page as it is before a question is answered. On paper the pictures of all steps can be seen.
struct StudentPage {
    std::string text;                  // of its station, titles and questions included
    SceneDocument document, asked;     // the step's scene; the same as its picture shows it
    std::vector<SceneDocument> paper;  // the scenes of all pictures of the lesson's page
    const Reveal* reveal = nullptr;    // of this question; or none
};

/// How the page shows the answer of that question; nothing if it does not. Draws its pictures and compares
/// them with what the question's runs draw.
[[nodiscard]] Result<std::optional<std::string>> answer_shown(LessonRunner& runner, const Lesson& lesson,
                                                              const Prediction& question,
                                                              const RightAnswer& right,
                                                              const StudentPage& page);

/// The numbers that a reader finds in a text: "−0.5", "1/3", "½", "a quarter", "twice"; "25 %" is 25 and
/// 0.25. Angles if `angles`, else all others. Coordinates such as (0, 1, 0) and digits in names are left out.
[[nodiscard]] std::vector<double> numbers_in(std::string_view text, bool angles);

}  // namespace glint
