#pragma once
// Runs the real program while one of its calls of the C library fails.

#include <functional>
#include <string>
#include <vector>

#include "tests/faults/failing_calls.h"
#include "tests/support/program.h"

namespace glint::faults {

/// A command of the program, and its output.
struct Command {
    std::string name;                    // for messages
    std::vector<std::string> arguments;  // for glint
    std::string out;                     // the output file, which already exists; empty for none
};

/// The number of calls of each kind in the command, and the calls on files in order ("rename FROM TO").
struct Calls {
    std::array<long, kinds> counts{};
    std::vector<std::string> lines;
};
[[nodiscard]] Calls calls_of(const Command& command);

/// The command's output without a failure: its standard output and its file.
struct Made {
    std::string out, file;
    bool operator==(const Made&) const = default;
};
[[nodiscard]] Made made_by(const Command& command);

/// A command of the program, started once up to its main(): each run continues in a copy of that process.
class FailingProgram {
  public:
    explicit FailingProgram(Command command);
    ~FailingProgram();
    FailingProgram(const FailingProgram&) = delete;
    FailingProgram& operator=(const FailingProgram&) = delete;

    /// Runs the command with the fault; its output file already exists. Returns an empty text if it ended as
    /// allowed: with complete output; or with one line on standard error, exit status 1, nothing on standard
    /// output, and the old or the new file. No other file may be in the folder. Otherwise returns the
    /// problem. A run longer than longest_run_s has hung.
    [[nodiscard]] std::string wrong_end(const Fault& fault, const Made& right);

  private:
    [[nodiscard]] Ended run(const std::string& fault);

    Command command_;
    TemporaryDirectory notes_;
    int socket_ = -1, process_ = -1;
};

/// The command's standard error with that fault.
[[nodiscard]] std::string error_of(const Command& command, const Fault& fault);

/// "the write 3 to 5 with no space": for messages.
[[nodiscard]] std::string words_of(const Fault& fault);

/// The numbers of the calls to fail one after another: all of them if GLINT_FAULTS=all is in the environment,
/// otherwise about `most`, evenly spread, including the first and the last.
[[nodiscard]] std::vector<long> numbers(long count, long most);

}  // namespace glint::faults
