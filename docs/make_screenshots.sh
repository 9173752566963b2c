#!/usr/bin/env bash
# Takes screenshots of the window in ten states, docs/pictures/window-*.png, on a display in memory (Xvfb) with a real mouse
# (xdotool). Usage: docs/make_screenshots.sh [PROGRAM] [NAME...]; without names, takes all of them.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
program=${1:-$root/build/release/app/glint}
[ $# -eq 0 ] || shift
out=$root/docs/pictures
for tool in Xvfb xdotool import; do
    command -v "$tool" >/dev/null || { echo "make_screenshots: $tool is not installed" >&2; exit 1; }
done
[ -x "$program" ] || { echo "make_screenshots: $program does not exist; build it first" >&2; exit 1; }

work=$(mktemp -d)
glint_pid='' xvfb_pid=''
stop() {
    [ -z "$glint_pid" ] || kill "$glint_pid" 2>/dev/null || true
    [ -z "$xvfb_pid" ] || kill "$xvfb_pid" 2>/dev/null || true
    wait "$glint_pid" "$xvfb_pid" 2>/dev/null || true
    glint_pid='' xvfb_pid=''
}
trap 'stop; rm -rf "$work"' EXIT

at() { xdotool mousemove "$1" "$2"; sleep 0.2; }
click() { at "$1" "$2"; xdotool click 1; sleep 0.4; }
press() { xdotool key "$@"; sleep 0.6; }
drag() { # FROM_X FROM_Y TO_X TO_Y: drags, and does not release the button
    at "$1" "$2"
    xdotool mousedown 1
    for i in 1 2 3 4 5 6 7 8; do
        xdotool mousemove $(($1 + ($3 - $1) * i / 8)) $(($2 + ($4 - $2) * i / 8))
        sleep 0.05
    done
    sleep 0.4
}

shot() { # NAME WxH SCENE: opens the scene, runs the commands on standard input and takes a screenshot
    local name=$1 size=$2 scene=$3 number
    local steps
    steps=$(cat)
    [ -z "$wanted" ] || [[ " $wanted " == *" $name "* ]] || return 0
    export XDG_STATE_HOME=$work/state-$name # fresh state, as on first launch
    mkfifo "$work/display-$name"
    Xvfb -displayfd 3 -screen 0 "${size}x24" -nolisten tcp -noreset 3>"$work/display-$name" 2>/dev/null &
    xvfb_pid=$!
    read -r -t 20 number <"$work/display-$name"
    export DISPLAY=:$number
    unset WAYLAND_DISPLAY
    "$program" ${scene:+"$root/assets/scenes/$scene.json"} &
    glint_pid=$!
    for ((i = 0; i < 100; i++)); do
        xdotool search --onlyvisible --name Glint >/dev/null 2>&1 && break
        sleep 0.1
    done
    window=$(xdotool search --onlyvisible --name Glint | tail -1)
    xdotool windowmove "$window" 0 0 windowsize "$window" "${size%x*}" "${size#*x}" windowfocus "$window"
    sleep 1.5
    eval "$steps"
    sleep 0.8
    import -window root -strip -define png:compression-level=9 "$out/window-$name.png"
    stop
    echo "window-$name.png"
}

wanted=$*
shot start 1280x800 '' <<<':'
shot why 1280x800 '' <<<'click 560 480; at 1270 790'
shot light 1280x800 '' <<<'drag 436 241 380 330'
shot mach-bands 1280x800 mach-bands <<<'press p; at 1270 790'
shot compare 1280x800 coarse-ball <<<'press c; at 1270 790'
shot palette 1280x800 '' <<<'press ctrl+k; xdotool type sha'
shot lecture 1024x768 still-life <<<'press F9; press w; drag 440 300 640 460; xdotool mouseup 1'
shot narrow 1024x640 shininess-grid <<<'press F1; press Escape; at 600 300'
shot light-theme 1920x1080 classic-materials <<<'press ctrl+k; xdotool type "light theme"; sleep 0.3; press Return; at 1750 900'
shot clean 1280x800 spot-cone <<<'press F10; at 1270 790'
