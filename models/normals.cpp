#include "models/normals.h"

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "models/polygon.h"
#include "models/vertex_normals.h"

namespace glint {
namespace {

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const glm::dvec3 d(v);
    const double length = std::sqrt(glm::dot(d, d));
    return length > 0 ? glm::vec3(d / length) : glm::vec3(0);
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

/// The mesh's own normals, made unit; corners without one take their vertex normal.
CornerNormals given_normals(const Mesh& mesh, const NormalOptions& options) {
    CornerNormals result;
    result.normals.reserve(mesh.normals.size());
    for (const glm::vec3& n : mesh.normals) result.normals.push_back(unit_or_zero(n));
    result.corner = mesh.corner_normal;
    const auto& index = mesh.corner_normal.empty() ? mesh.corner_position : mesh.corner_normal;
    const auto missing = [&](std::uint32_t i) { return i == no_index || result.normals[i] == glm::vec3(0); };
    std::vector<std::size_t> without;
    for (std::size_t c = 0; c < index.size(); ++c)
        if (missing(index[c])) without.push_back(c);
    if (without.empty()) return result;

    const CornerNormals vertex = vertex_normals(mesh, options.weighting, options.crease_deg);
    const auto& vertex_index = vertex.corner.empty() ? mesh.corner_position : vertex.corner;
    const auto first = static_cast<std::uint32_t>(result.normals.size());
    result.corner = index;
    result.normals.insert(result.normals.end(), vertex.normals.begin(), vertex.normals.end());
    for (const std::size_t c : without) result.corner[c] = first + vertex_index[c];
    result.warnings.push_back(
        without.size() == 1
            ? std::string("1 corner has no normal; its vertex normal is used")
            : fmt::format("{} corners have no normal; their vertex normals are used", without.size()));
    return result;
}

NormalSource automatic(GivenNormals given) {
    switch (given) {
    case GivenNormals::File:
        return NormalSource::File;
    case GivenNormals::Analytic:
        return NormalSource::Analytic;
    case GivenNormals::None:
        return NormalSource::Vertex;
    }
    return NormalSource::Vertex;  // not reached
}

const char* source_name(NormalSource source) {
    switch (source) {
    case NormalSource::Auto:
        return "auto";
    case NormalSource::File:
        return "file";
    case NormalSource::Facet:
        return "facet";
    case NormalSource::Vertex:
        return "vertex";
    case NormalSource::Analytic:
        return "analytic";
    }
    return "";  // not reached
}

}  // namespace

glm::vec3 facet_normal(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    return glm::vec3(triangle_plane(a, b, c).normal);
}

glm::vec3 facet_normal(const Mesh& mesh, std::size_t face) {
    return glm::vec3(polygon_plane(mesh, face).normal);
}

CornerNormals corner_normals(const Mesh& mesh, const NormalOptions& options) {
    if (options.source == NormalSource::Facet) return facet_normals(mesh);
    const NormalSource taken =
        options.source == NormalSource::Vertex ? NormalSource::Vertex : automatic(mesh.given_normals);
    CornerNormals result = taken == NormalSource::Vertex
                               ? vertex_normals(mesh, options.weighting, options.crease_deg)
                               : given_normals(mesh, options);
    if (taken != options.source && options.source != NormalSource::Auto)
        result.warnings.insert(result.warnings.begin(),
                               fmt::format("the mesh has no \"{}\" normals; \"{}\" normals are used",
                                           source_name(options.source), source_name(taken)));
    return result;
}

}  // namespace glint
