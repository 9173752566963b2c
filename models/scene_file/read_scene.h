#pragma once
// A scene from a JSON document, by its fields (models/fields/scene_fields.h).

#include "models/json/json_node.h"
#include "models/scene/scene.h"

namespace glint {

/// The scene of a document of version 1. Throws ProblemFound, without a file, where it breaks a rule; a key
/// that is not there keeps its default.
[[nodiscard]] Scene read_scene(const Node& root);

/// The keys of a projection of that type, `type` first.
[[nodiscard]] std::vector<std::string> projection_keys(ProjectionKind kind);

/// A projection of that kind with its defaults.
[[nodiscard]] Projection default_projection(ProjectionKind kind);

}  // namespace glint
