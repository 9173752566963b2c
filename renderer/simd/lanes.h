#pragma once
// The number type of the equation: `float`, or a vector of N floats (`Lanes<N>`) with the same operations and
// bit-identical results. Only this header and its three extensions (double_lanes.h, transpose.h, int_lanes.h)
// use the compiler's vector types and the processor's intrinsics. Everything here is in a separate namespace
// for each instruction set, so that the linker can never merge AVX code with baseline code.
//
// The equation may use only + - * / square_root, comparisons, select, and the bit operations of pow.h. With
// -ffp-contract=off, every width and every optimization level then gives the same bits.

#ifndef GLINT_ISA
#define GLINT_ISA baseline
#endif

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace glint::inline GLINT_ISA {

template <int N> struct LanesOf {  // N floats and N ints as the compiler's vector types
    typedef float Floats __attribute__((vector_size(N * sizeof(float))));
    typedef int Ints __attribute__((vector_size(N * sizeof(int))));
};

/// N integers. As a mask, each lane is 0 (false) or -1 (true), as returned by comparisons.
template <int N> struct IntLanes { typename LanesOf<N>::Ints v; };

template <int N> struct Lanes {
    using V = typename LanesOf<N>::Floats;
    V v;
    Lanes() : v{} {}
    Lanes(float a) : v(a - V{}) {}  // NOLINT: broadcasts a number to all lanes
    explicit Lanes(V a) : v(a) {}
};

/// A mask of 16 lanes in an AVX-512 mask register.
struct Mask16 {
    unsigned short bits;  // lane i: bit i
};
template <int N> struct MaskOfLanes { using Type = IntLanes<N>; };
#ifdef __AVX512F__
template <> struct MaskOfLanes<16> { using Type = Mask16; };
#endif

// The mask and integer types of a number type.
template <class F> struct NumberTraits;
template <> struct NumberTraits<float> {
    using Mask = bool;
    using Int = int;
    static constexpr int width = 1;
};
template <>
struct NumberTraits<double> {  // for positions on faces that are too large for floats; never in the equation
    using Mask = bool;
    using Int = long long;
    static constexpr int width = 1;
};
template <int N> struct NumberTraits<Lanes<N>> {
    using Mask = typename MaskOfLanes<N>::Type;
    using Int = IntLanes<N>;
    static constexpr int width = N;
};
template <class F>
concept Number = requires {
    typename NumberTraits<F>::Mask;
};
template <Number F> using MaskOf = typename NumberTraits<F>::Mask;
template <Number F> using IntOf = typename NumberTraits<F>::Int;

/// A vector of numbers: Lanes or Doubles (double_lanes.h).
template <class L>
concept SideBySide = Number<L> && requires {
    typename L::V;
};

// Arithmetic.
template <SideBySide L> L operator+(L a, L b) { return L(a.v + b.v); }
template <SideBySide L> L operator-(L a, L b) { return L(a.v - b.v); }
template <SideBySide L> L operator*(L a, L b) { return L(a.v * b.v); }
template <SideBySide L> L operator/(L a, L b) { return L(a.v / b.v); }
template <SideBySide L> L operator-(L a) { return L(-a.v); }

// Comparisons return masks.
template <SideBySide L> MaskOf<L> operator<(L a, L b) { return {a.v < b.v}; }
template <SideBySide L> MaskOf<L> operator>(L a, L b) { return {a.v > b.v}; }
template <SideBySide L> MaskOf<L> operator<=(L a, L b) { return {a.v <= b.v}; }
template <SideBySide L> MaskOf<L> operator>=(L a, L b) { return {a.v >= b.v}; }
#ifdef __AVX512F__
template <int comparison> Mask16 compared(Lanes<16> a, Lanes<16> b) {
    return {_mm512_cmp_ps_mask((__m512)a.v, (__m512)b.v, comparison)};
}
inline Mask16 operator<(Lanes<16> a, Lanes<16> b) { return compared<_CMP_LT_OS>(a, b); }
inline Mask16 operator>(Lanes<16> a, Lanes<16> b) { return compared<_CMP_GT_OS>(a, b); }
inline Mask16 operator<=(Lanes<16> a, Lanes<16> b) { return compared<_CMP_LE_OS>(a, b); }
inline Mask16 operator>=(Lanes<16> a, Lanes<16> b) { return compared<_CMP_GE_OS>(a, b); }
inline Mask16 mask_and(Mask16 a, Mask16 b) { return {static_cast<unsigned short>(a.bits & b.bits)}; }
inline Lanes<16> select(Mask16 m, Lanes<16> a, Lanes<16> b) {
    return Lanes<16>((LanesOf<16>::Floats)_mm512_mask_blend_ps(m.bits, (__m512)b.v, (__m512)a.v));
}
inline bool any(Mask16 m) { return m.bits != 0; }
#endif
template <int N> IntLanes<N> mask_and(IntLanes<N> a, IntLanes<N> b) { return {a.v & b.v}; }
inline bool mask_and(bool a, bool b) { return a && b; }

/// a where the mask is true, otherwise b. Evaluates both.
template <SideBySide L> L select(MaskOf<L> m, L a, L b) { return L(m.v ? a.v : b.v); }
inline float select(bool m, float a, float b) { return m ? a : b; }
inline double select(bool m, double a, double b) { return m ? a : b; }

/// Whether the mask is true in any lane.
template <int N> bool any(IntLanes<N> m) {
#ifdef __AVX__
    if constexpr (N == 8) return _mm256_movemask_ps((__m256)m.v) != 0;
#endif
#ifdef __SSE2__
    if constexpr (N == 4) return _mm_movemask_ps((__m128)m.v) != 0;
#endif
    int seen = 0;
    for (int i = 0; i < N; ++i) seen |= m.v[i];
    return seen != 0;
}
inline bool any(bool m) { return m; }

// Integers, for the bit operations of pow.h.
template <int N> IntLanes<N> operator+(IntLanes<N> a, int b) { return {a.v + b}; }
template <int N> IntLanes<N> operator+(IntLanes<N> a, IntLanes<N> b) { return {a.v + b.v}; }
template <int N> IntLanes<N> operator-(IntLanes<N> a, int b) { return {a.v - b}; }
template <int N> IntLanes<N> operator&(IntLanes<N> a, int b) { return {a.v & b}; }
template <int N> IntLanes<N> operator<<(IntLanes<N> a, int b) { return {a.v << b}; }
template <int N> IntLanes<N> operator>>(IntLanes<N> a, int b) { return {a.v >> b}; }
template <int N> IntLanes<N> bits_of(Lanes<N> a) { return {(typename LanesOf<N>::Ints)a.v}; }
inline int bits_of(float a) { return __builtin_bit_cast(int, a); }
template <int N> Lanes<N> number_of_bits(IntLanes<N> a) { return Lanes<N>((typename Lanes<N>::V)a.v); }
inline float number_of_bits(int a) { return __builtin_bit_cast(float, a); }
template <int N> Lanes<N> to_number(IntLanes<N> a) {
    return Lanes<N>(__builtin_convertvector(a.v, typename Lanes<N>::V));
}
inline float to_number(int a) { return static_cast<float>(a); }
/// Truncates towards zero. The result must fit.
template <int N> IntLanes<N> to_int(Lanes<N> a) {
    return {__builtin_convertvector(a.v, typename LanesOf<N>::Ints)};
}
inline int to_int(float a) { return static_cast<int>(a); }
template <int N> IntLanes<N> operator|(IntLanes<N> a, IntLanes<N> b) { return {a.v | b.v}; }
template <int N> IntLanes<N> operator|(IntLanes<N> a, int b) { return {a.v | b}; }
/// Whether any bit is set in any lane.
template <int N> bool any_bit(IntLanes<N> a) { return any(IntLanes<N>{a.v != 0}); }
inline bool any_bit(int a) { return a != 0; }
inline void store_ints(void* to, int a) { __builtin_memcpy(to, &a, sizeof(a)); }
template <int N> void store_ints(void* to, IntLanes<N> a) { __builtin_memcpy(to, &a.v, sizeof(a.v)); }

/// Correctly rounded, as IEEE 754 requires, for every width.
inline float square_root(float a) { return __builtin_sqrtf(a); }
inline double square_root(double a) { return __builtin_sqrt(a); }
template <int N> Lanes<N> square_root(Lanes<N> a) {
#ifdef __AVX512F__
    // maskz: g++ 12 warns about an undefined register inside _mm512_sqrt_ps; the generated code is the same.
    if constexpr (N == 16) return Lanes<N>((typename Lanes<N>::V)_mm512_maskz_sqrt_ps(0xFFFF, (__m512)a.v));
#endif
#ifdef __AVX__
    if constexpr (N == 8) return Lanes<N>((typename Lanes<N>::V)_mm256_sqrt_ps((__m256)a.v));
#endif
#ifdef __SSE2__
    if constexpr (N == 4) return Lanes<N>((typename Lanes<N>::V)_mm_sqrt_ps((__m128)a.v));
#endif
    Lanes<N> root;
    for (int i = 0; i < N; ++i) root.v[i] = __builtin_sqrtf(a.v[i]);
    return root;
}

// Helpers in the lecture's notation.
inline constexpr float smallest_normal = 0x1p-126f;  // smaller positive numbers are denormal
template <Number F> F max(F a, F b) { return select(a > b, a, b); }
template <Number F> F min(F a, F b) { return select(a < b, a, b); }
template <int N> Lanes<N> max(Lanes<N> a, Lanes<N> b) {  // one instruction with the same result, even for NaN
#ifdef __AVX512F__
    if constexpr (N == 16)
        return Lanes<N>((typename Lanes<N>::V)_mm512_maskz_max_ps(0xFFFF, (__m512)a.v, (__m512)b.v));
#endif
#ifdef __AVX__
    if constexpr (N == 8) return Lanes<N>((typename Lanes<N>::V)_mm256_max_ps((__m256)a.v, (__m256)b.v));
#endif
#ifdef __SSE2__
    if constexpr (N == 4) return Lanes<N>((typename Lanes<N>::V)_mm_max_ps((__m128)a.v, (__m128)b.v));
#endif
    return select(a > b, a, b);
}
template <int N> Lanes<N> min(Lanes<N> a, Lanes<N> b) {
#ifdef __AVX512F__
    if constexpr (N == 16)
        return Lanes<N>((typename Lanes<N>::V)_mm512_maskz_min_ps(0xFFFF, (__m512)a.v, (__m512)b.v));
#endif
#ifdef __AVX__
    if constexpr (N == 8) return Lanes<N>((typename Lanes<N>::V)_mm256_min_ps((__m256)a.v, (__m256)b.v));
#endif
#ifdef __SSE2__
    if constexpr (N == 4) return Lanes<N>((typename Lanes<N>::V)_mm_min_ps((__m128)a.v, (__m128)b.v));
#endif
    return select(a < b, a, b);
}
template <Number F> F max0(F a) { return max(a, F(0)); }  // <a> = max(a, 0); NaN gives 0
template <Number F> F abs(F a) { return number_of_bits(bits_of(a) & 0x7fffffff); }
inline double abs(double a) { return a < 0 ? -a : a; }
/// 1 / a, or 0 if a is 0, negative, or so small that 1 / a could overflow.
template <Number F> F inverse_or_zero(F a) { return select(a >= F(smallest_normal), F(1) / a, F(0)); }
inline double inverse_or_zero(double a) { return a >= 0x1p-1022 ? 1 / a : 0; }

// Loads and stores; the pointer need not be aligned.
template <Number F> F load(const float* from) {
    if constexpr (NumberTraits<F>::width == 1) {
        return *from;
    } else {
        F a;
        __builtin_memcpy(&a.v, from, sizeof(a.v));
        return a;
    }
}
template <class I> I load_ints(const void* from) {
    I a;
    __builtin_memcpy(&a, from, sizeof(a));
    return a;
}
inline void store(float* to, float a) { *to = a; }
template <int N> void store(float* to, Lanes<N> a) { __builtin_memcpy(to, &a.v, sizeof(a.v)); }
/// Prefetches the cache lines of `bytes` bytes, starting at `from`. Unmapped addresses are harmless. Always
/// inlined: g++ 12 would remove calls to a function that does nothing else.
[[gnu::always_inline]] inline void prefetch(const void* from, unsigned long bytes) {
    for (unsigned long i = 0; i < bytes; i += 64) __builtin_prefetch(static_cast<const char*>(from) + i);
}
[[gnu::always_inline]] inline void prefetch_to_write(void* to) { __builtin_prefetch(to, 1); }  // one line
inline float lane(float a, int) { return a; }
template <int N> float lane(Lanes<N> a, int i) { return a.v[i]; }

}  // namespace glint::inline GLINT_ISA
