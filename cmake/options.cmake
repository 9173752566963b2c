# The compiler options for all our targets.
add_library(glint_options INTERFACE)
target_include_directories(glint_options INTERFACE ${PROJECT_SOURCE_DIR})
# -ffp-contract=off: a product and a sum are never fused, so that a picture has the same bytes on every instruction set
# and an explanation equals its pixel to the last bit (docs/architecture.md).
# -Wno-sign-conversion: Clang's -Wconversion warns about changes of sign; GCC's does not.
target_compile_options(glint_options INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion -ffp-contract=off)
if(NOT CMAKE_UNITY_BUILD)
  target_compile_options(glint_options INTERFACE -Wshadow)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # In a unity build -Wshadow would also warn about names in other files' anonymous namespaces. -Wno-subobject-linkage: GCC warns
  # about a type that has a member from an anonymous namespace, unless the type is in the main file.
  target_compile_options(glint_options INTERFACE -Wshadow=local -Wno-subobject-linkage)
endif()

if(GLINT_SANITIZE)
  # _GLIBCXX_ASSERTIONS: the standard library checks every index.
  target_compile_definitions(glint_options INTERFACE GLINT_SANITIZED _GLIBCXX_ASSERTIONS)
  # -Wno-maybe-uninitialized: GCC gives false warnings about variables in the sanitizers' code.
  target_compile_options(glint_options INTERFACE -fsanitize=${GLINT_SANITIZE} -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # Undefined behaviour ends the program with SIGILL, which is twice as fast as calling a function that describes it;
  # ASAN_OPTIONS=handle_sigill=2 prints the stack.
  if(GLINT_SANITIZE MATCHES "undefined" AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(glint_options INTERFACE -fsanitize-trap=undefined -fno-sanitize-trap=vptr)
  endif()
  # -no-pie: relocating 800,000 addresses would take a quarter of a program's startup time.
  target_link_options(glint_options INTERFACE -fsanitize=${GLINT_SANITIZE} -no-pie)
endif()
if(GLINT_SANITIZE STREQUAL "thread")
  # Debian's oneTBB is not built with ThreadSanitizer: tests/threads/tbb/parallel_for.h replaces its loops.
  target_include_directories(glint_options BEFORE INTERFACE ${PROJECT_SOURCE_DIR}/tests/threads)
endif()

# lld links programs with sanitizers five times faster.
find_program(GLINT_LLD ld.lld)
if(GLINT_LLD AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_link_options(-fuse-ld=lld)
endif()

find_program(GLINT_CCACHE ccache)
if(GLINT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Lets different checkouts share compiled files.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${GLINT_CCACHE})
endif()

# In a unity build (CMAKE_UNITY_BUILD) the files of a folder are compiled as one unit, so names in anonymous namespaces must be unique
# within a folder.
function(unity_by_folder target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_filename_component(path ${source} ABSOLUTE)
    file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${path})
    get_filename_component(folder ${path} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
  endforeach()
endfunction()

# For code that mostly waits for files and for the user: with -O1, such code compiles in two thirds of the time.
function(compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
