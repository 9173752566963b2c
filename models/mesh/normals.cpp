#include "models/mesh/normals.h"

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "models/mesh/polygon.h"
#include "models/problem.h"

namespace glint {
namespace {

void warn_of_missing(std::size_t corners, Warnings& warnings) {
    warn(warnings, corners, "corner has no normal; its vertex normal is used",
         "corners have no normal; their vertex normals are used");
}

CornerNormals facet_normals(const Mesh& mesh) {
    CornerNormals result;
    result.normals.resize(mesh.face_count());
    result.corner.resize(mesh.corner_position.size());
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        result.normals[f] = facet_normal(mesh, f);
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) result.corner[c] = f;
    }
    return result;
}

/// The corners without a given normal, or with a zero one.
std::vector<std::size_t> corners_without_normal(const Mesh& mesh) {
    std::vector<std::size_t> without;
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c) {
        const std::uint32_t given = mesh.given_normal_of(c);
        if (given == no_index || mesh.normals[given] == glm::vec3(0)) without.push_back(c);
    }
    return without;
}

/// The given normals, normalized; corners without one use their vertex normal.
CornerNormals given_normals(const Mesh& mesh, const NormalOptions& options) {
    CornerNormals result;
    result.normals.reserve(mesh.normals.size());
    for (const glm::vec3& n : mesh.normals) result.normals.push_back(glm::vec3(unit_or_zero(glm::dvec3(n))));
    result.corner = mesh.corner_normal;
    const std::vector<std::size_t> without = corners_without_normal(mesh);
    if (without.empty()) return result;

    const CornerNormals vertex = vertex_normals(mesh, options.weighting, options.crease_deg);
    const auto& vertex_index = vertex.corner.empty() ? mesh.corner_position : vertex.corner;
    const auto first = static_cast<std::uint32_t>(result.normals.size());
    result.normals.insert(result.normals.end(), vertex.normals.begin(), vertex.normals.end());
    if (result.corner.empty()) result.corner = mesh.corner_position;
    for (const std::size_t c : without) result.corner[c] = first + vertex_index[c];
    warn_of_missing(without.size(), result.warnings);
    return result;
}

}  // namespace

NormalSource used_source(const Mesh& mesh, NormalSource asked) {
    if (asked == NormalSource::Facet || asked == NormalSource::Vertex) return asked;
    switch (mesh.given_normals) {
    case GivenNormals::File:
        return NormalSource::File;
    case GivenNormals::Analytic:
        return NormalSource::Analytic;
    case GivenNormals::None:
        return NormalSource::Vertex;
    }
    return NormalSource::Vertex;  // not reached
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

glm::vec3 facet_normal(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    return glm::vec3(triangle_plane(a, b, c).normal);
}

glm::vec3 facet_normal(const Mesh& mesh, std::size_t face) {
    return glm::vec3(polygon_plane(mesh, face).normal);
}

void warn_of_missing_normals(const Mesh& mesh, Warnings& warnings) {
    if (mesh.given_normals != GivenNormals::None)
        warn_of_missing(corners_without_normal(mesh).size(), warnings);
}

CornerNormals corner_normals(const Mesh& mesh, const NormalOptions& options) {
    const NormalSource taken = used_source(mesh, options.source);
    if (taken == NormalSource::Facet) return facet_normals(mesh);
    CornerNormals result = taken == NormalSource::Vertex
                               ? vertex_normals(mesh, options.weighting, options.crease_deg)
                               : given_normals(mesh, options);
    if (taken != options.source && options.source != NormalSource::Auto)
        result.warnings.insert(result.warnings.begin(),
                               fmt::format("the mesh has no \"{}\" normals; \"{}\" normals are used",
                                           choice_of(options.source).word, choice_of(taken).word));
    return result;
}

}  // namespace glint
