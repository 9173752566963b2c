#pragma once
// How many threads work is spread over.

namespace glint {

/// Returns the threads of a tbb::task_arena: `threads`, 256 at most, or one a core for 0; fewer where their
/// stacks would take more than a quarter of the address space (RLIMIT_AS), 1 at least. From the first call on
/// the library may start so many.
[[nodiscard]] int arena_threads(int threads);

}  // namespace glint
