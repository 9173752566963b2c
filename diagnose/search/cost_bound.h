#pragma once
// The search tries very many explanations and keeps a few. Most of them are seen to be worse than those few
// long before they are tried to their end.

#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>
#include <queue>

namespace glint {

/// The largest of the `count` smallest costs that were added so far; infinity until there are so many.
/// Several threads may add and ask at once.
class CostBound {
  public:
    explicit CostBound(std::size_t count) : count_(count) {}

    [[nodiscard]] double get() const { return bound_.load(std::memory_order_relaxed); }
    void add(double cost) {
        const std::lock_guard lock(mutex_);
        smallest_.push(cost);
        if (smallest_.size() > count_) smallest_.pop();
        if (count_ > 0 && smallest_.size() == count_)
            bound_.store(smallest_.top(), std::memory_order_relaxed);
    }

  private:
    std::size_t count_;
    std::mutex mutex_;
    std::priority_queue<double> smallest_;
    std::atomic<double> bound_ = std::numeric_limits<double>::infinity();
};

}  // namespace glint
