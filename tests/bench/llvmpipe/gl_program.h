#pragma once
// Compiles the shaders of this folder.

#include <string>

namespace glint::bench {

/// Compiles and links a program. Prepends `head` to every shader, and "light.glsl" if `with_light`. Throws
/// std::runtime_error with the compiler's message.
struct ProgramText {
    std::string vertex, fragment;  // file names
    std::string head;
    bool light_in_vertex = false, light_in_fragment = false;
};
[[nodiscard]] unsigned make_program(const ProgramText& text);

}  // namespace glint::bench
