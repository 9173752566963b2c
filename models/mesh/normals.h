#pragma once
// Where a corner's normal comes from (lecture: "Vertex Normals", "Computing Normals").

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/mesh/mesh.h"

namespace glint {

enum class NormalSource { Auto, File, Facet, Vertex, Analytic };
enum class NormalWeighting { Uniform, Area, Angle };

struct NormalOptions {
    NormalSource source = NormalSource::Auto;
    NormalWeighting weighting = NormalWeighting::Angle;
    float crease_deg = 180;  // 0 to 180; facets that meet at more are not averaged across; 180: no crease
    bool operator==(const NormalOptions&) const = default;
};

/// v / |v|; (0, 0, 0) stays so.
[[nodiscard]] glm::dvec3 unit_or_zero(const glm::dvec3& v);

/// Unit normal of triangle a, b, c, on the side from which they run counter-clockwise.
/// Three points in one frame, any unit of length; the result is in that frame.
/// Degenerate (equal or collinear corners): (0, 0, 0), which lights black and is counted by `glint info`.
/// Source: lecture, "Computing Normals": the cross product of two edges that leave one corner.
[[nodiscard]] glm::vec3 facet_normal(glm::vec3 a, glm::vec3 b, glm::vec3 c);

/// Unit normal of polygon f by Newell's method, object coordinates, outward; (0, 0, 0) when it has no area.
/// Source: M. Newell, in Sutherland, Sproull, Schumacker 1974; formulas: docs/architecture.md.
[[nodiscard]] glm::vec3 facet_normal(const Mesh& mesh, std::size_t face);

/// Normals of all corners, object coordinates, unit (or zero where nothing defines one).
struct CornerNormals {
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t>
        corner;         // #C, indices into normals; empty: corner c has normals[corner_position[c]]
    Warnings warnings;  // source fallen back, corners without a normal
};
/// By the source, weighting and crease of `options`. A source that the mesh does not have falls back as
/// `auto` does, with a warning; corners without a normal of the chosen source (or with a zero one) take their
/// vertex normal, with a counted warning. `crease_deg` is used by vertex normals only. Never NaN. 1 million
/// triangles: about 60 ms; with a crease below 180 degrees, which needs the topology, 300 ms.
[[nodiscard]] CornerNormals corner_normals(const Mesh& mesh, const NormalOptions& options);

/// The warning that corner_normals() gives of corners without a normal in the mesh's own, for `glint info`.
void warn_of_missing_normals(const Mesh& mesh, Warnings& warnings);

}  // namespace glint
