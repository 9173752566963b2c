#pragma once
// Runs the real program while one of its calls to the C library fails.

#include <functional>
#include <string>
#include <vector>

#include "tests/faults/failing_calls.h"
#include "tests/support/program.h"

namespace glint::faults {

/// A command line of the program, and its output file.
struct Command {
    std::string name;                    // for messages
    std::vector<std::string> arguments;  // for glint
    std::string out;                     // the output file, which already exists; empty for none
};

/// The number of calls of each kind during the command, and the file operations in order ("rename FROM TO").
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

/// A process of the program that waits at its main(); each run of the command continues in a fork of it.
class FailingProgram {
  public:
    explicit FailingProgram(Command command);
    ~FailingProgram();
    FailingProgram(const FailingProgram&) = delete;
    FailingProgram& operator=(const FailingProgram&) = delete;

    /// Runs the command with the fault; its output file already exists. Returns an empty text if the command
    /// ended correctly: with complete output; or with one line on standard error, exit status 1, nothing on
    /// standard output, and the old or the new file. No other file may be in the folder. Otherwise returns
    /// the problem. A run longer than longest_run_s has hung.
    [[nodiscard]] std::string wrong_end(const Fault& fault, const Made& right);

  private:
    [[nodiscard]] Ended run(const std::string& fault);

    Command command_;
    TemporaryDirectory notes_;
    int socket_ = -1, process_ = -1;
};

/// What the command writes to standard error under that fault.
[[nodiscard]] std::string error_of(const Command& command, const Fault& fault);

/// The fault in the format of GLINT_FAULT, for messages.
[[nodiscard]] std::string words_of(const Fault& fault);

/// The indices of the calls that are made to fail in turn: all of them if GLINT_FAULTS=all is in the
/// environment, otherwise about `most`, evenly spread, including the first and the last.
[[nodiscard]] std::vector<long> numbers(long count, long most);

}  // namespace glint::faults
