#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "models/scene_read.h"

namespace glint {
namespace {

constexpr Range field_of_view{0, 180, "more than 0, less than 180", true, true};

void read_depth(const Node& node, float& near, float& far) {
    read(node, "near", near, above_zero);
    read(node, "far", far, above_zero);
    if (near < far) return;
    node.fail(fmt::format("near {} is not less than far {}", near, far), "0 < near < far");
}

Perspective read_perspective(const Node& node) {
    Perspective p;
    read(node, "fov_y_deg", p.fov_y_deg, field_of_view);
    read_depth(node, p.near, p.far);
    return p;
}

Orthographic read_orthographic(const Node& node) {
    Orthographic p;
    read(node, "height", p.height, above_zero);
    read_depth(node, p.near, p.far);
    return p;
}

Frustum read_frustum(const Node& node) {
    for (const std::string& key : projection_keys("frustum"))
        if (!node.has(key)) node.fail(fmt::format("\"{}\" is missing", key), "all six numbers of a frustum");
    Frustum p;
    read(node, "left", p.left);
    read(node, "right", p.right);
    read(node, "bottom", p.bottom);
    read(node, "top", p.top);
    if (p.left == p.right)
        node.fail(fmt::format("left and right are both {}", p.left), "two numbers that differ");
    if (p.bottom == p.top)
        node.fail(fmt::format("bottom and top are both {}", p.top), "two numbers that differ");
    read_depth(node, p.near, p.far);
    return p;
}

/// A key of another projection is known, but it would be without effect here.
void refuse_keys_of_others(const Node& node, const std::string& type) {
    const std::vector<std::string> keys = projection_keys(type);
    for (const char* other : {"perspective", "orthographic", "frustum"})
        for (const std::string& key : projection_keys(other)) {
            if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
            node.with(key, [&](const Node& at) {
                at.fail(fmt::format("no key of the projection \"{}\"", type), listed(keys));
            });
        }
}

Projection read_projection(const Node& node) {
    const std::vector<std::string> types{"perspective", "orthographic", "frustum"};
    std::string type = types.front();
    if (!node.value().is_object()) node.wrong_type("an object");
    node.with("type", [&](const Node& at) {
        type = text(at, listed(types));
        if (std::find(types.begin(), types.end(), type) == types.end())
            at.fail(in_quotes(type) + " is not known", listed(types));
    });
    refuse_keys_of_others(node, type);
    node.allow_keys(projection_keys(type));
    if (type == "frustum") return read_frustum(node);
    if (type == "orthographic") return read_orthographic(node);
    return read_perspective(node);
}

/// Without these two an orthonormal frame at the eye cannot be made (view_from_world).
void check_frame(const Camera& camera, const Node& node) {
    const glm::dvec3 back = glm::dvec3(camera.eye) - glm::dvec3(camera.target), up(camera.up);
    if (camera.eye == camera.target) node.fail("eye and target are the same point", "two points that differ");
    if (up == glm::dvec3(0)) node.fail("up is zero", "a direction");
    if (glm::length(glm::cross(up, back)) <= parallel_sine * glm::length(up) * glm::length(back))
        node.fail("up is parallel to the view direction",
                  "an up that is not along the line from eye to target");
}

}  // namespace

std::vector<std::string> projection_keys(std::string_view type) {
    if (type == "frustum") return {"type", "left", "right", "bottom", "top", "near", "far"};
    return {"type", type == "orthographic" ? "height" : "fov_y_deg", "near", "far"};
}

Camera read_camera(const Node& node) {
    Camera camera;
    node.allow_keys({"eye", "target", "up", "projection"});
    read(node, "eye", camera.eye);
    read(node, "target", camera.target);
    read(node, "up", camera.up);
    node.with("projection", [&](const Node& at) { camera.projection = read_projection(at); });
    check_frame(camera, node);
    return camera;
}

}  // namespace glint
