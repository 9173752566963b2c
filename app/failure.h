#pragma once
// Errors of commands: app throws a Failure, and main() prints it as one line and exits with its status. Other
// layers return a Result; take() converts it.

#include <string>
#include <utility>
#include <variant>

#include "models/problem.h"

namespace glint {

/// docs/command_line.md: 0 success; 1 impossible because of the input or the machine; 2 wrong usage.
enum class ExitStatus { Done = 0, Impossible = 1, WrongUsage = 2 };

struct Failure {
    ExitStatus status;
    Problem problem;
};

/// Wrong usage of an option, of FILE or of a command, which is named in place of a file.
[[nodiscard]] inline Failure wrong_usage(std::string option, std::string what, std::string expected = {}) {
    Problem problem;
    problem.file = std::move(option);
    problem.what = std::move(what);
    problem.expected = std::move(expected);
    return {ExitStatus::WrongUsage, std::move(problem)};
}

/// Returns the value of a result, or throws its problem: as wrong usage if it is about the value of --set or
/// --memory, else as a fault of the input.
template <class T> [[nodiscard]] T take(Result<T> result) {
    if (Problem* problem = std::get_if<Problem>(&result)) {
        const bool usage = problem->file == "--set" || problem->file == "--memory";
        throw Failure{usage ? ExitStatus::WrongUsage : ExitStatus::Impossible, std::move(*problem)};
    }
    return std::get<T>(std::move(result));
}

/// Prints "glint: KIND: the problem" to standard error: one line of at most 4096 bytes, with control
/// characters escaped.
void say(const char* kind, Problem problem);
/// Prints a warning in the same form.
void say_warning(const std::string& warning);

}  // namespace glint
