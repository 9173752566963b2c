#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "models/scene_read.h"

namespace glint {
namespace {

constexpr Range cutoff_range{0, 90, "0 to 90, or 180", false, false, 180};

glm::vec4 divided(const std::vector<double>& p, double w, const Node& node) {
    glm::dvec3 place(p[0], p[1], p[2]);
    place /= w;
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(place[i]) <= largest_number))
            node.fail(fmt::format("divided by w it is {}", place[i]), std::string(any_number.words));
    return {place, 1};
}

/// Homogeneous: w = 0 is the direction towards the light, w > 0 a place. Three numbers have the w of the
/// kind.
glm::vec4 position_of(LightKind kind, const Node& node) {
    const std::vector<double> p = numbers(node, 3, 4);
    const bool direction = kind == LightKind::Directional;
    const double w = p.size() == 4 ? p[3] : (direction ? 0 : 1);
    if (direction ? w != 0 : !(w > 0)) {
        const char* const article = kind == LightKind::Area ? "an" : "a";
        node.fail(fmt::format("w is {}", w),
                  fmt::format("w {} 0 for {} {} light", direction ? '=' : '>', article, name_of(kind)));
    }
    if (!direction) return divided(p, w, node);
    const glm::vec3 towards(p[0], p[1], p[2]);
    if (towards == glm::vec3(0)) node.fail("a zero direction", "the direction towards the light");
    return {towards, 0};
}

Falloff read_falloff(const Node& node) {
    Falloff f;
    node.allow_keys({"constant", "linear", "quadratic"});
    read(node, "constant", f.constant, at_least_zero);
    read(node, "linear", f.linear, at_least_zero);
    read(node, "quadratic", f.quadratic, at_least_zero);
    if (f == Falloff{0, 0, 0}) node.fail("constant, linear and quadratic are all 0", "one of them above 0");
    return f;
}

SpotCone read_spot(const Node& node) {
    SpotCone spot;
    node.allow_keys({"direction", "cutoff_deg", "exponent"});
    node.with("direction", [&](const Node& at) {
        const std::vector<double> d = numbers(at, 3, 3);
        spot.direction = glm::vec3(d[0], d[1], d[2]);
        if (spot.direction == glm::vec3(0)) at.fail("a zero direction", "the direction of the cone's axis");
    });
    read(node, "cutoff_deg", spot.cutoff_deg, cutoff_range);
    read(node, "exponent", spot.exponent, at_least_zero);
    return spot;
}

int read_samples(const Node& node) {
    constexpr std::string_view squares = "1, 4, 9, 16, 25, 36, 49 or 64";
    if (!node.value().is_number()) node.wrong_type(std::string(squares));
    const double count = node.value().get<double>();
    for (int n = 1; n <= 8; ++n)
        if (count == n * n) return n * n;
    node.fail(fmt::format("{} samples", count), std::string(squares));
}

AreaShape read_area(const Node& node) {
    AreaShape area;
    node.allow_keys({"edge_u", "edge_v", "samples"});
    read(node, "edge_u", area.edge_u);
    read(node, "edge_v", area.edge_v);
    const glm::dvec3 u(area.edge_u), v(area.edge_v);
    const double size = glm::length(glm::cross(u, v));  // of a quarter
    if (size <= parallel_sine * glm::length(u) * glm::length(v) || static_cast<float>(size) == 0)
        node.fail("edge_u and edge_v span no area", "two edges that are neither zero nor parallel");
    node.with("samples", [&](const Node& at) { area.samples = read_samples(at); });
    return area;
}

}  // namespace

Light read_light(const Node& node) {
    Light light;
    node.allow_keys({"name", "type", "space", "position", "ambient", "diffuse", "specular", "intensity",
                     "enabled", "falloff", "spot", "area"});
    read(node, "name", light.name);
    read_enum(node, "type", light.kind);
    read_enum(node, "space", light.space);
    light.position.w = light.kind == LightKind::Directional ? 0.0f : 1.0f;
    node.with("position", [&](const Node& at) { light.position = position_of(light.kind, at); });
    read(node, "ambient", light.ambient, at_least_zero);
    read(node, "diffuse", light.diffuse, at_least_zero);
    read(node, "specular", light.specular, at_least_zero);
    read(node, "intensity", light.intensity, at_least_zero);
    read(node, "enabled", light.enabled);
    node.with("falloff", [&](const Node& at) { light.falloff = read_falloff(at); });
    node.with("spot", [&](const Node& at) { light.spot = read_spot(at); });
    node.with("area", [&](const Node& at) { light.area = read_area(at); });
    return light;
}

}  // namespace glint
