#!/bin/sh
# changed_comment.sh ROOT FOLDER CMAKE: a comment of a header that is precompiled changes, and what includes the header still
# compiles, with what ccache kept from before. Exits with 77 where there is no ccache.
set -eu
root=$1 folder=$2/changed_comment cmake=$3
command -v ccache >/dev/null || exit 77
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.22)
project(changed_comment CXX)
set(CMAKE_CXX_STANDARD 20)
set(GLINT_FOLDERS_AS_ONE ON)
include($root/cmake/options.cmake)
include_directories(.)
add_library(includes STATIC includes.cpp)
precompile(includes OURS header.h)
END
export CCACHE_DIR="$folder/ccache"
build() { # COMMENT NUMBER
  printf '#pragma once\n// %s\ninline constexpr int number = 1;\n' "$1" >header.h
  printf '#include "header.h"\nint times() { return %s * number; }\n' "$2" >includes.cpp
  rm -rf build
  "$cmake" -S . -B build -G Ninja >/dev/null
  "$cmake" --build build
}
build "a comment" 2 >/dev/null
build "another one" 3
