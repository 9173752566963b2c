#!/usr/bin/env bash
# The window redraws only changes. After many changes it shows the same pixels as after a complete redraw.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

start_display 1100x760
start_glint "$(dirname "$0")/../../assets/scenes/default.json"
# The display discards the contents of a hidden window, and requests a complete redraw when it is shown again.
same_when_redrawn() { # after $1
    wait_for_rest 35 # notifications disappear after three seconds
    import -window root "$work/kept.png"
    xdotool windowunmap --sync "$window" windowmap --sync "$window" windowfocus "$window"
    wait_for_rest
    import -window root "$work/redrawn.png"
    local different
    different=$(difference kept redrawn)
    [ "$different" = 0 ] || fail "after $1 $different pixels differ from a complete redraw"
}
drag_with_mouse 400 300 90 40
same_when_redrawn "an orbit"
xdotool mousemove 20 160 click 1 mousemove 700 30
same_when_redrawn "a click in the list"
xdotool key c
xdotool mousemove 640 420
same_when_redrawn "a comparison"
xdotool key c key F9
same_when_redrawn "large type"
xdotool key F9 mousemove 25 20 click 1
sleep 0.3
xdotool key Escape mousemove 500 400 click 1
same_when_redrawn "a menu and a click in the picture"
echo "passed"
