// The program's entry point: prepares the process, runs the command line, and reports an error on one line.

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/io/child_process.h"
#include "models/io/file.h"
#include "models/memory_limit.h"
#include "renderer/simd/isa/kernel_set.h"
#include "shader/shader_process.h"

namespace {

using namespace glint;

/// Occupies a closed descriptor 0, 1 or 2. Otherwise the next file opened would get that number and receive
/// our output. The descriptor is opened in the wrong direction, so writing to a closed output is still an
/// error.
void occupy_closed_descriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) != -1) continue;
        const int wrong_way = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        (void)!open("/dev/null", wrong_way);  // uses the lowest free descriptor, which is this one
    }
}

/// Prints the current exception as one line, and returns the exit status.
int report_exception() {
    try {
        throw;
    } catch (const Failure& failure) {
        say("error", failure.problem);
        return static_cast<int>(failure.status);
    } catch (const std::bad_alloc& error) {
        say("error", problem_from(error));
    } catch (const std::exception& error) {
        say("error", {.file = {}, .pointer = {}, .what = error.what(), .expected = {}});
    }
    return static_cast<int>(ExitStatus::Impossible);
}

/// Reports an exception that cannot be caught, such as one in a library's thread, and ends the program at
/// once: other threads may be running.
[[noreturn]] void report_uncaught_exception() {
    std::set_terminate(std::abort);  // in case reporting fails
    std::_Exit(report_exception());
}

/// Prints the output, then writes the file: if the output cannot be printed, no file is replaced.
void finish(const Outcome& outcome) {
    if (!outcome.output.empty()) (void)take(write_file("-", outcome.output));
    if (!outcome.path.empty()) (void)take(write_file(outcome.path, outcome.bytes));
}

int run(const std::vector<std::string>& arguments) {
    if (const auto found = instruction_set_problem())
        throw Failure{found->unknown ? ExitStatus::WrongUsage : ExitStatus::Impossible, found->problem};
    if (auto problem = memory_limit_problem()) throw Failure{ExitStatus::WrongUsage, *problem};
    const Outcome outcome = run_command_line(arguments);
    finish(outcome);
    std::set<std::string> said;  // a scene may contain the same mesh twice
    for (const std::string& warning : outcome.warnings) {
        if (said.insert(warning).second) say_warning(warning);
    }
    return static_cast<int>(outcome.status);
}

/// Runs the worker called `name`, if there is one, and ends the process.
void work_as(const std::string& name, const std::vector<std::string>& words) {
    if (name != shader_worker_name && name != grade_worker_name) return;
    end_with_parent();
    // Exit at once: the driver's memory need not be freed.
    std::_Exit(name == shader_worker_name ? run_shader_worker() : run_grade_worker(words));
}

}  // namespace

int main(int argc, char** argv) {
    occupy_closed_descriptors();
    std::set_terminate(report_uncaught_exception);
    // Makes write() fail on a closed pipe or beyond the file size limit, instead of killing the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        if (argc > 0) work_as(argv[0], {argv + 1, argv + argc});
        return run({argv + 1, argv + argc});
    } catch (...) {
        return report_exception();
    }
}
