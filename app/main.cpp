// Where the program starts: prepares the process, runs the command line, says in one line what went wrong.

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "app/commands/command.h"
#include "app/failure.h"
#include "models/io/file.h"
#include "models/io/temporary.h"
#include "models/memory_limit.h"
#include "renderer/kernels/instruction_set.h"

namespace {

using namespace glint;

/// Fills a closed descriptor 0, 1 or 2, which else would be given to the next file that is opened and receive
/// our output. It is opened the wrong way round, so that writing to a closed output still is an error.
void occupy_closed_descriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) != -1) continue;
        const int wrong_way = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        (void)!open("/dev/null", wrong_way);  // the lowest free descriptor is this one
    }
}

/// Whether a library says that the system refuses it a thread.
bool is_about_a_thread(const std::exception& error) {
    return std::string_view(error.what()).find("pthread_create") != std::string_view::npos;
}
std::string what_of(const std::exception& error) {
    return is_about_a_thread(error) ? "the system refuses a thread: " + std::string(error.what())
                                    : error.what();
}
std::string needs_of(const std::exception& error) {
    return is_about_a_thread(error) ? "more memory and processes (ulimit -v, ulimit -u), or --threads 1" : "";
}

std::atomic<bool> has_begun_to_say = false, has_said = false;  // one line ends the program

/// Prints the current exception as one line like any other error, or as a fixed line if memory does not even
/// suffice for that. `before` precedes an exception's own words. If another thread came first, waits until
/// its line is printed. Returns the exit status.
int say_what_ended_it(const char* before = "") noexcept {
    int status = static_cast<int>(ExitStatus::Impossible);
    if (has_begun_to_say.exchange(true)) {
        while (!has_said) std::this_thread::yield();
        return status;
    }
    try {
        try {
            throw;
        } catch (const Failure& failure) {
            status = static_cast<int>(failure.status);
            say("error", failure.problem);
        } catch (const std::bad_alloc& error) {
            say("error", memory_problem(error));
        } catch (const std::exception& error) {
            say("error",
                {.file = {}, .pointer = {}, .what = before + what_of(error), .expected = needs_of(error)});
        }
    } catch (...) {
        (void)std::fputs("glint: error: there is not enough memory; expected more of it\n", stderr);
    }
    has_said = true;
    return status;
}

/// Handles what nobody could catch, such as a thread that the system refuses to a library that asked for it.
/// Leaves at once: other threads may still be at work.
[[noreturn]] void end_without_a_trace() {
    if (std::current_exception())
        (void)say_what_ended_it("the program cannot go on: ");
    else if (!has_begun_to_say.exchange(true))
        (void)std::fputs("glint: error: the program cannot go on\n", stderr);
    remove_temporaries();
    std::_Exit(static_cast<int>(ExitStatus::Impossible));
}

/// Prints the output, and then lets the files that were put aside take their places.
void finish(Outcome& outcome) {
    if (!outcome.output.empty()) outcome.put_aside("-", std::move(outcome.output));
    if (!outcome.files) return;
    (void)take(outcome.files->put_in_place());
}

int run(const std::vector<std::string>& arguments) {
    if (const auto found = instruction_set_problem())
        throw Failure{found->unknown ? ExitStatus::WrongUsage : ExitStatus::Impossible, found->problem};
    if (auto problem = memory_limit_problem()) throw Failure{ExitStatus::WrongUsage, *problem};
    Outcome outcome = run_command_line(arguments);
    finish(outcome);
    std::set<std::string> said;  // the same mesh may stand in a scene twice
    for (const std::string& warning : outcome.warnings) {
        if (said.insert(warning).second) say_warning(warning);
    }
    return static_cast<int>(outcome.status);
}

/// Lets all threads share one heap where the address space is limited: glibc would reserve 64 MiB of it for
/// the heap of each.
void share_a_heap_where_room_is_short() {
    if (address_space_limit() != std::numeric_limits<std::uint64_t>::max()) (void)mallopt(M_ARENA_MAX, 1);
}

}  // namespace

int main(int argc, char** argv) {
    occupy_closed_descriptors();
    std::set_terminate(end_without_a_trace);
    // A reader that went away and a file grown too large are errors that we can name.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // However the process ends, no half-written file stays.
    remove_temporaries_on_signals();
    std::at_quick_exit(remove_temporaries);
    share_a_heap_where_room_is_short();
    try {
        return run({argv + 1, argv + argc});
    } catch (...) {
        return say_what_ended_it();
    }
}
