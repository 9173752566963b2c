#!/bin/sh
# compile.sh COMMAND...: compiles with ccache. Beside a precompiled header goes a digest of all files that it was made of, which
# ccache takes in its place (CCACHE_PCH_EXTSUM): its own bytes are others each time, and what was compiled with it names only the
# files that it includes beside it.
ccache "$@" || exit
for argument; do
    case $before in
    -o) made=$argument ;;
    -MF) list=$argument ;;
    esac
    before=$argument
done
case $made in
*.gch | *.pch)
    # The list is "TARGET: FILE FILE \" over several lines.
    sed -e '1s/^[^:]*://' -e 's/\\$//' "$list" | xargs cat | sha256sum >"$made.sum"
    ;;
esac
