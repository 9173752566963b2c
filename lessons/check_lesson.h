#pragma once
// Runs what a lesson says: every claim, the answer of every prediction, the solution of every task, and a few
// of every exercise.

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
    std::string says;  // the claim, the question, what is to be dragged
    bool holds = false;
    std::string why;  // what falls short, with its numbers; empty where it holds
};

/// Checks everything of a lesson in its order, or its claims only. A problem where its scene does not open or
/// a step cannot be set.
[[nodiscard]] Result<std::vector<Checked>> check_lesson(LessonRunner& runner, const Lesson& lesson,
                                                        bool claims_only = false);

}  // namespace glint
