#!/usr/bin/env bash
# In a large window, the maximum zoom enlarges the picture itself, not just its overlays.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

# A green ball on black.
cat >"$work/scene.json" <<'JSON'
{"glint": 1, "camera": {"eye": [0, 0, 9], "target": [0, 0, 0]}, "global_ambient": [0, 0, 0], "lights": [],
 "objects": [{"mesh": {"primitive": "sphere"}, "material": {"emission": [0, 0.5, 0]}}],
 "display": {"background": [0, 0, 0]}}
JSON

start_display 2560x1440
start_glint "$work/scene.json"
xdotool windowmove "$window" 0 0 windowsize "$window" 2560 1440
xdotool key F11 # only the picture
wait_for_rest
import -window root "$work/whole.png"
edge=$(convert "$work/whole.png" -crop 2000x9+280+716 +repage -channel G -separate +channel -threshold 30% -format '%@' info: | tr 'x+' '  ' | cut -d' ' -f3)
edge=$((edge + 280)) # the crop begins there, inside the frame
[ "$edge" -gt 700 ] && [ "$edge" -lt 1200 ] || fail "the ball begins at $edge"
# The cursor is twelve pixels inside the ball, so its edge moves 384 pixels to the left at a zoom of 32, and 768 at 64.
hand=$((edge + 12))
green() { # prints the green value of the pixel this far to the left of the cursor, 0 to 255
    import -window root -crop "100x100+$((hand - $1))+670" "$work/place.png"
    convert "$work/place.png" -channel G -separate +channel -resize 1x1! -format '%[fx:int(255*mean)]' info:
}
is_green() { [ "$(green "$1")" -gt 100 ]; }
xdotool mousemove "$hand" 720 keydown ctrl
for _ in 1 2 3 4 5; do xdotool click 4 && wait_for_rest 2; done
within 10 is_green 300 || fail "the picture is not enlarged: the green value is $(green 300)"
is_green 600 && fail "the picture is enlarged too much"
xdotool click 4 keyup ctrl
within 10 is_green 600 || fail "the picture is not enlarged as much as its overlays: the green value is $(green 600)"
echo "passed"
