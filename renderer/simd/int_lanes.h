#pragma once
// Integer operations of the rasterizer on the types of lanes.h: multiply, compare and select, lane by lane.

#include "renderer/simd/lanes.h"

namespace glint::inline GLINT_ISA {

/// 0, 1, 2, ..., one number per lane of the widest set.
static constexpr int iota[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

template <class I> I broadcast(int a) {
    if constexpr (sizeof(I) == sizeof(int))
        return a;
    else
        return I{decltype(I::v){} + a};
}

template <int N> IntLanes<N> operator-(IntLanes<N> a, IntLanes<N> b) { return {a.v - b.v}; }
template <int N> IntLanes<N> operator-(int a, IntLanes<N> b) { return {a - b.v}; }
template <int N> IntLanes<N> operator&(IntLanes<N> a, IntLanes<N> b) { return {a.v & b.v}; }
template <int N> IntLanes<N> operator*(IntLanes<N> a, int b) { return {a.v * b}; }
template <int N> IntLanes<N> operator*(IntLanes<N> a, IntLanes<N> b) { return {a.v * b.v}; }

template <int N> IntLanes<N> operator>(IntLanes<N> a, IntLanes<N> b) { return {a.v > b.v}; }
template <int N> IntLanes<N> not_equal(IntLanes<N> a, IntLanes<N> b) { return {a.v != b.v}; }
template <int N> IntLanes<N> not_negative(IntLanes<N> a) { return {a.v >= 0}; }
template <int N> IntLanes<N> mask_or(IntLanes<N> a, IntLanes<N> b) { return {a.v | b.v}; }
template <int N> IntLanes<N> select(IntLanes<N> m, IntLanes<N> a, IntLanes<N> b) { return {m.v ? a.v : b.v}; }
#ifdef __AVX512F__
inline Mask16 operator>(IntLanes<16> a, IntLanes<16> b) {
    return {_mm512_cmpgt_epi32_mask((__m512i)a.v, (__m512i)b.v)};
}
inline Mask16 not_equal(IntLanes<16> a, IntLanes<16> b) {
    return {_mm512_cmpneq_epi32_mask((__m512i)a.v, (__m512i)b.v)};
}
inline Mask16 not_negative(IntLanes<16> a) {
    return {_mm512_cmpge_epi32_mask((__m512i)a.v, _mm512_setzero_si512())};
}
inline bool any_bit(IntLanes<16> a) { return _mm512_test_epi32_mask((__m512i)a.v, (__m512i)a.v) != 0; }
inline Mask16 mask_or(Mask16 a, Mask16 b) { return {static_cast<unsigned short>(a.bits | b.bits)}; }
inline IntLanes<16> select(Mask16 m, IntLanes<16> a, IntLanes<16> b) {
    return {(LanesOf<16>::Ints)_mm512_mask_blend_epi32(m.bits, (__m512i)b.v, (__m512i)a.v)};
}
#endif
/// A mask of the lanes 0 .. count - 1.
template <Number F> MaskOf<F> first_n(int count) {
#ifdef __AVX512F__
    if constexpr (NumberTraits<F>::width == 16) return {static_cast<unsigned short>((1u << count) - 1)};
#endif
    return broadcast<IntOf<F>>(count) > load_ints<IntOf<F>>(iota);
}
/// Moves lane i - 1 to lane i. The first lane is unchanged.
inline IntLanes<4> slide1up(IntLanes<4> a) { return {__builtin_shufflevector(a.v, a.v, 0, 0, 1, 2)}; }
inline IntLanes<8> slide1up(IntLanes<8> a) {
    return {__builtin_shufflevector(a.v, a.v, 0, 0, 1, 2, 3, 4, 5, 6)};
}
inline IntLanes<16> slide1up(IntLanes<16> a) {
    return {__builtin_shufflevector(a.v, a.v, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14)};
}
inline int slide1up(int a) { return a; }
/// Returns a mask as bits: bit i for lane i.
template <int N> unsigned mask_bits(IntLanes<N> m) {
#ifdef __AVX__
    if constexpr (N == 8) return static_cast<unsigned>(_mm256_movemask_ps((__m256)m.v));
#endif
#ifdef __SSE2__
    if constexpr (N == 4) return static_cast<unsigned>(_mm_movemask_ps((__m128)m.v));
#endif
    unsigned bits = 0;
    for (int i = 0; i < N; ++i) bits |= (m.v[i] & 1u) << i;
    return bits;
}
#ifdef __AVX512F__
inline unsigned mask_bits(Mask16 m) { return m.bits; }
#endif
inline unsigned mask_bits(bool m) { return m ? 1 : 0; }

/// Stores the selected lanes contiguously, in memory with room for all lanes. Returns the number of selected
/// lanes.
template <int N> unsigned compress_store(IntLanes<N> mask, IntLanes<N> a, int* to) {
    const unsigned bits = mask_bits(mask);
    unsigned count = 0;
    for (int i = 0; i < N; ++i) {  // without branches, which would be unpredictable
        to[count] = a.v[i];
        count += bits >> i & 1u;
    }
    return count;
}
#ifdef __AVX512F__
inline unsigned compress_store(Mask16 mask, IntLanes<16> a, int* to) {
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask.bits, (__m512i)a.v));
    return static_cast<unsigned>(__builtin_popcount(mask.bits));
}
#endif
inline unsigned compress_store(bool mask, int a, int* to) {
    *to = a;
    return mask ? 1 : 0;
}

/// Returns the largest number in any lane.
template <int N> int reduce_max(IntLanes<N> a) {
    int most = a.v[0];
    for (int i = 1; i < N; ++i) most = a.v[i] > most ? a.v[i] : most;
    return most;
}
inline int reduce_max(int a) { return a; }
inline bool not_equal(int a, int b) { return a != b; }
inline bool not_negative(int a) { return a >= 0; }
inline bool mask_or(bool a, bool b) { return a || b; }
inline int select(bool m, int a, int b) { return m ? a : b; }

template <int N> IntLanes<N> max(IntLanes<N> a, IntLanes<N> b) { return select(a > b, a, b); }
template <int N> IntLanes<N> min(IntLanes<N> a, IntLanes<N> b) { return select(a > b, b, a); }
inline int max(int a, int b) { return a > b ? a : b; }
inline int min(int a, int b) { return a > b ? b : a; }

}  // namespace glint::inline GLINT_ISA
