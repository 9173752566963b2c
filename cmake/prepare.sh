# shellcheck shell=bash
# Sourced by run.sh, test.sh and .ci/run: installs missing packages, configures and builds. Prints nothing if everything is up
# to date. Expects `set -eu`.

# The root of the project, independent of the current directory.
glint_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

fail() {
    echo "glint: error: $1" >&2
    exit 1
}

# Prints the packages in the given lists that are not installed, with a single call to dpkg-query.
missing_packages() {
    local wanted
    wanted=$(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$@" | sort -u)
    # shellcheck disable=SC2086,SC2016  # one argument per package; dpkg-query expands the ${}
    { dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null || true; } |
        sed -n 's/^installed //p' | sort -u | comm -23 <(echo "$wanted") -
}

# Installs missing packages from the given lists. Uses the network only if there are any.
install_packages() {
    command -v dpkg-query >/dev/null || return 0 # not Debian: CMake reports missing packages
    local missing as_root="" log
    missing=$(missing_packages "$@" | tr '\n' ' ')
    missing=${missing% }
    [ -n "$missing" ] || return 0
    local by_hand="apt-get install --no-install-recommends $missing"
    if [ "$(id -u)" -ne 0 ]; then
        by_hand="sudo $by_hand"
        as_root="sudo"
        [ -t 0 ] || as_root="sudo -n" # nobody can type a password
        command -v sudo >/dev/null && $as_root true 2>/dev/null ||
            fail "packages are missing and only root can install them; run: $by_hand"
    fi
    echo "glint: installing $missing" >&2
    log=$(mktemp)
    # shellcheck disable=SC2086  # one argument per package
    if ! (
        set -o pipefail
        { { $as_root apt-get update -q || true; } &&
            $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing; } \
            2>&1 </dev/null | tee "$log" | counted installing
    ); then
        local reason
        reason=$(sed -n 's/^E: //p' "$log" | tail -n 1)
        rm -f "$log"
        fail "packages could not be installed (${reason:-apt-get failed}); run: $by_hand"
    fi
    rm -f "$log"
}

# counted DOING: reads the output of apt-get or Ninja and reports their progress every 15 seconds, even while they print
# nothing: "glint: building 120 of 231".
counted() {
    local line="" steps=0 of=0 said=$((SECONDS - 10)) # the first report comes sooner
    while true; do
        if IFS= read -r -t 5 line; then
            case $line in
            *Re-checking*) ;;
            [[]*/*[]]" "*) steps=${line%%/*} steps=${steps#[[]} of=${line#*/} of=${of%%]*} ;;
            *" newly installed, "*) of=${line% newly installed, *} of=${of##* } ;;
            "Setting up "*) steps=$((steps + 1)) ;;
            esac
        elif [ $? -le 128 ]; then
            return 0 # end of input; more than 128 is a timeout
        fi
        [ $((SECONDS - said)) -ge 15 ] || continue
        said=$SECONDS
        if [ "$of" -gt 0 ]; then echo "glint: $1 $steps of $of" >&2; else echo "glint: $1" >&2; fi
    done
}

# quietly LOG DOING COMMAND...: on a terminal, shows the command's output as it appears; otherwise counts its steps and shows
# the output only if it fails.
quietly() {
    local log=$1 doing=$2
    shift 2
    if [ -t 2 ]; then
        { "$@" 2>&1 | sed -u -e '/no work to do/d' -e '/Re-checking globbed/d' >&2; } && return 0
    else
        { "$@" 2>&1 | tee "$log" | counted "$doing"; } && return 0
        cat "$log" >&2
    fi
    return 1
}

# build PRESET TESTS [TARGET...]: configures build/PRESET if necessary and builds the targets (or all).
# TESTS is ON or OFF; once ON, it stays ON for that build tree. Only one build runs in a tree at a time; others wait.
build() {
    local preset=$1 tests=$2 tree cache target targets=()
    shift 2
    tree=$glint_root/build/$preset
    cache=$tree/CMakeCache.txt
    for target; do targets+=(--target "$target"); done
    mkdir -p "$tree"
    (
        set -o pipefail
        cd "$glint_root"
        until flock -w 15 9; do echo "glint: waiting for another build in $tree" >&2; done
        # A tree that was copied from elsewhere would still build in its original location.
        if [ -e "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$glint_root" "$cache"; then
            find "$tree" -mindepth 1 ! -name lock -delete
        fi
        if [ ! -e "$tree/build.ninja" ] || { [ "$tests" = ON ] && grep -qx GLINT_TESTS:BOOL=OFF "$cache"; }; then
            quietly "$tree/log" configuring cmake --preset "$preset" -DGLINT_TESTS="$tests" ||
                fail "the build could not be configured; see above"
        fi
        quietly "$tree/log" building cmake --build "$tree" -j"$(nproc)" ${targets[@]+"${targets[@]}"} 9>&- ||
            fail "the build failed; see above"
    ) 9>"$tree/lock"
}
