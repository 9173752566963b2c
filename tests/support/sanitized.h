// Whether this runs under sanitizers, where everything takes 5 to 20 times as long. A test that compares
// numbers then checks fewer pixels or sizes, because the Release build checks all of them, but still covers
// every path through the code.
#pragma once

namespace glint::test {

#ifdef GLINT_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

}  // namespace glint::test
