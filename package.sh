#!/usr/bin/env bash
# Builds Glint's packages in build/package: a .deb for Debian 12, and a .tar.xz with all libraries that runs from any folder.
# Installs missing packages first.
set -eu
. "$(dirname "${BASH_SOURCE[0]}")/cmake/prepare.sh"

install_packages "$glint_root/cmake/packages.txt" "$glint_root/cmake/packages-package.txt"
build release OFF glint package_texts
out=$glint_root/build/package
rm -rf "$out"
mkdir -p "$out"
cd "$glint_root/build/release"
cpack -G DEB -B "$out" >"$out/log" 2>&1 || { cat "$out/log" >&2; fail "the .deb could not be built; see above"; }
rm -rf "$out/_CPack_Packages" "$out/log"

# The archive includes all libraries except those that every Debian system has and that must match the machine: the C and C++
# libraries, X and OpenGL.
version=$("$glint_root/build/release/app/glint" --version | cut -d ' ' -f 2)
name=glint-$version-$(uname -m)
cmake --install . --prefix "$out/$name" --strip >/dev/null
mkdir -p "$out/$name/lib"
ldd app/glint | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' |
    grep -Ev '/lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|X11|xcb|Xau|Xdmcp|bsd|md)\.so' |
    while read -r library; do cp -L "$library" "$out/$name/lib/"; done
patchelf --set-rpath '$ORIGIN/../lib' "$out/$name/bin/glint"
for library in "$out/$name"/lib/*; do patchelf --set-rpath '$ORIGIN' "$library"; done
tar -C "$out" --owner=0 --group=0 -cJf "$out/$name.tar.xz" "$name"
rm -rf "${out:?}/$name"
ls -1 "$out"/*
