#include "renderer/pipeline/object_normals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

namespace glint {
namespace {

constexpr glm::vec3 opengl_default_normal{0, 0, 1};  // what OpenGL takes while no normal was given

/// An object's normal in camera coordinates, as long as the matrix leaves it.
glm::dvec3 to_camera(const ObjectGeometry& object, glm::vec3 n, const NormalMistakes& mistakes) {
    const glm::dmat3 matrix =
        mistakes.by_model_matrix ? glm::dmat3(object.view_from_object) : object.normal_matrix;
    const glm::dvec3 m = matrix * glm::dvec3(mistakes.none_given ? opengl_default_normal : n);
    return mistakes.flipped ? -m : m;
}

glm::vec3 unit_or_zero(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0 ? glm::vec3(v / length) : glm::vec3(0);
}

/// Lengths that a file's normals had before they were made unit, one for each of `of_mesh.normals`.
std::vector<float> given_lengths(const ObjectNormals& normals) {
    std::vector<float> lengths(normals.of_mesh.normals.size(), 1);
    const Mesh& mesh = *normals.mesh;
    const NormalSource source = normals.options.source;
    const bool from_file = source == NormalSource::File || source == NormalSource::Auto;
    if (mesh.given_normals != GivenNormals::File || !from_file) return lengths;
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c) {
        const std::uint32_t given = mesh.given_normal_of(c);
        if (given == no_index) continue;
        const std::uint32_t which =
            normals.of_mesh.corner.empty() ? mesh.corner_position[c] : normals.of_mesh.corner[c];
        const float length = glm::length(mesh.normals[given]);
        if (length > 0) lengths[which] = length;
    }
    return lengths;
}

}  // namespace

NormalMistakes normal_mistakes(const Mistakes& m) {
    return {m.unnormalized_normals, m.normals_by_model_matrix, m.normals_flipped, m.no_normals_given,
            m.interpolated_normals_not_normalized || m.unnormalized_normals};
}

void update_normals(std::vector<ObjectNormals>& kept, const Scene& scene, const Geometry& g,
                    const NormalMistakes& mistakes) {
    kept.resize(scene.objects.size());
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        ObjectNormals& normals = kept[o];
        if (normals.mesh != scene.objects[o].mesh || normals.options != scene.objects[o].normals) {
            normals.mesh = scene.objects[o].mesh;
            normals.options = scene.objects[o].normals;
            normals.of_mesh = corner_normals(*normals.mesh, normals.options);
        }
        std::vector<float> lengths;
        if (mistakes.unnormalized) lengths = given_lengths(normals);
        normals.normals.resize(normals.of_mesh.normals.size());
        using Range = tbb::blocked_range<std::size_t>;
        tbb::parallel_for(Range(0, normals.normals.size(), 4096), [&](const Range& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) {
                const glm::dvec3 n = to_camera(g.objects[o], normals.of_mesh.normals[i], mistakes);
                const glm::vec3 taken =
                    mistakes.unnormalized ? glm::vec3(static_cast<double>(lengths[i]) * n) : unit_or_zero(n);
                normals.normals[i] = {taken.x, taken.y, taken.z};
            }
        });
    }
}

bool same_normals(const std::vector<ObjectNormals>& kept, const Scene& scene) {
    if (kept.size() != scene.objects.size()) return false;
    for (std::size_t o = 0; o < scene.objects.size(); ++o)
        if (kept[o].mesh != scene.objects[o].mesh || kept[o].options != scene.objects[o].normals)
            return false;
    return true;
}

glm::vec3 camera_facet_normal(const ObjectGeometry& object, std::uint32_t face,
                              const NormalMistakes& mistakes) {
    return unit_or_zero(to_camera(object, facet_normal(*object.mesh, face), mistakes));
}

}  // namespace glint
