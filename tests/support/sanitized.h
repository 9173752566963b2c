// Whether this runs under sanitizers, where all takes 5 to 20 times as long: a test of numbers looks there at
// fewer of many pixels or sizes, since Release holds every one of them, but takes every way through the code.
#pragma once

namespace glint::test {

// Asked for while the tests run: two build trees may share what was compiled (GLINT_COMPILED_TESTS).
extern const bool sanitized;

}  // namespace glint::test
