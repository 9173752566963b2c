#pragma once
// Finds the properties of a scene that decide which lines its program has. A language may lack some of them:
// each such property is one row, and a language has it where its text mentions the row's flag.

#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "programs/template.h"

namespace glint {

/// Something that a scene asks of a program.
struct Need {
    std::string flag, pointer, what;  // what: "Phong shading lights each pixel"
};

/// The enabled lights and the visible objects, which are all that a program draws. A spot without a cone is a
/// point light.
[[nodiscard]] std::vector<Light> shining(const Scene& scene);
[[nodiscard]] std::vector<Object> shown(const Scene& scene);

/// All needs of the scene.
[[nodiscard]] std::vector<Need> needs_of(const Scene& scene);

/// The needs' flags, and those that follow from the scene and that every language knows.
[[nodiscard]] Flags flags_of(const Scene& scene);

}  // namespace glint
