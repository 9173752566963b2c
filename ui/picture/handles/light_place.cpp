#include "ui/picture/handles/light_place.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "renderer/shade/light_sources.h"

namespace glint {
namespace {

// The renderer defines which matrix transforms a light to camera coordinates
// (renderer/shade/light_sources.h). A light in world space skips the transforms there and back, so that no
// digit of it changes.
glm::dmat4 world_from_own(const Light& light, const ScreenMap& map) {
    const glm::dmat4 carry = camera_from_light(light.space, map.view_from_world);
    return carry == map.view_from_world ? glm::dmat4(1) : map.world_from_view * carry;
}

glm::dmat4 own_from_world(const Light& light, const ScreenMap& map) {
    const glm::dmat4 carry = camera_from_light(light.space, map.view_from_world);
    return carry == map.view_from_world ? glm::dmat4(1) : glm::inverse(carry) * map.view_from_world;
}

glm::dvec3 own_place(const Light& light) {
    const double w = light.position.w;
    return glm::dvec3(light.position) / (w == 0 ? 1.0 : w);
}

void widen(Bounds& bounds, const Object& object) {
    const glm::dmat4 world = world_from_object(object.transform);
    for (const glm::dvec3& corner : corners_of(object.mesh->bounds)) {
        const glm::vec3 place(world * glm::dvec4(corner, 1));
        bounds.min = glm::min(bounds.min, place);
        bounds.max = glm::max(bounds.max, place);
    }
}

}  // namespace

Bounds scene_bounds(const Scene& scene) {
    constexpr float huge = 3e38f;
    Bounds bounds{glm::vec3(huge), glm::vec3(-huge)};
    for (const Object& object : scene.objects)
        if (object.mesh && object.visible) widen(bounds, object);
    if (bounds.min.x > bounds.max.x) return {scene.camera.target - 1.0f, scene.camera.target + 1.0f};
    return bounds;
}

double ground_height(const Scene& scene) {
    constexpr float level = 1e-3f;  // the maximum height of a horizontal object, as a share of its width
    const Bounds all = scene_bounds(scene);
    const float middle = (all.min.y + all.max.y) / 2;  // a ceiling is above the middle
    double height = all.min.y;
    float widest = 0;
    for (const Object& object : scene.objects) {
        if (!object.mesh || !object.visible) continue;
        constexpr float huge = 3e38f;
        Bounds bounds{glm::vec3(huge), glm::vec3(-huge)};
        widen(bounds, object);
        const glm::vec3 size = bounds.max - bounds.min;
        const float width = std::min(size.x, size.z);
        if (size.y > level * width || width <= widest || bounds.max.y > middle) continue;
        widest = width;
        height = bounds.max.y;
    }
    return height;
}

Dome sun_dome(glm::vec3 target, const Bounds& bounds, const ScreenMap& map) {
    const glm::dvec3 low(bounds.min), high(bounds.max), centre(target);
    const double scene_radius = std::max(glm::length(high - low) / 2, 1e-6);
    // Half the height and half the width of the view, as tangents of angles or (orthographic) as lengths.
    const double half =
        std::min(1 / std::abs(map.clip_from_view[0][0]), 1 / std::abs(map.clip_from_view[1][1]));
    const bool parallel = map.clip_from_view[2][3] == 0;
    const double distance = glm::length(centre - glm::dvec3(map.world_from_view[3]));
    const double fits = parallel ? half : distance * half / std::sqrt(1 + half * half);
    return {centre, std::min(0.86 * fits, 2 * scene_radius)};
}

glm::dvec3 to_world(const Light& light, glm::dvec3 own, double w, const ScreenMap& map) {
    return glm::dvec3(world_from_own(light, map) * glm::dvec4(own, w));
}

glm::dvec3 to_own(const Light& light, glm::dvec3 world, double w, const ScreenMap& map) {
    return glm::dvec3(own_from_world(light, map) * glm::dvec4(world, w));
}

glm::dvec3 direction_of(const Light& light, const ScreenMap& map) {
    return glm::normalize(to_world(light, own_place(light), 0, map));
}

glm::dvec3 handle_of(const Light& light, const Dome& dome, const ScreenMap& map) {
    if (light.kind == LightKind::Directional) return dome.centre + dome.radius * direction_of(light, map);
    return to_world(light, own_place(light), 1, map);
}

Light placed_at(Light light, glm::dvec3 place, const Dome& dome, const ScreenMap& map) {
    if (light.kind == LightKind::Directional) {
        const glm::dvec3 away = place - dome.centre;
        const double length = glm::length(away);
        if (length > 0) light.position = glm::vec4(own_from_world(light, map) * glm::dvec4(away / length, 0));
        return light;
    }
    light.position = glm::vec4(glm::vec3(own_from_world(light, map) * glm::dvec4(place, 1)), 1);
    return light;
}

void turn_shape(Light& light, const glm::dmat4& turn, const ScreenMap& map) {
    const auto turned = [&](glm::vec3 own) {
        const glm::dvec4 world(to_world(light, own, 0, map), 0);
        return glm::vec3(to_own(light, glm::dvec3(turn * world), 0, map));
    };
    if (light.kind == LightKind::Spot) light.spot.direction = turned(light.spot.direction);
    if (light.kind == LightKind::Area) {
        light.area.edge_u = turned(light.area.edge_u);
        light.area.edge_v = turned(light.area.edge_v);
    }
}

Light in_space(Light light, LightSpace space, const Camera& camera) {
    if (light.space == space) return light;
    const ScreenMap map = screen_map(camera, {1, 1});
    const glm::dmat4 to_world = world_from_own(light, map);
    const double w = light.position.w == 0 ? 0 : 1;
    const glm::dvec4 place(own_place(light), w);
    light.space = space;
    const glm::dmat4 carry = own_from_world(light, map) * to_world;
    const auto carried = [&carry](glm::vec3 v) { return glm::vec3(carry * glm::dvec4(v, 0)); };
    light.position = glm::vec4(carry * place);
    light.spot.direction = carried(light.spot.direction);
    light.area.edge_u = carried(light.area.edge_u);
    light.area.edge_v = carried(light.area.edge_v);
    return light;
}

Light as_kind(Light light, LightKind kind, const Dome& dome, const ScreenMap& map) {
    if (light.kind == kind) return light;
    const glm::dvec3 handle = handle_of(light, dome, map);
    light.kind = kind;
    if (kind == LightKind::Directional) light.position.w = 0;
    const bool at_centre = glm::length(handle - dome.centre) < 1e-9;
    return placed_at(light, at_centre ? dome.centre + glm::dvec3(0, 1, 0) : handle, dome, map);
}

}  // namespace glint
