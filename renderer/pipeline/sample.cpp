// What a sample shows, one at a time: the functions behind both the surface stage and `explain`.

#include <glm/geometric.hpp>

#include "renderer/pipeline/near_weights.h"
#include "renderer/pipeline/surface.h"
#include "renderer/shading/interpolate.h"

namespace glint {
namespace {

using Vec = Vec3<float>;

Vec to_vec(glm::vec3 v) { return {v.x, v.y, v.z}; }
glm::vec3 to_glm(Vec v) { return {v.x, v.y, v.z}; }

ScreenPoint<float> screen_point(PictureSize size, int x, int y) {
    return {(2.0f * static_cast<float>(x) + 1.0f) / static_cast<float>(size.width) - 1.0f,
            1.0f - (2.0f * static_cast<float>(y) + 1.0f) / static_cast<float>(size.height)};
}

ClipCorner<float> clip_corner(const ClipVertex& v) { return {v.x, v.y, v.w}; }

/// The slot of a corner's normal: what tells lit vertices of one object apart.
std::uint32_t normal_slot(const ObjectNormals& normals, const Mesh& mesh, std::uint32_t corner) {
    return normals.of_mesh.corner.empty() ? mesh.corner_position[corner] : corner;
}

glm::vec3 corner_normal(const ObjectNormals& normals, const Mesh& mesh, std::uint32_t corner) {
    return normals.normals[normals.of_mesh.corner.empty() ? mesh.corner_position[corner]
                                                          : normals.of_mesh.corner[corner]];
}

glm::vec3 camera_facet_normal(const ObjectGeometry& object, std::uint32_t face) {
    const glm::vec3 n = facet_normal(*object.mesh, face);
    return to_glm(unit(to_vec(glm::vec3(object.normal_matrix * glm::dvec3(n)))));
}

/// Weights that interpolation uses for what the mode interpolates.
Vec interpolation_weights(const SurfaceChoice& choice, const Geometry& g, const SampleFace& face, int x, int y) {
    const Vec weights = to_vec(face.weights);
    if (!choice.screen_weights) return weights;
    const ObjectGeometry& object = g.objects[face.object];
    const auto p = g.position_indices(face.object, g.triangle(face.object, face.triangle));
    const ClipVertex &a = object.vertices[p[0]], &b = object.vertices[p[1]], &c = object.vertices[p[2]];
    if (near_is_crossed(a, b, c)) return near_clipped_screen_weights(g, face, x, y);
    return screen_weights(weights, a.w, b.w, c.w);
}

}  // namespace

SampleFace sample_face(const SurfaceChoice& choice, const Geometry& g, const Visibility& visibility, int x, int y) {
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(g.size.width) + static_cast<std::size_t>(x);
    SampleFace face;
    face.triangle = visibility.triangle_at(pixel);
    face.object = g.object_of(face.triangle);
    face.turned = choice.two_sided && visibility.back[pixel];
    const ObjectGeometry& object = g.objects[face.object];
    const auto p = g.position_indices(face.object, g.triangle(face.object, face.triangle));
    face.weights = to_glm(perspective_weights(clip_corner(object.vertices[p[0]]), clip_corner(object.vertices[p[1]]),
                                              clip_corner(object.vertices[p[2]]), screen_point(g.size, x, y)));
    return face;
}

PlacedNormal pixel_point(const Surface& surface, const Geometry& g, const SampleFace& face, int x, int y) {
    const ObjectGeometry& object = g.objects[face.object];
    const Triangle& t = g.triangle(face.object, face.triangle);
    const auto at = g.position_indices(face.object, t);
    const Vec p = blend(to_vec(face.weights), to_vec(object.positions[at[0]]), to_vec(object.positions[at[1]]),
                        to_vec(object.positions[at[2]]));
    Vec n;
    if (!surface.choice.facet_normals) {
        const ObjectNormals& normals = surface.normals[face.object];
        const Vec sum = blend(interpolation_weights(surface.choice, g, face, x, y),
                              to_vec(corner_normal(normals, *object.mesh, t.corner[0])),
                              to_vec(corner_normal(normals, *object.mesh, t.corner[1])),
                              to_vec(corner_normal(normals, *object.mesh, t.corner[2])));
        if (length(sum) > 1e-6f) n = unit(sum);
    }
    // Opposite corner normals can cancel: then, too, the facet's own is the best there is.
    if (dot(n, n) == 0) n = to_vec(camera_facet_normal(object, t.face));
    return {to_glm(p), face.turned ? -to_glm(n) : to_glm(n)};
}

PlacedNormal lit_point(const Surface& surface, const Geometry& g, const PointSource& source) {
    const ObjectGeometry& object = g.objects[source.object];
    const Mesh& mesh = *object.mesh;
    const ObjectNormals& normals = surface.normals[source.object];
    PlacedNormal at;
    if (surface.choice.kind == SurfaceKind::Faces && !surface.choice.provoking) {
        const auto around = mesh.corners_of(source.item);
        glm::dvec3 sum(0);
        for (const std::uint32_t p : around) sum += glm::dvec3(object.positions[p]);
        at = {glm::vec3(sum / static_cast<double>(around.size())), camera_facet_normal(object, source.item)};
    } else if (surface.choice.kind == SurfaceKind::Faces) {
        const std::uint32_t corner = mesh.triangles[source.item].corner[2];
        at = {object.positions[mesh.corner_position[corner]], corner_normal(normals, mesh, corner)};
    } else if (normals.of_mesh.corner.empty()) {
        at = {object.positions[source.item], normals.normals[source.item]};
    } else {
        at = {object.positions[mesh.corner_position[source.item]],
              normals.normals[normals.of_mesh.corner[source.item]]};
    }
    if (source.turned) at.n = -at.n;
    return at;
}

SampleSources sample_sources(const Surface& surface, const Geometry& g, const SampleFace& face, int x, int y) {
    const Triangle& t = g.triangle(face.object, face.triangle);
    SampleSources s;
    if (surface.choice.kind == SurfaceKind::Faces) {
        const std::uint32_t triangle = face.triangle - g.objects[face.object].first_triangle;
        s.count = 1;
        s.source[0] = {face.object, surface.choice.provoking ? triangle : t.face, face.turned};
        s.weight[0] = 1;
        return s;
    }
    const Vec weights = interpolation_weights(surface.choice, g, face, x, y);
    const ObjectNormals& normals = surface.normals[face.object];
    s.count = 3;
    for (std::size_t i = 0; i < 3; ++i)
        s.source[i] = {face.object, normal_slot(normals, *g.objects[face.object].mesh, t.corner[i]), face.turned};
    s.weight[0] = weights.x;
    s.weight[1] = weights.y;
    s.weight[2] = weights.z;
    return s;
}

}  // namespace glint
