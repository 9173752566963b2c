# What every target of ours is compiled with.
add_library(glint_options INTERFACE)
# -ffp-contract=off: a product and a sum are never fused behind our back, so that a picture has the same bytes
# on every instruction set and an explanation equals its pixel to the last bit (docs/architecture.md).
target_compile_options(glint_options INTERFACE -Wall -Wextra -Wconversion -Wshadow -Wswitch -ffp-contract=off)
target_include_directories(glint_options INTERFACE ${PROJECT_SOURCE_DIR})
if(GLINT_WERROR)
  target_compile_options(glint_options INTERFACE -Werror)
endif()
if(GLINT_SANITIZE)
  target_compile_options(glint_options INTERFACE -fsanitize=${GLINT_SANITIZE} -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer)
  target_link_options(glint_options INTERFACE -fsanitize=${GLINT_SANITIZE})
endif()
# Under the sanitizers (build type Debug) most of the time goes into compiling. What draws is optimised all the same, the
# command line and the window are not: they wait for JSON and for people.
function(compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Debug>:-O0>)
endfunction()

find_program(GLINT_CCACHE ccache)
if(GLINT_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${GLINT_CCACHE})
endif()
