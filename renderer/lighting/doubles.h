#pragma once
// Doubles side by side, for places: half as many as the instruction set has floats, so that they fill a
// register. Operations round alike in every width, as in number.h.

#include "renderer/lighting/number.h"

namespace glint::inline GLINT_ISA {

template <class Number, int N> struct Vector {  // N of them as the compiler's vector type
    typedef Number Type __attribute__((vector_size(N * sizeof(Number))));
};
template <int N> struct Doubles {
    using V = typename Vector<double, N>::Type;
    static constexpr int width = N;
    V v;
    Doubles() : v{} {}
    Doubles(double a) : v(a - V{}) {}  // NOLINT: a number stands for itself in all lanes
    explicit Doubles(V a) : v(a) {}
};
template <int N> Doubles<N> operator+(Doubles<N> a, Doubles<N> b) { return Doubles<N>(a.v + b.v); }
template <int N> Doubles<N> operator-(Doubles<N> a, Doubles<N> b) { return Doubles<N>(a.v - b.v); }
template <int N> Doubles<N> operator*(Doubles<N> a, Doubles<N> b) { return Doubles<N>(a.v * b.v); }
template <int N> Doubles<N> operator/(Doubles<N> a, Doubles<N> b) { return Doubles<N>(a.v / b.v); }

/// The doubles that go with a number type: as many as `width`.
template <int N> struct DoublesOf {
    using Type = Doubles<N>;
    static constexpr int width = N;
};
template <> struct DoublesOf<1> {
    using Type = double;
    static constexpr int width = 1;
};
template <Number F> using HalfAsMany = DoublesOf<(NumberTraits<F>::width + 1) / 2>;

/// `from`: floats or ints, as many as D has lanes; each is a double without rounding.
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

/// Rounded to floats.
inline void store_narrowed(float* to, double a) { *to = static_cast<float>(a); }
template <int N> void store_narrowed(float* to, Doubles<N> a) {
    const auto few = __builtin_convertvector(a.v, typename Vector<float, N>::Type);
    __builtin_memcpy(to, &few, sizeof(few));
}

}  // namespace glint::inline GLINT_ISA
