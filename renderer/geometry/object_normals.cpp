#include "renderer/geometry/object_normals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <utility>

#include "models/scene/mistakes.h"
#include "renderer/geometry/vertex_transform.h"
#include "renderer/simd/glm_vec3.h"

namespace glint {
namespace {

constexpr glm::vec3 opengl_default_normal{0, 0, 1};  // OpenGL's normal if none is given

/// Transforms an object's normals to camera coordinates: a matrix, and a translation for the mistake that
/// transforms normals like points.
struct NormalFrame {
    Matrix3 matrix;
    Vec3<double> offset;

    /// Transforms a normal; the result is not normalized.
    [[nodiscard]] Vec3<double> to_camera(Vec3<double> n) const {
        return glint::to_camera(matrix, n) + offset;
    }
};

/// The matrix for the normals.
glm::dmat3 linear_part(const ObjectGeometry& object, const NormalMistakes& mistakes) {
    const glm::dmat3 all(object.view_from_object);
    const auto model = [&] { return glm::dmat3(world_from_object(object.transform)); };
    const auto view = [&] { return all * glm::inverse(model()); };
    if (mistakes.left_in_object) return glm::dmat3(1.0);
    if (mistakes.left_in_world) return glm::transpose(glm::inverse(model()));
    if (mistakes.without_model) return view();
    if (mistakes.by_inverse) {
        if (mistakes.form == 0) return glm::inverse(all);
        if (mistakes.form == 1) return view() * glm::inverse(model());
        return glm::transpose(view()) * glm::transpose(glm::inverse(model()));
    }
    if (mistakes.by_projection) {
        const glm::dmat4& clip = object.clip_from_object;
        return glm::dmat3(mistakes.form == 0 ? glm::transpose(glm::inverse(clip)) : clip);
    }
    if (mistakes.by_model_matrix || mistakes.as_points) return glm::dmat3(object.view_from_object);
    return object.normal_matrix;
}

/// `flip`: the normals are reversed as well.
NormalFrame normal_frame(const ObjectGeometry& object, bool flip, const NormalMistakes& mistakes) {
    const glm::dmat3 m = linear_part(object, mistakes);
    const bool inside_out = mistakes.mirror_turns && object.mirrored;
    const bool turned = (flip != mistakes.flipped) != inside_out;
    NormalFrame frame;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) frame.matrix.column[c][r] = turned ? -m[c][r] : m[c][r];
    const bool in_camera = !mistakes.left_in_object && !mistakes.left_in_world;
    if (mistakes.as_points && in_camera) {
        glm::dvec3 t(object.view_from_object[3]);
        if (mistakes.form == 1) {  // lit in world coordinates, rotated to camera coordinates
            const glm::dmat4 model = world_from_object(object.transform);
            t = glm::dmat3(object.view_from_object) * glm::inverse(glm::dmat3(model)) * glm::dvec3(model[3]);
        }
        frame.offset = {t.x, t.y, t.z};
    }
    return frame;
}

Vec3<double> object_normal(glm::vec3 n, const NormalMistakes& mistakes) {
    if (mistakes.none_given) n = opengl_default_normal;
    if (mistakes.axes_exchanged) {
        const AxesForm axes = axes_form(mistakes.form);
        const glm::vec3 given = n;
        for (int i = 0; i < 3; ++i) n[i] = static_cast<float>(axes.sign[i]) * given[axes.from[i]];
    }
    return {n.x, n.y, n.z};
}

/// Lengths of the file's normals before normalization, one for each of `of_mesh->normals`.
std::vector<float> given_lengths(const ObjectNormals& normals) {
    std::vector<float> lengths(normals.of_mesh->normals.size(), 1);
    const Mesh& mesh = *normals.mesh;
    const NormalSource source = normals.options.source;
    const bool from_file = source == NormalSource::File || source == NormalSource::Auto;
    if (mesh.given_normals != GivenNormals::File || !from_file) return lengths;
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c) {
        const std::uint32_t given = mesh.given_normal_of(c);
        if (given == no_index) continue;
        const std::uint32_t which =
            normals.of_mesh->corner.empty() ? mesh.corner_position[c] : normals.of_mesh->corner[c];
        const float length = glm::length(mesh.normals[given]);
        if (length > 0) lengths[which] = length;
    }
    return lengths;
}

