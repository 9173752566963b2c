#pragma once
// A user's lighting.glsl as text: reading it, preparing it for the compiler, and the compiler's messages
// about it. Contract of the file: docs/shader.md.

#include <string>
#include <string_view>
#include <vector>

#include "models/problem.h"

namespace glint {

inline constexpr std::size_t max_shader_bytes = std::size_t{1} << 20;

/// The text of the file. Problem: it cannot be read, is too large or is not text.
[[nodiscard]] Result<std::string> read_shader(const std::string& path);

/// The text with the same lines for the compiler: its `#version` is removed, and each iteration of a loop
/// evaluates loop_runs(), which ends the loop after max_loop_runs.
[[nodiscard]] std::string prepared_shader(std::string_view text);

/// A message of the compiler about a line of the user's file, from 1; 0 if it is about the file as a whole.
struct ShaderMessage {
    bool is_error = true;
    int line = 0;
    std::string text;
    bool operator==(const ShaderMessage&) const = default;
};

/// The numbers of the first lines of the texts before and after the user's file, which begins with 1. GLSL
/// also has numbers for source strings, but Mesa reports wrong ones for expressions.
inline constexpr int first_line_before = 2'000'000, first_line_after = 3'000'000;

/// The messages of a compiler's or linker's log, in Mesa's, NVIDIA's or Intel's form. `lines`: of the user's
/// file.
[[nodiscard]] std::vector<ShaderMessage> shader_messages(const std::string& log, int lines);

/// A message as a problem of the file.
[[nodiscard]] Problem problem_from(const ShaderMessage& message, const std::string& file);

}  // namespace glint
