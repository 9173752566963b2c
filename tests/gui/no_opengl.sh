#!/usr/bin/env bash
# On a display without OpenGL, the program prints one line that reports this with GLFW's message, and exits with 1.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

start_display 640x480 -extension GLX
"$program" 2>"$work/glint.err" &
glint_pid=$!
within 20 has_ended || fail "the program did not exit"
wait "$glint_pid"
status=$?
glint_pid=
[ "$status" -eq 1 ] || fail "exit status $status, not 1"
[ "$(wc -l <"$work/glint.err")" -eq 1 ] || fail "not exactly one line on standard error"
grep -q '^glint: error: no window can be opened: GLX: .*; expected a display with OpenGL' "$work/glint.err" || fail "unexpected message"
echo "passed"
