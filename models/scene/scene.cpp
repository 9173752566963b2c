#include "models/scene/scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_relational.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "models/json/json.h"
#include "models/material_presets_text.h"
#include "models/memory_limit.h"
#include "models/numbers.h"

namespace glint {
namespace {

/// The matrix of a single step, rotation or scale, without the translation.
glm::dmat3 linear_part(const Transform& written, TransformStep step) {
    Transform alone;
    if (step == TransformStep::Rotate) alone.rotate_deg = written.rotate_deg;
    if (step == TransformStep::Scale) alone.scale = written.scale;
    return {world_from_object(alone)};
}

}  // namespace

glm::dmat4 world_from_object(const Transform& transform) {
    const glm::dvec3 angle = glm::radians(glm::dvec3(transform.rotate_deg));
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), glm::dvec3(transform.translate));
    m = glm::rotate(m, angle.z, {0, 0, 1});
    m = glm::rotate(m, angle.y, {0, 1, 0});
    m = glm::rotate(m, angle.x, {1, 0, 0});
    return glm::scale(m, glm::dvec3(transform.scale));
}

std::optional<Transform> in_file_order(const Transform& written, const TransformOrder& order) {
    const glm::dmat3 rotate = linear_part(written, TransformStep::Rotate);
    const glm::dmat3 scale = linear_part(written, TransformStep::Scale);
    glm::dmat3 linear(1), before_translate(1);
    for (const TransformStep step : order) {
        if (step == TransformStep::Translate) before_translate = linear;
        linear = linear * linear_part(written, step);
    }
    const glm::dvec3 s = glm::abs(glm::dvec3(written.scale));
    const double error = 1e-9 * (s.x + s.y + s.z);
    if (!glm::all(glm::equal(linear, rotate * scale, error))) return std::nullopt;
    Transform transform = written;
    transform.translate = glm::vec3(before_translate * glm::dvec3(written.translate));
    return transform;
}

namespace {

constexpr std::uint64_t bytes_an_object = 4096;
// For each vertex and triangle of an object: transformed positions, averaged normals, the mesh's index list,
// and entries in tiles. Measured with spheres and meshes of various sizes.
constexpr std::uint64_t bytes_a_vertex = 96, bytes_a_triangle = 44;
// A pixel's surface point, light sums and colour; and the number of the triangle in each sample.
constexpr std::uint64_t bytes_a_pixel = 56, bytes_a_sample = 8;

// For rays, each triangle needs its corners and Embree's tree, and each pixel one bit per light; for paths,
// each pixel needs sums and means.
constexpr std::uint64_t bytes_a_ray_triangle = 200, bytes_a_path_pixel = 36;

template <class T> std::uint64_t bytes_of(const std::vector<T>& list) { return sizeof(T) * list.size(); }

std::string size_text(std::uint64_t bytes) {
    const auto size = static_cast<double>(bytes);
    constexpr double mib = 1 << 20, gib = 1 << 30;
    return size < gib ? fmt::format("{:.1f} MiB", size / mib) : fmt::format("{:.1f} GiB", size / gib);
}

/// The points that represent the enabled lights.
std::uint64_t light_points(const Scene& scene) {
    std::uint64_t points = 0;
    for (const Light& light : scene.lights)
        if (light.enabled) points += light.kind == LightKind::Area ? std::uint64_t(light.area.samples) : 1;
    return points;
}

std::optional<Problem> too_many_triangles(const Scene& scene) {
    std::size_t triangles = 0;
    for (const Object& object : scene.objects)
        if (object.mesh) triangles += object.mesh->triangles.size();
    if (triangles <= max_scene_triangles) return {};
    return Problem{"", "/objects", fmt::format("the objects have {} triangles", triangles),
                   fmt::format("at most {} in a scene", max_scene_triangles)};
}

}  // namespace

std::uint64_t mesh_bytes(const Mesh& mesh) {
    return bytes_of(mesh.positions) + bytes_of(mesh.first_corner) + bytes_of(mesh.corner_position) +
           bytes_of(mesh.normals) + bytes_of(mesh.corner_normal) + bytes_of(mesh.colors) +
           bytes_of(mesh.triangles) + bytes_of(mesh.smoothing) + bytes_of(mesh.first_at_place);
}

SceneCost scene_cost(const Scene& scene, PictureSize size, int samples) {
    SceneCost cost;
    cost.picture = size.pixels() * (bytes_a_pixel + bytes_a_sample * static_cast<std::uint64_t>(samples));
    const bool rays = scene.transport.model != TransportModel::Local;
    if (rays) cost.picture += size.pixels() * (bytes_a_path_pixel + light_points(scene) / 8);
    const std::uint64_t each_triangle = bytes_a_triangle + (rays ? bytes_a_ray_triangle : 0);
    thread_local std::vector<const Mesh*> meshes;  // kept between calls, so a steady drag allocates nothing
    meshes.clear();
    for (const Object& object : scene.objects) {
        if (!object.mesh) continue;
        meshes.push_back(object.mesh.get());
        cost.objects += bytes_an_object + bytes_a_vertex * object.mesh->positions.size() +
                        each_triangle * object.mesh->triangles.size();
    }
    std::sort(meshes.begin(), meshes.end());
    meshes.erase(std::unique(meshes.begin(), meshes.end()), meshes.end());
    for (const Mesh* mesh : meshes) cost.meshes += mesh_bytes(*mesh);
    return cost;
}

