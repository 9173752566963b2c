#!/usr/bin/env bash
# Files are dropped on the window the way a file manager does it: a scene, a mesh, a picture with its scene. An
# unreadable file leaves the scene unchanged. A saved scene is reopened, and a slow load is cancelled.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
source=$2
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"
[ -x "$source" ] || { echo "skipped: the program that drops files was not built (libx11-dev)"; exit 77; }

scene() { # NAME COLOUR: a ball of this colour, unlit
    cat >"$work/$1.json" <<JSON
{"glint": 1, "camera": {"eye": [0, 0, 4]}, "global_ambient": [1, 1, 1],
 "objects": [{"name": "Ball", "material": {"ambient": $2, "diffuse": [0, 0, 0], "specular": [0, 0, 0]}}]}
JSON
}
scene first '[0, 0.2, 0]'
scene second '[1, 0, 1]'
printf 'v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n' >"$work/triangle.obj"
"$program" render "$work/second.json" -o "$work/picture.png" --size 64x48 || fail "no picture to drop"
echo '{"glint": 1, "lights": 5}' >"$work/broken.json"

start_display 1280x800
start_glint "$work/first.json"
xdotool key F10 # the picture alone
within 10 middle_is 003300 || fail "the first scene is not visible"
drop second.json
within 10 middle_is FF00FF || fail "the dropped scene is not visible"
title_is second.json || fail "the title is not the dropped scene's"
drop broken.json
sleep 1
title_is second.json || fail "a file that cannot be opened changed the title"
drop first.json
within 10 middle_is 003300 || fail "the first scene did not reappear"
drop picture.png
within 10 middle_is FF00FF || fail "the picture's scene is not visible"
drop triangle.obj
within 10 title_is triangle.obj || fail "the mesh was not opened"

# The program that dragged may have ended before the window answers.
"$source" --vanish || fail "nothing was dragged"
sleep 1
kill -0 "$glint_pid" 2>/dev/null || fail "the window ended when the program that dragged something over it ended"

# A scene that is edited with a key, saved and reopened.
drop second.json
within 10 middle_is FF00FF || fail "the scene did not reappear"
xdotool key shift+a # ambient off: black
within 10 middle_is 000000 || fail "the ambient term is still visible"
xdotool key ctrl+s
saved() { grep -q '"ambient": false' "$work/second.json"; }
within 10 saved || fail "the scene was not saved"
drop first.json
within 10 middle_is 003300 || fail "the first scene did not reappear"
drop second.json
within 10 middle_is 000000 || fail "the reopened scene is not the saved one"

# While a lesson that takes many seconds loads, the window shows the default scene, and loading can be
# cancelled.
xdotool key ctrl+q
within 10 bash -c "! kill -0 $glint_pid 2>/dev/null" || fail "the window did not close"
{
    printf '# Slow\n```lesson\ntopic: x\nscene: first.json\nsize: 16x16\n```\n```predict number\nquestion: how many?\n'
    for i in {0..31}; do
        echo "r$i = explain --pixel 5,5 --set /objects/0/mesh={\"primitive\":\"sphere\",\"detail\":$((700 + i))}"
    done
    printf 'answer: 1\ntolerance: 0\n```\n'
} >"$work/slow.md"
start_glint "$work/slow.md"
within 10 title_is "New scene" || fail "the default scene is not shown while the lesson is opening"
xdotool key Escape
wait_for_rest
title_is "New scene" || fail "the lesson was opened although it was cancelled"
echo "passed"
