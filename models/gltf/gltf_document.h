#pragma once
// The parts shared by all glTF readers: the document, its checked members, and the numbers of an accessor.
// Errors are thrown as ProblemFound with their pointer. Internal to models/gltf/.

#include <fmt/core.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/json/json.h"
#include "models/problem.h"
#include "models/scene/scene.h"

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

/// The numbers of the positions and of the normals; the second is empty if there are no normals.
using GltfVertexKey = std::pair<GltfNumbers, GltfNumbers>;
/// The vertices with this key; vertices at the same point share a position.
struct GltfVertices {
    std::vector<glm::vec3> places, normals;
    std::vector<std::uint32_t> place_of;  // for each vertex, an index into `places`
};

struct GltfDocument {
    GltfDocument() noexcept(false) = default;    // maps and JSON may allocate
    GltfDocument(const GltfDocument&) = delete;  // `buffers` points into this object
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
/// Calls f(Node) with the object at a key, if the key exists. Fails for any other value.
template <class F> void with_object(const Node& node, std::string_view key, F f) {
    node.with(key, [&f](const Node& at) {
        require_object(at);
        f(at);
    });
}

/// Calls f(Node) with an element of a list at the root ("meshes"). Its index is at `key` in `from`. Fails if
/// the element does not exist.
template <class F>
void follow(const Node& root, const Node& from, std::string_view key, std::string_view list, F f) {
    const Json& lists = root.value();
    const std::size_t count = lists.contains(list) && lists[list].is_array() ? lists[list].size() : 0;
    const std::uint64_t index = whole(from, key, 4294967295.0);
    if (index >= count)
        from.with(key, [&](const Node& at) {
            at.fail(fmt::format("element {} of \"{}\" does not exist", index, list),
                    count == 0 ? "no number: the list is empty" : fmt::format("0 to {}", count - 1));
        });
    root.with(list, [&](const Node& all) { f(Node(all.value()[index], all, index)); });
}

/// Returns whether an object has an extension.
[[nodiscard]] bool has_extension(const Node& object, std::string_view name);

/// Returns the accessor whose index is at `key` in `from`; its numbers are within its buffer view. Fails if
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

// Converts a glTF material, camera, light or matrix to ours. Each function throws ProblemFound with its
// pointer. Internal to models/gltf/.

/// Whether an axis of the matrix has a length that a float cannot represent.
[[nodiscard]] bool is_flat(const glm::dmat4& m);
/// Splits a matrix into T R S. Returns nullopt if it is flat or contains a number that a scene cannot
/// represent. Sets `sheared` if its axes are not at right angles, which T R S cannot express.
[[nodiscard]] std::optional<Transform> transform_of(const glm::dmat4& m, bool& sheared);

struct GltfMaterial {
    Material material;  // for cook-torrance; its shininess gives a Blinn highlight of the same width
    bool has_textures = false, is_transparent = false, is_double_sided = false;
    bool lacks_emission = false;            // its emissive texture is not read, so the factor is dropped too
    std::vector<std::string_view> effects;  // names of its extensions that are not read
};
/// Reads a metallic-roughness material; an unlit one (KHR_materials_unlit) emits its base colour. A primitive
/// without a material uses an empty JSON object.
[[nodiscard]] GltfMaterial material_of(const Node& node);

/// The reflectance of a material that is not metal, with an index of refraction of 1.5.
constexpr float usual_f0 = 0.04f;
/// The fraction of the light that is not reflected at its surface and so reaches the diffuse layer below it.
constexpr float not_reflected = 1 - usual_f0;

/// A spot's cone as glTF's two angles, in radians: brightness is constant within the inner one and 0 outside
/// the outer one. A spot with an exponent and a hard edge gets a soft edge with the same brightness halfway
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
/// A point at that distance from the eye, or farther if floats could not represent the direction at that
/// distance.
[[nodiscard]] glm::vec3 target_of(const glm::vec3& eye, const glm::dvec3& ahead, double distance);

/// Converts a light. `placed` transforms the node's coordinates to those of `space`. Sets `has_bad_cone` if
/// the angles of a spot were clamped.
[[nodiscard]] Light light_from(const Node& light, const std::string& name, const glm::dmat4& placed,
                               LightSpace space, bool& has_bad_cone);

/// Builds a .glb file from its two chunks, which are below 4 GiB in total.
[[nodiscard]] std::string glb_container(std::string_view json, std::string_view bin);

// The nodes of a glTF file and the items that they refer to. Internal to models/gltf/.

/// The number of elements of a list at the root ("meshes"); 0 without such a list.
[[nodiscard]] std::size_t count_of(const Node& root, std::string_view list);

/// The node index stored at `at`, an element of a list of nodes; the node need not exist.
[[nodiscard]] std::uint64_t node_number(const Node& at);

/// Reads the name of a node, a mesh or a light, up to the length limit on a scene's names.
void read_name(const Node& named, std::string& to);

/// The matrix from a node's own coordinates to its parent's. Fails if the specification forbids it: a matrix
/// together with T, R or S, a bottom row other than 0 0 0 1, a quaternion of length 0.
[[nodiscard]] glm::dmat4 local_of(const Node& node);

/// Calls f(Node) with the node's light, if the node names one. Fails if that light does not exist.
template <class F> void with_light(const Node& root, const Node& node, F f) {
    constexpr std::string_view extension = "KHR_lights_punctual";
    static const Json undeclared = Json::object();
    with_object(node, "extensions", [&](const Node& extensions) {
        with_object(extensions, extension, [&](const Node& reference) {
            bool is_declared = false;
            with_object(root, "extensions", [&](const Node& all) {
                with_object(all, extension, [&](const Node& punctual) {
                    is_declared = true;
                    follow(punctual, reference, "light", "lights", f);
                });
            });
            if (!is_declared) follow(Node(undeclared), reference, "light", "lights", f);
        });
    });
}

/// Checks every node, even one that no scene reaches: fails if local_of() fails, or if a node names a missing
/// child, mesh, camera or light.
void check_nodes(const Node& root);

}  // namespace glint
