#!/usr/bin/env bash
# Input typed during a slow frame reaches its target: after Ctrl+K it reaches the palette, and after Return it
# reaches the field that the palette opens.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

cp "$(dirname "$0")/../../assets/scenes/default.json" "$work/scene.json"
start_display 1280x800
start_glint "$work/scene.json"
wait_for_rest
holds() { grep -q "$1" "$work/scene.json"; }

kill -STOP "$glint_pid"
xdotool key ctrl+k type --delay 12 exposure
xdotool key Return type --delay 12 1.5
xdotool key Return ctrl+s
kill -CONT "$glint_pid"
within 20 holds '"exposure": 1.5' || fail "the input after Ctrl+K and Return did not reach the exposure field"
holds '"mode": "phong"' || fail "a letter was treated as a shortcut that changes the shading"
echo "passed"
