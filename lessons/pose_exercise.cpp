#include "lessons/pose_exercise.h"

#include <cmath>
#include <utility>

namespace glint {
namespace {

/// SplitMix64. Source: G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", 2014.
std::uint64_t next_random(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

Problem in_exercise(Problem problem, const Lesson& lesson, const Exercise& exercise) {
    if (problem.file.empty()) {
        problem.file = lesson.path;
        problem.line = exercise.line;
    }
    return problem;
}

std::vector<double> drawn_values(const Exercise& exercise, std::uint64_t seed) {
    std::uint64_t state = seed * 1'000'003 + static_cast<std::uint64_t>(exercise.line);
    std::vector<double> drawn;
    for (const Exercise::Variable& variable : exercise.variables)
        drawn.push_back(variable.values[next_random(state) % variable.values.size()]);
    return drawn;
}

/// All combinations of one value for each variable, up to that number.
std::vector<std::vector<double>> choices(const std::vector<Exercise::Variable>& variables, std::size_t most) {
    std::vector<std::vector<double>> all{{}};
    for (const Exercise::Variable& variable : variables) {
        std::vector<std::vector<double>> longer;
        for (const double value : variable.values)
            for (std::vector<double> values : all) {
                if (longer.size() == most) break;
                values.push_back(value);
                longer.push_back(std::move(values));
            }
        all = std::move(longer);
    }
    return all;
}

}  // namespace

bool agrees(const PosedQuestion& posed) {
    return !posed.closed || std::abs(*posed.closed - posed.answer) <= posed.tolerance;  // false for NaN
}

std::vector<std::vector<double>> values_to_try(const Exercise& exercise, std::size_t most) {
    std::vector<std::vector<double>> tries = choices(exercise.variables, most + 1);
    if (tries.size() <= most) return tries;
    std::vector<Exercise::Variable> ends = exercise.variables;
    for (Exercise::Variable& variable : ends)
        if (variable.values.size() > 2) variable.values = {variable.values.front(), variable.values.back()};
    tries = choices(ends, most / 2);
    for (std::uint64_t seed = 1; tries.size() < most; ++seed) tries.push_back(drawn_values(exercise, seed));
    return tries;
}

Result<PosedQuestion> pose(LessonRunner& runner, const SceneDocument& document, const Lesson& lesson,
                           const Exercise& exercise, std::uint64_t seed) {
    return pose_with(runner, document, lesson, exercise, drawn_values(exercise, seed));
}

Result<PosedQuestion> pose_with(LessonRunner& runner, const SceneDocument& document, const Lesson& lesson,
                                const Exercise& exercise, const std::vector<double>& chosen) {
    const Result<ExerciseInstance> made = exercise_with(exercise, chosen, lesson.path);
    if (const Problem* problem = problem_of(made)) return *problem;
    const auto& instance = std::get<ExerciseInstance>(made);
    const Result<SceneDocument> set = LessonRunner::with(document, instance.set, lesson, exercise.line);
    if (const Problem* problem = problem_of(set)) return *problem;
    Result<NamedValues> run = runner.answers(std::get<SceneDocument>(set), lesson, instance.runs);
    if (const Problem* problem = problem_of(run)) return *problem;
    auto& values = std::get<NamedValues>(run);
    values.insert(instance.values.begin(), instance.values.end());

    PosedQuestion posed{instance.question, instance.unit, 0, 0, {}, exercise.line};
    const Result<double> answer = instance.answer.number(values),
                         tolerance = instance.tolerance.number(values);
    if (const Problem* problem = problem_of(answer)) return in_exercise(*problem, lesson, exercise);
    if (const Problem* problem = problem_of(tolerance)) return in_exercise(*problem, lesson, exercise);
    posed.answer = std::get<double>(answer);
    posed.tolerance = std::get<double>(tolerance);
    if (instance.closed.text().empty()) return posed;
    const Result<double> closed = instance.closed.number(values);
    if (const Problem* problem = problem_of(closed)) return in_exercise(*problem, lesson, exercise);
    posed.closed = std::get<double>(closed);
    return posed;
}

}  // namespace glint
