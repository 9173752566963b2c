#include "models/gltf/gltf_nodes.h"

#include <fmt/core.h>

#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "models/json/json_node.h"
#include "models/scene/scene.h"

namespace glint {

std::size_t count_of(const Node& root, std::string_view list) {
    const Json& all = root.value();
    return all.contains(list) && all[list].is_array() ? all[list].size() : 0;
}

std::uint64_t node_number(const Node& at) {
    const double x = at.value().is_number() ? at.value().get<double>() : -1;
    if (!(x >= 0 && x <= 4294967295.0) || x != std::floor(x))
        at.fail("it is not the number of a node", "a whole number");
    return static_cast<std::uint64_t>(x);
}

void read_name(const Node& named, std::string& to) { read(named, "name", to, max_name_characters); }

glm::dmat4 local_of(const Node& node) {
    glm::dmat4 m(1);
    if (node.has("matrix")) {
        node.with("matrix", [&](const Node& at) {
            const std::vector<double> all = numbers(at, 16, 16);
            for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = all[static_cast<std::size_t>(i)];
            if (glm::row(m, 3) != glm::dvec4(0, 0, 0, 1))
                at.fail(fmt::format("its bottom row is {} {} {} {}", m[0][3], m[1][3], m[2][3], m[3][3]),
                        "0 0 0 1");
        });
        for (const char* other : {"translation", "rotation", "scale"})
            if (node.has(other)) node.fail(fmt::format("it has a matrix and a {}", other), "a matrix alone");
        return m;
    }
    node.with("scale", [&](const Node& at) {
        const std::vector<double> s = numbers(at, 3, 3);
        for (int i = 0; i < 3; ++i) m[i] *= s[static_cast<std::size_t>(i)];
    });
    node.with("rotation", [&](const Node& at) {
        const std::vector<double> q = numbers(at, 4, 4);
        const glm::dquat turn(q[3], q[0], q[1], q[2]);
        if (!(glm::dot(turn, turn) > 0)) at.fail("the quaternion is zero", "a quaternion of length 1");
        m = glm::mat4_cast(glm::normalize(turn)) * m;
    });
    node.with("translation", [&](const Node& at) {
        const std::vector<double> t = numbers(at, 3, 3);
        m[3] = glm::dvec4(t[0], t[1], t[2], 1);
    });
    return m;
}

void check_nodes(const Node& root) {
    const auto nothing = [](const Node&) {};
    root.with("nodes", [&](const Node& nodes) {
        nodes.each(max_json_values, "nodes", [&](const Node& node) {
            require_object(node);
            (void)local_of(node);
            if (node.has("mesh")) follow(root, node, "mesh", "meshes", nothing);
            if (node.has("camera")) follow(root, node, "camera", "cameras", nothing);
            with_light(root, node, nothing);
            node.with("children", [&](const Node& children) {
                children.each(max_json_values, "numbers of nodes", [&](const Node& at) {
                    const std::uint64_t i = node_number(at);
                    if (i >= nodes.value().size())
                        at.fail(fmt::format("node {} is not there", i),
                                fmt::format("0 to {}", nodes.value().size() - 1));
                });
            });
        });
    });
}

}  // namespace glint
