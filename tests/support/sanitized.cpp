#include "tests/support/sanitized.h"

namespace glint::test {

#ifdef GLINT_SANITIZED
const bool sanitized = true;
#else
const bool sanitized = false;
#endif

}  // namespace glint::test
