#pragma once
// Where a corner's normal comes from (lecture: "Vertex Normals", "Computing Normals").

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/mesh.h"

namespace glint {

enum class NormalSource { Auto, File, Facet, Vertex, Analytic };
enum class NormalWeighting { Uniform, Area, Angle };

struct NormalOptions {
    NormalSource source = NormalSource::Auto;
    NormalWeighting weighting = NormalWeighting::Angle;
    float crease_deg = 180;  // 0 to 180; facets that meet at more are not averaged across; 180 is no crease
    bool operator==(const NormalOptions&) const = default;
};

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
[[nodiscard]] CornerNormals corner_normals(const Mesh& mesh, const NormalOptions& options);

}  // namespace glint
