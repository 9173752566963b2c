#pragma once
// Shaders from the files of this folder.

#include <string>

namespace glint::bench {

/// Compiles and links; `head` is put in front of every text, "light.glsl" where `with_light` says so. Throws
/// std::runtime_error with the compiler's words.
struct ProgramText {
    std::string vertex, fragment;  // file names
    std::string head;
    bool light_in_vertex = false, light_in_fragment = false;
};
[[nodiscard]] unsigned make_program(const ProgramText& text);

}  // namespace glint::bench
