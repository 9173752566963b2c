#include "models/fields/scene_rules.h"

#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <utility>

#include "models/fields/scene_fields.h"

namespace glint {
namespace {

std::optional<Problem> violation_of(const Projection& projection) {
    const float near = near_of(projection), far = far_of(projection);
    if (const auto* f = std::get_if<Frustum>(&projection)) {
        if (f->left == f->right)
            return Problem{"", "", fmt::format("left and right are both {}", f->left),
                           "two numbers that differ"};
        if (f->bottom == f->top)
            return Problem{"", "", fmt::format("bottom and top are both {}", f->top),
                           "two numbers that differ"};
    }
    if (!(near < far))
        return Problem{"", "", fmt::format("near {} is not less than far {}", near, far), "0 < near < far"};
    return std::nullopt;
}

/// Returns nothing if edge_u and edge_v span a parallelogram whose area a float can represent.
std::optional<Problem> violation_of(const AreaShape& area) {
    const glm::dvec3 u(area.edge_u), v(area.edge_v);
    const double quarter = glm::length(glm::cross(u, v));
    if (quarter > parallel_sine * glm::length(u) * glm::length(v) && static_cast<float>(quarter) != 0)
        return std::nullopt;
    return Problem{"", "", "edge_u and edge_v span no area", "two edges that are neither zero nor parallel"};
}

std::optional<Problem> below(std::string at, std::optional<Problem> violation) {
    if (violation) violation->pointer = std::move(at) + violation->pointer;
    return violation;
}

/// Finds the first number of a struct, nested structs included, that its kind does not allow. Skips lists.
class RangeSearch {
  public:
    template <class T> static std::optional<Problem> in(const T& value) {
        std::optional<Problem> found;
        fields(value, [&found](const Row& row, const auto& kind, const auto& member) {
            if (found) return;
            found = at(kind, member);
            if (found) found->pointer = fmt::format("/{}{}", row.key, found->pointer);
        });
        return found;
    }

  private:
    using Found = std::optional<Problem>;

    static Found at(const Real& kind, float x) {
        if (kind.range.contains(x)) return {};
        return out_of_range(x, std::string(kind.range.words));
    }
    static Found at(const Count& kind, int n) {
        if (kind.contains(n)) return {};
        return out_of_range(n, words_of(kind));
    }
    template <class Kind, int size> static Found parts(const Kind& kind, const glm::vec<size, float>& v) {
        for (int i = 0; i < size; ++i)
            if (Found found = at(component_of(kind), v[i]))
                return below(fmt::format("/{}", i), std::move(found));
        return {};
    }
    static Found at(const Colour& kind, const glm::vec3& v) { return parts(kind, v); }
    static Found at(const Vector& kind, const glm::vec3& v) { return parts(kind, v); }
    static Found at(const Homogeneous& kind, const glm::vec4& v) { return parts(kind, v); }
    template <class T> static Found at(const Group&, const T& value) { return in(value); }
    static Found at(const OneProjection&, const Projection& projection) {
        return std::visit([](const auto& p) { return in(p); }, projection);
    }
    static Found at(const OneMesh&, const MeshSource& source) {
        return std::visit([](const auto& s) { return in(s); }, source);
    }
    template <class Kind, class T> static Found at(const Kind&, const T&) { return {}; }
};

template <class T> std::optional<Problem> any_violation_of(const T& value) {
    if (auto found = violation_of(value)) return found;
    return violation_of_ranges(value);
}

/// Positions in memory have already been divided by w.
std::optional<Problem> any_violation_of(const Light& light) {
    if (auto found = any_violation_of<Light>(light)) return found;
    if (light.position.w == 0 || light.position.w == 1) return std::nullopt;
    return Problem{"", "/position/3", fmt::format("w is {}", light.position.w),
                   "1, the position divided by it"};
}

/// Returns the first violation in a new or changed item.
template <class Item>
std::optional<Problem> violation_in(const char* list, const std::vector<Item>& valid,
                                    const std::vector<Item>& now) {
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (i < valid.size() && now[i] == valid[i]) continue;
        if (auto found = any_violation_of(now[i]))
            return below(fmt::format("/{}/{}", list, i), std::move(found));
    }
    return std::nullopt;
}

}  // namespace

