#!/usr/bin/env bash
# Sends random events to the real window: resolutions from 72 to 300 dpi, sizes from 1x1 to 2000 pixels, keys
# and clicks 20 ms apart, drops from programs that vanish, files that change, two windows that share a state folder.
# Fails if a window dies, prints anything but a warning, or does not respond; prints the seed, the number of the
# life (one run of the program) and the last events.
#
#   tests/gui/monkey.sh EVENTS SEED [FIRST_LIFE]     FIRST_LIFE: number of the first life, to repeat a failure
#
# Uses the sanitizers' build (cmake --preset dev && cmake --build --preset dev), or the one named by
# GLINT_BUILD.
set -u
# Random input in a file dialog must not reach the user's files, so as root the script drops its privileges first.
if [ "$(id -u)" -eq 0 ] && command -v setpriv >/dev/null; then
    exec setpriv --reuid=65534 --regid=65534 --clear-groups env HOME=/nonexistent bash "$0" "$@"
fi
# shellcheck disable=SC2034  # display.sh uses it
events=${1:-2000} seed=${2:-1} life=${3:-0}
build=${GLINT_BUILD:-$(cd "$(dirname "$0")/../.." && pwd)/build/dev}
program=$build/app/glint hand=$build/tests/gui/monkey_hand source=$build/tests/gui/xdnd_source
# shellcheck source=tests/gui/display.sh
. "$(dirname "$0")/display.sh"
[ -x "$program" ] || { echo "$program does not exist: cmake --preset dev && cmake --build --preset dev"; exit 2; }
[ -x "$hand" ] || { echo "skipped: monkey_hand was not built (libxtst-dev)"; exit 77; }

# The program with its own copies of the scenes, which may be overwritten.
mkdir -p "$work/bin" "$work/work" "$work/given"
cp "$program" "$work/bin/glint"
cp -r "$(dirname "$0")/../../assets" "$work/bin/"
cp "$work/bin/assets/scenes/"* "$work/given/"
cp "$work/given/default.json" "$work/work/scene.json"
cp "$work/given/still-life.json" "$work/work/"
printf 'v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n' >"$work/given/triangle.obj"
"$program" render "$work/work/scene.json" -o "$work/given/picture.png" --size 64x48 || fail "no picture to drop"
echo '{"glint": 1, "lights": 5}' >"$work/given/broken.json"
echo '{"glint": 1}' >"$work/given/empty.json"

if grep -q __asan_init "$program"; then
    export ASAN_OPTIONS=detect_leaks=0:handle_abort=1 UBSAN_OPTIONS=print_stacktrace=1
else
    ulimit -v $((8 << 20)) # graphics drivers reserve most of it without using it
fi
ulimit -c 0
start_display 2000x1500
cd "$work" || exit 1
"$hand" "$events" "$seed" "$life" "$work" "$work/bin/glint" "$source"
