#!/usr/bin/env bash
# When the connection to the display is lost, the window reports it in one line and exits with 1. The copy of
# unsaved work is kept.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

echo '{"glint": 1, "objects": [{"name": "Ball"}]}' >"$work/scene.json"
start_display 1280x800
start_glint "$work/scene.json"
xdotool key 1 # flat shading: a change
within 15 copied flat || fail "the change did not take effect"
kill -9 "$xvfb_pid"
within 20 has_ended || fail "the program keeps running without a display"
wait "$glint_pid"
status=$?
glint_pid=
[ "$status" -eq 1 ] || fail "exit status $status, not 1"
[ "$(wc -l <"$work/glint.err")" -eq 1 ] || fail "not exactly one line on standard error"
grep -q '^glint: error: the connection to the display was lost$' "$work/glint.err" || fail "unexpected message"
copied flat || fail "the copy of unsaved work was removed"
echo "passed"
