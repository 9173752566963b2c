#pragma once
// Reads a scene from a JSON document, by its fields (models/fields/scene_fields.h), and applies assignments
// to the document first. Inside models/ only.

#include <optional>

#include "models/json/json.h"
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"

namespace glint {

/// The scene of a document of version 1. Throws ProblemFound, without a file, if it breaks a rule; a missing
/// key keeps its default.
[[nodiscard]] Scene read_scene(const Node& root);

/// The keys of a projection of that type, `type` first.
[[nodiscard]] std::vector<std::string> projection_keys(ProjectionKind kind);

/// A projection of that kind with its defaults.
[[nodiscard]] Projection default_projection(ProjectionKind kind);

// `--set /pointer=JSON`: assignments to a document before it is checked (docs/command_line.md, "Changing a
// scene").

/// Applies all assignments in order. Missing parents are created: lists and vectors where a scene has them,
/// otherwise objects. Setting only a light's `type` also sets the w of that type. Setting a projection's
/// `type` drops the keys of the other projections. Throws ProblemFound with file "--set".
void apply_assignments(Json& document, const std::vector<Assignment>& assignments);

/// The scene of a document under assignments. Returns the problem of `json`, or one as parse_scene() does.
[[nodiscard]] Result<Scene> scene_of(const Result<Json>& json, const std::string& file,
                                     const std::vector<Assignment>& assignments);

/// True if an assignment sets the value at `pointer` or one that contains it.
[[nodiscard]] bool is_assigned(const std::string& pointer, const std::vector<Assignment>& assignments);

}  // namespace glint
