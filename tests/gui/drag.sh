#!/usr/bin/env bash
# Dragging a light with the real mouse: its handle follows the cursor, the picture changes, undo reverts both,
# and the saved scene matches the window. The second argument is the display's resolution, if not 96 dots per inch.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

# Only the handle is pure magenta: the ball reflects at most a third of the light.
cat >"$work/scene.json" <<'JSON'
{"glint": 1, "camera": {"eye": [0, 0, 5]},
 "lights": [{"name": "Bulb", "position": [-1.2, 1.1, 1], "diffuse": [1, 0, 1], "specular": [0, 0, 0]}],
 "objects": [{"name": "Ball", "material": {"ambient": [0, 0, 0], "diffuse": [0.3, 0.3, 0.3]}}]}
JSON

start_display 1280x800
set_resolution "${2:-96}"
start_glint "$work/scene.json"
xdotool key F11 # only the picture: the list of lights also shows the colour
handle_seen() { # in the screenshot $1
    look "$1"
    read -r x_seen y_seen <<<"$(middle_of "$1" '#ff00ff')"
    [ -n "$y_seen" ]
}
within 10 handle_seen before || fail "the light's handle is not visible"
sleep 1
handle_seen before
x=$x_seen y=$y_seen

# Saves the scene, and keeps a copy of the file as $1.
save_as() {
    rm -f "$work/scene.json"
    xdotool key ctrl+s
    within 10 test -s "$work/scene.json" || fail "Ctrl+S wrote nothing"
    sleep 0.2
    cp "$work/scene.json" "$work/$1"
}
save_as first

drag_with_mouse "$x" "$y" 180 90
handle_followed() {
    handle_seen dragged || return 1
    local right=$((x_seen - x - 180)) down=$((y_seen - y - 90))
    [ "${right#-}" -le 1 ] && [ "${down#-}" -le 1 ]
}
within 10 handle_followed ||
    fail "the handle moved from $x $y to $x_seen $y_seen; expected $((x + 180)) $((y + 90))"
changed=$(difference before dragged)
[ "$changed" -gt 10000 ] || fail "the picture changed in only $changed pixels"
save_as second
cmp -s "$work/first" "$work/second" && fail "the drag is not in the saved scene"

looks_like() { # NAME PIXELS: fewer pixels than that differ from the screenshot NAME
    look now
    [ "$(difference "$1" now)" -lt "$2" ]
}
xdotool key ctrl+z
# The hint at the bottom has disappeared in the meantime; without undo the entire ball differs.
within 10 looks_like before 10000 || fail "after undo $(difference before now) pixels differ from the original"
save_as third
cmp -s "$work/first" "$work/third" || fail "after undo the saved scene differs from the first one"

xdotool key ctrl+shift+z
within 10 looks_like dragged 200 || fail "redo does not restore the drag"
xdotool key ctrl+s
sleep 0.5
xdotool key ctrl+q
within 10 has_ended || fail "Ctrl+Q did not close the window"
wait "$glint_pid"
status=$?
glint_pid=
[ "$status" -eq 0 ] || fail "exit status $status"
echo "passed: the drag changed $changed pixels"
