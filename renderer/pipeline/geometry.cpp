#include "renderer/pipeline/geometry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/matrix.hpp>

#include "renderer/pipeline/clip.h"
#include "renderer/pipeline/to_screen.h"

namespace glint {
namespace {

void transform_vertices(ObjectGeometry& object, const glm::dmat4& clip_from_view, const ToScreen& to_screen) {
    const std::vector<glm::vec3>& from = object.mesh->positions;
    object.vertices.resize(from.size());
    object.screen.resize(from.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, from.size(), 4096), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const glm::dvec4 view = object.view_from_object * glm::dvec4(glm::dvec3(from[i]), 1.0);
            const glm::dvec4 clip = clip_from_view * view;
            PlacedVertex& v = object.vertices[i];
            v.clip_x = static_cast<float>(clip.x);
            v.clip_y = static_cast<float>(clip.y);
            v.clip_w = static_cast<float>(clip.w);
            v.x = static_cast<float>(view.x);
            v.y = static_cast<float>(view.y);
            v.z = static_cast<float>(view.z);
            v.outside = outside_bits(clip);
            ScreenVertex& s = object.screen[i];
            if (!(v.outside & needs_clipping)) s = to_screen(clip);
            s.outside = v.outside;
        }
    });
}

/// The corners' vertices, once a mesh: a triangle's own list of corners is one step further away.
void list_triangle_vertices(ObjectGeometry& object) {
    object.triangle_vertices.clear();
    object.triangle_vertices.reserve(3 * object.mesh->triangles.size());
    for (const Triangle& t : object.mesh->triangles)
        for (const std::uint32_t c : t.corner)
            object.triangle_vertices.push_back(object.mesh->corner_position[c]);
}

void place_objects(Geometry& g, const Scene& scene) {
    const glm::dmat4 view = view_from_world(scene.camera);
    const glm::dmat4 projection = clip_from_view(scene.camera.projection, g.size);
    const ToScreen to_screen{g.size, is_orthographic(scene.camera.projection)};
    g.objects.resize(scene.objects.size());
    g.triangle_count = 0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        ObjectGeometry& o = g.objects[i];
        if (o.mesh != scene.objects[i].mesh) {
            o.mesh = scene.objects[i].mesh;
            list_triangle_vertices(o);
        }
        o.transform = scene.objects[i].transform;
        o.view_from_object = view * world_from_object(o.transform);
        const glm::dmat3 linear(o.view_from_object);
        o.mirrored = glm::determinant(linear) < 0;
        o.normal_matrix = glm::transpose(glm::inverse(linear));
        o.first_triangle = g.triangle_count;
        g.triangle_count += static_cast<std::uint32_t>(o.mesh->triangles.size());
        transform_vertices(o, projection, to_screen);
    }
}

bool same_inputs(const Geometry& kept, const Scene& scene, PictureSize size) {
    if (kept.size != size || kept.camera != scene.camera || kept.objects.size() != scene.objects.size())
        return false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (kept.objects[i].mesh != scene.objects[i].mesh ||
            kept.objects[i].transform != scene.objects[i].transform)
            return false;
    return true;
}

}  // namespace

std::uint32_t Geometry::object_of(std::uint32_t triangle) const {
    const auto after =
        std::upper_bound(objects.begin(), objects.end(), triangle,
                         [](std::uint32_t t, const ObjectGeometry& o) { return t < o.first_triangle; });
    return static_cast<std::uint32_t>(after - objects.begin()) - 1;
}

bool update_geometry(Geometry& kept, const Scene& scene, PictureSize size) {
    if (same_inputs(kept, scene, size)) return false;
    kept.size = size;
    kept.camera = scene.camera;
    place_objects(kept, scene);
    return true;
}

}  // namespace glint
