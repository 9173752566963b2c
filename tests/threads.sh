#!/usr/bin/env bash
# Builds what draws and searches on several threads under ThreadSanitizer and runs its tests: exit status 0 where there is
# no race but those that tests/tsan.supp names, with their reason. Further arguments are Catch2's.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cmake --preset tsan >/dev/null
cmake --build --preset tsan --target thread_tests
TSAN_OPTIONS="suppressions=$PWD/tests/tsan.supp report_signal_unsafe=0 halt_on_error=0 exitcode=66" \
    build/tsan/tests/thread_tests "~[long]~[release]" "$@"
