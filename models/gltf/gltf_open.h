#pragma once
// A glTF file as a scene that can be looked at.

#include "models/gltf/gltf.h"

namespace glint {

struct GltfOpened {
    Scene scene;  // meshes loaded
    Warnings warnings;
};
/// What the file has, and what a picture needs besides: a camera that shows all where it has none, two
/// default lights where it has none. Lights that are far too bright, as candela and lux are, become darker by
/// one factor for all, which a warning says.
[[nodiscard]] Result<GltfOpened> open_gltf(const std::string& path);

}  // namespace glint
