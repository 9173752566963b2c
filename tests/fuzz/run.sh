#!/usr/bin/env bash
# tests/fuzz/run.sh SECONDS [TARGET]: builds the fuzzers and runs each of them, or only TARGET, for SECONDS. Each starts from
# its corpus and the inputs found by earlier runs (build/dev/found). With 0 seconds, only these inputs are run.
# Failing inputs are stored in build/dev/failed/TARGET-*; pass one to build/dev/tests/fuzz/fuzz_TARGET to reproduce it. Exits with status 1,
# after all have run, if a fuzzer failed.
#
#   GLINT_FUZZ_SEED=N           tries the same inputs in the same order every time, within the time limit
#   tests/fuzz/run.sh merge     stores a selection of all runs' inputs that reaches the same code in
#                               tests/fuzz/corpus
set -eu
. "$(dirname "${BASH_SOURCE[0]}")/../../cmake/prepare.sh"

here=$glint_root/tests/fuzz
tree=$glint_root/build/dev

if [ $# -lt 1 ] || [ $# -gt 2 ] || [[ ! $1 =~ ^([0-9]+|merge)$ ]]; then
    echo "glint: error: tests/fuzz/run.sh: expected SECONDS [TARGET], or merge" >&2
    exit 2
fi
names=$(ls "$here/corpus")
if [ $# -eq 2 ]; then
    grep -qx -- "$2" <<<"$names" ||
        fail "tests/fuzz/run.sh: no target $2; expected one of ${names//$'\n'/, }"
    names=$2
fi

# Prints the maximum input length for a target. Longer inputs reach no additional code and are slower.
longest_of() {
    case $1 in
    scene_picture) echo 700 ;;
    gltf | lesson | png_scene | scene_json | state) echo 4096 ;;
    *) echo 2048 ;;
    esac
}

# fuzz TARGET ARGUMENT...: limits each input's memory and time; exceeding either counts as a failure.
fuzz() {
    local target=$1 once=512
    shift
    # For some damaged headers, OpenEXR reserves up to 2 GiB of memory that it does not touch.
    [ "$target" != picture_exr ] || once=2100
    # Weighting inputs by the rarity of their coverage (entropic) took 25 to 50 % of the time.
    ASAN_OPTIONS=malloc_context_size=8:quarantine_size_mb=8 \
        "$tree/tests/fuzz/fuzz_$target" -entropic=0 -max_len="$(longest_of "$target")" -malloc_limit_mb=$once -rss_limit_mb=2560 \
        -timeout=20 -seed="${GLINT_FUZZ_SEED:-0}" -artifact_prefix="$tree/failed/$target-" "$@"
}

run() {
    local log=$tree/failed/$1.log limit=-max_total_time=$seconds
    [ "$seconds" != 0 ] || limit=-runs=0
    if fuzz "$1" "$limit" -print_final_stats=1 "$tree/found/$1" "$here/corpus/$1" >"$log" 2>&1; then
        sed -n "s/^stat::number_of_executed_units: */fuzz: $1, runs: /p" "$log"
    else
        cat "$log"
        echo "fuzz: $1 failed; see above"
        return 1
    fi
}

merge() {
    local kept=$tree/kept/$1
    rm -rf "$kept"
    mkdir -p "$kept"
    fuzz "$1" -merge=1 "$kept" "$here/corpus/$1" "$tree/found/$1" >"$tree/failed/$1.log" 2>&1
    # Keeps as many inputs as the repository has room for, both small and large ones.
    find "$here/corpus/$1" -type f -delete
    find "$kept" -type f -printf '%s %p\n' | sort -n |
        awk '{ line[NR] = $0 } END { for (i = NR; i > 0; i -= int((NR + 39) / 40)) print line[i] }' |
        while read -r size file; do
            room=$((${room:-18000} - size))
            [ "$room" -lt 0 ] || cp "$file" "$here/corpus/$1/"
            [ "$room" -ge 0 ] || room=$((room + size))
        done
}

install_packages "$glint_root/cmake/packages.txt" "$glint_root/cmake/packages-test.txt" "$glint_root/cmake/packages-ci.txt"
# shellcheck disable=SC2086,SC2046  # one argument per target
build dev ON $(printf 'fuzz_%s ' $names)

# Runs one fuzzer per processor at a time.
seconds=$1
failed=0
running=()
for target in $names; do
    mkdir -p "$tree/found/$target" "$tree/failed"
    if [ ${#running[@]} -ge "$(nproc)" ]; then
        wait "${running[0]}" || failed=1
        running=("${running[@]:1}")
    fi
    if [ "$1" = merge ]; then merge "$target" & else run "$target" & fi
    running+=($!)
done
for job in "${running[@]}"; do wait "$job" || failed=1; done
exit $failed
