#pragma once
// A command ends early by throwing a Failure: the line for standard error, and the exit status. It is thrown
// and caught inside app only.

#include <string>
#include <utility>
#include <variant>

#include "models/problem.h"

namespace glint {

/// docs/interface.md: 0 done; 1 the input or the machine made it impossible; 2 wrong usage.
enum class ExitStatus { Done = 0, Impossible = 1, WrongUsage = 2 };

struct Failure {
    ExitStatus status;
    Problem problem;
};

/// Wrong usage of an option (or of FILE, or of a command), which stands in place of a file.
[[nodiscard]] inline Failure wrong_usage(std::string option, std::string what, std::string expected = {}) {
    Problem problem;
    problem.file = std::move(option);
    problem.what = std::move(what);
    problem.expected = std::move(expected);
    return {ExitStatus::WrongUsage, std::move(problem)};
}

/// Returns the value of a result, or throws its problem: as wrong usage if it is about the value of --set or
/// --memory, else as the input's fault.
template <class T> [[nodiscard]] T take(Result<T> result) {
    if (Problem* problem = std::get_if<Problem>(&result)) {
        const bool usage = problem->file == "--set" || problem->file == "--memory";
        throw Failure{usage ? ExitStatus::WrongUsage : ExitStatus::Impossible, std::move(*problem)};
    }
    return std::get<T>(std::move(result));
}

/// "glint: KIND: the problem": one line of at most 4096 bytes, with control characters escaped. When standard
/// error is gone nobody is told.
void say(const char* kind, Problem problem);

/// Says, in the same form, what was tolerated.
void say_warning(const std::string& warning);

}  // namespace glint
