#pragma once
// For kernels compiled once for each instruction set: the set's number type, Wide, and the attribute that
// inlines everything. Internal to these kernels (GLINT_LANES, renderer/CMakeLists.txt, add_kernels).

#include "renderer/simd/lanes.h"

#ifdef GLINT_SANITIZED
#define GLINT_FLATTEN  // one huge function full of checks would take minutes to compile
#else
#define GLINT_FLATTEN [[gnu::flatten]]
#endif

namespace glint::inline GLINT_ISA {

template <int N> struct NumberOf { using Type = Lanes<N>; };
template <> struct NumberOf<1> { using Type = float; };
using Wide = NumberOf<GLINT_LANES>::Type;

}  // namespace glint::inline GLINT_ISA
