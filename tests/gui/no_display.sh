#!/usr/bin/env bash
# Without a display, the program prints one line that reports this and names a command to use instead, and exits with 1.
set -u
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
env -u DISPLAY -u WAYLAND_DISPLAY "$program" >"$work/out" 2>"$work/err"
status=$?
fail() { echo "failed: $1"; cat "$work/err"; exit 1; }
[ "$status" -eq 1 ] || fail "exit status $status, not 1"
[ "$(wc -l <"$work/err")" -eq 1 ] || fail "not exactly one line on standard error"
grep -q '^glint: error: no window can be opened: .*DISPLAY.*"glint render FILE -o OUT.png"' "$work/err" || fail "unexpected message"
grep -q '; expected ' "$work/err" || fail "the message does not say what is expected"
[ ! -s "$work/out" ] || fail "unexpected text on standard output"
echo "passed"
