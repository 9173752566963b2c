#pragma once
// Vectors with one element per pixel: megabytes written by many threads at once.

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace glint {

/// Leaves new elements uninitialized if no value is given (std::vector sets them to 0, on one thread), and
/// requests large pages: with pages of 4 KiB, page faults took a third of the time of the first picture.
template <class T> struct PixelAllocator {
    static_assert(std::is_trivially_copyable_v<T>);
    using value_type = T;

    PixelAllocator() = default;
    template <class Other>
    PixelAllocator(const PixelAllocator<Other>& /*same*/) {}  // NOLINT: implicit, as in std::allocator

    [[nodiscard]] T* allocate(std::size_t count) {
        T* memory = std::allocator<T>().allocate(count);
#ifdef __linux__
        constexpr std::size_t large_page = std::size_t{1} << 21;
        void* first = memory;
        std::size_t bytes = count * sizeof(T);
        // Only a hint, which the system may ignore.
        if (std::align(large_page, large_page, first, bytes) != nullptr)
            (void)madvise(first, bytes / large_page * large_page, MADV_HUGEPAGE);
#endif
        return memory;
    }
    void deallocate(T* memory, std::size_t count) { std::allocator<T>().deallocate(memory, count); }

    template <class U> void construct(U* at) { ::new (static_cast<void*>(at)) U; }
    template <class U, class... Arguments> void construct(U* at, Arguments&&... arguments) {
        std::construct_at(at, std::forward<Arguments>(arguments)...);
    }
    bool operator==(const PixelAllocator&) const = default;
};

template <class T> using PixelVector = std::vector<T, PixelAllocator<T>>;

}  // namespace glint