std::optional<Problem> violation_of(const Camera& camera) {
    const glm::dvec3 back = glm::dvec3(camera.eye) - glm::dvec3(camera.target), up(camera.up);
    if (camera.eye == camera.target)
        return Problem{"", "", "eye and target are the same point", "two points that differ"};
    if (up == glm::dvec3(0)) return Problem{"", "", "up is zero", "a direction"};
    // Without these conditions the camera has no orthonormal frame (view_from_world).
    if (!(glm::length(glm::cross(up, back)) > parallel_sine * glm::length(up) * glm::length(back)))
        return Problem{"", "", "up is parallel to the view direction",
                       "an up that is not along the line from eye to target"};
    return below("/projection", violation_of(camera.projection));
}

std::optional<Problem> violation_of_w(LightKind kind, double w) {
    const bool is_direction = kind == LightKind::Directional;
    if (is_direction ? w == 0 : w > 0) return std::nullopt;
    const char* const article = kind == LightKind::Area ? "an" : "a";
    return Problem{"", "/position", fmt::format("w is {}", w),
                   fmt::format("w {} 0 for {} {} light", is_direction ? '=' : '>', article, name_of(kind))};
}

std::optional<Problem> violation_of_division(const glm::dvec4& position) {
    for (int i = 0; i < 3 && position.w != 0; ++i) {
        const double divided = position[i] / position.w;
        if (!any_number.contains(static_cast<float>(divided)))
            return Problem{"", "/position", fmt::format("divided by w it is {}", divided),
                           std::string(any_number.words)};
    }
    return std::nullopt;
}

std::optional<Problem> violation_of(const Light& light) {
    if (auto found = violation_of_w(light.kind, light.position.w)) return found;
    if (light.position.w == 0 && glm::vec3(light.position) == glm::vec3(0))
        return Problem{"", "/position", "a zero direction", "the direction towards the light"};
    if (light.falloff == Falloff{0, 0, 0})
        return Problem{"", "/falloff", "constant, linear and quadratic are all 0", "one of them above 0"};
    if (light.spot.direction == glm::vec3(0))
        return Problem{"", "/spot/direction", "a zero direction", "the direction of the cone's axis"};
    return below("/area", violation_of(light.area));
}

std::optional<Problem> violation_of(const Object& object) {
    for (int i = 0; i < 3; ++i)
        if (object.transform.scale[i] == 0)
            return Problem{"", fmt::format("/transform/scale/{}", i), "a scale of 0",
                           "a number other than 0 (below 0 mirrors)"};
    return std::nullopt;
}

std::optional<Problem> violation_of(const Scene& scene) {
    if (auto found = violation_of(scene.camera)) return below("/camera", std::move(found));
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (auto found = violation_of(scene.lights[i]))
            return below(fmt::format("/lights/{}", i), std::move(found));
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (auto found = violation_of(scene.objects[i]))
            return below(fmt::format("/objects/{}", i), std::move(found));
    return std::nullopt;
}

std::optional<Problem> violation_of_ranges(const Camera& camera) { return RangeSearch::in(camera); }
std::optional<Problem> violation_of_ranges(const Light& light) { return RangeSearch::in(light); }
std::optional<Problem> violation_of_ranges(const Object& object) { return RangeSearch::in(object); }
std::optional<Problem> violation_of_ranges(const Scene& scene) { return RangeSearch::in(scene); }

std::optional<Problem> violation_since(const Scene& valid, const Scene& now) {
    if (auto found = violation_of(now.camera)) return below("/camera", std::move(found));
    if (auto found = violation_of_ranges(now)) return found;
    if (auto found = violation_in("lights", valid.lights, now.lights)) return found;
    return violation_in("objects", valid.objects, now.objects);
}

glm::vec4 divided_by_w(glm::dvec4 position) {
    if (position.w == 0) return position;
    return {glm::vec3(glm::dvec3(position) / position.w), 1};
}

}  // namespace glint
