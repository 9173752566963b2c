option(GLINT_FOLDERS_AS_ONE "Compile the files of a folder together" OFF)

# What every target of ours is compiled with.
add_library(glint_options INTERFACE)
# -ffp-contract=off: a product and a sum are never fused behind our back, so that a picture has the same bytes
# on every instruction set and an explanation equals its pixel to the last bit (docs/architecture.md).
# What Clang counts to -Wconversion beyond GCC, a change of sign, is left out.
target_compile_options(glint_options INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion -Wswitch -ffp-contract=off)
# Where files are compiled together, not about names of another file's anonymous namespace.
if(NOT GLINT_FOLDERS_AS_ONE)
  target_compile_options(glint_options INTERFACE -Wshadow)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(glint_options INTERFACE -Wshadow=local -Wno-subobject-linkage)
endif()
target_include_directories(glint_options INTERFACE ${PROJECT_SOURCE_DIR})
if(GLINT_WERROR)
  target_compile_options(glint_options INTERFACE -Werror)
endif()
if(GLINT_SANITIZE)
  # Each compiler has its own name for GLINT_SANITIZED. The standard library checks every index: an address behind a vector's
  # end may be another one's, where no sanitizer minds it.
  target_compile_definitions(glint_options INTERFACE GLINT_SANITIZED _GLIBCXX_ASSERTIONS)
  # GCC takes what the sanitizers add for uses of what was not set.
  target_compile_options(glint_options INTERFACE -fsanitize=${GLINT_SANITIZE} -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # What is undefined ends the program by an instruction (SIGILL), without a call that would say what it was: drawing takes half
  # of the time. With ASAN_OPTIONS=handle_sigill=2 the address sanitizer says where. Whether an object has the type that it is taken
  # for is found out by such a call.
  if(GLINT_SANITIZE MATCHES "undefined" AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(glint_options INTERFACE -fsanitize-trap=undefined -fno-sanitize-trap=vptr)
  endif()
  # Where a program may lie anywhere, each of the 800,000 addresses that they know is put right whenever it begins: a quarter of
  # what a start costs.
  target_link_options(glint_options INTERFACE -fsanitize=${GLINT_SANITIZE} -no-pie)
endif()
if(GLINT_SANITIZE STREQUAL "thread")
  # Loops on threads that it knows, in front of oneTBB's, which it does not: tests/threads/tbb/parallel_for.h says why.
  target_include_directories(glint_options BEFORE INTERFACE ${PROJECT_SOURCE_DIR}/tests/threads)
endif()
# The command line, the window and what reads and writes texts wait for files and for people; what draws is `renderer`, with
# Release's -O3. -O1 compiles in two thirds of the time, and under the sanitizers the program is half as large as unoptimised.
function(compile_quickly target)
  if(GLINT_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${target} PRIVATE -O1)
  endif()
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    set_target_properties(${target} PROPERTIES NOT_OPTIMISED ON)
  endif()
endfunction()

# clang's linker, where there is one, links what the sanitizers make in a fifth of the time.
find_program(GLINT_LLD ld.lld)
if(GLINT_LLD AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_link_options(-fuse-ld=lld)
endif()

# The linker takes the first copy of an inline function that several files define. That of tests, and under the sanitizers that of
# the window, is not optimised; with the libraries in front of them a library's copy is taken, and most tests of drawing take a
# quarter of the time under the sanitizers.
function(link_first library)
  set(first "LINKER:--whole-archive,$<TARGET_FILE:${library}>,--no-whole-archive")
  target_link_options(${library} INTERFACE $<$<BOOL:$<TARGET_PROPERTY:NOT_OPTIMISED>>:${first}>)
endfunction()

# Counts which ways an input takes through the target: that leads the fuzzers. Comparisons are not traced, so that they try twice
# as many inputs.
function(count_ways target)
  if(GLINT_FUZZERS)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp)
  endif()
endfunction()

# Precompiled headers of libraries, for what nearly every file of a target includes: reading them is most of what
# compiling a small file costs. Where folders are compiled as one, those of ours behind OURS too, which nearly every folder
# includes; where files are compiled alone none of ours is among them, so that changing one compiles only what includes it.
# GLINT_PCH=OFF shows whether every file still includes what it needs.
option(GLINT_PCH "Precompile the headers of libraries" ON)
set(GLINT_PCH_LIBRARY <algorithm> <array> <cmath> <cstdint> <functional> <memory> <optional> <span> <string> <string_view>
    <utility> <variant> <vector> <fmt/format.h> <glm/glm.hpp>)
# GCC 12 forgets in a precompiled header that <string> switches off three warnings that are wrong about it.
add_library(glint_precompiled INTERFACE)
target_compile_options(glint_precompiled INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>)
function(precompile target)
  cmake_parse_arguments(PARSE_ARGV 1 headers "" "" OURS)
  set(headers ${headers_UNPARSED_ARGUMENTS})
  if(GLINT_FOLDERS_AS_ONE)
    list(TRANSFORM headers_OURS REPLACE "(.+)" "<\\1>" OUTPUT_VARIABLE ours)
    list(APPEND headers ${ours})
  endif()
  if(GLINT_PCH)
    target_precompile_headers(${target} PRIVATE ${headers})
    target_link_libraries(${target} PRIVATE glint_precompiled)
  endif()
endfunction()
# The files of a folder, with those of the folders in it, as one, where nobody changes a single one of them: what they include
# and instantiate is compiled once, in a third of the time. Names in anonymous namespaces are then those of a folder. The preset
# `edit` compiles each file alone. A folder lies two below the root, among the tests three.
# What has SKIP_UNITY_BUILD_INCLUSION before, and what the build makes, is compiled alone. CMake's own UNITY_BUILD writes the
# checkout's place into its files, and what ccache keeps of one checkout would not serve in another.
function(compile_by_folder target)
  if(NOT GLINT_FOLDERS_AS_ONE)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  set(compiled "")
  set(folders "")
  foreach(source ${sources})
    get_source_file_property(skips ${source} SKIP_UNITY_BUILD_INCLUSION)
    get_source_file_property(is_made ${source} GENERATED)
    if(skips OR is_made OR NOT source MATCHES "\\.cpp$")
      list(APPEND compiled ${source})
    else()
      get_filename_component(path ${source} ABSOLUTE)
      file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${path})
      string(REGEX MATCH "^(tests/)?(ui/features/)?[^/]+(/[^/]+)?/" folder "${path}")
      string(MAKE_C_IDENTIFIER "${folder}" folder)
      list(APPEND folders ${folder})
      string(APPEND includes_of_${folder} "#include \"${path}\"\n")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder ${folders})
    set(file ${CMAKE_CURRENT_BINARY_DIR}/folders/${target}/${folder}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${includes_of_${folder}}" @ONLY)
    list(APPEND compiled ${file})
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${compiled}")
endfunction()
# A library of `sources`, of which the files `words` read and write texts or visit fields: many small instances, each run once a
# file. They are compiled quickly, as the library ${target}_of_words, which is linked behind the other, so that the optimised copy
# of what both define is taken.
function(add_library_with_words target sources words)
  list(REMOVE_ITEM sources ${words})
  add_library(${target}_of_words STATIC ${words})
  compile_quickly(${target}_of_words)
  add_library(${target} STATIC ${sources})
  target_link_libraries(${target} PUBLIC ${target}_of_words)
  target_link_libraries(${target}_of_words PRIVATE ${target})  # each calls the other
  foreach(part ${target} ${target}_of_words)
    compile_by_folder(${part})
    count_ways(${part})
  endforeach()
  link_first(${target})
  link_first(${target}_of_words)
endfunction()

# How the compilers are started. Their memory comes in large pages (glibc 2.35; before, nothing changes): clang takes a tenth of the
# page faults, and of the time four fifths.
set(GLINT_LAUNCHER ${CMAKE_COMMAND} -E env GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.top_pad=67108864)

# ccache where there is one. A precompiled header holds the time of its files, which ccache is to pass over, and a digest of each,
# comments too. So what is hashed is the files (CCACHE_DEPEND) and not the preprocessed text, which has no comments: a precompiled
# header from before another comment would let what has `#pragma once` be included twice. What one checkout compiled serves the
# others: paths are hashed relative to the checkout, and of a precompiled header its files alone (compile.sh). clang writes into it
# where its files are: none may serve elsewhere. CMake would name clang the header beside it, too, which clang needs not and ccache
# leaves absolute.
find_program(GLINT_CCACHE ccache)
if(GLINT_CCACHE)
  list(APPEND GLINT_LAUNCHER CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1 CCACHE_PCH_EXTSUM=1
       CCACHE_SLOPPINESS=pch_defines,time_macros sh ${CMAKE_CURRENT_LIST_DIR}/compile.sh)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    string(MD5 checkout ${CMAKE_BINARY_DIR})
    list(APPEND CMAKE_CXX_COMPILE_OPTIONS_CREATE_PCH -DGLINT_PRECOMPILED_IN_${checkout})
    set(CMAKE_CXX_COMPILE_OPTIONS_USE_PCH -Xclang -include-pch -Xclang <PCH_FILE>)
  endif()
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  add_compile_options("$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endif()
set(CMAKE_CXX_COMPILER_LAUNCHER ${GLINT_LAUNCHER})
