#pragma once
// A glTF file as a scene that can be looked at.

#include "models/gltf/gltf.h"

namespace glint {

struct GltfOpened {
    Scene scene;  // meshes loaded
    Warnings warnings;
};
/// Reads the file and adds what a picture needs: a camera that shows all objects and two default lights,
/// where the file has none; but a file of ours without lights is dark. Lights that are far too bright, as
/// candela and lux can be, are all divided by one factor, which a warning gives.
[[nodiscard]] Result<GltfOpened> open_gltf(const std::string& path);
/// Does the same with a file that was read already.
[[nodiscard]] Result<GltfOpened> open_gltf(const Result<GltfFile>& file, const std::string& path);

}  // namespace glint
