#!/usr/bin/env bash
# Under Wayland: the window appears, a click picks a pixel, a key changes the shading, Ctrl+S saves, Ctrl+Q closes it.
# Weston runs in a window on an X display, because GLFW 3.3 needs a mouse: without one (weston --backend=headless) it
# crashes when it creates a cursor. Debian's GLFW is built for either X or Wayland. The Wayland package is unpacked
# rather than installed, because the two packages conflict.
set -u
program=$1
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"
command -v weston >/dev/null || { echo "skipped: weston is not installed"; exit 77; }
(cd "$work" && apt-get download -q libglfw3-wayland && dpkg -x libglfw3-wayland_*.deb glfw) >/dev/null 2>&1 ||
    { echo "skipped: the package libglfw3-wayland cannot be downloaded"; exit 77; }

cp "$(dirname "$0")/../../assets/scenes/default.json" "$work/scene.json"
start_display 1280x800
export XDG_RUNTIME_DIR=$work/run
mkdir -m 700 "$XDG_RUNTIME_DIR"
weston --backend=x11-backend.so --use-pixman --width=1280 --height=800 --socket=glint --idle-time=0 >"$work/weston.log" 2>&1 &
weston_pid=$!
trap 'kill "$weston_pid" 2>/dev/null; finish' EXIT
within 20 test -S "$XDG_RUNTIME_DIR/glint" || fail "weston did not start"
env -u DISPLAY WAYLAND_DISPLAY=glint LD_LIBRARY_PATH="$(dirname "$(find "$work/glfw" -name libglfw.so.3)")" \
    "$program" "$work/scene.json" 2>"$work/glint.err" &
glint_pid=$!
picture_seen() { import -window root "$work/now.png" && [ "$(convert "$work/now.png" -crop 600x500+300+150 -unique-colors -format %w info:)" -gt 500 ]; }
within 20 picture_seen || fail "no picture is visible"
cp "$work/now.png" "$work/before.png"
click_at() { xdotool mousemove "$1" "$2" && sleep 0.5 && xdotool click 1 && sleep 0.5; }
explained() {
    import -window root "$work/now.png"
    [ "$(compare -metric AE "$work/before.png[300x500+970+130]" "$work/now.png[300x500+970+130]" null: 2>&1)" -gt 2000 ]
}
click_at 560 430
within 10 explained || fail "a click does not explain the pixel"
xdotool key 1 # flat shading
sleep 2 # with sanitizers, a frame can take that long
xdotool key ctrl+s
within 10 saved flat || fail "a key did not change the saved scene"
xdotool key ctrl+q
within 10 has_ended || fail "Ctrl+Q did not close the window"
wait "$glint_pid" || fail "the window exited with status $?"
glint_pid=
echo "passed"
