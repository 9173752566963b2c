#pragma once
// Compares the buffers of another renderer with ours, from geometry to colour: the first one that differs
// shows where the mistake is made. For vectors, it names the transform that would repair them.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"
#include "renderer/debug_views/buffers.h"

namespace glint {

/// The names of the scene's buffers that are compared, in the order in which a program computes them: all but
/// `face`.
[[nodiscard]] std::vector<std::string> checked_buffers(const Scene& scene);

struct BufferDifference {
    std::string name;
    double share = 0;     // of the comparable pixels that differ, 0 to 1
    glm::ivec2 pixel{0};  // where it differs most
    glm::vec3 mine{0}, ours{0};
    std::string found;  // "world coordinates": what the numbers are, in words; empty where nothing fits
};

struct BufferCheck {
    PictureSize size;
    std::size_t compared = 0;                 // pixels; where there is none nothing is said of the buffers
    std::vector<std::string> agree;           // those before the first that differs
    std::vector<std::string> conventions;     // what the program does differently and is not a mistake
    std::optional<BufferDifference> differs;  // the first
};

/// Draws the scene without mistakes at the size of the given buffers and compares. `given`: at least one of
/// checked_buffers(), `linear` filled, all of one size. `in_world`: their vectors are in world coordinates.
[[nodiscard]] BufferCheck check_buffers(const SceneDocument& document, const std::vector<PixelBuffer>& given,
                                        int threads, bool in_world = false);

/// The result as text, and as JSON.
[[nodiscard]] std::string check_text(const BufferCheck& check);
[[nodiscard]] std::string check_json(const BufferCheck& check);

}  // namespace glint
