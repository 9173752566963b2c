// Whether this runs under sanitizers, where everything takes 5 to 20 times as long: a test of numbers then
// checks fewer of many pixels or sizes, since Release checks all of them, but covers every path through the
// code.
#pragma once

namespace glint::test {

// Evaluated while the tests run: two build trees may share compiled tests (GLINT_COMPILED_TESTS).
extern const bool sanitized;

}  // namespace glint::test
