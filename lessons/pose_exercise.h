#pragma once
// An exercise with the values of its variables, given or drawn from a seed, and its answer.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lessons/run_lesson.h"

namespace glint {

struct PosedQuestion {
    std::string question, unit;
    double answer = 0, tolerance = 0;
    std::optional<double> closed;           // the result of the exercise's formula, if it has one
    int line = 0;                           // line of the exercise in the lesson's file
    std::vector<std::string> working = {};  // the formula with numbers, simplified step by step
};

/// Whether the formula, if there is one, agrees with the engine's answer within the tolerance.
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

}  // namespace glint
