#!/usr/bin/env bash
# Text can be pasted from another program and copied to it.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"
command -v xclip >/dev/null || { echo "skipped: xclip is not installed"; exit 77; }

cat >"$work/scene.json" <<'JSON'
{"glint": 1, "camera": {"eye": [0, 0, 4]}, "global_ambient": [1, 1, 1],
 "objects": [{"name": "Ball", "material": {"ambient": [0, 0.2, 0], "diffuse": [0, 0, 0], "specular": [0, 0, 0]}}]}
JSON
start_display 1280x800
start_glint "$work/scene.json"
xdotool key F10 # the picture alone
within 10 middle_is 003300 || fail "the scene is not visible"

printf 'Ambient on or off' | xclip -selection clipboard
xdotool key ctrl+k # the list of commands
sleep 0.5
xdotool key ctrl+v
sleep 0.5
xdotool key Return
within 10 middle_is 000000 || fail "the text was not pasted"

xdotool key ctrl+k
sleep 0.5
xdotool type --delay 30 "no such command"
sleep 0.5
xdotool key ctrl+a ctrl+c
sleep 0.5
[ "$(timeout 5 xclip -selection clipboard -o)" = "no such command" ] || fail "the text was not copied"
echo "passed"
