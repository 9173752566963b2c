// Exercises: blocks whose {names} are replaced by numbers for each sheet.
#include <fmt/format.h>

#include <cmath>

#include "lessons/lesson_source.h"
#include "models/json/json.h"

namespace glint {
namespace {

constexpr std::size_t max_values = 1000;
constexpr double max_combinations = 1e9;

/// Parses `angle = 10 to 80 step 5` or `n = 5, 10, 20`.
Exercise::Variable read_variable(const BlockLine& line) {
    const std::size_t equals = std::min(line.value.find('='), line.value.size());
    Exercise::Variable variable;
    const std::vector<std::string> name = words_of(line.value.substr(0, equals));
    std::string list = equals < line.value.size() ? line.value.substr(equals + 1) : "";
    for (char& c : list)
        if (c == ',') c = ' ';
    const std::vector<std::string> words = words_of(list);
    if (name.size() != 1 || words.empty())
        fail_at(line.line, in_quotes(line.value) + " varies nothing",
                "NAME = 10 to 80 step 5, or NAME = 5, 10, 20");
    variable.name = name[0];
    if (words.size() == 5 && words[1] == "to" && words[3] == "step") {
        const double from = read_decimal(words[0], line.line), to = read_decimal(words[2], line.line),
                     step = read_decimal(words[4], line.line);
        const double steps = (to - from) / step;
        if (!(steps >= 0 && steps < static_cast<double>(max_values)))
            fail_at(line.line, in_quotes(line.value) + " gives no values, or too many", "1 to 1000");
        for (int i = 0; i <= static_cast<int>(steps + 1e-9); ++i) variable.values.push_back(from + i * step);
        return variable;
    }
    if (words.size() > max_values) fail_at(line.line, "too many values", "at most 1000");
    for (const std::string& word : words) variable.values.push_back(read_decimal(word, line.line));
    return variable;
}

/// Formats a number without rounding noise: "0.3", not 0.30000000000000004.
std::string decimal_text(double value) {
    return fmt::format("{:.10g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

/// Evaluates the expression between two braces and formats the result.
std::string number_of(const std::string& text, const NamedValues& values, int line) {
    const Result<Expression> parsed = Expression::parse(text);
    if (const Problem* problem = problem_of(parsed)) fail_at(line, problem->what, problem->expected);
    const Result<double> number = std::get<Expression>(parsed).number(values);
    if (const Problem* problem = problem_of(number)) fail_at(line, problem->what, problem->expected);
    return decimal_text(std::get<double>(number));
}

/// Replaces {angle} and {sin(angle)} by numbers. Braces that contain a quotation mark are a JSON object,
/// which may contain further braces.
std::string replaced(const std::string& text, const NamedValues& values, int line) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text[at] == '{' ? text.find_first_of("{}\"", at + 1) : text.npos;
        if (end == text.npos || text[end] != '}') {
            result += text[at++];
            continue;
        }
        result += number_of(text.substr(at + 1, end - at - 1), values, line);
        at = end + 1;
    }
    return result;
}

ExerciseInstance instance_of(const SourceBlock& block, const NamedValues& values) {
    SourceBlock filled = block;
    for (BlockLine& line : filled.lines) line.value = replaced(line.value, values, line.line);
    ExerciseInstance instance;
    instance.values = values;
    std::vector<std::string> names;
    for (const auto& [name, unused] : values) names.push_back(name);
    instance.question = filled.require("question").value;
    for (const BlockLine* line : filled.all("set")) instance.set.push_back(read_set(*line));
    instance.runs = read_runs(filled.lines);
    instance.answer = read_expression(filled.require("answer"), instance.runs, names);
    instance.tolerance = read_expression(filled.require("tolerance"), instance.runs, names);
    if (const BlockLine* unit = filled.find("unit")) instance.unit = unit->value;
    if (const BlockLine* closed = filled.find("closed"))
        instance.closed = read_expression(*closed, {}, names);
    return instance;
}

SourceBlock block_of(const Exercise& exercise) {
    SourceBlock block{"exercise", "", {}, exercise.line};
    for (const Exercise::Line& l : exercise.lines) block.lines.push_back({l.key, l.value, l.line, l.is_run});
    return block;
}

NamedValues values_of(const Exercise& exercise, const std::vector<double>& values) {
    NamedValues named;
    for (std::size_t i = 0; i < exercise.variables.size(); ++i)
        named[exercise.variables[i].name] = Json(values[i]);
    return named;
}

}  // namespace

Exercise read_exercise(const SourceBlock& block) {
    block.allow({"question", "vary", "set", "answer", "tolerance", "unit", "closed"}, true);
    Exercise exercise;
    exercise.line = block.line;
    std::vector<double> first;
    for (const BlockLine* line : block.all("vary")) {
        Exercise::Variable variable = read_variable(*line);
        for (const Exercise::Variable& other : exercise.variables)
            if (other.name == variable.name)
                fail_at(line->line, in_quotes(variable.name) + " varies already", "another name");
        exercise.variables.push_back(std::move(variable));
        first.push_back(exercise.variables.back().values.front());
    }
    double combinations = 1;
    for (const Exercise::Variable& variable : exercise.variables)
        combinations *= static_cast<double>(variable.values.size());
    if (combinations > max_combinations)
        fail_at(block.line, "the exercise varies too much", "at most 10^9 combinations");
    if (first.empty()) fail_at(block.line, "the exercise varies nothing", "a line vary:");
    for (const BlockLine& l : block.lines)
        if (l.is_run || l.key != "vary") exercise.lines.push_back({l.key, l.value, l.line, l.is_run});
    (void)instance_of(block_of(exercise), values_of(exercise, first));
    return exercise;
}

Result<ExerciseInstance> exercise_with(const Exercise& exercise, const std::vector<double>& values,
                                       const std::string& path) {
    try {
        return instance_of(block_of(exercise), values_of(exercise, values));
    } catch (ProblemFound& found) {
        found.problem.file = path;
        return std::move(found.problem);
    }
}

}  // namespace glint
