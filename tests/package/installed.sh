#!/usr/bin/env bash
# Installs the packages that ./package.sh built, as a user would, tests their contents, and removes them:
# tests/package/installed.sh [FOLDER]. FOLDER is build/package by default. Needs root, and a machine that does
# not have Glint installed and may be altered.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
packages=${1:-build/package}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export DEBIAN_FRONTEND=noninteractive

check() { # WHAT COMMAND...
    local what=$1
    shift
    if "$@" >"$work/log" 2>&1; then echo "ok: $what"; else
        echo "failed: $what" >&2
        cat "$work/log" >&2
        exit 1
    fi
}
is_png() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]; }
draws() { "$@" render "$scene" -o "$work/picture.png" --size 320x180 && is_png "$work/picture.png"; }
opens() { # the window stays open until it is terminated
    timeout 60 xvfb-run -a sh -c '"$0" & sleep 8; kill -0 $! && kill $!' "$@"
}
complete_word() { bash -c 'source /usr/share/bash-completion/completions/glint; COMP_WORDS=(glint expl); COMP_CWORD=1; _glint; [ "${COMPREPLY[*]}" = explain ]'; }
# Prints the paths of Glint's files, except for the user's own files and the pages that man has cached.
traces() { find / -xdev \( -path "$PWD" -o -path "$HOME" -o -path "$work" -o -path /tmp -o -path /var/cache/man \) -prune -o -iname '*glint*' -print; }

apt-get update -q >/dev/null
traces | sort >"$work/before"
check "the package installs" apt-get install -y -q --no-install-recommends ./"$packages"/glint_*.deb
scene=/usr/share/glint/assets/scenes/default.json
check "glint --version" glint --version
check "a shipped scene is drawn" draws glint
check "the lessons are found and pass their checks" glint lessons --check
check "man glint" sh -c 'apt-get install -y -q --no-install-recommends man-db >/dev/null && man -P cat glint | grep -q "light a scene" && man -P cat glint-render | grep -q samples'
check "bash completes a command" complete_word
apt-get install -y -q --no-install-recommends xvfb xauth libgl1-mesa-dri libglx-mesa0 >/dev/null
check "the window opens" opens glint
check "the package is removed" apt-get purge -y -q glint
traces | sort >"$work/after"
check "nothing is left" diff "$work/before" "$work/after"

# The archive needs neither root nor any packages beyond the C library and a few similar ones.
apt-get autoremove -y -q --purge >/dev/null
apt-get install -y -q --no-install-recommends libx11-6 libgl1 xz-utils >/dev/null
tar -xf "$packages"/glint-*.tar.xz -C "$work"
program=$(echo "$work"/glint-*/bin/glint)
scene=$(dirname "$program")/../share/glint/assets/scenes/default.json
check "the archive's program draws" draws "$program"