/// For each of `of_mesh->normals`, 1 if it comes from a file or a formula, and 0 if it comes from facets.
std::vector<std::uint8_t> own_normals(const ObjectNormals& normals) {
    std::vector<std::uint8_t> own(normals.of_mesh->normals.size(), 0);
    const Mesh& mesh = *normals.mesh;
    const NormalSource source = normals.options.source;
    const bool from_facets = source == NormalSource::Facet || source == NormalSource::Vertex;
    if (mesh.given_normals == GivenNormals::None || from_facets) return own;
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c) {
        const std::uint32_t given = mesh.given_normal_of(c);
        if (given != no_index && mesh.normals[given] != glm::vec3(0)) own[normals.normal_of_corner()[c]] = 1;
    }
    return own;
}

/// Changes the sign of one component of a facet normal in object coordinates.
glm::vec3 with_wrong_component(glm::vec3 facet, const NormalMistakes& mistakes) {
    constexpr int component[3] = {1, 0, 2};
    facet[component[mistakes.form % 3]] *= -1;
    return facet;
}

/// Transforms the normals with the mistakes.
void transform_mistaken_normals(ObjectNormals& normals, const NormalFrame& frame,
                                const NormalMistakes& mistakes) {
    std::vector<float> lengths;
    const bool keeps_lengths = mistakes.unnormalized || mistakes.lengths;
    if (keeps_lengths) lengths = given_lengths(normals);
    std::vector<std::uint8_t> own;
    if (mistakes.facets_reversed || mistakes.cross_component_wrong) own = own_normals(normals);
    tbb::parallel_for(std::size_t{0}, normals.normals.size(), [&](std::size_t i) {
        const bool reversed = mistakes.facets_reversed && !own[i];
        glm::vec3 given = normals.of_mesh->normals[i];
        if (mistakes.cross_component_wrong && !own[i]) given = with_wrong_component(given, mistakes);
        const Vec3<double> n = frame.to_camera(object_normal(reversed ? -given : given, mistakes));
        const bool kept = keeps_lengths || std::isnan(n.x);
        const double length = keeps_lengths ? static_cast<double>(lengths[i]) : 1;
        const glm::vec3 taken = to_glm(kept ? length * n : unit_or_zero(n));
        constexpr float most = 1e18f;  // products with positions must fit in a float
        const glm::vec3 held = glm::clamp(taken, -most, most);
        normals.normals[i] = {held.x, held.y, held.z};
    });
}

void transform_normals(ObjectNormals& normals, const ObjectGeometry& object, const NormalMistakes& mistakes) {
    const std::vector<glm::vec3>& from = normals.of_mesh->normals;
    normals.normals.resize(from.size());
    const NormalFrame frame = normal_frame(object, normals.options.flip, mistakes);
    if (mistakes.unnormalized || mistakes.none_given || mistakes.as_points || mistakes.facets_reversed ||
        mistakes.lengths || mistakes.axes_exchanged || mistakes.cross_component_wrong || mistakes.zero_is_nan)
        return transform_mistaken_normals(normals, frame, mistakes);
    if (from.empty()) return;
    const NormalJob job{&from.front().x, frame.matrix, normals.normals.data()};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, from.size(), 4096), [&job](const auto& range) {
        geometry_kernels().transform_normals(job, range.begin(), range.end());
    });
}

/// Returns the normal of the plane through the first three corners.
glm::vec3 normal_of_first_corners(const Mesh& mesh, std::size_t face) {
    const auto around = mesh.corners_of(face);
    if (around.size() < 3) return glm::vec3(0);
    return facet_normal(mesh.positions[around[0]], mesh.positions[around[1]], mesh.positions[around[2]]);
}

