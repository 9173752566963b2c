#!/usr/bin/env bash
# The examples' pictures appear one after another until all are complete and no grey placeholder remains.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

start_display 1280x800
start_glint "$(dirname "$0")/../../assets/scenes/default.json"
xdotool key ctrl+shift+o
sleep 0.5
# Counts the grey that remains in the dialog's area; one scene has a plate of about the same grey.
all_drawn() {
    import -window root -crop 940x640+170+75 +repage "$work/examples.png"
    grey=$(convert "$work/examples.png" -fill black +opaque '#777777' -fill white -opaque '#777777' -format '%[fx:int(mean*w*h)]' info:)
    [ "$grey" -lt 500 ]
}
within 30 all_drawn || fail "$grey pixels of the examples are still grey"
echo "passed"
