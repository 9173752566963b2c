#pragma once
// Buffers of another renderer held against ours, from geometry to colour: the first that differs is where its
// mistake is made. Of vectors the transform is named that would repair them.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"
#include "renderer/inspect/debug_views/buffers.h"

namespace glint {

/// The names of the scene's buffers that are looked at, in the order in which a program makes them: all but
/// the numbers of faces.
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
    std::optional<BufferDifference> differs;  // the first
};

/// `given`: at least one of checked_buffers(), `linear` filled, all of one size; the scene is drawn at it,
/// right.
[[nodiscard]] BufferCheck check_buffers(const SceneDocument& document, const std::vector<PixelBuffer>& given,
                                        int threads);

/// For people, at most three lines; for programs.
[[nodiscard]] std::string check_text(const BufferCheck& check);
[[nodiscard]] std::string check_json(const BufferCheck& check);

}  // namespace glint
