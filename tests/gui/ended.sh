#!/usr/bin/env bash
# A window that receives a signal keeps the latest edits and ends with that signal. If its work is saved, it leaves
# no copy.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"

state=$XDG_STATE_HOME/glint
start_display 1280x800
# end_by SIGNAL: sends the signal, and checks that the window ends and that its status names the signal.
end_by() {
    local signal=$1 status=0
    kill -"$signal" "$glint_pid"
    within 20 has_ended || fail "$signal did not end the window"
    wait "$glint_pid" || status=$?
    [ "$status" -eq $((128 + $(kill -l "$signal"))) ] || fail "exit status $status after $signal"
    glint_pid=
}

for signal in TERM HUP; do
    rm -rf "$state"
    echo '{"glint": 1, "objects": [{"name": "Ball"}]}' >"$work/scene.json"
    start_glint "$work/scene.json"
    xdotool key 1 # flat shading: a change
    within 15 copied flat || fail "no copy of the unsaved work"
    xdotool key 2 # facet: the next copy would come 5 seconds later
    sleep 1
    end_by "$signal"
    copied facet || fail "after $signal the copy differs from the screen"
    grep -q facet "$work/scene.json" && fail "$signal wrote the file without being asked"
    [ -s "$state/window.json" ] || fail "after $signal the window's settings are not saved"

    start_glint "$work/scene.json"
    recover_and_save facet
    sleep 1
    end_by "$signal"
    ls "$state"/*.autosave >/dev/null 2>&1 && fail "a copy of saved work was left behind"
done
echo "passed"
