#pragma once
// Counts what a scene cannot hold of a glTF file, and a glTF file of a scene. Inside models/gltf/ only.

#include <cstddef>

#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// How many things of each kind were met and left out.
struct GltfLeftOut {
    std::size_t textures = 0, blended = 0, skins = 0, animations = 0, morphs = 0, lines = 0, sparse = 0,
                colours = 0;
    std::size_t cameras = 0, sheared = 0, flat = 0, far = 0, lights = 0, ranges = 0;
};
/// Returns one warning, with its count, for each kind of object that was met.
[[nodiscard]] Warnings said_objects(const GltfLeftOut& left);
/// Returns one for each kind of anything, objects among them.
[[nodiscard]] Warnings said(const GltfLeftOut& left);

/// What glTF cannot say of a scene.
struct GltfUnsaid {
    bool frustum = false, mirroring = false, angle = false;  // of the camera
    std::size_t invisible = 0, empty = 0;                    // objects
    std::size_t materials = 0, bright = 0;
    std::size_t off = 0, areas = 0, falloffs = 0, cones = 0, ambients = 0, speculars = 0;  // lights
};
/// Returns one warning, with its count, for each kind, and for each that is of the scene as a whole.
[[nodiscard]] Warnings said(const GltfUnsaid& unsaid, const Scene& scene);

}  // namespace glint
