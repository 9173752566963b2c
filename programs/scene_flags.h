#pragma once
// Finds the properties of a scene that determine the lines of its program. A language may lack some of them:
// each such property is one row, and a language supports it if its text mentions the row's flag.

#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "programs/template.h"

namespace glint {

/// A feature that a scene needs from a program.
struct Need {
    std::string flag, pointer, what;  // what: "Phong shading lights each pixel"
};

/// Only the enabled lights and the visible objects, which a program draws. A spot without a cone becomes a
/// point light.
[[nodiscard]] std::vector<Light> shining(const Scene& scene);
[[nodiscard]] std::vector<Object> shown(const Scene& scene);

/// All needs of the scene.
[[nodiscard]] std::vector<Need> needs_of(const Scene& scene);

/// The needs' flags, and flags of the scene that every language supports.
[[nodiscard]] Flags flags_of(const Scene& scene);

}  // namespace glint
