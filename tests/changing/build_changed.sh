#!/usr/bin/env bash
# build_changed.sh SOURCE BUILD CMAKE: copies models and renderer, applies the patches, builds what came out without
# optimising, for one instruction set, and runs its test. What did not change since the last time is not built again.
set -eu
source=$1 tree=$2/tree cmake=$3
# clang compiles without optimising in half of GCC's time.
compiler=$(command -v clang++ || true)
build=$tree/build/${compiler:+clang} # in the tree, beside which ccache leaves names absolute
here=$source/tests/changing
new=$(mktemp -d "$2/new.XXXXXX")
trap 'rm -rf "$new"' EXIT

mkdir "$new/assets"
cp -R "$source"/{models,renderer,cmake} "$new"
cp "$source/assets/materials.json" "$new/assets"
cp -R "$source/assets/programs" "$new/assets"
mkdir -p "$new/tests/support" "$new/tests/changing"
cp "$source/tests/support/catch.h" "$new/tests/support"
cp "$here/changed_test.cpp" "$new/tests/changing"
cp "$here/changed_project.cmake" "$new/CMakeLists.txt"
for patch in light_number reflection_model primitive mistake; do
    patch --quiet --strip=1 --directory="$new" <"$here/$patch.patch" || {
        echo "tests/changing/$patch.patch does not apply any more: make the change by hand and write the patch anew" >&2
        exit 1
    }
done
find "$new" -name '*.orig' -delete
mkdir -p "$build"
# Only what differs gets a new time, so that the rest need not be compiled again.
(cd "$tree" && find . -path ./build -prune -o -type f -print) | while read -r file; do [ -e "$new/$file" ] || rm "$tree/$file"; done
(cd "$new" && find . -type f) | while read -r file; do
    cmp -s "$new/$file" "$tree/$file" || install -D -m 644 "$new/$file" "$tree/$file"
done
"$cmake" -S "$tree" -B "$build" -G Ninja ${compiler:+-DCMAKE_CXX_COMPILER="$compiler"} \
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DGLINT_FOLDERS_AS_ONE=ON -DGLINT_PATCHES="$here" >"$2/log" || { cat "$2/log" >&2 && exit 1; }
"$cmake" --build "$build" >"$2/log" || { cat "$2/log" >&2 && exit 1; }
"$build/changed_test"
