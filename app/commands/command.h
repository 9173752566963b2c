#pragma once
// A command of the program: its options and its action.

#include <functional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "models/problem.h"

namespace glint {

class Options;

/// The result of a command.
struct Outcome {
    std::string output;  // for standard output
    Warnings warnings;   // tolerated problems
    ExitStatus status = ExitStatus::Done;
    std::string path = {}, bytes = {};  // a file to write after the output; empty path: none
};

/// Throws Failure. All output is in the outcome, so a failure leaves standard output empty.
using Run = std::function<Outcome()>;

struct Command {
    std::string name;                  // "render"; empty for the window
    std::string usage;                 // follows the name: "FILE -o OUT"
    std::string summary;               // one line
    std::string example;               // a complete line to copy
    Run (*declare)(Options& options);  // adds the command's options and returns its action
};

[[nodiscard]] Command window_command();
[[nodiscard]] Command render_command();
[[nodiscard]] Command explain_command();
[[nodiscard]] Command profile_command();
[[nodiscard]] Command sheet_command();
[[nodiscard]] Command lobe_command();
[[nodiscard]] Command microfacets_command();
[[nodiscard]] Command formfactor_command();
[[nodiscard]] Command info_command();
[[nodiscard]] Command mistakes_command();
[[nodiscard]] Command schema_command();
[[nodiscard]] Command code_command();
[[nodiscard]] Command shade_command();
[[nodiscard]] Command export_command();
[[nodiscard]] Command grade_command();
[[nodiscard]] Command compare_command();
[[nodiscard]] Command diagnose_command();
[[nodiscard]] Command check_command();
[[nodiscard]] Command bench_command();
[[nodiscard]] Command lessons_command();
[[nodiscard]] Command exercise_command();
[[nodiscard]] Command quiz_command();

/// The argv[0] that makes main() run as a worker of `glint grade`, which judges one file.
inline constexpr const char* grade_worker_name = "glint-grade";
[[nodiscard]] int run_grade_worker(const std::vector<std::string>& words);

/// Returns the commands that have a name, in the order in which --help lists them.
[[nodiscard]] std::vector<Command> named_commands();

/// Runs the command that `arguments` (argv without argv[0]) name: parses its options, and reports errors in
/// the one-line form of docs/command_line.md. Throws Failure.
[[nodiscard]] Outcome run_command_line(const std::vector<std::string>& arguments);

}  // namespace glint
