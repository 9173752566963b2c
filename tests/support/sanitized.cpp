#include "tests/support/sanitized.h"

namespace glint::test {

#ifdef GLINT_SANITIZED
const bool sanitized = true;
#else
const bool sanitized = false;
#endif

}  // namespace glint::test

#ifdef GLINT_SANITIZED
// OpenMesh's writer, which tests call, keeps 16 bytes to the end of the program; the leak check need not tell
// of them.
extern "C" const char*
__lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier): the sanitizer's
extern "C" const char* __lsan_default_suppressions() { return "leak:libOpenMeshCore"; }
#endif
