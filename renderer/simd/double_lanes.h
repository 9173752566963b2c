#pragma once
// Vectors of doubles, for positions: half as many lanes as for floats, so that they fill a register.
// Operations round identically for every width, as in lanes.h.

#include "renderer/simd/lanes.h"

namespace glint::inline GLINT_ISA {

template <class Number, int N> struct Vector {  // N numbers as the compiler's vector type
    typedef Number Type __attribute__((vector_size(N * sizeof(Number))));
};
template <int N> struct Doubles {
    using V = typename Vector<double, N>::Type;
    static constexpr int width = N;
    V v;
    Doubles() : v{} {}
    Doubles(double a) : v(a - V{}) {}  // NOLINT: broadcasts a number to all lanes
    explicit Doubles(V a) : v(a) {}
};
template <int N> struct DoubleMask { typename Vector<long long, N>::Type v; };
template <int N> struct NumberTraits<Doubles<N>> {
    using Mask = DoubleMask<N>;
    using Int = IntLanes<N>;
    static constexpr int width = N;
};

/// Correctly rounded, as IEEE 754 requires, for every width.
template <int N> Doubles<N> square_root(Doubles<N> a) {
#ifdef __AVX512F__
    if constexpr (N == 8) return Doubles<N>((typename Doubles<N>::V)_mm512_maskz_sqrt_pd(0xFF, (__m512d)a.v));
#endif
#ifdef __AVX__
    if constexpr (N == 4) return Doubles<N>((typename Doubles<N>::V)_mm256_sqrt_pd((__m256d)a.v));
#endif
#ifdef __SSE2__
    if constexpr (N == 2) return Doubles<N>((typename Doubles<N>::V)_mm_sqrt_pd((__m128d)a.v));
#endif
    Doubles<N> root;
    for (int i = 0; i < N; ++i) root.v[i] = __builtin_sqrt(a.v[i]);
    return root;
}

/// The type that holds N doubles: a vector, or for N = 1 a double.
template <int N> struct DoublesOf {
    using Type = Doubles<N>;
    static constexpr int width = N;
};
template <> struct DoublesOf<1> {
    using Type = double;
    static constexpr int width = 1;
};
template <Number F> using HalfAsMany = DoublesOf<(NumberTraits<F>::width + 1) / 2>;

/// Loads as many floats or ints as D has lanes, and converts them exactly to doubles.
template <class D, class Narrow> D widened(const Narrow* from) {
    if constexpr (sizeof(D) == sizeof(double)) {
        return static_cast<double>(*from);
    } else {
        typedef Narrow Few
            __attribute__((vector_size(sizeof(typename D::V) / sizeof(double) * sizeof(Narrow))));
        Few few;
        __builtin_memcpy(&few, from, sizeof(few));
        return D(__builtin_convertvector(few, typename D::V));
    }
}

/// Stores numbers rounded to floats.
inline void store_narrowed(float* to, double a) { *to = static_cast<float>(a); }
template <int N> void store_narrowed(float* to, Doubles<N> a) {
    const auto few = __builtin_convertvector(a.v, typename Vector<float, N>::Type);
    __builtin_memcpy(to, &few, sizeof(few));
}
/// Truncates numbers, |a| < 2^31. store_truncated() stores them as ints, truncated() returns them as doubles.
inline void store_truncated(void* to, double a) { store_ints(to, static_cast<int>(a)); }
template <int N> void store_truncated(void* to, Doubles<N> a) {
    const auto few = __builtin_convertvector(a.v, typename Vector<int, N>::Type);
    __builtin_memcpy(to, &few, sizeof(few));
}
inline double truncated(double a) { return static_cast<double>(static_cast<int>(a)); }
template <int N> Doubles<N> truncated(Doubles<N> a) {
    return Doubles<N>(__builtin_convertvector(__builtin_convertvector(a.v, typename Vector<int, N>::Type),
                                              typename Doubles<N>::V));
}

}  // namespace glint::inline GLINT_ISA
