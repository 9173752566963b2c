#pragma once
// From argv to what the program does: finds the command, splits its line, and says what is wrong with it in
// the one-line form of docs/interface.md.

#include <string>
#include <vector>

#include "app/commands/command.h"

namespace glint {

/// Runs the command that `arguments` (argv without its first) name. Throws Failure.
[[nodiscard]] Outcome run_command_line(const std::vector<std::string>& arguments);

}  // namespace glint
