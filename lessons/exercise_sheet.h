#pragma once
// Sheets of exercises with different numbers, and their keys. The engine computes the keys, or an exercise's
// formula, which is checked against the engine.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/pose_exercise.h"
#include "lessons/question_export.h"

namespace glint {

struct ExerciseSheet {
    std::uint64_t seed = 0;
    std::vector<PosedQuestion> questions;
};

/// The maximum number of sheets at once.
inline constexpr int max_exercise_sheets = 500;

/// One sheet for each of `count` seeds from `seed` on, with all exercises of the lesson. A problem if it has
/// none.
[[nodiscard]] Result<std::vector<ExerciseSheet>> exercise_sheets(LessonRunner& runner, const Lesson& lesson,
                                                                 std::uint64_t seed, int count);

/// A line for each exercise whose formula differs from the engine's answer on one of the sheets, and for each
/// with fewer variants than sheets.
[[nodiscard]] Warnings key_warnings(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);

/// The lesson's first picture as an HTML element, on a light ground and bright enough to be copied.
[[nodiscard]] Result<std::string> sheet_picture(LessonRunner& runner, const Lesson& lesson);

/// A self-contained HTML page: the sheets, each on its own page, without answers. `picture` is an HTML
/// element, or empty.
[[nodiscard]] std::string exercises_html(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets,
                                         const std::string& picture);
/// The keys with their working, step by step, and what to accept; both answers if formula and engine
/// disagree.
[[nodiscard]] std::string exercise_keys_html(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);
/// The same for LaTeX, without the picture. Writes letters that LaTeX's usual fonts lack as commands.
[[nodiscard]] std::string exercises_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);
[[nodiscard]] std::string exercise_keys_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);
/// Every question of every sheet, for a learning platform.
[[nodiscard]] std::vector<ExportedQuestion> sheet_questions(const std::vector<ExerciseSheet>& sheets);
/// The letters of a LaTeX text that pdflatex rejects, each once: those beyond U+017F except dashes and
/// quotation marks. Lists the first 20 and the number of others: "漢Ж…鐵 and 7 more".
[[nodiscard]] std::string unset_letters(std::string_view tex);

}  // namespace glint
