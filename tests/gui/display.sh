# shellcheck shell=bash disable=SC2154
# Starts a display and a window on it, and has helpers for the mouse. Sourced by the scripts in this folder; needs $program.

for tool in Xvfb xdotool import compare convert; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

work=$(mktemp -d)
export XDG_STATE_HOME=$work/state # keeps the window's settings within the test
glint_pid=
finish() {
    [ -z "$glint_pid" ] || kill "$glint_pid" 2>/dev/null
    [ -z "${xvfb_pid:-}" ] || kill "$xvfb_pid" 2>/dev/null
    rm -rf "$work"
}
trap finish EXIT

fail() {
    echo "failed: $1"
    [ ! -s "$work/glint.err" ] || cat "$work/glint.err"
    exit 1
}

# within SECONDS COMMAND...: waits until the command succeeds.
within() {
    local tries=$(($1 * 10))
    shift
    for ((i = 0; i < tries; i++)); do
        "$@" && return 0
        sleep 0.1
    done
    return 1
}

display_answers() { xdotool getdisplaygeometry >/dev/null 2>&1; }

# WxH OPTIONS...: starts Xvfb. Two servers that start at the same time may choose the same number; in that case this
# function tries again. Without -noreset, a server resets when its last client leaves, such as the one that checks
# whether the server answers, and rejects new clients during the reset.
start_display() {
    unset WAYLAND_DISPLAY
    local number try
    for try in 1 2 3; do
        rm -f "$work/display"
        mkfifo "$work/display"
        Xvfb -displayfd 3 -screen 0 "$1x24" -nolisten tcp -noreset "${@:2}" 3>"$work/display" 2>/dev/null &
        xvfb_pid=$!
        number=
        read -r -t 20 number <"$work/display"
        export DISPLAY=:$number
        [ -n "$number" ] && within 5 display_answers && return
        kill "$xvfb_pid" 2>/dev/null
    done
    fail "no display could be started in $try tries"
}

# DPI: sets the display's resolution, from which the window takes its scale: 96 dots per inch is a scale of 1.
set_resolution() {
    command -v xprop >/dev/null || { echo "skipped: xprop is not installed"; exit 77; }
    xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER "Xft.dpi:	$1"
}

find_window() {
    window=$(xdotool search --onlyvisible --name Glint 2>/dev/null | tail -1)
    [ -n "$window" ]
}

window_or_end() { find_window || ! kill -0 "$glint_pid" 2>/dev/null; }

start_glint() { # ARGUMENTS of the program
    "$program" "$@" 2>"$work/glint.err" &
    glint_pid=$!
    within 30 window_or_end && find_window || fail "no window appeared"
    xdotool windowfocus "$window"
    sleep 0.5
}

title_is() { xdotool getwindowname "$window" | grep -q "$1"; }
# NAME: drops that file in $work on the picture, using the program $source.
drop() {
    xdotool mousemove 640 420
    sleep 0.2
    "$source" "$work/$1" || fail "$1 was not accepted"
}

has_ended() { ! kill -0 "$glint_pid" 2>/dev/null; }
# MODE: check that the copy of unsaved work, or the scene's file, has that shading mode.
copied() { grep -q "\"mode\": \"$1\"" "$XDG_STATE_HOME"/glint/*.autosave 2>/dev/null; }
saved() { grep -q "\"mode\": \"$1\"" "$work/scene.json"; }

# MODE: clicks "Recover" in a 1280x800 window, and saves the recovered scene.
recover_and_save() {
    sleep 0.5
    xdotool mousemove 430 136 click 1
    sleep 0.5
    xdotool key ctrl+s
    within 10 saved "$1" || fail "the recovered scene is not the saved one"
}

# Sets `used` to the processor time of all the window's threads, in nanoseconds, and `running` to the number
# of runnable ones. Starts no process, because it is called many times a second.
look_at_threads() {
    local task time state rest
    used=0 running=0
    for task in /proc/"$glint_pid"/task/*; do
        { read -r time rest <"$task/schedstat" && used=$((used + time)); } 2>/dev/null
        { read -r state <"$task/stat" && rest=${state##*) } && [ "${rest%% *}" = R ] && running=$((running + 1)); } 2>/dev/null
    done
}

# Waits until the window has processed its input and drawn the effects (tooltips, full pictures): until it has used
# no processor time for TENTHS tenths of a second, by default 10. A sleep of fixed length could be too short on
# a busy machine.
wait_for_rest() { # [TENTHS]
    local before used running still=0
    for ((i = 0; i < 300; i++)); do
        look_at_threads
        before=$used
        sleep 0.1
        look_at_threads
        if [ "$before" = "$used" ] && [ "$running" = 0 ]; then still=$((still + 1)); else still=0; fi
        [ "$still" -lt "${1:-10}" ] || return 0
    done
    fail "the window did not become idle in half a minute"
}

# X Y RIGHT DOWN: presses at (X, Y) on the display and moves right and down by that many pixels, in ten steps.
drag_with_mouse() {
    xdotool mousemove "$1" "$2"
    sleep 0.3
    xdotool mousedown 1
    local step
    for step in 1 2 3 4 5 6 7 8 9 10; do
        xdotool mousemove $(($1 + $3 * step / 10)) $(($2 + $4 * step / 10))
        sleep 0.03
    done
    xdotool mouseup 1
}

# Moves the cursor out of the picture and saves the rows between the bars and the hints to $work/$1.png.
look() {
    xdotool mousemove 2 2
    sleep 0.3
    import -window root -crop 1280x600+0+50 +repage "$work/$1.png"
}

# Prints the centre of the pixels with exactly the colour $2 in $work/$1.png, in the display's coordinates.
middle_of() {
    local box w h x y
    box=$(convert "$work/$1.png" -fill black +opaque "$2" -format '%@' info: | tr 'x+' '  ')
    read -r w h x y <<<"$box"
    [ -n "$y" ] && [ "$w" -lt 100 ] && echo $((x + w / 2)) $((y + h / 2 + 50))
}

middle_is() { # COLOUR: the pixel in the middle of a 1280x800 display has this colour
    import -window root -crop 1x1+640+420 +repage "$work/middle.png"
    [ "$(convert "$work/middle.png" -format '%[hex:u.p{0,0}]' info: | cut -c1-6)" = "$1" ]
}

# Prints the number of pixels that differ between two screenshots.
difference() { compare -metric AE "$work/$1.png" "$work/$2.png" null: 2>&1 | sed 's/[^0-9.e+].*//'; }
