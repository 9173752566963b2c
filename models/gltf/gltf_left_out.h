#pragma once
// What of a glTF file a scene has no place for. Inside models/gltf/ only.

#include <cstddef>

#include "models/problem.h"

namespace glint {

/// What is met and left out, one line a kind.
struct GltfLeftOut {
    std::size_t textures = 0, blended = 0, skins = 0, animations = 0, morphs = 0, lines = 0, sparse = 0,
                colours = 0;
    std::size_t cameras = 0, sheared = 0, flat = 0, lights = 0;
};
/// Appends one line a kind that there is, with its count.
void say(const GltfLeftOut& left, Warnings& warnings);

}  // namespace glint
