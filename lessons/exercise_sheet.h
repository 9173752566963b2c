#pragma once
// Sheets of exercises, each with numbers of its own, and their keys, which the engine computes, or an
// exercise's formula that it is held against.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/pose_exercise.h"

namespace glint {

struct ExerciseSheet {
    std::uint64_t seed = 0;
    std::vector<PosedQuestion> questions;
};

/// The most sheets at once.
inline constexpr int max_exercise_sheets = 500;

/// One sheet for each of `count` seeds from `seed` on, with all exercises of the lesson. A problem where it
/// has none.
[[nodiscard]] Result<std::vector<ExerciseSheet>> exercise_sheets(LessonRunner& runner, const Lesson& lesson,
                                                                 std::uint64_t seed, int count);

/// For each exercise whose formula misses the engine's answer on one of the sheets, a line that says so.
[[nodiscard]] Warnings key_warnings(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);

/// A self-contained HTML page: the sheets, each on a page of its own, then their keys, which hold both where
/// formula and engine disagree. `picture` is an HTML element, or empty.
[[nodiscard]] std::string exercises_html(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets,
                                         const std::string& picture);
/// The sheets and keys for LaTeX, without the picture. A letter that LaTeX's usual fonts lack is written as a
/// command.
[[nodiscard]] std::string exercises_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);
/// The letters of a LaTeX text, each once, at which pdflatex stops: those beyond U+017F but for dashes and
/// quotation marks. The first 20 of them, and how many more there are: "漢Ж…鐵 and 7 more".
[[nodiscard]] std::string unset_letters(std::string_view tex);

}  // namespace glint
