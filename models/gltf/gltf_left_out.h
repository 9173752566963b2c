#pragma once
// Counts the parts of a glTF file that a scene cannot hold. Inside models/gltf/ only.

#include <cstddef>

#include "models/problem.h"

namespace glint {

/// How many things of each kind were met and left out.
struct GltfLeftOut {
    std::size_t textures = 0, blended = 0, skins = 0, animations = 0, morphs = 0, lines = 0, sparse = 0,
                colours = 0;
    std::size_t cameras = 0, sheared = 0, flat = 0, lights = 0;
};
/// Appends one warning, with its count, for each kind that was met.
void say(const GltfLeftOut& left, Warnings& warnings);

}  // namespace glint
