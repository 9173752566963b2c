#!/usr/bin/env bash
# Runs the tests of multithreaded code under ThreadSanitizer (preset `tsan`): the renderer's stages, the
# diagnosis, and the window's background work. Exits with status 0 if no race was found. Additional arguments
# are passed to Catch2.
set -eu
. "$(dirname "${BASH_SOURCE[0]}")/../cmake/prepare.sh"
cd "$glint_root"
build tsan ON glint renderer_tests diagnose_tests ui_tests
export TSAN_OPTIONS="halt_on_error=0 exitcode=66 suppressions=$glint_root/tests/threads/embree.supp"
# tests_of FILE...: the filter that selects the tests in these files.
tests_of() { printf '%s\n' "$@" | sed -E 's|.*/(.*)\.cpp|[#\1]~[cli]~[long]~[release],|' | tr -d '\n'; }
run() { # LAYER FILE...
    local layer=$1
    shift
    "build/tsan/tests/${layer}_tests" --filenames-as-tags "$(tests_of "$@")" "${more[@]}" || failed=1
}
more=("$@")
failed=0
run renderer tests/renderer/stages/*_test.cpp
run diagnose tests/diagnose/*_test.cpp
run ui tests/ui/document/*_test.cpp tests/ui/inspector/{mistake_pictures,why_sensitivity}_test.cpp
exit $failed
