#pragma once
// Records of four floats, one for each lane, turned into four numbers: one 16-byte read a lane instead of
// four gathers of four bytes, and the turning is done in registers. Shuffles only, so no bit can change.

#include <cstddef>

#include "renderer/lighting/number.h"

namespace glint::inline GLINT_ISA {

/// The four floats of each lane's record, side by side.
template <Number F> struct Quad { F a, b, c, d; };

namespace quads {

typedef float Row __attribute__((vector_size(16)));
inline Row row(const char* from) {
    Row r;
    __builtin_memcpy(&r, from, sizeof(r));
    return r;
}

// What turning needs of each width: N floats of N / 4 rows; two vectors' floats in turn, from the lower or
// the upper half of each row; and two vectors' pairs of floats in turn.
template <int N> struct Turn;
template <> struct Turn<4> {
    using V = LanesOf<4>::Floats;
    static V rows(const char* from, const unsigned* at, std::size_t step) { return row(from + at[0] * step); }
    static V low(V a, V b) { return __builtin_shufflevector(a, b, 0, 4, 1, 5); }
    static V high(V a, V b) { return __builtin_shufflevector(a, b, 2, 6, 3, 7); }
    static V low_pairs(V a, V b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
    static V high_pairs(V a, V b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }
};
template <> struct Turn<8> {
    using V = LanesOf<8>::Floats;
    static V rows(const char* from, const unsigned* at, std::size_t step) {
        return __builtin_shufflevector(row(from + at[0] * step), row(from + at[4] * step), 0, 1, 2, 3, 4, 5,
                                       6, 7);
    }
    static V low(V a, V b) { return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13); }
    static V high(V a, V b) { return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15); }
    static V low_pairs(V a, V b) { return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13); }
    static V high_pairs(V a, V b) { return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15); }
};
template <> struct Turn<16> {
    using V = LanesOf<16>::Floats;
    static V rows(const char* from, const unsigned* at, std::size_t step) {
        return __builtin_shufflevector(Turn<8>::rows(from, at, step), Turn<8>::rows(from, at + 8, step), 0, 1,
                                       2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    }
    static V low(V a, V b) {
        return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    }
    static V high(V a, V b) {
        return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    }
    static V low_pairs(V a, V b) {
        return __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
    }
    static V high_pairs(V a, V b) {
        return __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
    }
};

}  // namespace quads

/// Lane i: the four floats that lie at[i] * step bytes behind `from`.
template <Number F> Quad<F> load_quads(const void* from, const unsigned* at, std::size_t step) {
    constexpr int N = NumberTraits<F>::width;
    const auto* bytes = static_cast<const char*>(from);
    if constexpr (N == 1) {
        Quad<F> record;
        __builtin_memcpy(&record, bytes + at[0] * step, sizeof(record));
        return record;
    } else {
        using T = quads::Turn<N>;
        // Each holds a record in every row of four: those of lanes 0, 4, 8, 12 and so on.
        const auto r0 = T::rows(bytes, at, step), r1 = T::rows(bytes, at + 1, step);
        const auto r2 = T::rows(bytes, at + 2, step), r3 = T::rows(bytes, at + 3, step);
        const auto ab0 = T::low(r0, r1), ab2 = T::low(r2, r3);
        const auto cd0 = T::high(r0, r1), cd2 = T::high(r2, r3);
        return {F(T::low_pairs(ab0, ab2)), F(T::high_pairs(ab0, ab2)), F(T::low_pairs(cd0, cd2)),
                F(T::high_pairs(cd0, cd2))};
    }
}

}  // namespace glint::inline GLINT_ISA
