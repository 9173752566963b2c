#pragma once
// Transposes between records of four floats, one per lane, and four vectors (AoS and SoA): one 16-byte load
// per lane instead of four gathers of four bytes, followed by a transpose in registers. Uses only shuffles,
// so values are unchanged to the last bit.

#include <cstddef>

#include "renderer/simd/lanes.h"

namespace glint::inline GLINT_ISA {

/// The four floats of each lane's record, transposed to four vectors.
template <Number F> struct Columns { F a, b, c, d; };

namespace transposing {

typedef float Row __attribute__((vector_size(16)));
inline Row row(const char* from) {
    Row r;
    __builtin_memcpy(&r, from, sizeof(r));
    return r;
}

// The shuffles of a transpose, for each width. `rows` loads N floats, four from each of N / 4 records. The
// others interleave two vectors: single floats of the lower or the upper half of each row, or pairs of
// floats.
template <int N> struct Rows;
template <> struct Rows<4> {
    using V = LanesOf<4>::Floats;
    static V rows(const char* const* at, int offset) { return row(at[0] + offset); }
    static V low(V a, V b) { return __builtin_shufflevector(a, b, 0, 4, 1, 5); }
    static V high(V a, V b) { return __builtin_shufflevector(a, b, 2, 6, 3, 7); }
    static V low_pairs(V a, V b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
    static V high_pairs(V a, V b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }
};
template <> struct Rows<8> {
    using V = LanesOf<8>::Floats;
    static V rows(const char* const* at, int offset) {
        return __builtin_shufflevector(row(at[0] + offset), row(at[1] + offset), 0, 1, 2, 3, 4, 5, 6, 7);
    }
    static V low(V a, V b) { return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13); }
    static V high(V a, V b) { return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15); }
    static V low_pairs(V a, V b) { return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13); }
    static V high_pairs(V a, V b) { return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15); }
};
template <> struct Rows<16> {
    using V = LanesOf<16>::Floats;
    static V rows(const char* const* at, int offset) {
        return __builtin_shufflevector(Rows<8>::rows(at, offset), Rows<8>::rows(at + 2, offset), 0, 1, 2, 3,
                                       4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
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

/// Transposes r[k], which contains the records of lanes k, k + 4, k + 8, ...
template <Number F> Columns<F> transposed(const typename Rows<NumberTraits<F>::width>::V* r) {
    using T = Rows<NumberTraits<F>::width>;
    const auto ab0 = T::low(r[0], r[1]), ab2 = T::low(r[2], r[3]);
    const auto cd0 = T::high(r[0], r[1]), cd2 = T::high(r[2], r[3]);
    return {F(T::low_pairs(ab0, ab2)), F(T::high_pairs(ab0, ab2)), F(T::low_pairs(cd0, cd2)),
            F(T::high_pairs(cd0, cd2))};
}

}  // namespace transposing

/// Gathers, for lane i, the four floats at `from` + at[i] * step bytes.
template <Number F> Columns<F> gather_transposed(const void* from, const unsigned* at, std::size_t step) {
    constexpr int width = NumberTraits<F>::width;
    const auto* bytes = static_cast<const char*>(from);
    if constexpr (width == 1) {
        Columns<F> record;
        __builtin_memcpy(&record, bytes + at[0] * step, sizeof(record));
        return record;
    } else {
        typename transposing::Rows<width>::V rows[4];
#pragma GCC unroll 4  // otherwise the rows would be spilled to memory
        for (int k = 0; k < 4; ++k) {
            const char* record[width / 4];
#pragma GCC unroll 4
            for (int row = 0; row < width / 4; ++row) record[row] = bytes + at[k + 4 * row] * step;
            rows[k] = transposing::Rows<width>::rows(record, 0);
        }
        return transposing::transposed<F>(rows);
    }
}

/// Transposes `count` triples of numbers into three arrays of N. Entries past `count` repeat the first.
template <int N> void transpose_triples(const float* triples, std::size_t count, float (&lists)[3][N]) {
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < 3; ++k) lists[k][i] = triples[3 * (i < count ? i : 0) + k];
}

/// Transposes four arrays of N four-byte numbers into N records, `step` bytes apart.
template <int N> void store_transposed(const float (&lists)[4][N], void* records, std::size_t step) {
    auto* to = static_cast<char*>(records);
    for (int i = 0; i < N; i += 4) {
        transposing::Row list[4];
        for (int k = 0; k < 4; ++k) __builtin_memcpy(&list[k], lists[k] + i, sizeof(transposing::Row));
        const Columns<Lanes<4>> turned = transposing::transposed<Lanes<4>>(list);
        const Lanes<4> record[4] = {turned.a, turned.b, turned.c, turned.d};
        for (int k = 0; k < 4; ++k, to += step) __builtin_memcpy(to, &record[k].v, sizeof(transposing::Row));
    }
}

}  // namespace glint::inline GLINT_ISA
