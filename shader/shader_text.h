#pragma once
// Reads the text of a user's lighting.glsl, prepares it for the compiler, and parses the compiler's messages.
// The contract of that file is in docs/shader.md.

#include <string>
#include <string_view>
#include <vector>

#include "models/problem.h"

namespace glint {

inline constexpr std::size_t max_shader_bytes = std::size_t{1} << 20;

/// Reads the file. Returns a problem if the file cannot be read, is too large or is not text.
[[nodiscard]] Result<std::string> read_shader(const std::string& path);

/// Prepares the text for the compiler without changing its line numbers: its `#version` is removed, and each
/// iteration of a loop evaluates loop_runs(), which ends the loop after max_loop_runs.
[[nodiscard]] std::string prepared_shader(std::string_view text);

/// A message from the compiler about a line of the user's file, counted from 1; 0 if it is about the entire
/// file.
struct ShaderMessage {
    bool is_error = true;
    int line = 0;
    std::string text;
    bool operator==(const ShaderMessage&) const = default;
};

/// The line numbers at which the code before and after the user's file starts; the user's file starts at line
/// 1. GLSL can also number source strings, but Mesa reports wrong numbers for expressions.
inline constexpr int first_line_before = 2'000'000, first_line_after = 3'000'000;

/// Parses a compiler's or linker's log in Mesa's, NVIDIA's or Intel's format. `lines`: the number of lines in
/// the user's file.
[[nodiscard]] std::vector<ShaderMessage> shader_messages(const std::string& log, int lines);

/// Converts a message to a problem with the file.
[[nodiscard]] Problem problem_from(const ShaderMessage& message, const std::string& file);

}  // namespace glint
