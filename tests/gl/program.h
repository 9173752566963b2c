#pragma once
// Shaders of the OpenGL programs that ours is compared with (the oracle) and timed against (llvmpipe).

#include <string>

namespace glint::test {

/// All of the file `path`, which is relative to the folder tests. Throws std::runtime_error when there is
/// none.
[[nodiscard]] std::string shader_text(const std::string& path);

/// A shader's whole source, and the name that an error calls it by.
struct ShaderSource {
    std::string name, text;
};
/// Compiles both and links them, in the current context. Throws std::runtime_error with the compiler's words.
[[nodiscard]] unsigned link_program(const ShaderSource& vertex, const ShaderSource& fragment);

}  // namespace glint::test
