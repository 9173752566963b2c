#!/usr/bin/env bash
# texts.sh GLINT SHARE MAINTAINER: writes a package's text files: man pages and completions for bash and zsh from --help, and
# Debian's changelog.
# SHARE is the folder that is installed as /usr/share.
set -eu
glint=$(realpath "$1") share=$2 maintainer=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$share/man/man1"
version=$("$glint" --version | cut -d ' ' -f 2)

man_page() { # PAGE SUMMARY HELP-COMMAND...
    local page=$1 summary=$2
    shift 2
    # help2man runs a program with --help and --version, but each of our commands consists of the program's name and a word.
    printf '#!/bin/sh\n[ "$1" = --version ] && echo "%s %s" || exec %s --help\n' "$page" "$version" "$*" >"$work/$page"
    chmod +x "$work/$page"
    help2man --no-info --section 1 --name "$summary" "$work/$page" | gzip -9n >"$share/man/man1/$page.1.gz"
}

mkdir -p "$share/doc/glint"
printf 'glint (%s) stable; urgency=medium\n\n  * Built from source.\n\n -- %s  %s\n' "$version" "$maintainer" "$(date -R)" |
    gzip -9n >"$share/doc/glint/changelog.gz"
python3 "$here/completions.py" "$glint" "$share"
man_page glint "light a scene, see the picture, inspect every number behind a pixel" "$glint"
"$glint" --help | sed -n 's/^  glint \([a-z]\+\).*/\1/p' | while read -r command; do
    man_page "glint-$command" "$("$glint" "$command" --help | head -n 1)" "$glint $command"
done
