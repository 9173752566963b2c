// Whether this runs under sanitizers, where everything takes 5 to 20 times as long: a test of numbers then
// checks fewer of many pixels or sizes, since Release checks all of them, but covers every path through the
// code.
#pragma once

namespace glint::test {

#ifdef GLINT_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

}  // namespace glint::test
