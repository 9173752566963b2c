// The surface at single samples: the functions behind both the surface stage and `explain`.

#include <glm/geometric.hpp>

#include "renderer/geometry/recent_faces.h"
#include "renderer/simd/glm_vec3.h"
#include "renderer/simd/vec3.h"
#include "renderer/surface/surface.h"

namespace glint {
namespace {

using Vec = Vec3<float>;

/// The interpolated normal, not yet unit.
Vec blended_normal(const SurfaceInputs& surface, const Geometry& g, const SampleFace& face) {
    const CornerWeights weights = corner_weights(surface.choice.interpolation, g, face);
    const ObjectNormals& normals = surface.normals[face.object];
    Vec sum;
    for (std::size_t i = 0; i < static_cast<std::size_t>(weights.count); ++i)
        sum = sum + weights.weight[i] * to_vec(normals.at_corner(weights.corner[i]));
    return sum;
}

/// Whether the normals of a face are reversed: with two-sided lighting, those of a face seen from behind are.
bool is_turned(const SurfaceChoice& choice, const Geometry& g, const SampleFace& face, bool back) {
    const bool turned = choice.two_sided && back;
    if (!choice.mistakes.some_faces_flipped) return turned;
    return turned != (g.triangle(face.object, face.triangle).face % 3 == 0);
}

SampleFace seen_face(const SurfaceChoice& choice, const Geometry& g, const Visibility& visibility, int x,
                     int y) {
    const std::size_t pixel = g.size.index(x, y);
    SampleFace face;
    face.at = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
    face.triangle = visibility.triangle_at(pixel);
    face.object = g.object_of(face.triangle);
    face.turned = is_turned(choice, g, face, visibility.back_at(pixel));
    return face;
}

}  // namespace

SampleFace sample_face(const SurfaceChoice& choice, const Geometry& g, const Visibility& visibility, int x,
                       int y) {
    SampleFace face = seen_face(choice, g, visibility, x, y);
    locate_on_face(face, g);
    return face;
}

SampleFace face_of_lane(const Surface& s, const Geometry& g, const Visibility& visibility, std::size_t group,
                        unsigned lane) {
    if (s.group_samples.empty()) {
        const auto width = static_cast<std::uint32_t>(g.size.width);
        const std::uint32_t pixel = s.groups[group].first_pixel + lane;
        return seen_face(s.choice, g, visibility, static_cast<int>(pixel % width),
                         static_cast<int>(pixel / width));
    }
    const GroupSamples& samples = s.group_samples[group];
    SampleFace face;
    face.at = samples.at[lane];
    face.object = s.groups[group].object;
    face.triangle = samples.triangle[lane];
    face.turned = is_turned(s.choice, g, face, samples.back >> lane & 1u);
    return face;
}

PositionNormal pixel_point(const SurfaceInputs& surface, const Geometry& g, const SampleFace& face) {
    const ObjectGeometry& object = g.objects[face.object];
    const Triangle& t = g.triangle(face.object, face.triangle);
    Vec n;
    if (!surface.choice.facet_normals) {
        const Vec sum = blended_normal(surface, g, face);
        if (!(length(sum) <= shortest_normal))  // also if it is NaN
            n = surface.choice.mistakes.unnormalized_at_pixel ? sum : unit(sum);
    }
    // If opposite corner normals cancel as well, the facet's own normal is the best choice.
    if (dot(n, n) == 0)
        n = to_vec(camera_facet_normal(object, surface.normals[face.object].options.flip, t.face,
                                       surface.choice.mistakes));
    return {face.p, face.turned ? -to_glm(n) : to_glm(n)};
}

namespace {

glm::vec3 known_centroid(const Geometry& g, std::uint32_t object, std::uint32_t face) {
    const ObjectGeometry& o = g.objects[object];
    if (o.mesh->corners_of(face).size() < many_corners) return glm::vec3(o.centroid(face));
    thread_local RecentFaces<GeometryFace, glm::vec3> known;
    return known.of({g.state, object, face}, [&] { return glm::vec3(o.centroid(face)); });
}

}  // namespace

PositionNormal lit_point(const SurfaceInputs& surface, const Geometry& g, const ShadingPoint& source) {
    const ObjectGeometry& object = g.objects[source.object];
    const Mesh& mesh = *object.mesh;
    const ObjectNormals& normals = surface.normals[source.object];
    PositionNormal at;
    if (surface.choice.kind == SurfaceKind::Faces && !surface.choice.provoking) {
        at = {known_centroid(g, source.object, source.item),
              camera_facet_normal(object, normals.options.flip, source.item, surface.choice.mistakes)};
    } else if (surface.choice.kind == SurfaceKind::Faces) {
        const std::uint32_t corner = mesh.triangles[source.item].corner[2];
        at = {object.position(mesh.corner_position[corner]), normals.at_corner(corner)};
    } else {
        at = {object.position(normals.position_of_slot(source.item)), normals.normal_of_slot(source.item)};
    }
    if (source.turned) at.n = -at.n;
    return at;
}

BlendedPoints blended_points(const SurfaceInputs& surface, const Geometry& g, const SampleFace& face) {
    const Triangle& t = g.triangle(face.object, face.triangle);
    BlendedPoints s;
    if (surface.choice.kind == SurfaceKind::Faces) {
        const std::uint32_t triangle = face.triangle - g.objects[face.object].first_triangle;
        s.count = 1;
        s.point[0] = {face.object, surface.choice.provoking ? triangle : t.face, face.turned};
        s.weight[0] = 1;
        return s;
    }
    const CornerWeights weights = corner_weights(surface.choice.interpolation, g, face);
    const ObjectNormals& normals = surface.normals[face.object];
    s.count = weights.count;
    s.weight = weights.weight;
    for (std::size_t i = 0; i < static_cast<std::size_t>(s.count); ++i)
        s.point[i] = {face.object, normals.slot_of(weights.corner[i]), face.turned};
    return s;
}

}  // namespace glint
