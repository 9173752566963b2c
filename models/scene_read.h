#pragma once
// The parts of reading a scene file, one a .cpp (docs/interface.md, "Scene file"). Each takes a node of the
// document and throws ProblemFound where it breaks a rule; a key that is not there keeps its default.

#include "models/json_node.h"
#include "models/scene.h"

namespace glint {

inline constexpr std::size_t max_lights = 4096;
inline constexpr std::size_t max_objects = 10'000;
/// Directions whose sine of the angle between them is below this count as parallel: a float keeps seven
/// digits.
inline constexpr double parallel_sine = 1e-6;

[[nodiscard]] Scene read_scene(const Node& node);

[[nodiscard]] Camera read_camera(const Node& node);
[[nodiscard]] Light read_light(const Node& node);
[[nodiscard]] Object read_object(const Node& node);
[[nodiscard]] Shading read_shading(const Node& node);
[[nodiscard]] Npr read_npr(const Node& node);
[[nodiscard]] Display read_display(const Node& node);

/// The keys of a projection of that type ("perspective", ...), `type` first.
[[nodiscard]] std::vector<std::string> projection_keys(std::string_view type);

}  // namespace glint
