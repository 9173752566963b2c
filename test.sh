#!/usr/bin/env bash
# Builds Glint and runs every test; ./test.sh NAME runs those whose names contain NAME (ignoring case). Slow tests that rarely
# fail are run by tests/nightly.sh. Installs missing packages first. GLINT_PRESET selects a preset of CMakePresets.json instead of `release`.
set -eu
. "$(dirname "${BASH_SOURCE[0]}")/cmake/prepare.sh"

if [ $# -gt 1 ]; then
    echo "glint: error: test.sh: $# names; expected one name, or none to run all tests" >&2
    exit 2
fi
preset=${GLINT_PRESET:-release}
filter=()
if [ -n "${1:-}" ]; then
    # CTest expects a regular expression; this one matches NAME literally, ignoring case.
    filter=(-R "$(printf %s "$1" | sed -e 's/[][\\.^$*+?(){}|]/\\&/g' -e 's/[a-zA-Z]/[\L&\U&]/g')")
fi

install_packages "$glint_root/cmake/packages.txt" "$glint_root/cmake/packages-test.txt"
build "$preset" ON
cd "$glint_root/build/$preset"
# One more job than there are processors, because the window's tests sleep.
exec ctest -LE nightly --output-on-failure --no-tests=error --timeout 300 -j"$(($(nproc) + 1))" ${filter[@]+"${filter[@]}"}
