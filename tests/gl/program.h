#pragma once
// Shaders of the OpenGL programs that Glint is compared with (the oracle) and timed against (llvmpipe).

#include <string>

namespace glint::test {

/// The contents of the file `path`, relative to the tests folder. Throws std::runtime_error if it cannot be
/// read.
[[nodiscard]] std::string shader_text(const std::string& path);

/// A shader's complete source, and its name in error messages.
struct ShaderSource {
    std::string name, text;
};
/// Compiles the two shaders and links them, in the current context. Throws std::runtime_error with the
/// compiler's message.
[[nodiscard]] unsigned link_program(const ShaderSource& vertex, const ShaderSource& fragment);

}  // namespace glint::test
