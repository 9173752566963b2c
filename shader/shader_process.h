#pragma once
// Draws with a user's lighting.glsl in a process of its own, because it may run forever, use up all memory or
// crash the driver.

#include <cstdint>
#include <string>

#include "models/io/child_process.h"
#include "shader/shader_canvas.h"

namespace glint {

struct ShaderAnswer {
    // NeverEnds: a loop was ended after max_loop_runs. Failed: OpenGL is missing, or the process crashed.
    enum class End { Drawn, NotCompiled, NeverEnds, TimedOut, Failed, Cancelled };
    End end = End::Failed;
    std::vector<ShaderMessage> messages;  // from the compiler
    std::string why;                      // the reason, unless Drawn or NotCompiled
    ShaderPicture picture;                // if Drawn
};

/// The argv[0] with which main() calls run_shader_worker().
inline constexpr const char* shader_worker_name = "glint-shader";

/// The memory limit for the driver, in addition to the scene: Mesa's compiler reserves much and uses little.
inline constexpr std::uint64_t shader_memory = std::uint64_t{4} << 30;

/// Compiles `text` from read_shader() and draws the scene. `limits.bytes` may be 0 for shader_memory.
/// Thread-safe.
[[nodiscard]] ShaderAnswer shade_in_process(const ShaderScene& scene, const std::string& text,
                                            ShaderOutput output, ChildLimits limits);

/// Returns the errors as problems with the file; empty if the scene was drawn.
[[nodiscard]] std::vector<Problem> problems_of(const ShaderAnswer& answer, const std::string& file);
/// Warnings about a drawn picture, and the compiler's warnings, one per line.
[[nodiscard]] Warnings warnings_of(const ShaderAnswer& answer, const std::string& file);

/// The worker process: reads a scene and a shader from standard input, and writes the answer to standard
/// output.
[[nodiscard]] int run_shader_worker();

}  // namespace glint
