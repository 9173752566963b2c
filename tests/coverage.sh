#!/usr/bin/env bash
# Measures which lines and branches the tests run, and writes the table in docs/testing.md. Takes half an hour on 2 cores.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. cmake/prepare.sh
install_packages cmake/packages.txt cmake/packages-test.txt cmake/packages-ci.txt
tree=build/coverage
flags="-O1 -fprofile-instr-generate -fcoverage-mapping"
cmake --preset release -B "$tree" -DGLINT_TESTS=ON -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG="$flags" >/dev/null
ninja -C "$tree" >"$tree/log" || { tail -20 "$tree/log" && exit 1; }
rm -rf "$tree/profiles"
export LLVM_PROFILE_FILE=$PWD/$tree/profiles/%4m.profraw
(cd "$tree" && ctest -LE nightly --output-on-failure -j"$(nproc)") >"$tree/tests.log" || tail -3 "$tree/tests.log"
llvm-profdata merge -o "$tree/all.profdata" "$tree"/profiles/*.profraw
objects=("$tree/app/glint")
for program in "$tree"/tests/*_tests; do objects+=(-object "$program"); done
llvm-cov export -summary-only -instr-profile "$tree/all.profdata" "${objects[@]}" 2>/dev/null | python3 tests/coverage.py docs/testing.md
