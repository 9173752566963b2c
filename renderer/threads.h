#pragma once
// Determines the number of threads.

namespace glint {

/// Returns the number of threads for a tbb::task_arena, 1 to 256: `threads`, or one per core for 0. Returns
/// fewer if their stacks would take more than a quarter of the address space (RLIMIT_AS). Allows TBB to start
/// this many threads.
[[nodiscard]] int arena_threads(int threads);

}  // namespace glint
