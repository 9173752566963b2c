// Stage 1, from object to clip coordinates. Points are transformed by the model, camera and projection
// matrices, normals by the inverse transpose of the first two (transform_objects).
#include "renderer/geometry/geometry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <utility>

#include "renderer/geometry/clip.h"

namespace glint {
namespace {

void transform_vertices(ObjectGeometry& object, VertexJob job) {
    const std::vector<glm::vec3>& from = object.mesh->positions;
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    object.vertices.resize(from.size());
    object.screen.resize(from.size());
    if (from.empty()) return;
    job.positions = &from.front().x;
    job.view_from_object = matrix_of(object.view_from_object);
    job.vertices = object.vertices.data();
    job.on_screen = object.screen.data();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, from.size(), 4096), [&job](const auto& range) {
        geometry_kernels().transform_vertices(job, range.begin(), range.end());
    });
}

using VertexList = std::shared_ptr<const std::vector<std::uint32_t>>;

/// The vertex of each triangle corner. Computed once for each mesh, because a lookup through the corner would
/// be another indirection.
VertexList list_triangle_vertices(const Mesh& mesh) {
    std::vector<std::uint32_t> list;
    list.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t c : t.corner) list.push_back(mesh.corner_position[c]);
    return std::make_shared<const std::vector<std::uint32_t>>(std::move(list));
}

/// Assigns the new mesh and its list, which all objects with that mesh share, to objects whose mesh has
/// changed.
void take_meshes(std::vector<ObjectGeometry>& objects, const Scene& scene) {
    std::map<const Mesh*, VertexList> lists;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const MeshPtr& mesh = scene.objects[i].mesh;
        if (objects[i].mesh == mesh) continue;
        if (lists.empty())
            for (const ObjectGeometry& o : objects)
                if (o.mesh) lists.emplace(o.mesh.get(), o.vertices_of_mesh);
        VertexList& list = lists[mesh.get()];
        if (!list) list = list_triangle_vertices(*mesh);
        objects[i].mesh = mesh;
        objects[i].vertices_of_mesh = list;
        objects[i].triangle_vertices = *list;
    }
}

void transform_objects(Geometry& g, const Scene& scene) {
    const glm::dmat4 view = view_from_world(scene.camera);
    VertexJob job;
    g.clip_from_view = clip_from_view(scene.camera.projection, g.size);
    job.clip_from_view = matrix_of(g.clip_from_view);
    job.viewport = viewport_of(scene.camera, g.size);
    g.objects.resize(scene.objects.size());
    take_meshes(g.objects, scene);
    g.triangle_count = 0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        ObjectGeometry& o = g.objects[i];
        o.transform = scene.objects[i].transform;
        o.visible = scene.objects[i].visible;
        o.double_sided = scene.objects[i].double_sided;
        o.view_from_object = view * world_from_object(o.transform);
        o.clip_from_object = g.clip_from_view * o.view_from_object;
        const glm::dmat3 linear(o.view_from_object);
        o.mirrored = glm::determinant(linear) < 0;
        o.normal_matrix = glm::transpose(glm::inverse(linear));
        o.first_triangle = g.triangle_count;
        g.triangle_count += static_cast<std::uint32_t>(o.mesh->triangles.size());
        transform_vertices(o, job);
    }
}

bool same_inputs(const Geometry& kept, const Scene& scene, PictureSize size) {
    if (kept.size != size || kept.camera != scene.camera || kept.objects.size() != scene.objects.size())
        return false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (kept.objects[i].mesh != scene.objects[i].mesh ||
            kept.objects[i].transform != scene.objects[i].transform ||
            kept.objects[i].visible != scene.objects[i].visible ||
            kept.objects[i].double_sided != scene.objects[i].double_sided)
            return false;
    return true;
}

}  // namespace

glm::vec3 ObjectGeometry::position(std::uint32_t index) const {
    return {vertices[index].x, vertices[index].y, vertices[index].z};
}

glm::dvec3 ObjectGeometry::centroid(std::uint32_t face) const {
    const auto around = mesh->corners_of(face);
    glm::dvec3 sum(0);
    for (const std::uint32_t p : around) sum += glm::dvec3(position(p));
    return sum / static_cast<double>(around.size());
}

std::uint32_t Geometry::object_of(std::uint32_t triangle) const {
    const auto after =
        std::upper_bound(objects.begin(), objects.end(), triangle,
                         [](std::uint32_t t, const ObjectGeometry& o) { return t < o.first_triangle; });
    return static_cast<std::uint32_t>(after - objects.begin()) - 1;
}

bool update_geometry(Geometry& kept, const Scene& scene, PictureSize size) {
    if (same_inputs(kept, scene, size)) return false;
    static std::atomic<std::uint64_t> states = 0;
    kept.state = ++states;
    kept.size = size;
    kept.camera = scene.camera;
    transform_objects(kept, scene);
    return true;
}

}  // namespace glint
