#pragma once
// Parts of the .glb writer: the binary chunk, cameras and lights. Inside models/gltf/ only.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/gltf/gltf_items.h"
#include "models/json/json.h"
#include "models/scene/scene.h"

namespace glint {

[[nodiscard]] Json numbers_json(const glm::vec3& v);

/// Builds a .glb file from its two chunks, which are below 4 GiB in total.
[[nodiscard]] std::string glb_container(std::string_view json, std::string_view bin);

/// Identifies the stored data of an object's mesh: objects with equal keys share it.
using GltfMeshKey = std::pair<NormalsKey, bool>;  // and NormalOptions::flip
[[nodiscard]] GltfMeshKey mesh_key(const Object& object);

/// Collects the data of meshes, with the buffer views and accessors that locate it.
class GltfBuffer {
  public:
    /// Adds the object's mesh with the normals used to draw it (`flip` reverses them). Returns the accessors
    /// as the members "attributes" and "indices" of a primitive. Precondition: the object's mesh is loaded.
    [[nodiscard]] Json add(const Object& object);
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] const Json& views() const { return views_; }
    [[nodiscard]] const Json& accessors() const { return accessors_; }

  private:
    int add_vectors(const std::vector<glm::vec3>& vectors, bool with_bounds);
    int add_indices(const std::vector<std::uint32_t>& indices);
    int add_view(std::size_t begin, int target);

    std::string bytes_;
    Json views_ = Json::array(), accessors_ = Json::array();
};

// The camera and lights of a scene, converted to glTF.

/// An element of "cameras".
[[nodiscard]] Json camera_json(const Projection& projection, GltfUnsaid& unsaid);
/// The members that place a node at the camera.
[[nodiscard]] Json camera_matrix(const Camera& camera);

/// An element of "lights". Precondition: it is not an area light. Throws ProblemFound with `pointer` (the
/// light's pointer) if its intensity exceeds the reader's limit.
[[nodiscard]] Json light_json(const Light& light, const Camera& camera, const std::string& pointer,
                              GltfUnsaid& unsaid);
/// The node of light number `index`, in the light's space.
[[nodiscard]] Json light_node(const Light& light, std::size_t index);

}  // namespace glint
