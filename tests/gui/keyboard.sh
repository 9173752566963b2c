#!/usr/bin/env bash
# Keys do what is printed on them, even on a German or French keyboard. The number pad types digits, and without NumLock it
# moves the cursor.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"
command -v setxkbmap >/dev/null || { echo "skipped: setxkbmap is not installed"; exit 77; }

holds() { grep -q "$1" "$work/scene.json"; }
save() { xdotool key ctrl+s && sleep 0.5; }
# KEYS...: presses the keys in the exposure field.
set_exposure() {
    xdotool key ctrl+k type --delay 40 exposure
    xdotool key Return
    sleep 0.5
    xdotool key --delay 150 "$@" # a frame can take that long with sanitizers
}
for layout in de fr; do
    cp "$(dirname "$0")/../../assets/scenes/default.json" "$work/scene.json"
    start_display 1280x800
    setxkbmap "$layout"
    start_glint "$work/scene.json"
    wait_for_rest
    # The key to the left of X on a German keyboard, and of S on a French one, has a different letter in the layout that
    # programs assume.
    set_exposure 1 period 2 5 Return
    save
    within 10 holds '"exposure": 1.25' || fail "$layout: 1.25 was not accepted: $(grep exposure "$work/scene.json")"
    xdotool key ctrl+z
    wait_for_rest 3
    save
    holds '"exposure": 1.25' && fail "$layout: Ctrl+Z did not undo"
    xdotool key ctrl+y
    wait_for_rest 3
    save
    within 10 holds '"exposure": 1.25' || fail "$layout: Ctrl+Y did not redo"

    set_exposure KP_2 period KP_5 KP_Enter # xdotool sets NumLock for KP_2
    save
    within 10 holds '"exposure": 2.5' || fail "$layout: the number pad did not type 2.5: $(grep exposure "$work/scene.json")"
    set_exposure 3 KP_Home 1 KP_End period 5 Return # without NumLock: 13.5
    save
    within 10 holds '"exposure": 13.5' || fail "$layout: Home and End on the number pad did not move the cursor: $(grep exposure "$work/scene.json")"
    kill "$glint_pid" "$xvfb_pid"
    wait "$glint_pid" 2>/dev/null
    glint_pid=
done
echo "passed"
