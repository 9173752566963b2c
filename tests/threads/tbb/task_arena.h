#pragma once
// Replaces oneTBB under ThreadSanitizer: see parallel_for.h.

#include <algorithm>
#include <thread>
#include <utility>

namespace tbb {
namespace detail {

inline thread_local int arena_threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));

/// During its lifetime, loops started by this thread run on `threads` threads.
class ArenaOf {
  public:
    explicit ArenaOf(int threads) : before_(std::exchange(arena_threads, threads)) {}
    ~ArenaOf() { arena_threads = before_; }
    ArenaOf(const ArenaOf&) = delete;
    ArenaOf& operator=(const ArenaOf&) = delete;

  private:
    int before_;
};

}  // namespace detail

class task_arena {
  public:
    explicit task_arena(int threads) : threads_(threads) {}
    [[nodiscard]] int max_concurrency() const { return threads_; }

    template <typename Body> void execute(const Body& body) {
        const detail::ArenaOf own(threads_);
        body();
    }

  private:
    int threads_;
};

namespace this_task_arena {
[[nodiscard]] inline int max_concurrency() { return detail::arena_threads; }
}  // namespace this_task_arena

}  // namespace tbb