/// Whether the mistakes replace the normals that the mesh and the options define.
bool gives_other_normals(const NormalMistakes& m) {
    return m.first_corners || m.last_facet_wins || m.positions || m.by_position_index || m.zero_is_nan;
}

/// Returns the mistaken normal of a corner, object coordinates.
glm::vec3 mistaken_corner(const ObjectNormals& n, std::size_t face, std::uint32_t corner,
                          const NormalMistakes& mistakes, const std::vector<glm::vec3>& last_facets) {
    const Mesh& mesh = *n.mesh;
    const std::uint32_t position = mesh.corner_position[corner];
    const NormalSource source = used_source(mesh, n.options.source);
    const bool given = source == NormalSource::File || source == NormalSource::Analytic;
    if (mistakes.positions) return glm::vec3(unit_or_zero(glm::dvec3(mesh.positions[position])));
    if (mistakes.last_facet_wins && source == NormalSource::Vertex) return last_facets[position];
    if (mistakes.first_corners && source == NormalSource::Facet) return normal_of_first_corners(mesh, face);
    if (mistakes.by_position_index && given)
        return position < mesh.normals.size() ? glm::vec3(unit_or_zero(glm::dvec3(mesh.normals[position])))
                                              : opengl_default_normal;
    if (mistakes.zero_is_nan && given) {
        const std::uint32_t which = mesh.given_normal_of(corner);
        if (which == no_index || mesh.normals[which] == glm::vec3(0)) return glm::vec3(__builtin_nanf(""));
    }
    return n.of_mesh->normals[n.normal_of_corner()[corner]];
}

/// Replaces of_mesh with the wrong normals of all corners that the mistakes cause.
void take_mistaken_normals(ObjectNormals& n, const NormalMistakes& mistakes) {
    const Mesh& mesh = *n.mesh;
    std::vector<glm::vec3> last_facets(mistakes.last_facet_wins ? mesh.positions.size() : 0);
    if (mistakes.last_facet_wins)
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (const std::uint32_t p : mesh.corners_of(f)) last_facets[p] = facet_normal(mesh, f);
    auto made = std::make_shared<CornerNormals>();
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            made->corner.push_back(c);
            made->normals.push_back(mistaken_corner(n, f, c, mistakes, last_facets));
        }
    made->warnings = n.of_mesh->warnings;
    n.of_mesh = made;
    n.mistaken = true;
}

/// The known normals of meshes, with the options they were computed for.
using KnownNormals =
    std::multimap<const Mesh*, std::pair<NormalOptions, std::shared_ptr<const CornerNormals>>>;

std::shared_ptr<const CornerNormals> normals_of(KnownNormals& known, const Object& object) {
    const auto [begin, end] = known.equal_range(object.mesh.get());
    for (auto at = begin; at != end; ++at)
        if (at->second.first == object.normals) return at->second.second;
    auto made = std::make_shared<const CornerNormals>(corner_normals(*object.mesh, object.normals));
    known.insert({object.mesh.get(), {object.normals, made}});
    return made;
}

/// Updates the normals of objects whose mesh or options have changed. Objects with the same mesh and options
/// share them.
void take_normals(std::vector<ObjectNormals>& kept, const Scene& scene) {
    KnownNormals known;
    for (std::size_t o = 0; o < kept.size(); ++o) {
        const Object& object = scene.objects[o];
        if (kept[o].mesh == object.mesh && kept[o].options == object.normals && !kept[o].mistaken) continue;
        if (known.empty())
            for (const ObjectNormals& n : kept)
                if (n.of_mesh && !n.mistaken) known.insert({n.mesh.get(), {n.options, n.of_mesh}});
        kept[o].of_mesh = normals_of(known, object);
        kept[o].mesh = object.mesh;
        kept[o].options = object.normals;
        kept[o].mistaken = false;
    }
}

