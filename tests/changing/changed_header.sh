#!/bin/sh
# changed_header.sh ROOT FOLDER CMAKE: a header that is precompiled changes, in a comment or in what it says, and what includes it
# compiles anew with what ccache kept from before. Exits with 77 where there is no ccache.
set -eu
root=$1 folder=$2/changed_header cmake=$3
command -v ccache >/dev/null || exit 77
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.22)
project(changed_header CXX)
set(CMAKE_CXX_STANDARD 20)
set(GLINT_FOLDERS_AS_ONE ON)
include($root/cmake/options.cmake)
include_directories(.)
add_executable(product main.cpp)
precompile(product OURS header.h)
END
export CCACHE_DIR="$folder/ccache"
# builds COMMENT A B: in a new tree, a program that ends with A, which the header says, times B.
builds() {
  printf '#pragma once\n// %s\ninline constexpr int number = %s;\n' "$1" "$2" >header.h
  printf '#include "header.h"\nint main() { return %s * number; }\n' "$3" >main.cpp
  rm -rf build
  "$cmake" -S . -B build -G Ninja "-DCMAKE_CXX_COMPILER=$compiler" >/dev/null
  "$cmake" --build build >log || { cat log && exit 1; }
  status=0
  build/product || status=$?
  [ "$status" -eq $(($2 * $3)) ] || { echo "$compiler: $2 times $3 is not $status, which was kept from before" && exit 1; }
}
for compiler in c++ clang++; do
  command -v $compiler >/dev/null || continue
  builds "a comment" 1 2
  builds "another one" 1 3
  builds "another one" 5 3
  builds "a comment" 1 2
done
