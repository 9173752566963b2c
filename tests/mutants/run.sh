#!/usr/bin/env bash
# Puts each fault of tests/mutants/*.txt, one at a time, into a copy of the project, builds what it changes and runs the unit
# tests until one fails. Prints a line a fault; ends with status 1 where one survived that is not listed as equivalent, where
# one does not compile, or where its text is not found exactly once, so that it has gone stale.
#
#   tests/mutants/run.sh [TEXT]    all of them, or those whose file or name contains TEXT
#
# The lists: "@ FILE", then a line a fault: NAME ## FROM => TO ## TESTS, where ↵ is the end of a line. TESTS is a Catch2 test
# spec that is run before all others, to be quick about it, or "equivalent: WHY" for a fault that nothing can see.
# GLINT_MUTANTS_TREE names another copy, built with the preset ci, to break instead of build/mutants.
set -eu
. "$(dirname "${BASH_SOURCE[0]}")/../../cmake/prepare.sh"

tree=${GLINT_MUTANTS_TREE:-$glint_root/build/mutants}
tests=$tree/build/ci/tests/unit_tests
wanted=${1:-}
killed=0 survived=0 wrong=0

# The project as it is, but for what was not changed since: that keeps its time and is not built again.
copy() {
    mkdir -p "$tree"
    (cd "$glint_root" && git ls-files -z --cached --others --exclude-standard |
        xargs -0 cp --parents --update --preserve=mode,timestamps -t "$tree")
}
compile() { nice -n 5 cmake --build "$tree/build/ci" -j"$(nproc)" --target glint unit_tests >"$tree/build/log" 2>&1; }
# passes SPEC...: whether these unit tests pass.
passes() { (cd "$tree/build/ci" && timeout 900 "$tests" "$@" --abort >"$tree/build/log" 2>&1); }

# change FILE FROM TO: writes the changed file, or fails where FROM does not stand in it exactly once.
change() {
    python3 - "$@" <<'END'
import sys
path, old, new = (argument.replace("↵", "\n") for argument in sys.argv[1:])
text = open(path, encoding="utf-8").read()
if text.count(old) != 1:
    sys.exit(1)
open(path, "w", encoding="utf-8").write(text.replace(old, new))
END
}

# verdict FILE FROM TO TESTS: stale, uncompiled, untested (TESTS names none), killed or survived.
verdict() {
    local file=$tree/$1 result=survived
    case $4 in
    "" | equivalent:*) ;;
    *) "$tests" --list-test-names-only "$4" | grep -q . || { echo untested && return; } ;;
    esac
    change "$file" "$2" "$3" || { echo stale && return; }
    if ! compile; then
        result=uncompiled
    elif [ -n "$4" ] && [[ $4 != equivalent:* ]] && ! passes "$4"; then
        result=killed
    elif ! passes; then
        result=killed
    fi
    cp --preserve=mode "$glint_root/$1" "$file"
    echo "$result"
}

# judge FILE LINE
judge() {
    local name=${2%% ## *} rest=${2#* ## } hint="" began=$SECONDS result
    [[ $rest != *" ## "* ]] || { hint=${rest##* ## } && rest=${rest% ## *}; }
    [[ "$1 $name" == *"$wanted"* ]] || return 0
    result=$(verdict "$1" "${rest%% => *}" "${rest#* => }" "$hint")
    case $result:$hint in
    killed:equivalent:*) wrong=$((wrong + 1)) ;;
    killed:*) killed=$((killed + 1)) ;;
    survived:equivalent:*) result=equivalent ;;
    survived:*) survived=$((survived + 1)) ;;
    *) wrong=$((wrong + 1)) ;;
    esac
    printf '%-10s %4d s  %s: %s\n' "$result" $((SECONDS - began)) "$1" "$name"
}

install_packages "$glint_root/cmake/packages.txt" "$glint_root/cmake/packages-test.txt"
copy
[ -e "$tree/build/ci/build.ninja" ] || (cd "$tree" && cmake --preset ci -DGLINT_WERROR=OFF >/dev/null)
compile || { cat "$tree/build/log" && fail "the copy does not build; see above"; }

file=""
while IFS= read -r line <&3; do
    case $line in
    "" | "#"*) ;;
    "@ "*) file=${line#@ } ;;
    *) judge "$file" "$line" ;;
    esac
done 3< <(cat "$glint_root"/tests/mutants/*.txt)
echo "mutants: $killed killed, $survived survived, $wrong stale, not compiled, or killed though equivalent"
[ $((survived + wrong)) -eq 0 ]
