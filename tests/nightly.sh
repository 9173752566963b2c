#!/usr/bin/env bash
# Runs the tests that are slow and rarely fail; .ci/run runs the others. Installs missing packages first. As
# root, the script also installs and removes Glint's own package. Prints the duration of each part, and finally the
# parts that failed. tests/nightly.sh WORD... runs only the parts whose names contain one of the words.
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
. cmake/prepare.sh

words=("$@")
failed=
part() { # NAME COMMAND...
    local name=$1 began=$SECONDS word wanted=$((${#words[@]} == 0))
    shift
    for word in ${words[@]+"${words[@]}"}; do [[ $name != *"$word"* ]] || wanted=1; done
    [ "$wanted" = 1 ] || return 0
    ("$@") || failed="$failed${failed:+, }$name"
    echo "nightly: $name took $((SECONDS - began)) s"
}
tests() { # PRESET ARGUMENTS..., which are passed to ctest
    cd "build/$1" && ctest --output-on-failure --no-tests=error --timeout 3600 -j"$(nproc)" "${@:2}"
}
every_fault() {
    export GLINT_FAULTS=all GLINT_KILLS=500
    local status=0
    build/ci/tests/faults/command_faults_tests || status=1
    build/ci/tests/faults/window_faults_tests || status=1
    return $status
}
exported_files() {
    command -v npm >/dev/null || { echo "nightly: skipped exported glTF files: npm is not installed" && return; }
    tests/gltf_validator.sh build/ci/app/glint
}
speed() {
    local last
    last=$(git describe --tags --match 'v*' --abbrev=0 2>/dev/null || git rev-list -1 --before='1 week ago' HEAD)
    [ -n "$last" ] || { echo "nightly: skipped speed: no tag, and no commit older than a week" && return; }
    tests/bench/against.sh "$last"
}
packages() {
    [ "$(id -u)" -eq 0 ] || { echo "nightly: skipped the installed package: not root" && return; }
    ./package.sh && tests/package/installed.sh
}

install_packages cmake/packages.txt cmake/packages-test.txt cmake/packages-ci.txt cmake/packages-nightly.txt
part "the Release build" build ci ON all nightly
part "long tests" tests ci -L nightly
part "every fault, 500 kills" every_fault
part "exported glTF files" exported_files
part "files from Blender" tests/blender.sh build/ci/app/glint
part "speed compared with the last tag" speed
part "generated faults" tests/mutate.py -n 100 --seed "$(date +%j)"
part "clang-tidy" tests/tidy.sh
part "the build with sanitizers" build dev ON
export ASAN_OPTIONS=malloc_context_size=8:handle_sigill=2
part "tests with sanitizers" tests dev
part "fuzzing" tests/fuzz/run.sh 120
part "ThreadSanitizer" tests/threads.sh
part "the installed package" packages
[ -z "$failed" ] || { echo "nightly: failed: $failed" && exit 1; }
echo "nightly: passed in $SECONDS s"
