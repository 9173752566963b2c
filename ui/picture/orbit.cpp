#include "ui/picture/orbit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <utility>

#include "models/fields/scene_fields.h"
#include "models/numbers.h"
#include "models/scene/scene.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/screen.h"

namespace glint {
namespace {

constexpr double closest = 1e-4, farthest = max_number / 10;  // eye to target, scene units
constexpr double closest_share = 1e-4;  // of the largest coordinate; when closer, rounding turns the view
constexpr double pole_margin = std::numbers::pi / 180;

bool usable(const Camera& camera) {
    const glm::vec3 reach = glm::max(glm::abs(camera.eye), glm::abs(camera.target));
    const double away = std::max({double(reach.x), double(reach.y), double(reach.z)});
    const double distance = target_depth(camera);
    return distance > std::max(closest, closest_share * away) && distance < farthest && away < max_number &&
           !violation_of(camera);
}

/// Returns the depths of the nearest and farthest corners of a box in front of a camera.
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

/// Moves the eye and the target by the same vector.
Camera shifted(Camera camera, glm::dvec3 shift) {
    camera.eye = glm::vec3(glm::dvec3(camera.eye) + shift);
    camera.target = glm::vec3(glm::dvec3(camera.target) + shift);
    return camera;
}

/// Returns points of the visible objects, or of the one with that index, in camera coordinates; for large
/// meshes, only some of the points.
std::vector<glm::dvec3> framed_points(const Scene& scene, int object, const glm::dmat4& view_from_world) {
    constexpr std::size_t enough = 50'000;  // of a mesh
    std::vector<glm::dvec3> points;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const Object& each = scene.objects[o];
        if (!each.mesh || (object >= 0 ? static_cast<int>(o) != object : !each.visible)) continue;
        const glm::dmat4 to_view = view_from_world * world_from_object(each.transform);
        const std::vector<glm::vec3>& positions = each.mesh->positions;
        for (std::size_t p = 0; p < positions.size(); p += positions.size() / enough + 1)
            points.emplace_back(to_view * glm::dvec4(positions[p], 1));
    }
    return points;
}

/// Along one axis of the picture, a point at x to the side and d in front of the eye is in the wanted part of
/// the picture if d low <= x <= d high. If the eye is moved sideways by s and forward by f, the condition for
/// all points is left <= low f - s and right <= s - high f.
struct Extent {
    double low = 0, high = 0, left = -HUGE_VAL, right = -HUGE_VAL;
    /// The largest forward motion of the eye.
    [[nodiscard]] double forward() const { return -size() / (high - low); }
    /// The sideways motion that leaves the same room on both sides.
    [[nodiscard]] double middle(double forward) const { return (right - left + (low + high) * forward) / 2; }
    [[nodiscard]] double size() const { return left + right; }
};

Extent extent_along(int axis, const std::vector<glm::dvec3>& points, const ScreenMap& map, double share) {
    Extent extent;
    if (map.clip_from_view[2][3] != 0) {  // perspective
        const double scale = map.clip_from_view[axis][axis], shift = map.clip_from_view[2][axis];
        extent.low = (shift - share) / scale, extent.high = (shift + share) / scale;
    }
    for (const glm::dvec3& at : points) {
        extent.right = std::max(extent.right, at[axis] + extent.high * at.z);
        extent.left = std::max(extent.left, -at[axis] - extent.low * at.z);
    }
    return extent;
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
    Camera camera = scene.camera;
    const ScreenMap map = screen_map(camera, size);
    const std::vector<glm::dvec3> seen = framed_points(scene, object, map.view_from_world);
    if (seen.empty()) return;
    const bool is_parallel = is_orthographic(camera.projection);
    const Extent x = extent_along(0, seen, map, share), y = extent_along(1, seen, map, share);
    const double forward = is_parallel ? 0 : std::min(x.forward(), y.forward());
    const auto [far, near] =
        std::minmax_element(seen.begin(), seen.end(), [](auto& a, auto& b) { return a.z < b.z; });
    const auto in_world = [&](double z) {
        return glm::vec3(map.world_from_view * glm::dvec4(x.middle(forward), y.middle(forward), z, 1));
    };
    camera.eye = in_world(-forward), camera.target = in_world((near->z + far->z) / 2);
    if (auto* flat = std::get_if<Orthographic>(&camera.projection))
        flat->height *= static_cast<float>(
            std::max(x.size() * map.clip_from_view[0][0], y.size() * map.clip_from_view[1][1]) / 2 / share);
    if (!usable(camera)) return;
    Bounds framed{glm::vec3(HUGE_VALF), glm::vec3(-HUGE_VALF)};
    for (const glm::dvec3& point : seen) {
        const glm::vec3 at(map.world_from_view * glm::dvec4(point, 1));
        framed = {glm::min(framed.min, at), glm::max(framed.max, at)};
    }
    keep_depth_range(camera, scene.camera, scene_bounds(scene));
    keep_depth_range(camera, scene.camera, framed);  // even if the scene extends behind the eye
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
            // A near plane at the eye would waste all depth precision; one that is already closer does not
            // change.
            if (low < p.near) p.near = std::min(p.near, static_cast<float>(std::max(low / 2, p.far * 1e-4)));
            // The window of a frustum is on its near plane. It shrinks with the plane, or the angle would
            // change.
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
