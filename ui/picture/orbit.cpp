#include "ui/picture/orbit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <utility>

#include "models/fields/scene_rules.h"
#include "models/range.h"
#include "models/scene/transform.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/picture/handles/light_place.h"
#include "ui/picture/screen.h"

namespace glint {
namespace {

constexpr double closest = 1e-4, farthest = max_number / 10;  // eye to target, scene units
constexpr double closest_share = 1e-4;  // of the largest coordinate: closer, float rounding turns the view
                                        // direction
constexpr double pole_margin = std::numbers::pi / 180;

bool usable(const Camera& camera) {
    const glm::vec3 reach = glm::max(glm::abs(camera.eye), glm::abs(camera.target));
    const double away = std::max({double(reach.x), double(reach.y), double(reach.z)});
    const double distance = target_depth(camera);
    return distance > std::max(closest, closest_share * away) && distance < farthest && away < max_number &&
           !violation_of(camera);
}

/// Depths of the nearest and farthest corner of a box in front of a camera.
std::pair<double, double> depths_of(const Camera& camera, const Bounds& bounds) {
    const glm::dmat4 view = view_from_world(camera);
    double low = 1e300, high = -1e300;
    for (const glm::dvec3& corner : corners_of(bounds)) {
        const double depth = -(view * glm::dvec4(corner, 1)).z;
        low = std::min(low, depth);
        high = std::max(high, depth);
    }
    return {low, high};
}

/// Moves eye and target equally.
Camera shifted(Camera camera, glm::dvec3 shift) {
    camera.eye = glm::vec3(glm::dvec3(camera.eye) + shift);
    camera.target = glm::vec3(glm::dvec3(camera.target) + shift);
    return camera;
}

glm::dvec3 way_to_eye(ViewFrom from) {
    constexpr double off_pole = 2e-3;  // a tenth of a degree
    switch (from) {
    case ViewFrom::Front:
        return {0, 0, 1};
    case ViewFrom::Back:
        return {0, 0, -1};
    case ViewFrom::Right:
        return {1, 0, 0};
    case ViewFrom::Left:
        return {-1, 0, 0};
    case ViewFrom::Top:
        return {0, 1, off_pole};
    case ViewFrom::Bottom:
        return {0, -1, off_pole};
    }
    return {0, 0, 1};  // not reached
}

}  // namespace

double target_depth(const Camera& camera) {
    return glm::length(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
}

void orbit(Camera& camera, glm::dvec2 motion_px, PictureSize size) {
    const double turn = 2 * std::numbers::pi / size.height;
    const glm::dvec3 up = glm::normalize(glm::dvec3(camera.up));
    const glm::dvec3 arm = glm::dvec3(camera.eye) - glm::dvec3(camera.target);
    const double radius = glm::length(arm);
    const double from_pole = std::acos(std::clamp(glm::dot(arm, up) / radius, -1.0, 1.0));
    const glm::dvec3 level = glm::normalize(arm - glm::dot(arm, up) * up), side = glm::cross(up, level);
    const double yaw = -motion_px.x * turn;
    const double polar =
        std::clamp(from_pole - motion_px.y * turn, pole_margin, std::numbers::pi - pole_margin);
    const glm::dvec3 outward = std::cos(yaw) * level + std::sin(yaw) * side;
    Camera turned = camera;
    turned.eye =
        glm::vec3(glm::dvec3(camera.target) + radius * (std::cos(polar) * up + std::sin(polar) * outward));
    if (!violation_of(turned)) camera = turned;
}

void pan(Camera& camera, glm::dvec2 from_px, glm::dvec2 to_px, double depth, PictureSize size) {
    const ScreenMap map = screen_map(camera, size);
    const Camera moved = shifted(camera, unproject(map, from_px, depth) - unproject(map, to_px, depth));
    if (usable(moved) || !usable(camera)) camera = moved;
}

void dolly(Camera& camera, glm::dvec2 cursor_px, double depth, double factor, PictureSize size) {
    const ScreenMap map = screen_map(camera, size);
    const glm::dvec3 anchor = unproject(map, cursor_px, depth);
    Camera moved = camera;
    if (auto* flat = std::get_if<Orthographic>(&moved.projection)) {
        const double height = flat->height * factor;
        if (factor < 1 ? height < closest : height > farthest) return;
        flat->height = static_cast<float>(height);
        moved = shifted(moved, anchor - unproject(screen_map(moved, size), cursor_px, depth));
    } else {
        moved.eye = glm::vec3(anchor + factor * (glm::dvec3(camera.eye) - anchor));
        moved.target = glm::vec3(anchor + factor * (glm::dvec3(camera.target) - anchor));
    }
    if (usable(moved) || !usable(camera)) camera = moved;
}

void fill_picture(Scene& scene, int object, PictureSize size) {
    constexpr double share = 0.8;
    constexpr std::size_t enough = 50'000;  // positions of a mesh
    constexpr int steps = 6;                // perspective: the nearest parts grow faster than the others
    const glm::dvec2 whole(size.width, size.height);
    Camera camera = scene.camera;
    for (int i = 0; i < steps; ++i) {
        const ScreenMap map = screen_map(camera, size);
        glm::dvec2 low(HUGE_VAL), high(-HUGE_VAL);
        for (std::size_t o = 0; o < scene.objects.size(); ++o) {
            const Object& each = scene.objects[o];
            if (object >= 0 ? static_cast<int>(o) != object : !each.visible) continue;
            if (!each.mesh) continue;
            const glm::dmat4 to_world = world_from_object(each.transform);
            const std::vector<glm::vec3>& positions = each.mesh->positions;
            for (std::size_t p = 0; p < positions.size(); p += positions.size() / enough + 1) {
                const ProjectedPoint at = project(map, glm::dvec3(to_world * glm::dvec4(positions[p], 1)));
                if (!at.in_front) return;
                low = glm::min(low, at.pixel), high = glm::max(high, at.pixel);
            }
        }
        const glm::dvec2 extent = (high - low) / whole;
        const double factor = std::max(extent.x, extent.y) / share;
        if (!(factor > 0) || !std::isfinite(factor)) return;
        pan(camera, (low + high) / 2.0, whole / 2.0, target_depth(camera), size);
        dolly(camera, whole / 2.0, target_depth(camera), factor, size);
    }
    if (violation_of(camera)) return;
    keep_depth_range(camera, scene.camera, scene_bounds(scene));
    scene.camera = camera;
}

void keep_depth_range(Camera& camera, const Camera& before, const Bounds& bounds) {
    const auto [low_before, high_before] = depths_of(before, bounds);
    if (low_before < near_of(before.projection) || high_before > far_of(before.projection)) return;
    const auto [low, high] = depths_of(camera, bounds);
    std::visit(
        [low = low, high = high](auto& p) {
            [[maybe_unused]] const float near_before = p.near;
            if (high > p.far) p.far = static_cast<float>(std::min(high * 1.5, max_number));
            // A near plane at the eye would waste all depth precision; an existing one there stays.
            if (low < p.near) p.near = std::min(p.near, static_cast<float>(std::max(low / 2, p.far * 1e-4)));
            // The window of a frustum is on its near plane: it shrinks with it, or the angle would change.
            if constexpr (requires { p.left; }) {
                const float share = p.near / near_before;
                p.left *= share, p.right *= share, p.bottom *= share, p.top *= share;
            }
        },
        camera.projection);
}

Camera seen_from(Camera camera, ViewFrom from) {
    const Camera before = camera;
    const glm::dvec3 way = glm::normalize(way_to_eye(from));
    camera.eye = glm::vec3(glm::dvec3(camera.target) + target_depth(camera) * way);
    camera.up = {0, 1, 0};
    return violation_of(camera) ? before : camera;
}

Camera other_projection(Camera camera, PictureSize size) {
    camera.projection = as_projection(
        camera,
        is_orthographic(camera.projection) ? ProjectionKind::Perspective : ProjectionKind::Orthographic,
        size);
    return camera;
}

}  // namespace glint
