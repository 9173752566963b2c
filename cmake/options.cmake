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
find_program(GLINT_CCACHE ccache)
if(GLINT_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${GLINT_CCACHE})
endif()
