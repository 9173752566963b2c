#pragma once
// The nodes of a glTF file, and what they name. Inside models/gltf/ only.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <string_view>

#include "models/gltf/gltf_document.h"

namespace glint {

/// How many elements a list at the root ("meshes") has; 0 where there is none.
[[nodiscard]] std::size_t count_of(const Node& root, std::string_view list);

/// The number that an element of a list of nodes holds; it may be of no node.
[[nodiscard]] std::uint64_t node_number(const Node& at);

/// Reads what the file calls a node, a mesh or a light, of as many characters as a scene's names may have.
void read_name(const Node& named, std::string& to);

/// The matrix of a node, from its own coordinates to its parent's. Fails for what the specification forbids:
/// a matrix beside T, R or S, another bottom row than 0 0 0 1, a quaternion of length 0.
[[nodiscard]] glm::dmat4 local_of(const Node& node);

/// Calls f(Node) with the light that the node names, if it names one. Fails where there is no such light.
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

/// Checks every node, whether a scene reaches it or not: fails where local_of() fails, or where a node names
/// a child, a mesh, a camera or a light that is not there.
void check_nodes(const Node& root);

}  // namespace glint
