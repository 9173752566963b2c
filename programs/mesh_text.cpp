#include "programs/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>

#include "models/mesh/normals.h"

namespace glint {
namespace {

void add_vectors(std::string& text, const char* name, const std::vector<glm::vec3>& vectors) {
    auto out = std::back_inserter(text);
    fmt::format_to(out, "{} {}\n", name, vectors.size());
    for (const glm::vec3& v : vectors) fmt::format_to(out, "{} {} {}\n", v.x, v.y, v.z);
}

/// Whether corner c has a normal (from the file or analytic).
bool has_own_normal(const Object& object, std::size_t corner) {
    const Mesh& mesh = *object.mesh;
    const NormalSource source = object.normals.source;
    if (source == NormalSource::Facet || source == NormalSource::Vertex) return false;
    if (mesh.given_normals == GivenNormals::None) return false;
    const std::uint32_t given = mesh.given_normal_of(corner);
    return given != no_index && mesh.normals[given] != glm::vec3(0);
}

/// The normals of corner_normals(), or those that an incorrect program reads instead.
std::vector<glm::vec3> normals_as_read(const Object& object, const CornerNormals& right,
                                       const Mistakes& mistakes) {
    std::vector<glm::vec3> normals = right.normals;
    const Mesh& mesh = *object.mesh;
    std::vector<bool> done(normals.size());
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c) {
        const std::uint32_t which = right.corner.empty() ? mesh.corner_position[c] : right.corner[c];
        if (done[which]) continue;
        done[which] = true;
        const bool own = has_own_normal(object, c);
        if (mistakes.cross_reversed && !own) normals[which] = -normals[which];
        // Normals from a file keep their length.
        if (mistakes.unnormalized_normals && own && mesh.given_normals == GivenNormals::File)
            normals[which] *= glm::length(mesh.normals[mesh.given_normal_of(c)]);
    }
    return normals;
}

}  // namespace

std::string mesh_text(const Object& object, const Mistakes& mistakes) {
    const Mesh& mesh = *object.mesh;
    const CornerNormals normals = corner_normals(mesh, object.normals);
    std::string text;
    auto out = std::back_inserter(text);
    add_vectors(text, "positions", mesh.positions);
    add_vectors(text, "normals", normals_as_read(object, normals, mistakes));
    add_vectors(text, "colors", mesh.colors);
    fmt::format_to(out, "faces {}\n", mesh.face_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        fmt::format_to(out, "{}", mesh.first_corner[f + 1] - mesh.first_corner[f]);
        for (std::size_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            const std::uint32_t position = mesh.corner_position[c];
            fmt::format_to(out, "  {} {}", position, normals.corner.empty() ? position : normals.corner[c]);
        }
        text += '\n';
    }
    fmt::format_to(out, "triangles {}\n", mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const std::uint32_t first = mesh.first_corner[t.face];
        fmt::format_to(out, "{} {} {} {}\n", t.face, t.corner[0] - first, t.corner[1] - first,
                       t.corner[2] - first);
    }
    return text;
}

}  // namespace glint
