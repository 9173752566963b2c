#include "renderer/threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>

namespace glint {
namespace {

constexpr int max_threads = 256;

/// Allows TBB to start more threads than there are cores. The process keeps a single limit object, because
/// with several objects the smallest limit would apply.
void allow_threads() {
    static const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, max_threads);
}

}  // namespace

int arena_threads(int threads) {
    allow_threads();
    const int asked = threads > 0 ? threads : tbb::info::default_concurrency();
    return std::min(asked, max_threads);
}

}  // namespace glint
