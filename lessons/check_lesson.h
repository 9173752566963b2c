#pragma once
// Checks a lesson by running it: every claim, the answer of every prediction, the solution of every task, and
// some values of every exercise.

#include <string>
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

}  // namespace glint
