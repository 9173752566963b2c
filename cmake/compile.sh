#!/bin/sh
# compile.sh COMMAND...: compiles with ccache. Writes a digest of all source files next to a precompiled header, and ccache uses
# it instead of the header (CCACHE_PCH_EXTSUM): the header's bytes differ each time, and dependency files list only the files
# outside of it.
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
