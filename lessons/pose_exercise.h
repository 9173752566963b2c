#pragma once
// An exercise with values for its variables, drawn by a seed or given, and its answer.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lessons/run_lesson.h"

namespace glint {

struct PosedQuestion {
    std::string question, unit;
    double answer = 0, tolerance = 0;
    std::optional<double> closed;           // the same by the exercise's formula, if it has one
    int line = 0;                           // of the exercise, in the lesson's file
    std::vector<std::string> working = {};  // the formula, with numbers, and reduced step by step
};

/// Whether the formula, if there is one, gives the engine's answer within the tolerance.
[[nodiscard]] bool agrees(const PosedQuestion& posed);

/// Poses the exercise on that scene with those values, one for each variable.
[[nodiscard]] Result<PosedQuestion> pose_with(LessonRunner& runner, const SceneDocument& document,
                                              const Lesson& lesson, const Exercise& exercise,
                                              const std::vector<double>& chosen);

/// The values of the sheet with that number, one for each variable. Successive numbers go through all
/// combinations before one returns.
[[nodiscard]] std::vector<double> drawn_values(const Exercise& exercise, std::uint64_t seed);

/// Samples for checking a formula: all combinations of values if there are at most `most`; else combinations
/// of first and last values, at most half of `most`, and others drawn by seeds.
[[nodiscard]] std::vector<std::vector<double>> values_to_try(const Exercise& exercise, std::size_t most);

}  // namespace glint
