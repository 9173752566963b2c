#pragma once
// Keeps the limit of the memory that all scenes in hand may ask for together, and how much has been asked
// for. Large allocations are announced here first, so that a scene that does not fit ends in one line and not
// in a machine that swaps or a process that is killed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "models/problem.h"

namespace glint {

/// A std::bad_alloc with a message: code that can go on after running out of memory can go on after this.
class Refused : public std::bad_alloc {
  public:
    explicit Refused(Problem problem) {
        std::string text = problem.text();
        told_ = std::make_shared<const Told>(Told{std::move(problem), std::move(text)});
    }
    [[nodiscard]] const Problem& problem() const { return told_->problem; }
    [[nodiscard]] const char* what() const noexcept override { return told_->text.c_str(); }

  private:
    struct Told {
        Problem problem;
        std::string text;
    };
    std::shared_ptr<const Told> told_;  // exceptions are copied, and that must not throw
};

/// What memory is for; memory_limit.cpp has the words.
enum class MemoryUse { Files, Meshes, Objects, Tiles, Pixels, Output };
inline constexpr std::size_t memory_uses = 6;

/// Bytes, use by use.
struct MemoryNeed {
    std::array<std::uint64_t, memory_uses> bytes{};

    [[nodiscard]] std::uint64_t& operator[](MemoryUse use) { return bytes[static_cast<std::size_t>(use)]; }
    [[nodiscard]] std::uint64_t total() const;
    MemoryNeed& operator+=(const MemoryNeed& more);
};
[[nodiscard]] MemoryNeed memory_need(MemoryUse use, std::uint64_t bytes);
/// Returns the bytes that a text holds outside of its string: 0 for a short one, which lies in it.
[[nodiscard]] inline std::uint64_t bytes_outside(const std::string& text) {
    return text.capacity() > std::string().capacity() ? text.capacity() + 1 : 0;
}

/// Bytes: what set_memory_limit() or the environment variable GLINT_MEMORY says, else default_memory_limit().
[[nodiscard]] std::uint64_t memory_limit();
/// Sets it for the whole process, in bytes; 0: as if this had never been called.
void set_memory_limit(std::uint64_t bytes);

/// Three quarters of the least of: the machine's memory, that of the process's control group and of those
/// around it, and the limits of its address space and its data (RLIMIT_AS, RLIMIT_DATA).
[[nodiscard]] std::uint64_t default_memory_limit();
/// The limit of the address space (RLIMIT_AS), in bytes; the largest number where there is none.
[[nodiscard]] std::uint64_t address_space_limit();
/// The smallest memory limit of this process's control groups, version 1 or 2; the largest number where none
/// has one. `root` is put before /proc and /sys.
[[nodiscard]] std::uint64_t control_group_memory(const std::string& root);

/// "16G", "512M", "1000000": a whole number of bytes, with K, M, G or T of 1024, 1024^2, ... bytes. A problem
/// has `option` in place of a file. 1M at least.
[[nodiscard]] Result<std::uint64_t> parse_memory_size(const std::string& option, std::string_view text);
/// The problem with the value of GLINT_MEMORY; nullopt when it is valid or not set.
[[nodiscard]] std::optional<Problem> memory_limit_problem();

/// The problem to report for an exception that ends a piece of work: its own message, or that memory ran out.
/// `file`: the file that the work was about, or empty.
[[nodiscard]] Problem memory_problem(const std::bad_alloc& error, const std::string& file = {});

/// Throws Refused when `need` does not fit beside all shares there are, of which `own` would be given
/// back.
void require_memory(const MemoryNeed& need, const MemoryNeed& own = {});
/// Bytes that may still be asked for.
[[nodiscard]] std::uint64_t memory_left();

/// A share of the limit, taken while this lives. Several threads may change the same.
class MemoryShare {
  public:
    MemoryShare() = default;
    explicit MemoryShare(const MemoryNeed& need) { set(need); }
    ~MemoryShare();
    MemoryShare(MemoryShare&& other) noexcept;
    MemoryShare& operator=(MemoryShare&& other) noexcept;

    /// Throws Refused, and keeps what it had, when that does not fit.
    void set(const MemoryNeed& need);
    void add(const MemoryNeed& more);
    [[nodiscard]] MemoryNeed need() const;

  private:
    MemoryNeed need_;
};

}  // namespace glint
