#pragma once
// An exercise with numbers for its variables, drawn by a seed or chosen, and its answer.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lessons/run_lesson.h"

namespace glint {

struct PosedQuestion {
    std::string question, unit;
    double answer = 0, tolerance = 0;
    std::optional<double> closed;  // the same by the exercise's formula, where it has one
    int line = 0;                  // of the exercise, in the lesson's file
};

/// Whether the formula, where there is one, gives the engine's answer within the tolerance.
[[nodiscard]] bool agrees(const PosedQuestion& posed);

/// Poses the exercise on that scene with those values, one for each variable.
[[nodiscard]] Result<PosedQuestion> pose_with(LessonRunner& runner, const SceneDocument& document,
                                              const Lesson& lesson, const Exercise& exercise,
                                              const std::vector<double>& chosen);

/// What to hold a formula against: all values with all others where those are at most `most`; else the first
/// and last values with each other, at most half of `most`, and others drawn by seeds.
[[nodiscard]] std::vector<std::vector<double>> values_to_try(const Exercise& exercise, std::size_t most);

/// Poses the exercise on that scene with values drawn by the seed. The same seed gives the same numbers on
/// every machine.
[[nodiscard]] Result<PosedQuestion> pose(LessonRunner& runner, const SceneDocument& document,
                                         const Lesson& lesson, const Exercise& exercise, std::uint64_t seed);

}  // namespace glint
