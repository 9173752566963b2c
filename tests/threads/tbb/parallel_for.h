#pragma once
// Replaces oneTBB under ThreadSanitizer (tests/threads.sh). Debian's library is not built for it, so that
// ThreadSanitizer cannot see that a loop ends before the code after it begins: each value that one stage
// passes to the next would look like a race, indistinguishable from a real one. These loops run on threads
// that ThreadSanitizer knows. The thread that runs a piece depends only on the piece's number, so each run
// compares the same accesses.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "tbb/blocked_range.h"
#include "tbb/task_arena.h"

namespace tbb {
namespace detail {

/// The first exception thrown in a loop. Pieces that have not started are skipped, as in the library.
class FirstException {
  public:
    template <typename Piece> void run(const Piece& piece) {
        if (thrown_.load(std::memory_order_relaxed)) return;
        try {
            piece();
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!first_) first_ = std::current_exception();
            thrown_.store(true, std::memory_order_relaxed);
        }
    }
    /// Rethrows the first exception of a thread. Call it after all threads have ended.
    void rethrow() const {
        if (first_) std::rethrow_exception(first_);
    }

  private:
    std::atomic<bool> thrown_ = false;
    std::mutex mutex_;
    std::exception_ptr first_;
};

/// Calls `piece(i)` for each i < `count` on the threads of this arena; a nested loop runs on the thread that
/// started it.
template <typename Piece> void on_all_threads(std::size_t count, const Piece& piece) {
    const std::size_t threads = std::min(count, static_cast<std::size_t>(arena_threads));
    FirstException thrown;
    const auto work = [&](std::size_t own) {
        const ArenaOf alone(1);
        for (std::size_t i = own; i < count; i += threads) thrown.run([&] { piece(i); });
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t own = 1; own < threads; ++own) others.emplace_back(work, own);
        if (threads > 0) work(0);
    }
    thrown.rethrow();
}

}  // namespace detail

template <typename Value, typename Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
    if (range.empty()) return;
    const std::size_t size = range.size();
    const std::size_t piece = std::max(range.grainsize(), size / 64);
    detail::on_all_threads((size + piece - 1) / piece, [&](std::size_t i) {
        const std::size_t from = i * piece, to = std::min(from + piece, size);
        body(blocked_range<Value>(range.begin() + static_cast<Value>(from),
                                  range.begin() + static_cast<Value>(to), range.grainsize()));
    });
}

template <typename Value, typename Body> void parallel_for(Value first, Value last, const Body& body) {
    parallel_for(blocked_range<Value>(first, last), [&body](const blocked_range<Value>& range) {
        for (Value i = range.begin(); i < range.end(); ++i) body(i);
    });
}

}  // namespace tbb
