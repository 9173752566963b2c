#pragma once
// Memory allocation that is counted, and fails when it is told to, in place of the library's. For programs of
// one test file.

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

inline std::atomic<long> allocations{0};
inline std::atomic<std::int64_t> bytes_held{0}, max_bytes_held{0}, all_bytes{0};

/// Which allocations fail: the one with that number, counted down (0: now; negative: none), and from then on
/// all of `large_bytes` and more.
inline std::atomic<long> fails_after{-1};
inline std::atomic<std::size_t> large_bytes{SIZE_MAX};
inline std::atomic<bool> large_ones_fail{false};

inline void* counted(std::size_t bytes, std::size_t alignment) {
    ++allocations;
    if (fails_after >= 0 && fails_after-- == 0) {
        large_ones_fail = true;
        throw std::bad_alloc();
    }
    if (large_ones_fail && bytes >= large_bytes) throw std::bad_alloc();
    const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, whole > 0 ? whole : alignment);
    if (!memory) throw std::bad_alloc();
    const auto size = static_cast<std::int64_t>(malloc_usable_size(memory));
    all_bytes += size;
    const std::int64_t held = bytes_held += size;
    for (std::int64_t most = max_bytes_held;
         held > most && !max_bytes_held.compare_exchange_weak(most, held);) {
    }
    return memory;
}

inline void give_back(void* memory) noexcept {
    if (memory != nullptr) bytes_held -= static_cast<std::int64_t>(malloc_usable_size(memory));
    std::free(memory);
}

void* operator new(std::size_t bytes) { return counted(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return counted(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { give_back(memory); }
