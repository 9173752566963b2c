#pragma once
// The parts shared by all glTF readers: the document, its checked members, and the numbers of an accessor.
// Errors are thrown as ProblemFound with their pointer. Inside models/gltf/ only.

#include <fmt/core.h>

#include <compare>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/json/json_node.h"

namespace glint {

/// OpenGL's constants for component types.
inline constexpr int gltf_unsigned_byte = 5121, gltf_unsigned_short = 5123, gltf_unsigned_int = 5125,
                     gltf_floats = 5126;

/// The numbers of an accessor, read as floats: normalized integers become 0 to 1, or -1 to 1 if signed. Equal
/// keys mean equal numbers, even from different accessors.
struct GltfNumbers {
    std::size_t count = 0, components = 0;
    int type = 0;  // OpenGL's constant for the component type: gltf_floats, ...
    bool normalized = false;
    const char* data = nullptr;
    std::size_t stride = 0;

    [[nodiscard]] double at(std::size_t i, std::size_t component) const;
    [[nodiscard]] glm::vec3 vector_at(std::size_t i) const;
    /// Returns the size of the numbers alone, without the gaps between elements.
    [[nodiscard]] std::uint64_t bytes() const;
    auto operator<=>(const GltfNumbers&) const = default;
};

/// The numbers of the positions and of the normals; the second is empty if there are none.
using GltfVertexKey = std::pair<GltfNumbers, GltfNumbers>;
/// The vertices of a key; those at the same point share a position.
struct GltfVertices {
    std::vector<glm::vec3> places, normals;
    std::vector<std::uint32_t> place_of;  // for each vertex, an index into `places`
};

struct GltfDocument {
    GltfDocument() noexcept(false) = default;    // maps and JSON may allocate
    GltfDocument(const GltfDocument&) = delete;  // its buffers point into it
    GltfDocument& operator=(const GltfDocument&) = delete;

    std::string path;
    std::string bytes;             // the bytes of the file
    std::vector<std::string> own;  // the contents of buffers in other files and data URIs
    std::vector<std::string_view> buffers;
    Json root;
    std::vector<std::string> warnings;  // about the container
    bool is_quantized = false;          // the file names KHR_mesh_quantization
    // Entry i is the number of the first primitive of mesh i, counted across all meshes; the last entry is
    // the total.
    std::vector<std::size_t> first_parts;
    // Vertices used by several primitives are read once, for the first of them. Not thread-safe.
    std::set<GltfVertexKey> shared_vertices;
    mutable std::map<GltfVertexKey, GltfVertices> kept_vertices;
};

/// Returns the whole number at a key, from 0 to `most`, or `otherwise` if the key is missing. Fails for any
/// other value, and for a missing key if `otherwise` is negative.
[[nodiscard]] std::uint64_t whole(const Node& object, std::string_view key, double most,
                                  double otherwise = -1);

/// Fails unless the value is an object.
void require_object(const Node& node);

/// Calls f(Node) with an element of a list at the root ("meshes"). Its index is at `key` of `from`. Fails if
/// the element does not exist.
template <class F>
void follow(const Node& root, const Node& from, std::string_view key, std::string_view list, F f) {
    const Json& lists = root.value();
    const std::size_t count = lists.contains(list) && lists[list].is_array() ? lists[list].size() : 0;
    const std::uint64_t index = whole(from, key, 4294967295.0);
    if (index >= count)
        from.with(key, [&](const Node& at) {
            at.fail(fmt::format("{} of \"{}\" is not there", index, list),
                    count == 0 ? "no number: the list is empty" : fmt::format("0 to {}", count - 1));
        });
    root.with(list, [&](const Node& all) { f(Node(all.value()[index], all, index)); });
}

/// Returns whether an object has an extension.
[[nodiscard]] bool has_extension(const Node& object, std::string_view name);

/// Returns the accessor whose index is at `key` of `from`; its numbers are within its buffer view. Fails if
/// it is not of that `type` ("VEC3"), or has no buffer view.
[[nodiscard]] GltfNumbers numbers_of(const GltfDocument& document, const Node& root, const Node& from,
                                     std::string_view key, std::string_view type);
/// Returns the numbers of a primitive's vertices. Fails like numbers_of().
[[nodiscard]] GltfVertexKey vertex_key_of(const GltfDocument& document, const Node& root,
                                          const Node& attributes);
[[nodiscard]] bool is_sparse(const Node& root, const Node& from, std::string_view key);

/// How vertices form triangles; None: they form none.
enum class PrimitiveMode { None, Triangles, Strip, Fan };
/// Precondition: the primitive is an object.
[[nodiscard]] PrimitiveMode mode_of(const Node& primitive);

}  // namespace glint
