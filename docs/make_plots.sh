#!/usr/bin/env bash
# Measures how the cost of a light drag grows, for docs/performance.md: docs/make_plots.sh [GLINT]
# Writes three plots to docs/pictures/cost-*.svg: time against the number of lights, of covered pixels and of triangles. Every frame recomputes
# all lights. Each point is the median of three runs' medians; the runs alternate, so a busy moment affects all points equally.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/.."
glint=${1:-build/release/app/glint}
[ -x "$glint" ] || { echo "make_plots.sh: $glint: no such program; build it first" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

measured() { # prints "PIXELS TRIANGLES MS"
    "$glint" bench tests/bench/knot.json --drag light --relight --frames 60 --threads 2 "$@" | awk '
        /"median"/ { gsub(/[^0-9.]/, ""); ms = $0 }
        /"shaded_pixels"/ { gsub(/[^0-9]/, ""); pixels = $0 }
        /"triangles"/ { gsub(/[^0-9]/, ""); triangles = $0 }
        END { print pixels, triangles, ms }'
}

some_lights() { # N: prints N point lights on a circle in front of the knot
    awk -v n="$1" 'BEGIN {
        printf "["
        for (i = 0; i < n; ++i)
            printf "%s{\"type\":\"point\",\"position\":[%.3f,%.3f,3],\"diffuse\":[0.1,0.1,0.1],\"specular\":[0.1,0.1,0.1]," \
                "\"falloff\":{\"constant\":1,\"linear\":0,\"quadratic\":0.05}}", i ? "," : "", 3 * cos(i), 3 * sin(i)
        printf "]"
    }'
}

# Prints the median ms over the rounds for each x, in order of x.
points() { sort -g -k1,1 -k2,2 "$1" | awk '
    $1 != x { if (n) print x, ms[int((n + 1) / 2)]; n = 0; x = $1 }
    { ms[++n] = $2 }
    END { print x, ms[int((n + 1) / 2)] }'; }

# plot NAME TITLE SCALE: reads "x ms" lines; SCALE is linear or log (of x). The dashed line is the expected curve: on a
# linear scale, a line through the origin and the last point; on a logarithmic one, a horizontal line at the median.
plot() {
    awk -v title="$2" -v scale="$3" '
        function at(v) { return scale == "log" ? log(v) : v }
        function px(v) { return 46 + 240 * (at(v) - x0) / (x1 - x0) }
        function py(v) { return 158 - 124 * v / top }
        function label(v) { return v >= 1e6 ? sprintf("%.3g M", v / 1e6) : v >= 1e3 ? int(v / 1e3 + 0.5) " k" : v }
        { x[NR] = $1; y[NR] = $2; sorted[NR] = $2; if ($2 > most) most = $2 }
        END {
            n = NR
            x0 = scale == "log" ? at(x[1]) : 0; x1 = at(x[n])
            for (step = 0.1; most / step > 5; step *= step ~ /^20*$|^0.2$/ ? 2.5 : 2) {}
            top = step * (int(most / step) + 1)
            print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"310\" height=\"200\" font-family=\"sans-serif\" font-size=\"11\" fill=\"#333\">"
            print "<rect width=\"310\" height=\"200\" fill=\"white\"/>"
            printf "<text x=\"10\" y=\"18\" font-size=\"12\">%s, ms</text>\n", title
            for (v = 0; v <= top; v += step)
                printf "<path d=\"M46 %.1fH286\" stroke=\"#ddd\"/><text x=\"40\" y=\"%.1f\" text-anchor=\"end\">%g</text>\n", py(v), py(v) + 4, v
            for (i = 1; i <= n; ++i) if (i == n || px(x[n]) - px(x[i]) > 34 && (i == 1 || px(x[i]) - last > 34)) {
                last = px(x[i])
                printf "<text x=\"%.1f\" y=\"176\" text-anchor=\"middle\">%s</text>\n", last, label(x[i])
            }
            if (scale == "log") {
                for (i = 2; i <= n; ++i) for (j = i; j > 1 && sorted[j] < sorted[j - 1]; --j) { t = sorted[j]; sorted[j] = sorted[j - 1]; sorted[j - 1] = t }
                m = py(sorted[int((n + 1) / 2)])
                printf "<path d=\"M46 %.1fH286\" stroke=\"#999\" stroke-dasharray=\"4 3\"/>\n", m
            } else
                printf "<path d=\"M46 158L%.1f %.1f\" stroke=\"#999\" stroke-dasharray=\"4 3\"/>\n", px(x[n]), py(y[n])
            for (i = 1; i <= n; ++i) printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"#2b7bd6\"/>\n", px(x[i]), py(y[i])
            print "</svg>"
        }' >"docs/pictures/cost-$1.svg"
}

for round in 1 2 3; do
    for n in 1 2 4 8 16 32; do
        echo "$n $(measured --size 1920x1080 --set "/lights=$(some_lights $n)" | cut -d' ' -f3)"
    done >>"$work/lights"
    for size in 480x270 960x540 1280x720 1600x900 1920x1080; do
        measured --size $size | cut -d' ' -f1,3
    done >>"$work/pixels"
    for detail in 90 180 360 572 1200 2000; do
        measured --size 1920x1080 --set "/objects/0/mesh/detail=$detail" | cut -d' ' -f2,3
    done >>"$work/triangles"
done
points "$work/lights" | plot lights "Lights, at 1920x1080" linear
points "$work/pixels" | plot pixels "Pixels covered, 8 lights" linear
points "$work/triangles" | plot triangles "Triangles, 1920x1080, 8 lights" log
