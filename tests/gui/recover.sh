#!/usr/bin/env bash
# A killed window leaves a copy of unsaved work. The next window offers to recover it, and saving the recovered scene
# writes the copy's contents. The file is among the recent ones.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

cat >"$work/scene.json" <<'JSON'
{"glint": 1, "lights": [{"name": "Bulb", "position": [-1, 1, 2]}], "objects": [{"name": "Ball"}]}
JSON
state=$XDG_STATE_HOME/glint
start_display 1280x800
start_glint "$work/scene.json"
xdotool key 1 # flat shading
within 15 copied flat || fail "no copy of the unsaved work"
remembered() { grep -q "$work/scene.json" "$state/window.json"; }
within 5 remembered || fail "the file is not among the recent ones"
kill -9 "$glint_pid"
wait "$glint_pid" 2>/dev/null
grep -q flat "$work/scene.json" && fail "the file was written without being asked"

start_glint "$work/scene.json"
recover_and_save flat
gone_copy() { ! ls "$state"/*.autosave >/dev/null 2>&1; }
within 10 gone_copy || fail "the copy still exists after saving"
xdotool key ctrl+q
within 10 has_ended || fail "Ctrl+Q did not close the window"
glint_pid=
echo "passed"
