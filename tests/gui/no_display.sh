#!/usr/bin/env bash
# Without a display the window reports it in one line, names the headless command, and exits with 1.
set -u
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
env -u DISPLAY -u WAYLAND_DISPLAY "$program" >"$work/out" 2>"$work/err"
status=$?
fail() { echo "failed: $1"; cat "$work/err"; exit 1; }
[ "$status" -eq 1 ] || fail "exit status $status, not 1"
[ "$(wc -l <"$work/err")" -eq 1 ] || fail "more or less than one line on standard error"
grep -q '^glint: error: no window can be opened: .*DISPLAY.*"glint render FILE -o OUT.png"' "$work/err" || fail "other words"
grep -q '; expected ' "$work/err" || fail "the message has no expected value"
[ ! -s "$work/out" ] || fail "something on standard output"
echo "passed"
