#pragma once
// The nodes of a glTF file and the items that they refer to. Inside models/gltf/ only.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <string_view>

#include "models/gltf/gltf_document.h"

namespace glint {

/// The number of elements of a list at the root ("meshes"); 0 without such a list.
[[nodiscard]] std::size_t count_of(const Node& root, std::string_view list);

/// The index at an element of a list of nodes; the node need not exist.
[[nodiscard]] std::uint64_t node_number(const Node& at);

/// Reads the name of a node, a mesh or a light, up to the length limit of a scene's names.
void read_name(const Node& named, std::string& to);

/// The matrix from a node's own coordinates to its parent's. Fails if the specification forbids it: a matrix
/// together with T, R or S, a bottom row other than 0 0 0 1, a quaternion of length 0.
[[nodiscard]] glm::dmat4 local_of(const Node& node);

/// Calls f(Node) with the node's light, if the node names one. Fails if that light does not exist.
template <class F> void with_light(const Node& root, const Node& node, F f) {
    constexpr std::string_view extension = "KHR_lights_punctual";
    static const Json undeclared = Json::object();
    node.with("extensions", [&](const Node& extensions) {
        require_object(extensions);
        extensions.with(extension, [&](const Node& reference) {
            require_object(reference);
            bool is_declared = false;
            root.with("extensions", [&](const Node& all) {
                require_object(all);
                all.with(extension, [&](const Node& punctual) {
                    require_object(punctual);
                    is_declared = true;
                    follow(punctual, reference, "light", "lights", f);
                });
            });
            if (!is_declared) follow(Node(undeclared), reference, "light", "lights", f);
        });
    });
}

/// Checks every node, even if no scene reaches it: fails if local_of() fails, or if a node names a missing
/// child, mesh, camera or light.
void check_nodes(const Node& root);

}  // namespace glint
