#pragma once
// Replaces oneTBB under ThreadSanitizer: see parallel_for.h.

#include "tbb/parallel_for.h"

namespace tbb {

/// `body(range, value)` adds a piece's result to `value`, which starts at `identity`; `join` joins two
/// results.
template <typename Value, typename Result, typename Body, typename Join>
Result parallel_reduce(const blocked_range<Value>& range, const Result& identity, const Body& body,
                       const Join& join) {
    std::mutex mutex;
    Result all = identity;
    parallel_for(range, [&](const blocked_range<Value>& piece) {
        const Result one = body(piece, identity);
        const std::lock_guard lock(mutex);
        all = join(all, one);
    });
    return all;
}

}  // namespace tbb
