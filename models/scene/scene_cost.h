#pragma once
// Estimates the memory of a scene and its picture. The estimate is compared with the limit before drawing.

#include <cstdint>
#include <optional>

#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// The limit of samples in a picture: its pixels times the samples per pixel.
inline constexpr std::uint64_t max_picture_samples = std::uint64_t{1} << 30;

/// The bytes used by a mesh's lists.
[[nodiscard]] std::uint64_t mesh_bytes(const Mesh& mesh);

/// Estimated bytes. Objects without a loaded mesh count as empty.
struct SceneCost {
    std::uint64_t meshes = 0;   // each counted once
    std::uint64_t objects = 0;  // transformed vertices, normals, triangles in tiles and for rays
    std::uint64_t picture = 0;
};
[[nodiscard]] SceneCost scene_cost(const Scene& scene, PictureSize size, int samples);
/// The problem with a cost above memory_limit().
[[nodiscard]] std::optional<Problem> too_much_memory(const SceneCost& cost);

/// The problem with a scene that has too many triangles or samples, or that needs more memory than
/// memory_limit(). Without `size`, checks only the scene.
[[nodiscard]] std::optional<Problem> too_large(const Scene& scene, PictureSize size = {0, 0},
                                               int samples = 1);

}  // namespace glint