std::optional<Problem> too_much_memory(const SceneCost& cost) {
    const std::uint64_t all = cost.meshes + cost.objects + cost.picture;
    if (all <= memory_limit()) return {};
    const auto [largest, words] =
        std::max({std::pair(cost.meshes, "the meshes"), std::pair(cost.objects, "the objects"),
                  std::pair(cost.picture, "the picture")});
    return Problem{
        "", "",
        fmt::format("this needs {} of memory, {} of it for {}", size_text(all), size_text(largest), words),
        fmt::format("at most {} (change it with --memory or GLINT_MEMORY)", size_text(memory_limit()))};
}

std::optional<Problem> too_large(const Scene& scene, PictureSize size, int samples) {
    const std::uint64_t all_samples = size.pixels() * static_cast<std::uint64_t>(samples);
    if (all_samples > max_picture_samples)
        return Problem{"", "", fmt::format("the picture has {} samples", all_samples),
                       fmt::format("at most {} (pixels times samples)", max_picture_samples)};
    if (auto problem = too_many_triangles(scene)) return problem;
    return too_much_memory(scene_cost(scene, size, samples));
}

namespace {

glm::vec3 color(const Json& numbers) {
    return {numbers[0].get<float>(), numbers[1].get<float>(), numbers[2].get<float>()};
}

/// Alpha is ignored: transparency is not supported.
MaterialPreset preset_of(const Json& entry) {
    Material m;
    m.ambient = color(entry["ambient"]);
    m.diffuse = color(entry["diffuse"]);
    m.specular = color(entry["specular"]);
    m.shininess = entry["shininess"].get<float>();
    return {entry["name"].get_ref<const std::string&>(), entry["family"].get_ref<const std::string&>(), m};
}

}  // namespace

std::span<const MaterialPreset> material_presets() {
    static const Json document = parsed_json(material_presets_text, "materials.json");  // owns the names
    static const std::vector<MaterialPreset> presets = [] {
        std::vector<MaterialPreset> made;
        for (const Json& entry : document["materials"]) made.push_back(preset_of(entry));
        return made;
    }();
    return presets;
}

namespace {

struct Axes {
    glm::dvec3 u, v, w;  // right, up, backwards: unit vectors in world coordinates
};

Axes camera_axes(const Camera& camera) {
    const glm::dvec3 w = glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
    const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(camera.up), w));
    return {u, glm::cross(w, u), w};
}

}  // namespace

glm::dmat4 view_from_world(const Camera& camera) {
    const Axes a = camera_axes(camera);
    const glm::dvec3 eye(camera.eye);
    return {{a.u.x, a.v.x, a.w.x, 0},
            {a.u.y, a.v.y, a.w.y, 0},
            {a.u.z, a.v.z, a.w.z, 0},
            {-glm::dot(a.u, eye), -glm::dot(a.v, eye), -glm::dot(a.w, eye), 1}};
}

glm::dmat4 world_from_view(const Camera& camera) {
    const Axes a = camera_axes(camera);
    return {{a.u, 0}, {a.v, 0}, {a.w, 0}, {glm::dvec3(camera.eye), 1}};
}

Projection fitted(const Projection& projection, PictureSize size) {
    constexpr double widest_deg = 179.9;
    const double aspect = static_cast<double>(size.width) / size.height;
    if (!is_widened(size)) return projection;
    Projection shown = projection;
    if (auto* p = std::get_if<Perspective>(&shown)) {
        const double half = std::tan(p->fov_y_deg * std::numbers::pi / 360) * composed_aspect / aspect;
        const double fov_y_deg = std::min(std::atan(half) * 360 / std::numbers::pi, widest_deg);
        p->fov_y_deg = std::max(static_cast<float>(fov_y_deg), p->fov_y_deg);
    } else if (auto* o = std::get_if<Orthographic>(&shown)) {
        o->height = static_cast<float>(std::min(o->height * composed_aspect / aspect, max_number));
    }
    return shown;
}

glm::dmat4 clip_from_view(const Projection& as_written, PictureSize size) {
    const Projection projection = fitted(as_written, size);
    const double aspect = static_cast<double>(size.width) / size.height;
    if (const auto* p = std::get_if<Perspective>(&projection)) {
        const double top = p->near * std::tan(p->fov_y_deg * std::numbers::pi / 360);
        return glm::frustumRH_NO<double>(-top * aspect, top * aspect, -top, top, p->near, p->far);
    }
    if (const auto* o = std::get_if<Orthographic>(&projection)) {
        const double top = o->height / 2.0;
        return glm::orthoRH_NO<double>(-top * aspect, top * aspect, -top, top, o->near, o->far);
    }
    const auto& f = std::get<Frustum>(projection);
    return glm::frustumRH_NO<double>(f.left, f.right, f.bottom, f.top, f.near, f.far);
}

}  // namespace glint
