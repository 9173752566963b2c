#!/usr/bin/env bash
# Tests in the real window what the README promises, in short: a click explains a pixel; a wrong picture that is
# dropped and then corrected is judged twice; a shader that is filled in with an editor is drawn when it is saved; a lecture
# goes from scene to scene; a lesson opens and closes.
set -u
# shellcheck disable=SC2034  # display.sh uses it
program=$1
source=$2
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"
[ -x "$source" ] || { echo "skipped: the program that drops files was not built (libx11-dev)"; exit 77; }
scenes=$(dirname "$0")/../../assets/scenes

shot() { import -window root "$work/$1.png"; }
# A WxH+X+Y PIXELS: more than PIXELS pixels in the area differ from screenshot A.
differs() {
    shot now
    [ "$(compare -metric AE "$work/$1.png[$2]" "$work/now.png[$2]" null: 2>&1)" -gt "$3" ]
}
quits() {
    kill -9 "$glint_pid" && wait "$glint_pid" 2>/dev/null
    within 10 has_ended
    rm -rf "$XDG_STATE_HOME"
}
left=270x650+5+50 picture=600x500+300+150 right=340x600+930+100

cp "$scenes/glossy-ball.json" "$work/scene.json"
start_display 1280x800
start_glint "$work/scene.json"
wait_for_rest
shot start
xdotool mousemove 600 420
sleep 0.3
xdotool click 1
within 10 differs start $right 2000 || fail "a click on the ball explains nothing"
quits

"$program" render "$work/scene.json" --size 640x400 -o "$work/right.png" &&
    "$program" render "$work/scene.json" --size 640x400 -o "$work/wrong.png" --set /shading/mistakes/normals_flipped=true ||
    fail "no pictures"
convert "$work/wrong.png" -strip "$work/mine.png" # as another program writes it, without the scene
start_glint "$work/scene.json"
wait_for_rest
shot start
drop mine.png
within 20 differs start $right 2000 || fail "the wrong picture is not judged"
sleep 2 # a watched file keeps a thread busy
shot wrong
convert "$work/right.png" -strip "$work/mine.png"
within 20 differs wrong $right 1000 || fail "the corrected picture is not judged again"
quits

"$program" code "$work/scene.json" --language glsl --blank -o "$work/blank" >/dev/null &&
    "$program" code "$work/scene.json" --language glsl -o "$work/whole" >/dev/null || fail "no shaders"
cp "$work/blank/lighting.glsl" "$work/lighting.glsl"
start_glint "$work/scene.json"
wait_for_rest
shot start
drop lighting.glsl
within 20 differs start $picture 20000 || fail "the blank shader does not darken the ball"
sleep 2
shot blank
cp "$work/whole/lighting.glsl" "$work/lighting.glsl"
within 20 differs blank $picture 20000 || fail "the shader that was filled in is not drawn"
quits

start_glint "$work/scene.json" "$scenes/bulb.json" "$scenes/spot-cone.json"
wait_for_rest
for name in bulb spot-cone; do
    xdotool key Next
    within 10 title_is "$name" || fail "page down does not show $name"
done
xdotool key Prior
within 10 title_is bulb || fail "page up does not go back"
quits

start_glint --lesson lambert
wait_for_rest
shot lesson
xdotool key ctrl+k type --delay 30 "close lesson"
xdotool key Return
within 10 differs lesson $left 5000 || fail "the lesson cannot be closed"
quits
echo "passed"
