#include "lessons/pose_exercise.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <numeric>
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

bool in_name(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

// Writes −3 as ~3 in a working, because parentheses mark the parts that have not been computed yet.
std::string as_atom(double value) { return fmt::format("{}{:.5g}", value < 0 ? "~" : "", std::abs(value)); }
std::string without_atoms(const std::string& text, std::string_view minus) {
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] != '~') {
            plain += text[at++];
            continue;
        }
        const std::size_t end = std::min(text.find_first_not_of("0123456789.e", at + 1), text.size());
        plain += fmt::format("({}{})", minus, text.substr(at + 1, end - at - 1));
        at = end;
    }
    return plain;
}

/// Substitutes the values of the variables.
std::string with_numbers(const std::string& formula, const NamedValues& values) {
    std::string text;
    for (std::size_t at = 0; at < formula.size();) {
        std::size_t end = at;
        while (end < formula.size() && in_name(formula[end])) ++end;
        const std::string name = formula.substr(at, std::max<std::size_t>(end - at, 1));
        const auto value = values.find(name);
        text += value == values.end() ? name : as_atom(value->second.get<double>());
        at += name.size();
    }
    return text;
}

/// Evaluates the innermost parentheses and the function in front of them. Returns the text unchanged if there
/// are none.
std::string reduced(const std::string& formula) {
    std::string text;
    for (std::size_t at = 0; at < formula.size();) {
        std::size_t open = at;
        while (open < formula.size() && in_name(formula[open])) ++open;
        const bool opens = open < formula.size() && formula[open] == '(';
        const std::size_t end = opens ? formula.find_first_of("()", open + 1) : std::string::npos;
        const bool is_innermost = end != std::string::npos && formula[end] == ')';
        const std::string part =
            formula.substr(at, is_innermost ? end + 1 - at : std::max<std::size_t>(open - at, 1));
        const Result<Expression> parsed = Expression::parse(without_atoms(part, "-"));
        const Result<double> value = is_innermost && problem_of(parsed) == nullptr
                                         ? std::get<Expression>(parsed).number({})
                                         : Result<double>(Problem{});
        text += problem_of(value) == nullptr ? as_atom(std::get<double>(value)) : part;
        at += part.size();
    }
    return text;
}

/// Converts operators to mathematical symbols.
std::string in_signs(const std::string& working) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> signs{
        {{" * ", " · "}, {"sqrt(", "√("}, {" ^ 2", "²"}, {"-", "−"}, {"pi()", "π"}}};
    std::string text = without_atoms(working, "-");
    for (const auto& [from, to] : signs)
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    return text;
}

std::vector<std::string> working_of(const std::string& formula, const NamedValues& values) {
    constexpr std::size_t most_lines = 8;
    std::string text = with_numbers(formula, values);
    std::vector<std::string> lines{in_signs(formula), in_signs(text)};
    for (std::string next = reduced(text); next != text && lines.size() < most_lines; next = reduced(text)) {
        text = next;
        lines.push_back(in_signs(text));
    }
    return lines;
}

/// All combinations of values, at most the given number.
std::vector<std::vector<double>> drawn_values(const std::vector<Exercise::Variable>& variables,
                                              std::size_t most) {
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

/// Steps through all combinations with a stride that is coprime to their number.
std::vector<double> drawn_values(const Exercise& exercise, std::uint64_t seed) {
    constexpr double golden = 0.6180339887;  // makes successive sheets differ as much as possible
    std::uint64_t count = 1, state = static_cast<std::uint64_t>(exercise.line);
    for (const Exercise::Variable& variable : exercise.variables) count *= variable.values.size();
    auto stride = static_cast<std::uint64_t>(golden * static_cast<double>(count)) + 1;
    while (std::gcd(stride, count) != 1) ++stride;
    std::uint64_t index = (next_random(state) % count + seed % count * stride) % count;
    std::vector<double> drawn;
    for (const Exercise::Variable& variable : exercise.variables) {
        drawn.push_back(variable.values[index % variable.values.size()]);
        index /= variable.values.size();
    }
    return drawn;
}

bool agrees(const PosedQuestion& posed) {
    return !posed.closed || std::abs(*posed.closed - posed.answer) <= posed.tolerance;  // false for NaN
}

std::vector<std::vector<double>> values_to_try(const Exercise& exercise, std::size_t most) {
    std::vector<std::vector<double>> tries = drawn_values(exercise.variables, most + 1);
    if (tries.size() <= most) return tries;
    std::vector<Exercise::Variable> ends = exercise.variables;
    for (Exercise::Variable& variable : ends)
        if (variable.values.size() > 2) variable.values = {variable.values.front(), variable.values.back()};
    tries = drawn_values(ends, most / 2);
    for (std::uint64_t seed = 1; tries.size() < most; ++seed) tries.push_back(drawn_values(exercise, seed));
    return tries;
}

Result<PosedQuestion> pose_with(LessonRunner& runner, const SceneDocument& document, const Lesson& lesson,
                                const Exercise& exercise, const std::vector<double>& chosen) {
    return result_of("", [&] {
        const ExerciseInstance instance = value_or_throw(exercise_with(exercise, chosen, lesson.path));
        const SceneDocument set =
            value_or_throw(LessonRunner::with(document, instance.set, lesson, exercise.line));
        NamedValues values = value_or_throw(runner.answers(set, lesson, instance.runs));
        values.insert(instance.values.begin(), instance.values.end());
        const auto number = [&](const Expression& expression) {
            const Result<double> found = expression.number(values);
            if (const Problem* problem = problem_of(found))
                throw ProblemFound(in_exercise(*problem, lesson, exercise));
            return std::get<double>(found);
        };
        PosedQuestion posed{
            instance.question, instance.unit, number(instance.answer), number(instance.tolerance), {},
            exercise.line};
        if (!instance.closed.text().empty()) {
            posed.closed = number(instance.closed);
            posed.working = working_of(instance.closed.text(), instance.values);
        }
        return posed;
    });
}

}  // namespace glint
