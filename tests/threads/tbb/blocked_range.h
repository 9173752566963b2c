#pragma once
// Replaces oneTBB under ThreadSanitizer: see parallel_for.h.

#include <cstddef>

namespace tbb {

/// The values in [begin(), end()); a loop passes them on in pieces of at least grainsize().
template <typename Value> class blocked_range {
  public:
    blocked_range(Value begin, Value end, std::size_t grainsize = 1)
        : begin_(begin), end_(end), grainsize_(grainsize) {}
    [[nodiscard]] Value begin() const { return begin_; }
    [[nodiscard]] Value end() const { return end_; }
    [[nodiscard]] std::size_t grainsize() const { return grainsize_; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
    [[nodiscard]] bool empty() const { return !(begin_ < end_); }

  private:
    Value begin_, end_;
    std::size_t grainsize_;
};

}  // namespace tbb
