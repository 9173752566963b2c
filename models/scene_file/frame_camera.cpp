// Cameras that frame objects, and the scene that shows a single mesh.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "models/fields/scene_rules.h"
#include "models/range.h"
#include "models/scene_file/scene_file.h"
#include "models/utf8.h"

namespace glint {
namespace {

constexpr double margin = 1.08;  // between the sphere and the picture's edge

struct Sphere {
    glm::dvec3 center{0};
    double radius = 0;
};

/// Calls f(world position) for every corner of all visible objects, or of one object.
template <class F> void each_corner(const Scene& scene, int object, F f) {
    const bool all = object < 0 || static_cast<std::size_t>(object) >= scene.objects.size();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& o = scene.objects[i];
        if (!o.mesh || (all ? !o.visible : i != static_cast<std::size_t>(object))) continue;
        const glm::dmat4 m = world_from_object(o.transform);
        for (const std::uint32_t p : o.mesh->corner_position)
            f(glm::dvec3(m * glm::dvec4(o.mesh->positions[p], 1)));
    }
}

/// A sphere around the centre of the bounds: not the smallest one, but usually at most a seventh larger.
std::optional<Sphere> bounding_sphere(const Scene& scene, int object) {
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    bool any = false;
    each_corner(scene, object, [&](glm::dvec3 p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        any = true;
    });
    if (!any) return std::nullopt;
    Sphere s{(low + high) / 2.0, 0};
    each_corner(scene, object,
                [&](glm::dvec3 p) { s.radius = std::max(s.radius, glm::distance(p, s.center)); });
    // A point has no size that could fill the picture; far from the origin, floats cannot distinguish eye and
    // target.
    const double far_off = std::max({std::abs(s.center.x), std::abs(s.center.y), std::abs(s.center.z)});
    s.radius = s.radius > 0 ? std::max(s.radius, 1e-5 * far_off) : std::max(1.0, 1e-5 * far_off);
    return s;
}

/// Tangent of the smallest angle between the axis and the window's edges; of half the window if the axis is
/// outside it.
double narrowest_tangent(const Frustum& f) {
    const double left = std::min(f.left, f.right), right = std::max(f.left, f.right);
    const double bottom = std::min(f.bottom, f.top), top = std::max(f.bottom, f.top);
    const double inside = std::min({-left, right, -bottom, top});
    return (inside > 0 ? inside : std::min(right - left, top - bottom) / 2) / f.near;
}

/// The distance of the eye from a sphere's centre at which it fits the narrower side of a picture from 1:1 to
/// 16:9, which is the height: a cone of half angle a touches it at radius / sin a.
double fitting_distance(const Projection& projection, double radius) {
    if (const auto* p = std::get_if<Perspective>(&projection))
        return margin * radius / std::sin(p->fov_y_deg * std::numbers::pi / 360);
    if (const auto* p = std::get_if<Frustum>(&projection))
        return margin * radius / std::sin(std::atan(narrowest_tangent(*p)));
    return 4 * radius;  // arbitrary: the size in the picture does not depend on it
}

/// Returns the projection with new clipping planes: near well in front of the sphere, far well behind it,
/// with a ratio that keeps the precision of depth.
Projection with_planes(Projection projection, double distance, double radius) {
    const auto near = static_cast<float>(distance / 50), far = static_cast<float>(distance + 20 * radius);
    if (auto* f = std::get_if<Frustum>(&projection)) {
        const float scale = near / f->near;  // the window is on the near plane
        f->left *= scale, f->right *= scale, f->bottom *= scale, f->top *= scale;
    }
    if (auto* o = std::get_if<Orthographic>(&projection)) o->height = static_cast<float>(2 * margin * radius);
    std::visit([&](auto& p) { p.near = near, p.far = far; }, projection);
    return projection;
}

}  // namespace

bool frame_camera(Scene& scene, int object) {
    const std::optional<Sphere> sphere = bounding_sphere(scene, object);
    if (!sphere) return false;
    Camera camera = scene.camera;
    const glm::dvec3 back = glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
    const double distance = fitting_distance(camera.projection, sphere->radius);
    camera.target = glm::vec3(sphere->center);
    camera.eye = glm::vec3(sphere->center + distance * back);
    camera.projection = with_planes(camera.projection, distance, sphere->radius);
    if (violation_of_ranges(camera) || violation_of(camera)) return false;
    scene.camera = camera;
    return true;
}

std::vector<Light> default_lights() {
    Light key;
    key.name = "Key";
    key.kind = LightKind::Directional;
    key.position = {-1, 1.5f, 1, 0};
    key.diffuse = key.specular = glm::vec3(0.9f);
    Light fill;
    fill.name = "Fill";
    fill.space = LightSpace::Camera;
    fill.position = {0, 0, 0, 1};
    fill.diffuse = glm::vec3(0.3f);
    fill.specular = glm::vec3(0);  // a highlight at the eye would follow the viewer
    return {key, fill};
}

Scene scene_of_mesh(MeshPtr mesh, const std::string& path) {
    Scene scene;
    Object object;
    object.name = with_invalid_replaced(std::filesystem::path(path).stem().string());
    object.source = MeshFile{path};
    object.mesh = std::move(mesh);
    object.material = {.ambient = glm::vec3(0.2f), .diffuse = glm::vec3(0.7f), .specular = glm::vec3(0.25f)};
    scene.objects.push_back(std::move(object));
    scene.lights = default_lights();

    scene.camera.eye = eye_before_framing;
    frame_camera(scene);
    return scene;
}

}  // namespace glint
