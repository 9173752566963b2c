#pragma once
// One material, camera, light or transform of glTF as one of ours. Each throws ProblemFound with its pointer.
// Inside models/gltf/ only.

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>

#include "models/json/json_node.h"
#include "models/scene/scene.h"

namespace glint {

/// The matrix of a node, from its own coordinates to its parent's.
[[nodiscard]] glm::dmat4 local_of(const Node& node);
/// T R S of a matrix; nothing where an axis has no length. Sets `sheared` where its axes are not at right
/// angles, which T R S cannot say.
[[nodiscard]] std::optional<Transform> transform_of(const glm::dmat4& m, bool& sheared);

struct GltfMaterial {
    Material material;  // for cook-torrance, with a shininess whose highlight is as wide
    bool has_textures = false, is_transparent = false, is_double_sided = false;
};
/// Physically based metal and roughness. The material of a primitive that has none: that of an empty object.
[[nodiscard]] GltfMaterial material_of(const Node& node);

/// The other way: base colour and metal whose diffuse colour and f0 are the material's; nothing where no
/// metal has them.
struct GltfMetal {
    glm::vec3 base;
    float metal;  // 0 to 1
};
[[nodiscard]] std::optional<GltfMetal> metal_of(const Material& material);

/// A spot's cone as glTF's two, in radians: inside the inner one it is even, on the outer one dark. Alike:
/// read again it has the spot's exponent; no pair of cones has one that is very small or very large for its
/// cutoff, and such a spot becomes even up to its edge.
struct GltfCone {
    double inner, outer;
    bool is_alike;
};
[[nodiscard]] GltfCone cone_of(const SpotCone& cone);

/// Its target is one unit ahead. Infinitely far is 100,000 times as far as near.
[[nodiscard]] Camera camera_from(const Node& camera, const glm::dmat4& world_from_node);

/// `placed`: from the node's coordinates to those of `space`.
[[nodiscard]] Light light_from(const Node& light, const std::string& name, const glm::dmat4& placed,
                               LightSpace space);

}  // namespace glint
