#pragma once
// `--set /pointer=JSON`: assignments to a document before it is checked (docs/interface.md, "Command line").

#include <vector>

#include "models/json/json_reader.h"
#include "models/scene_file/scene_file.h"

namespace glint {

/// Applies all assignments in order. Missing parents are made: lists and the numbers of a vector where a
/// scene has them, else objects. A light's `type` set alone brings its own w, a projection's `type` drops the
/// keys of the other projections. Throws ProblemFound with file "--set".
void apply_assignments(Json& document, const std::vector<Assignment>& assignments);

/// True when an assignment sets the value at `pointer` or one around it.
[[nodiscard]] bool is_assigned(const std::string& pointer, const std::vector<Assignment>& assignments);

}  // namespace glint
