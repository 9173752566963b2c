#!/usr/bin/env bash
# Builds multithreaded code under ThreadSanitizer and runs its tests: exit status 0 if there is no race. Further
# arguments are passed to Catch2.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cmake --preset tsan >/dev/null
cmake --build --preset tsan --target thread_tests
TSAN_OPTIONS="halt_on_error=0 exitcode=66" build/tsan/tests/thread_tests "~[long]~[release]" "$@"
