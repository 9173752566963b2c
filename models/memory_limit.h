#pragma once
// Limits the memory of one scene: `--memory`, GLINT_MEMORY, and the exception for work that exceeds a limit.
// The estimate compared with these limits is in models/scene/scene.h.

#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "models/problem.h"

namespace glint {

/// Thrown by work that exceeds a limit; caught by the command, or by the code that draws the window's frame.
class LimitExceeded : public std::runtime_error {
  public:
    explicit LimitExceeded(const Problem& problem) : std::runtime_error(problem.text()), problem_(problem) {}
    [[nodiscard]] const Problem& problem() const { return problem_; }

  private:
    Problem problem_;
};

/// The problem to report for an exception that stopped an operation. `file`: the file being processed, or
/// empty.
[[nodiscard]] Problem problem_from(const std::exception& error, const std::string& file = {});

/// The bytes that one scene and its picture may use: the value of set_memory_limit() or of the environment
/// variable GLINT_MEMORY, else default_memory_limit().
[[nodiscard]] std::uint64_t memory_limit();
/// Sets the limit for this process, in bytes; 0 removes it.
void set_memory_limit(std::uint64_t bytes);

/// Three quarters of the smallest of: the machine's memory, the limits of the process's control group and its
/// parents, and the limits of its address space and its data (RLIMIT_AS, RLIMIT_DATA).
[[nodiscard]] std::uint64_t default_memory_limit();
/// The smallest memory limit of this process's control groups, version 1 or 2; the largest possible number if
/// none has a limit. `root` is prepended to /proc and /sys.
[[nodiscard]] std::uint64_t control_group_memory(const std::string& root);

/// "16G", "512M", "1000000": a whole number of bytes, with K, M, G or T for 1024, 1024^2, ... bytes; at least
/// 1M. In a problem, `option` takes the place of the file.
[[nodiscard]] Result<std::uint64_t> parse_memory_size(const std::string& option, std::string_view text);
/// The problem with the value of GLINT_MEMORY; nullopt if it is valid or not set.
[[nodiscard]] std::optional<Problem> memory_limit_problem();

}  // namespace glint
