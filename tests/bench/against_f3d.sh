#!/usr/bin/env bash
# Times how long Glint and f3d (Debian's package) take to convert a mesh file to a PNG at 1280x720, including startup. The two alternate.
# Usage: against_f3d.sh GLINT [ROUNDS] [MESH...]; without a MESH it writes and uses a knot with a million triangles. For each
# mesh, prints the two median times, how many times faster Glint is, and each program's peak memory.
set -eu

program=$1
rounds=${2:-9}
shift $(($# < 2 ? $# : 2))
for tool in f3d Xvfb /usr/bin/time awk; do
    command -v "$tool" >/dev/null || { echo "needs $tool; on Debian: apt-get install f3d xvfb time" >&2; exit 1; }
done

work=$(mktemp -d)
xvfb_pid=
trap '[ -z "$xvfb_pid" ] || kill "$xvfb_pid"; rm -rf "$work"' EXIT

knot() { # AROUND ALONG: prints the (2, 3) torus knot as an OBJ with 2 * AROUND * ALONG triangles.
    awk -v along="$2" -v around="$1" '
        function centre(t, at) {
            at[0] = (1 + cos(3 * t) / 2) * cos(2 * t); at[1] = (1 + cos(3 * t) / 2) * sin(2 * t); at[2] = sin(3 * t) / 2
        }
        BEGIN {
            pi = atan2(0, -1)
            for (i = 0; i < along; ++i) {
                t = 2 * pi * i / along
                centre(t, c)
                centre(t + 1e-4, d)
                for (k = 0; k < 3; ++k) { u[k] = d[k] - c[k]; v[k] = d[k] + c[k] }
                for (k = 0; k < 3; ++k) b[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]
                for (k = 0; k < 3; ++k) n[k] = b[(k + 1) % 3] * u[(k + 2) % 3] - b[(k + 2) % 3] * u[(k + 1) % 3]
                lb = sqrt(b[0] ^ 2 + b[1] ^ 2 + b[2] ^ 2); ln = sqrt(n[0] ^ 2 + n[1] ^ 2 + n[2] ^ 2)
                for (j = 0; j < around; ++j) {
                    x = 0.28 * cos(2 * pi * j / around) / ln; y = 0.28 * sin(2 * pi * j / around) / lb
                    printf "v %.6f %.6f %.6f\n", c[0] + x * n[0] + y * b[0], c[1] + x * n[1] + y * b[1], c[2] + x * n[2] + y * b[2]
                }
            }
            for (i = 0; i < along; ++i)
                for (j = 0; j < around; ++j) {
                    p = i * around + j + 1; q = (i + 1) % along * around + j + 1
                    r = (i + 1) % along * around + (j + 1) % around + 1; s = i * around + (j + 1) % around + 1
                    printf "f %d %d %d\nf %d %d %d\n", p, q, r, p, r, s
                }
        }'
}

timed() { # NAME COMMAND...: appends "seconds KiB" to $work/NAME.
    local name=$1
    shift
    /usr/bin/time -a -o "$work/$name" -f "%e %M" "$@" >/dev/null 2>&1 || { echo "$* failed" >&2; exit 1; }
}

median() { sort -n "$1" | awk '{ s[NR] = $1; if ($2 > m) m = $2 } END { printf "%.3f %.0f", s[int((NR + 1) / 2)], m / 1024 }'; }

meshes=("$@")
if [ ${#meshes[@]} -eq 0 ]; then
    knot 250 2000 >"$work/knot.obj"
    meshes=("$work/knot.obj")
fi
mkfifo "$work/display"
Xvfb -displayfd 3 -screen 0 1280x720x24 -nolisten tcp -noreset 3>"$work/display" 2>/dev/null &
xvfb_pid=$!
read -r number <"$work/display"
export DISPLAY=:$number

echo "| mesh | Glint s | f3d s | times faster | Glint MB | f3d MB |"
echo "|---|---|---|---|---|---|"
for mesh in "${meshes[@]}"; do
    rm -f "$work/ours" "$work/theirs"
    for ((i = 0; i < rounds; ++i)); do
        timed ours "$program" render "$mesh" -o "$work/ours.png" --size 1280x720
        timed theirs f3d "$mesh" --output="$work/theirs.png" --resolution=1280,720
    done
    read -r ours our_mb <<<"$(median "$work/ours")"
    read -r theirs their_mb <<<"$(median "$work/theirs")"
    echo "| $(basename "$mesh") | $ours | $theirs | $(awk -v a="$theirs" -v b="$ours" 'BEGIN { printf "%.1f", a / b }') | $our_mb | $their_mb |"
done
