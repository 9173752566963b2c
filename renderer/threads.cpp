#include "renderer/threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <new>

#include "models/memory_limit.h"

namespace glint {
namespace {

constexpr int max_threads = 256;

/// Lets the library start more threads than there are cores, if asked for. The process has a single limit: of
/// several, the smallest would count. It is never destroyed, because its destructor waits for ever if memory
/// ran out while the library started. It does not lie on the heap, where it would be a leak.
void allow_threads() {
    alignas(tbb::global_control) static std::array<std::byte, sizeof(tbb::global_control)> place;
    [[maybe_unused]] static const auto* const allowed =
        new (place.data()) tbb::global_control(tbb::global_control::max_allowed_parallelism, max_threads);
}

/// Bytes of the address space that the process has taken; 0 where the system does not tell.
std::uint64_t address_space_taken() {
    std::ifstream pages("/proc/self/statm");
    std::uint64_t taken = 0;
    if (!(pages >> taken)) return 0;
    return taken * static_cast<std::uint64_t>(std::max(sysconf(_SC_PAGESIZE), 1L));
}

/// How many threads have room for their stacks: where the system refuses a thread, the library ends the
/// program.
int threads_with_a_stack() {
    const std::uint64_t stack = tbb::global_control::active_value(tbb::global_control::thread_stack_size);
    const std::uint64_t limit = address_space_limit(), taken = std::min(limit, address_space_taken());
    const std::uint64_t stacks = (limit - taken) / 4 / std::max<std::uint64_t>(stack, 1);
    return static_cast<int>(std::min<std::uint64_t>(stacks, max_threads - 1));
}

}  // namespace

int arena_threads(int threads) {
    allow_threads();
    const int asked = threads > 0 ? threads : tbb::info::default_concurrency();
    return std::min({asked, max_threads, 1 + threads_with_a_stack()});
}

}  // namespace glint
