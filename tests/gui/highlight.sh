#!/usr/bin/env bash
# Dragging a highlight with the real mouse: it follows the cursor, and undo moves it back.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

# Only the highlight is bright: no other pixel is green, and the handle, which is red, is elsewhere.
cat >"$work/scene.json" <<'JSON'
{"glint": 1, "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}, "global_ambient": [0, 0, 0],
 "lights": [{"name": "Bulb", "position": [-1.6, 1.2, 2], "diffuse": [1, 0, 0], "specular": [0, 1, 0]}],
 "objects": [{"name": "Ball", "mesh": {"primitive": "sphere", "detail": 96}, "transform": {"scale": [1.5, 1.5, 1.5]},
   "material": {"ambient": [0, 0, 0], "diffuse": [0, 0, 0], "specular": [1, 1, 1], "shininess": 200}}],
 "display": {"background": [0, 0, 0]}}
JSON

start_display 1280x800
start_glint "$work/scene.json"
xdotool key F11 # only the picture
# Finds the centre of the nearly fully green pixels, in the display's coordinates.
highlight_seen() { # in the screenshot $1
    look "$1"
    local box w h x y
    box=$(convert "$work/$1.png" -channel G -separate +channel -threshold 92% -format '%@' info: | tr 'x+' '  ')
    read -r w h x y <<<"$box"
    [ -n "$y" ] && [ "$w" -gt 1 ] && [ "$w" -lt 100 ] || return 1
    x_seen=$((x + w / 2)) y_seen=$((y + h / 2 + 50))
}
within 10 highlight_seen before || fail "the highlight is not visible"
sleep 1
highlight_seen before
x=$x_seen y=$y_seen
drag_with_mouse "$x" "$y" 120 80
followed() {
    highlight_seen dragged || return 1
    local right=$((x_seen - x - 120)) down=$((y_seen - y - 80))
    [ "${right#-}" -le 3 ] && [ "${down#-}" -le 3 ]
}
within 10 followed || fail "the highlight moved from $x $y to $x_seen $y_seen; expected $((x + 120)) $((y + 80))"
xdotool key ctrl+z
back() {
    highlight_seen undone || return 1
    [ "$x_seen" -eq "$x" ] && [ "$y_seen" -eq "$y" ]
}
within 10 back || fail "after undo the highlight is at $x_seen $y_seen, not at $x $y"
echo "passed"
