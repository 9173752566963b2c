#pragma once
// Converts a material, camera, light or matrix of glTF to ours. Each function throws ProblemFound with its
// pointer. Inside models/gltf/ only.

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>

#include "models/json/json_node.h"
#include "models/problem.h"
#include "models/scene/scene.h"

namespace glint {

/// Whether an axis of the matrix has a length that a float cannot represent.
[[nodiscard]] bool is_flat(const glm::dmat4& m);
/// Splits a matrix into T R S. Returns nothing if it is flat or contains a number that a scene cannot
/// represent. Sets `sheared` if its axes are not at right angles, which T R S cannot express.
[[nodiscard]] std::optional<Transform> transform_of(const glm::dmat4& m, bool& sheared);

struct GltfMaterial {
    Material material;  // for cook-torrance; its shininess gives a Blinn highlight of the same width
    bool has_textures = false, is_transparent = false, is_double_sided = false;
    bool lacks_emission = false;  // its emissive texture is not read, so the factor is dropped too
};
/// Reads a metallic-roughness material; an unlit one (KHR_materials_unlit) emits its base colour. A primitive
/// without a material uses an empty JSON object.
[[nodiscard]] GltfMaterial material_of(const Node& node);

/// The inverse: the base colour and the metalness that give the material's diffuse colour and f0; nothing if
/// no such pair exists.
struct GltfMetal {
    glm::vec3 base;
    float metal;  // 0 to 1
};
[[nodiscard]] std::optional<GltfMetal> metal_of(const Material& material);

/// A spot's cone as glTF's two angles, in radians: brightness is constant within the inner one and 0 outside
/// the outer one. A spot with an exponent and a hard edge gets a soft edge with the same brightness half-way
/// between the cosines of its two angles, if such an edge exists.
struct GltfCone {
    double inner, outer;
};
[[nodiscard]] GltfCone cone_of(const SpotCone& cone);

struct GltfCamera {
    Camera camera;  // its target is close to the eye, straight ahead
    glm::dvec3 ahead;
    glm::dmat4 view_from_node;
};
/// Converts the camera of a node; an infinite far distance becomes 100,000 times near. Fails, with the node's
/// pointer, if a scene cannot represent the camera.
[[nodiscard]] GltfCamera camera_from(const Node& node, const Node& camera, const glm::dmat4& world_from_node);
/// A point at that distance from the eye, or farther if floats could not represent its direction.
[[nodiscard]] glm::vec3 target_of(const glm::vec3& eye, const glm::dvec3& ahead, double distance);

/// Converts a light. `placed` transforms the node's coordinates to those of `space`. Sets `has_bad_cone` if
/// the angles of a spot were clamped.
[[nodiscard]] Light light_from(const Node& light, const std::string& name, const glm::dmat4& placed,
                               LightSpace space, bool& has_bad_cone);

// Features of a glTF file that a scene cannot express, and vice versa.

/// Counts the items of each kind that were left out.
struct GltfLeftOut {
    std::size_t textures = 0, blended = 0, skins = 0, animations = 0, morphs = 0, lines = 0, sparse = 0,
                colours = 0, emissions = 0, instances = 0, cones = 0;
    std::size_t cameras = 0, sheared = 0, flat = 0, far = 0, lights = 0, ranges = 0;
};
/// Returns one warning, with its count, for each kind of missing object.
[[nodiscard]] Warnings said_objects(const GltfLeftOut& left);
/// Returns one warning for each kind, missing objects included.
[[nodiscard]] Warnings said(const GltfLeftOut& left);

/// Features of a scene that glTF cannot express.
struct GltfUnsaid {
    bool frustum = false, mirroring = false, angle = false;  // of the camera
    std::size_t invisible = 0, empty = 0, colours = 0;       // objects
    std::size_t materials = 0, bright = 0;
    std::size_t off = 0, areas = 0, falloffs = 0, cones = 0, ambients = 0, speculars = 0;  // lights
};
/// Returns one warning, with its count, for each kind, and one for each lost feature of the scene itself.
[[nodiscard]] Warnings said(const GltfUnsaid& unsaid, const Scene& scene);

}  // namespace glint
