#pragma once
// The camera and the lights of a scene as glTF has them. Inside models/gltf/ only.

#include <string>

#include "models/gltf/gltf_buffer.h"
#include "models/gltf/gltf_left_out.h"

namespace glint {

/// An element of "cameras".
[[nodiscard]] GltfJson camera_json(const Projection& projection, GltfUnsaid& unsaid);
/// What places a node where the camera stands.
[[nodiscard]] GltfJson camera_matrix(const Camera& camera);

/// An element of "lights". Precondition: it is not an area light. Throws ProblemFound with `pointer`, the
/// light's, where its intensity is beyond what is read.
[[nodiscard]] GltfJson light_json(const Light& light, const Camera& camera, const std::string& pointer,
                                  GltfUnsaid& unsaid);
/// The node of light number `index`, in the light's space.
[[nodiscard]] GltfJson light_node(const Light& light, std::size_t index);

}  // namespace glint
