#!/usr/bin/env bash
# Compares the speed of this checkout with that of another revision, running the two alternately: tests/bench/against.sh REV [ROUNDS]
# Builds REV in build/against. Each round draws every row with each program in turn; a row's figure is the median
# of the rounds' fastest frames, because medians of frames vary by a factor of 2 on a shared machine. Rows that REV cannot draw are left
# out. Exits with 1 if a row is slower by more than 10 % and 0.1 ms. Nothing else should run at the same time.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
rev=${1:?expected a revision, such as a tag} rounds=${2:-7}
. cmake/prepare.sh
there=build/against
[ -d "$there" ] || git worktree add --detach "$PWD/$there" "$rev" >&2
git -C "$there" checkout --quiet --detach "$rev"
(cd "$there" && cmake --preset ci >/dev/null && ninja -C build/ci glint >/dev/null)
cmake --preset ci >/dev/null && ninja -C build/ci glint >/dev/null

rows=( # a name, then the options of glint bench
    "light, Phong, all lights recomputed:--drag light --relight"
    "light, Phong, sum of the others kept:--drag light"
    "light, Gouraud:--drag light --set /shading/mode=gouraud"
    "light, flat:--drag light --set /shading/mode=flat"
    "material, Phong:--drag material"
    "object, Phong:--drag object"
    "camera, Phong:--drag camera"
    "camera, Phong, 1 million triangles:--drag camera --set /objects/0/mesh/detail=2000"
    "light, shadows:--drag light --set /transport/model=shadows")
fastest_ms() { # PROGRAM OPTIONS...
    "$1" bench tests/bench/knot.json --size 1920x1080 --frames 40 "${@:2}" |
        python3 -c 'import json, sys; print(json.load(sys.stdin)["ms"]["min"])'
}
middle() { sort -g | awk '{ value[NR] = $1 } END { print value[int((NR + 1) / 2)] }'; }
for i in "${!rows[@]}"; do
    read -ra options <<<"${rows[i]#*:}"
    "$there/build/ci/app/glint" bench tests/bench/knot.json --size 64x36 --frames 1 "${options[@]}" >/dev/null 2>&1 ||
        { echo "left out, because $rev cannot draw it: ${rows[i]%%:*}" >&2 && unset "rows[i]"; }
done
figures=$(mktemp -d)
trap 'rm -rf "$figures"' EXIT
for ((round = 1; round <= rounds; round++)); do
    for i in "${!rows[@]}"; do
        read -ra options <<<"${rows[i]#*:}"
        fastest_ms "$there/build/ci/app/glint" "${options[@]}" >>"$figures/before.$i"
        fastest_ms build/ci/app/glint "${options[@]}" >>"$figures/now.$i"
    done
    echo "round $round of $rounds" >&2
done
printf '%-40s %10s %10s\n' "ms per frame" "$rev" now
slower=0
for i in "${!rows[@]}"; do
    before=$(middle <"$figures/before.$i") now=$(middle <"$figures/now.$i")
    verdict=$(awk -v a="$before" -v b="$now" 'BEGIN { if (b > 1.1 * a && b > a + 0.1) print "slower" }')
    printf '%-40s %10.2f %10.2f %s\n' "${rows[i]%%:*}" "$before" "$now" "$verdict"
    [ -z "$verdict" ] || slower=1
done
exit $slower
