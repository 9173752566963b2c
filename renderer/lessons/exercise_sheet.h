#pragma once
// Exercises with numbers drawn by a seed, and their keys, which the engine computes, or an exercise's formula
// that it has been held against.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/lessons/run_lesson.h"

namespace glint {

struct PosedQuestion {
    std::string question, unit;
    double answer = 0, tolerance = 0;
    std::optional<double> closed;  // the same by the exercise's formula, where it has one
};

/// Poses the exercise on that scene with values drawn by the seed. The same seed gives the same numbers on
/// every machine.
[[nodiscard]] Result<PosedQuestion> pose(LessonRunner& runner, const SceneDocument& document,
                                         const Lesson& lesson, const Exercise& exercise, std::uint64_t seed);

struct ExerciseSheet {
    std::uint64_t seed = 0;
    std::vector<PosedQuestion> questions;
};

/// The most sheets at once.
inline constexpr int max_exercise_sheets = 500;

/// One sheet for each of `count` seeds from `seed` on, with all exercises of the lesson. A problem where it
/// has none. Throws Refused where they do not fit in memory, as the two below do.
[[nodiscard]] Result<std::vector<ExerciseSheet>> exercise_sheets(LessonRunner& runner, const Lesson& lesson,
                                                                 std::uint64_t seed, int count);

/// A self-contained HTML page: the sheets, each on a page of its own, then their keys. `picture` is an HTML
/// element, or empty.
[[nodiscard]] std::string exercises_html(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets,
                                         const std::string& picture);
/// The sheets and keys for LaTeX, without the picture. A letter that LaTeX's usual fonts lack is written as a
/// command.
[[nodiscard]] std::string exercises_tex(const Lesson& lesson, const std::vector<ExerciseSheet>& sheets);
/// The letters of a LaTeX text, each once, at which pdflatex stops: those beyond U+017F but for dashes and
/// quotation marks. The first 20 of them, and how many more there are: "漢Ж…鐵 and 7 more".
[[nodiscard]] std::string unset_letters(std::string_view tex);

}  // namespace glint
