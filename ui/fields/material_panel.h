#pragma once
// What a surface does with light.

#include <string>

#include "models/scene/material.h"
#include "models/scene/scene.h"

namespace glint {

/// Edits the material and says whether it did. `pointer`: "/objects/0/material". Numbers that `reflection`
/// does not use are dimmed.
[[nodiscard]] bool material_panel(Material& material, const std::string& pointer, Reflection reflection);

/// Gives the material a preset's ambient, diffuse, specular and shininess; the rest stays.
void apply(const MaterialPreset& preset, Material& material);

}  // namespace glint
