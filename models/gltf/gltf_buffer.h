#pragma once
// The binary chunk of a .glb, as it is put together. Inside models/gltf/ only.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/memory_limit.h"
#include "models/scene/scene.h"

namespace glint {

using GltfJson = nlohmann::ordered_json;

/// A float as a person would write it: 0.1.
[[nodiscard]] GltfJson number_json(float x);
[[nodiscard]] GltfJson numbers_json(const glm::vec3& v);

/// A .glb file of its two chunks; together below 4 GiB.
[[nodiscard]] std::string glb_container(std::string_view json, std::string_view bin);

/// Identifies the numbers of an object's mesh in the file: objects with equal keys share them.
using GltfMeshKey = std::pair<NormalsKey, bool>;  // and NormalOptions::flip
[[nodiscard]] GltfMeshKey mesh_key(const Object& object);

/// Collects the numbers of meshes, with the buffer views and accessors that say where they lie.
class GltfBuffer {
  public:
    /// Adds the object's mesh with the normals that it is drawn with (`flip` reverses them). Returns the
    /// accessors as the members "attributes" and "indices" of a primitive. Throws Refused where there is no
    /// memory for the numbers or for the file that they go into. Precondition: the object's mesh is loaded.
    [[nodiscard]] GltfJson add(const Object& object);
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] const GltfJson& views() const { return views_; }
    [[nodiscard]] const GltfJson& accessors() const { return accessors_; }

  private:
    int add_vectors(const std::vector<glm::vec3>& vectors, bool with_bounds);
    int add_indices(const std::vector<std::uint32_t>& indices);
    int add_view(std::size_t begin, int target);

    std::string bytes_;
    MemoryShare share_;  // of bytes_, and of the file that holds them, too
    GltfJson views_ = GltfJson::array(), accessors_ = GltfJson::array();
};

}  // namespace glint
