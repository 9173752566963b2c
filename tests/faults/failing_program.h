#pragma once
// Runs the real program while one of its calls of the C library fails.

#include <functional>
#include <string>
#include <vector>

#include "tests/faults/failing_calls.h"
#include "tests/support/program.h"

namespace glint::faults {

/// A command of the program, and what it makes.
struct Command {
    std::string name;                    // for messages
    std::vector<std::string> arguments;  // of glint
    std::string out;                     // the file that it writes, which was there before; empty for none
};

/// How many calls of each kind the command makes, and which calls that touch files, in their order
/// ("rename FROM TO").
struct Calls {
    std::array<long, kinds> counts{};
    std::vector<std::string> lines;
};
[[nodiscard]] Calls calls_of(const Command& command);

/// What the command made when nothing failed: its standard output and its file.
struct Made {
    std::string out, file;
    bool operator==(const Made&) const = default;
};
[[nodiscard]] Made made_by(const Command& command);

/// A command of the program, begun once up to its main(): each run goes on from there in a copy of that
/// process.
class FailingProgram {
  public:
    explicit FailingProgram(Command command);
    ~FailingProgram();
    FailingProgram(const FailingProgram&) = delete;
    FailingProgram& operator=(const FailingProgram&) = delete;

    /// Runs it with the fault, over an old file. Empty when it ended as it may: all was made, or one line on
    /// standard error, exit status 1, nothing on standard output, and the file the old or the new one; and
    /// nothing else is in the file's folder. Else what was wrong with it. After longest_run_s it hangs.
    [[nodiscard]] std::string wrong_end(const Fault& fault, const Made& right);

  private:
    [[nodiscard]] Ended run(const std::string& fault);

    Command command_;
    TemporaryDirectory notes_;
    int socket_ = -1, process_ = -1;
};

/// What the command says on standard error with that fault.
[[nodiscard]] std::string error_of(const Command& command, const Fault& fault);

/// "the write 3 to 5 with no space": for messages.
[[nodiscard]] std::string words_of(const Fault& fault);

/// The numbers of the calls that are let fail one after another: all of them where GLINT_FAULTS=all stands in
/// the environment, else about `most`, evenly spread, the first and the last among them.
[[nodiscard]] std::vector<long> numbers(long count, long most);

}  // namespace glint::faults
