#include "models/scene/scene_cost.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "models/memory_limit.h"

namespace glint {
namespace {

constexpr std::uint64_t bytes_an_object = 4096;
// Per vertex and per triangle of an object: transformed positions, averaged normals, the mesh's index list,
// and the tiles' entries. Measured on the spheres and meshes of tests/models/scene/scene_cost_test.cpp.
constexpr std::uint64_t bytes_a_vertex = 96, bytes_a_triangle = 44;
// The surface point of a pixel, its light sums, its colour; and the number of the triangle in each sample.
constexpr std::uint64_t bytes_a_pixel = 56, bytes_a_sample = 8;

// For rays, per triangle: its corners and Embree's tree; per pixel and light: one bit; for paths, per pixel:
// sums and means.
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
    thread_local std::vector<const Mesh*> meshes;  // kept between calls: a steady drag allocates nothing
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
        fmt::format("at most {} (--memory and GLINT_MEMORY change that)", size_text(memory_limit()))};
}

std::optional<Problem> too_large(const Scene& scene, PictureSize size, int samples) {
    const std::uint64_t all_samples = size.pixels() * static_cast<std::uint64_t>(samples);
    if (all_samples > max_picture_samples)
        return Problem{"", "", fmt::format("the picture has {} samples", all_samples),
                       fmt::format("at most {}, pixels times samples", max_picture_samples)};
    if (auto problem = too_many_triangles(scene)) return problem;
    return too_much_memory(scene_cost(scene, size, samples));
}

}  // namespace glint