struct MeshFace {
    std::weak_ptr<const Mesh> mesh;  // keeps the address from being reused
    std::uint32_t face = 0;
    bool operator==(const MeshFace& other) const {
        if (face != other.face) return false;
        const MeshPtr own = mesh.lock();
        return own && own == other.mesh.lock();
    }
};

/// The facet normal, object coordinates.
glm::vec3 known_facet_normal(const MeshPtr& mesh, std::uint32_t face) {
    if (mesh->corners_of(face).size() < many_corners) return facet_normal(*mesh, face);
    thread_local RecentFaces<MeshFace, glm::vec3> known;
    return known.of({mesh, face}, [&] { return facet_normal(*mesh, face); });
}

}  // namespace

NormalMistakes normal_mistakes(const Mistakes& m) {
    return {.unnormalized = m.unnormalized_normals,
            .by_model_matrix = m.normals_by_model_matrix,
            .flipped = m.normals_flipped,
            .none_given = m.no_normals_given,
            .left_in_object = m.normals_left_in_object,
            .left_in_world = m.normals_left_in_world,
            .as_points = m.normals_as_points,
            .facets_reversed = m.cross_reversed,
            .mirror_turns = m.mirror_turns_inside_out,
            .unnormalized_at_pixel = m.interpolated_normals_not_normalized || m.unnormalized_normals,
            .some_faces_flipped = m.some_faces_flipped,
            .without_model = m.normals_without_model,
            .by_inverse = m.normals_by_inverse,
            .by_projection = m.normals_by_projection,
            .of_screen_points = m.facet_normals_of_screen_points,
            .cross_component_wrong = m.cross_component_wrong,
            .first_corners = m.facet_normal_of_first_corners,
            .last_facet_wins = m.last_facet_wins,
            .axes_exchanged = m.normals_axes_exchanged,
            .positions = m.positions_as_normals,
            .by_position_index = m.normals_by_position_index,
            .lengths = m.interpolated_lengths,
            .zero_is_nan = m.zero_normal_is_nan,
            .form = m.form};
}

void update_normals(std::vector<ObjectNormals>& kept, const Scene& scene, const Geometry& g,
                    const NormalMistakes& mistakes) {
    kept.resize(scene.objects.size());
    take_normals(kept, scene);
    if (gives_other_normals(mistakes))
        for (ObjectNormals& n : kept) take_mistaken_normals(n, mistakes);
    for (std::size_t o = 0; o < kept.size(); ++o) transform_normals(kept[o], g.objects[o], mistakes);
}

bool same_normals(const std::vector<ObjectNormals>& kept, const Scene& scene) {
    if (kept.size() != scene.objects.size()) return false;
    for (std::size_t o = 0; o < scene.objects.size(); ++o)
        if (kept[o].mesh != scene.objects[o].mesh || kept[o].options != scene.objects[o].normals)
            return false;
    return true;
}

glm::vec3 camera_facet_normal(const ObjectGeometry& object, bool flip, std::uint32_t face,
                              const NormalMistakes& mistakes) {
    glm::vec3 facet = mistakes.first_corners ? normal_of_first_corners(*object.mesh, face)
                                             : known_facet_normal(object.mesh, face);
    if (mistakes.cross_component_wrong) facet = with_wrong_component(facet, mistakes);
    if (mistakes.of_screen_points) {
        const glm::vec3 n = glm::mat3(object.normal_matrix) * facet;
        const glm::vec3 p = object.position(object.mesh->corners_of(face)[0]);
        return {0, 0, glm::dot(n, p) < 0 ? 1 : -1};
    }
    const Vec3<double> n = object_normal(mistakes.facets_reversed ? -facet : facet, mistakes);
    return to_glm(unit_or_zero(normal_frame(object, flip, mistakes).to_camera(n)));
}

}  // namespace glint
