#!/usr/bin/env bash
# Puts each fault of tests/mutants/*.txt, one at a time, into a copy of the project, builds what it changes and runs the unit
# tests until one fails: those of the fault's own folder first, then all that are short, then the long ones. Prints a line a
# fault and keeps it in results.txt beside the copy, so that what was interrupted goes on where it was. Ends with status 1
# where one survived that is not listed as equivalent, where one does not compile, or where its text is not found exactly
# once, so that it has gone stale.
#
#   tests/mutants/run.sh [TEXT]    all of them, or those whose file or name contains TEXT
#   tests/mutants/run.sh --check   only whether each fault's text is found once; builds nothing
#
# The lists: "@ FILE", then a line a fault: NAME ## FROM => TO ## TESTS, where ↵ is the end of a line. TESTS is a Catch2 test
# spec that is run before all others, to be quick about it, or "equivalent: WHY" for a fault that nothing can see.
# GLINT_MUTANTS_TREE names another copy, built with the preset edit, to break instead of build/mutants. GLINT_MUTANTS_JOBS says
# how many compilers run at once; 1 when not given.
set -eu
. "$(dirname "${BASH_SOURCE[0]}")/../../cmake/prepare.sh"

tree=${GLINT_MUTANTS_TREE:-$glint_root/build/mutants}
tests=$tree/build/edit/tests/unit_tests
log=$tree/build/log
results=$tree/results.txt
wanted=${1:-}
killed=0 survived=0 equivalent=0 wrong=0

# The project as it is, but for what was not changed since: that keeps its time and is not built again.
copy() {
    mkdir -p "$tree"
    (cd "$glint_root" && git ls-files -z --cached --others --exclude-standard |
        xargs -0 cp --parents --update --preserve=mode,timestamps -t "$tree")
}
compile() {
    cmake --build "$tree/build/edit" -j"${GLINT_MUTANTS_JOBS:-1}" --target glint unit_tests >"$log" 2>&1
}
# passes SPEC: whether these unit tests pass, as those do of a spec that fits none.
passes() {
    (cd "$tree/build/edit" && timeout 900 "$tests" --filenames-as-tags --abort "$1" >"$log" 2>&1) ||
        grep -q "^No tests ran" "$log"
}
# The test that failed: its name stands between the first two rules.
failed_test() { awk '/^----------/ { if (found++) exit; next } found { printf "%s", $0; exit }' "$log"; }

# nearest FILE: a spec of the short tests of the folder that tests this file.
nearest() {
    find "$tree/tests/$(dirname "$1")" -maxdepth 1 -name '*_test.cpp' -printf '%f\n' 2>/dev/null |
        sed 's/\(.*\)\.cpp/[#\1]~[long]/' | paste -sd,
}

# change FILE FROM TO: writes the changed file, or fails where FROM does not stand in it exactly once.
change() {
    python3 - "$@" <<'PYTHON'
import sys
path, old, new = (argument.replace("↵", "\n") for argument in sys.argv[1:])
text = open(path, encoding="utf-8").read()
if text.count(old) != 1:
    sys.exit(1)
open(path, "w", encoding="utf-8").write(text.replace(old, new))
PYTHON
}

# verdict FILE TESTS: of the copy as it stands: uncompiled, "killed by TEST", survived or unclear.
verdict() {
    local spec test
    compile || { echo uncompiled && return; }
    for spec in "${2%%equivalent:*}" "$(nearest "$1")" "~[long]" "[long]"; do
        if [ -z "$spec" ] || passes "$spec"; then continue; fi
        # Without one it was not a test that ended the run.
        test=$(failed_test) && echo "${test:+killed by }${test:-unclear}" && return
    done
    echo survived
}

# verdict_of FILE FROM TO TESTS: that of the fault; stale where it cannot be put in, untested where TESTS names none.
verdict_of() {
    case $4 in
    "" | equivalent:*) ;;
    *) "$tests" --list-tests "$4" | grep -q '^[1-9]' || { echo untested && return; } ;;
    esac
    cp --preserve=mode,timestamps "$tree/$1" "$tree/build/original"
    change "$tree/$1" "$2" "$3" || { echo stale && return; }
    verdict "$1" "$4"
    cp --preserve=mode "$tree/build/original" "$tree/$1"
}

# judge FILE LINE
judge() {
    local name=${2%% ## *} rest=${2#* ## } hint="" began=$SECONDS result key
    [[ $rest != *" ## "* ]] || { hint=${rest##* ## } && rest=${rest% ## *}; }
    [[ "$1 $name" == *"$wanted"* ]] || return 0
    key=$(cksum <<<"$1 $rest" | cut -d' ' -f1)
    result=$(sed -n "s/^$key //p" "$results" | tail -1)
    if [ -z "$result" ]; then
        result=$(verdict_of "$1" "${rest%% => *}" "${rest#* => }" "$hint")
        echo "$key $result" >>"$results"
    fi
    case $result:$hint in
    killed*:equivalent:*) wrong=$((wrong + 1)) ;;
    killed*) killed=$((killed + 1)) ;;
    survived:equivalent:*) result=${hint} && equivalent=$((equivalent + 1)) ;;
    survived:*) survived=$((survived + 1)) ;;
    *) wrong=$((wrong + 1)) ;;
    esac
    printf '%4d s  %s: %s: %s\n' $((SECONDS - began)) "$1" "$name" "$result"
}

# check: names the faults whose text is not found once.
check() {
    cd "$glint_root" && python3 - tests/mutants/*.txt <<'PYTHON'
import sys
stale = 0
for name in sys.argv[1:]:
    for line in open(name, encoding="utf-8").read().splitlines():
        if line.startswith("@ "):
            path = line[2:]
            text = open(path, encoding="utf-8").read()
        elif line and not line.startswith("#"):
            fault, change = line.split(" ## ")[:2]
            if text.count(change.split(" => ")[0].replace("↵", "\n")) != 1:
                print(f"stale: {path}: {fault}")
                stale += 1
sys.exit(stale > 0)
PYTHON
}

if [ "$wanted" = --check ]; then
    check
    exit
fi
install_packages "$glint_root/cmake/packages.txt" "$glint_root/cmake/packages-test.txt"
mkdir -p "$tree"
exec 9>"$tree/lock"
flock -n 9 || fail "$tree: another run breaks this copy"
[ -n "${GLINT_MUTANTS_TREE:-}" ] || copy
[ -e "$tree/build/edit/build.ninja" ] || (cd "$tree" && cmake --preset edit -DGLINT_WERROR=OFF >/dev/null)
compile || { cat "$log" && fail "the copy does not build; see above"; }
touch "$results"
file=""
while IFS= read -r line <&3; do
    case $line in
    "" | "#"*) ;;
    "@ "*) file=${line#@ } ;;
    *) judge "$file" "$line" ;;
    esac
done 3< <(cat "$glint_root"/tests/mutants/*.txt)
echo "mutants: $killed killed, $survived survived, $equivalent equivalent, $wrong stale, not compiled, or killed though equivalent"
[ $((survived + wrong)) -eq 0 ]
