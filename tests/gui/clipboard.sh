#!/usr/bin/env bash
# Text is pasted from other programs: whole, in pieces; and one that never answers, or stops half-way, does not hold the
# window up.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
owner=$2
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"
[ -x "$owner" ] || { echo "skipped: the clipboard's owner was not built (libx11-dev)"; exit 77; }

cat >"$work/scene.json" <<'JSON'
{"glint": 1, "camera": {"eye": [0, 0, 4]}, "global_ambient": [1, 1, 1],
 "objects": [{"name": "Ball", "material": {"ambient": [0, 0.2, 0], "diffuse": [0, 0, 0], "specular": [0, 0, 0]}}]}
JSON
start_display 1280x800
start_glint "$work/scene.json"
lit() { middle_is 003300; }
dark() { middle_is 000000; }

copied() { # WAY TEXT: another program holds the clipboard
    [ -z "${owner_pid:-}" ] || kill "$owner_pid" 2>/dev/null
    "$owner" "$1" "$2" >"$work/owner" &
    owner_pid=$!
    within 5 grep -q ready "$work/owner" || fail "the clipboard was not taken"
}
# The list of commands, the pasted text in its field, Enter: what was pasted is run.
paste_a_command() {
    xdotool key ctrl+k
    sleep 0.5
    xdotool key ctrl+v
    sleep 0.5
    xdotool key Return
}

xdotool key F10 # the picture alone
within 10 lit || fail "the scene is not to be seen"
copied whole "Ambient on or off"
paste_a_command
within 10 dark || fail "a text was not pasted"
copied pieces "Ambient on or off"
paste_a_command
within 10 lit || fail "a text in pieces was not pasted"
for way in silent half; do
    copied "$way" "Ambient on or off"
    xdotool key ctrl+k
    sleep 0.5
    xdotool key ctrl+v
    sleep 0.5
    kill "$owner_pid" # while it is asked
    xdotool key Escape
    sleep 3 # the longest that the window waits
    xdotool key a
    within 10 dark || fail "the window hangs with a clipboard that is $way"
    xdotool key a
    within 10 lit || fail "the ambient term did not come back"
done
kill "$owner_pid" 2>/dev/null
echo "passed"
