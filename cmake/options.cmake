option(GLINT_FOLDERS_AS_ONE "Compile the files of a folder together" OFF)

# The compile options of all our targets.
add_library(glint_options INTERFACE)
# -ffp-contract=off: products and sums are never fused, so that a picture has the same bytes on every instruction set and an
# explanation equals its pixel to the last bit (docs/architecture.md).
# -Wno-sign-conversion: Clang's -Wconversion includes changes of sign, and GCC's does not.
target_compile_options(glint_options INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion -Wswitch -ffp-contract=off)
# If files are compiled together, do not warn about names in another file's anonymous namespace.
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
  # GLINT_SANITIZED replaces the compilers' different macros. The standard library checks every index: an address past a vector's
  # end may belong to another vector, which no sanitizer detects.
  target_compile_definitions(glint_options INTERFACE GLINT_SANITIZED _GLIBCXX_ASSERTIONS)
  # GCC warns falsely about uninitialised variables in the sanitizers' code.
  target_compile_options(glint_options INTERFACE -fsanitize=${GLINT_SANITIZE} -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # Undefined behaviour ends the program by an instruction (SIGILL) instead of a call with a message, which halves the time of
  # drawing. With ASAN_OPTIONS=handle_sigill=2 the address sanitizer prints the location. The check of an object's type (vptr)
  # needs the call.
  if(GLINT_SANITIZE MATCHES "undefined" AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(glint_options INTERFACE -fsanitize-trap=undefined -fno-sanitize-trap=vptr)
  endif()
  # A position-independent program with sanitizers relocates 800,000 addresses at each start, a quarter of its start-up time.
  target_link_options(glint_options INTERFACE -fsanitize=${GLINT_SANITIZE} -no-pie)
endif()
if(GLINT_SANITIZE STREQUAL "thread")
  # Replaces oneTBB's loops, which the sanitizer does not understand, by ones that it does (tests/threads/tbb/parallel_for.h).
  target_include_directories(glint_options BEFORE INTERFACE ${PROJECT_SOURCE_DIR}/tests/threads)
endif()
# The command line, the window and the readers and writers of text wait for files and people; `renderer` draws, with Release's
# -O3. -O1 compiles in two thirds of the time, and with sanitizers the program is half as large as without optimisation.
function(compile_quickly target)
  if(GLINT_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${target} PRIVATE -O1)
  endif()
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    set_target_properties(${target} PROPERTIES NOT_OPTIMISED ON)
  endif()
endfunction()

# clang's linker, if installed, links sanitizer builds in a fifth of the time.
find_program(GLINT_LLD ld.lld)
if(GLINT_LLD AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_link_options(-fuse-ld=lld)
endif()

# The linker takes the first copy of an inline function that several files define. The copies of tests, and with sanitizers those
# of the window, are not optimised. Linking the libraries first selects their copies, and most tests of drawing then take a
# quarter of the time with sanitizers.
function(link_first library)
  set(first "LINKER:--whole-archive,$<TARGET_FILE:${library}>,--no-whole-archive")
  target_link_options(${library} INTERFACE $<$<BOOL:$<TARGET_PROPERTY:NOT_OPTIMISED>>:${first}>)
endfunction()

# Adds coverage counters, which guide the fuzzers. Comparisons are not traced, so that the fuzzers try twice as many inputs.
function(count_ways target)
  if(GLINT_FUZZERS)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp)
  endif()
endfunction()

# Precompiles the headers of libraries that nearly every file of a target includes: parsing them is most of the cost of a small
# file. If folders are compiled as one, also precompiles our own headers after OURS, which nearly every folder includes. If files
# are compiled alone, it does not, so that changing such a header recompiles only the files that include it. GLINT_PCH=OFF checks
# that every file includes the headers that it needs.
option(GLINT_PCH "Precompile the headers of libraries" ON)
set(GLINT_PCH_LIBRARY <algorithm> <array> <cmath> <cstdint> <functional> <memory> <optional> <span> <string> <string_view>
    <utility> <variant> <vector> <fmt/format.h> <glm/glm.hpp>)
# In a precompiled header, GCC 12 forgets that <string> disables three false warnings.
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
# Compiles the files of a folder and its subfolders as one, for builds of the entire project: their includes and instantiations
# are compiled once, in a third of the time. Names in anonymous namespaces are then shared by a folder. The preset `edit` compiles
# each file alone. Folders are two levels below the root, or three in tests.
# Files with SKIP_UNITY_BUILD_INCLUSION and generated files are compiled alone. CMake's own UNITY_BUILD writes the checkout's path
# into its files, so that different checkouts could not share ccache's results.
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
# Adds a library of `sources`. Its files `words` read and write text or visit fields: many small instances, each run once per
# file. They form the library ${target}_of_words, which is compiled with little optimisation and linked after the other, so that
# the optimised copy of common functions is used.
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

# Starts the compilers with large pages (glibc 2.35; no effect in older versions): clang has a tenth of the page faults and takes
# four fifths of the time.
set(GLINT_LAUNCHER ${CMAKE_COMMAND} -E env GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.top_pad=67108864)

# Uses ccache if installed. A precompiled header contains the times of its files, which ccache must ignore, and a digest of each
# file including comments. So ccache hashes the files (CCACHE_DEPEND) and not the preprocessed text without comments: with an
# outdated precompiled header, a changed comment would cause files with `#pragma once` to be included twice. Checkouts share
# results: paths are hashed relative to the checkout, and a precompiled header only by its files (compile.sh). clang writes the
# path of its files into the header, so clang's are not shared. CMake would also pass the header next to it to clang, which does
# not need it, and ccache would keep its path absolute.
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
