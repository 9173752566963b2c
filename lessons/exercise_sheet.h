#pragma once
// Sheets of exercises with different numbers, and their answer keys. A key is computed by the engine or by
// the exercise's formula, which is checked against the engine.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/quiz.h"
#include "lessons/run_lesson.h"

namespace glint {

// An exercise with the values of its variables, given or drawn from a seed, and its answer.

struct PosedQuestion {
    std::string question, unit;
    double answer = 0, tolerance = 0;
    std::optional<double> closed;           // the result of the exercise's formula, if it has one
    int line = 0;                           // line of the exercise in the lesson's file
    std::vector<std::string> working = {};  // the formula with numbers, simplified step by step
};

/// Whether the formula, if there is one, agrees with the engine's answer to within the tolerance.
[[nodiscard]] bool agrees(const PosedQuestion& posed);

/// Poses the exercise for that scene with the given values, one for each variable.
[[nodiscard]] Result<PosedQuestion> pose_with(LessonRunner& runner, const SceneDocument& document,
                                              const Lesson& lesson, const Exercise& exercise,
                                              const std::vector<double>& chosen);

/// The values for the sheet with that number, one for each variable. Successive numbers visit all
/// combinations before repeating one.
[[nodiscard]] std::vector<double> drawn_values(const Exercise& exercise, std::uint64_t seed);

/// Samples for checking a formula: all combinations of values if there are at most `most`. Otherwise at most
/// half of `most` are combinations of first and last values, and the rest are drawn from seeds.
[[nodiscard]] std::vector<std::vector<double>> values_to_try(const Exercise& exercise, std::size_t most);

struct ExerciseSheet {
    std::uint64_t seed = 0;
    std::vector<PosedQuestion> questions;
};

/// The maximum number of sheets in one call.
inline constexpr int max_exercise_sheets = 500;

/// One sheet, with all exercises of the lesson, for each of `count` consecutive seeds from `seed` on. Returns
/// a problem if the lesson has no exercises.
[[nodiscard]] Result<std::vector<ExerciseSheet>> exercise_sheets(LessonRunner& runner, const Lesson& lesson,
                                                                 std::uint64_t seed, int count);

/// One line for each exercise whose formula disagrees with the engine on any sheet, and for each exercise
/// with fewer variants than sheets.
[[nodiscard]] Warnings key_warnings(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);

/// The lesson's first picture as an HTML element, with a light background and bright enough for photocopying.
[[nodiscard]] Result<std::string> sheet_picture(LessonRunner& runner, const Lesson& lesson);

/// A self-contained HTML page with each sheet on its own page, without answers. `picture` is an HTML element
/// or empty.
[[nodiscard]] std::string exercises_html(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets,
                                         const std::string& picture);
/// The answer keys with step-by-step working and the accepted ranges; both results if formula and engine
/// disagree.
[[nodiscard]] std::string exercise_keys_html(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);
/// The same for LaTeX, without the picture. Writes characters that LaTeX's usual fonts lack as commands.
[[nodiscard]] std::string exercises_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);
[[nodiscard]] std::string exercise_keys_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);
/// All questions of all sheets, for a learning platform.
[[nodiscard]] std::vector<ExportedQuestion> sheet_questions(const std::vector<ExerciseSheet>& sheets);
/// The characters of a LaTeX text that pdflatex rejects, each once: those beyond U+017F except dashes and
/// quotation marks. Lists the first 20 and the number of others: "漢Ж…鐵 and 7 more".
[[nodiscard]] std::string unset_letters(std::string_view tex);

}  // namespace glint
