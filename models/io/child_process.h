#pragma once
// Runs part of this program in a separate process, which may crash, loop forever or use too much memory.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

struct ChildLimits {
    double seconds = 10;  // time after which the child is killed
    std::uint64_t bytes =
        0;  // limit on the child's address space; 0: no limit. Ignored with sanitizers, which need terabytes
    std::function<bool()> is_cancelled = {};  // queried every few milliseconds; true kills the child
    std::string program = "/proc/self/exe";   // the program to run; default: this one
};

struct ChildEnd {
    enum class How { Exited, Killed, TimedOut, Cancelled, NotStarted };
    How how = How::NotStarted;
    int status = 0;              // the exit status, the signal that killed it, or the errno of NotStarted
    std::string output, errors;  // standard output and standard error

    [[nodiscard]] bool succeeded() const { return how == How::Exited && status == 0; }
};

/// Runs this program with `worker` as argv[0], from which main() chooses its task, and with `input` on
/// standard input. Waits until the child ends. The child is killed if this process ends first. Thread-safe.
[[nodiscard]] ChildEnd run_child(const std::string& worker, const std::vector<std::string>& arguments,
                                 std::string_view input, const ChildLimits& limits);

/// Ends this process when the process that started it ends. A worker must call this first.
void end_with_parent();

}  // namespace glint
