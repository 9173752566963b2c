#!/usr/bin/env bash
# Runs clang-tidy on the given files, or on every file of the project: tests/tidy.sh [FILE...]. A header is
# checked in the .cpp of the same name, or otherwise in one that includes it. Each file is compiled separately (preset
# `edit`), so missing #includes are found. Exits with status 1 if clang-tidy found something or could not
# check a file. If GLINT_TIDY_SECONDS is set, the script checks no further files after that time and prints the
# names of the skipped files.
set -eu
. "$(dirname "${BASH_SOURCE[0]}")/../cmake/prepare.sh"
cd "$glint_root"

# reader HEADER: prints a .cpp that includes it, directly or through other headers.
reader() {
    local own=${1%.h}.cpp seen=" $1 " queue=("$1") header includer
    [ ! -e "$own" ] || { echo "$own" && return; }
    while [ ${#queue[@]} -gt 0 ]; do
        header=${queue[0]} queue=("${queue[@]:1}")
        while read -r includer; do
            [[ $includer != *.cpp ]] || { echo "$includer" && return; }
            [[ $seen == *" $includer "* ]] || { seen+="$includer " && queue+=("$includer"); }
        done < <(git grep -lF "#include \"$header\"" -- '*.cpp' '*.h' | sort)
    done
}

# Clang understands the compiler's options, but not those of a launcher.
cmake --preset edit -B build/tidy -DGLINT_TESTS=ON -DGLINT_CCACHE= >/dev/null
# The templates in assets/programs are not C++ until `glint code` has filled them in.
[ $# -gt 0 ] || mapfile -t all < <(git ls-files '*.cpp' ':!assets/programs')
failed=0
files=()
for file in "$@" ${all[@]+"${all[@]}"}; do
    # Nor are the stand-ins for oneTBB in this build.
    [[ $file != assets/programs/* && $file != tests/threads/tbb/* ]] || continue
    source=$file
    [[ $file != *.h ]] || source=$(reader "$file")
    if [ -n "$source" ] && grep -qF "/$source\"" build/tidy/compile_commands.json; then
        files+=("$source")
    else
        echo "tidy: $file is not compiled on this machine" && failed=1
    fi
done
[ ${#files[@]} -gt 0 ] || exit $failed
mapfile -t files < <(printf '%s\n' "${files[@]}" | sort -u)
echo "tidy: checking ${#files[@]} files"
end=$(($(date +%s) + ${GLINT_TIDY_SECONDS:-86400}))
# shellcheck disable=SC2016  # the inner shell expands
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -I{} bash -c '
    [ "$(date +%s)" -lt "$2" ] || { echo "tidy: no time left for $1" && exit; }
    clang-tidy -p build/tidy --quiet --warnings-as-errors="*" "$1" 2>/dev/null || { echo "tidy: the above is in $1"; exit 1; }' tidy {} "$end" ||
    failed=1
exit $failed
