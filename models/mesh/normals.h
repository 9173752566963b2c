#pragma once
// Finds the normals of a mesh's corners (lecture: "Vertex Normals", "Computing Normals").

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/numbers.h"

namespace glint {

enum class NormalSource { Auto, File, Facet, Vertex, Analytic };
enum class NormalWeighting { Uniform, Area, Angle };

constexpr Choice choice_of(NormalSource source) {
    switch (source) {
    case NormalSource::Auto:
        return {"auto", "Auto", "From the file, else analytic, else averaged"};
    case NormalSource::File:
        return {"file", "File", "From the mesh file"};
    case NormalSource::Facet:
        return {"facet", "Facet", "Normal of each polygon"};
    case NormalSource::Vertex:
        return {"vertex", "Vertex", "Facet normals averaged around each vertex"};
    case NormalSource::Analytic:
        return {"analytic", "Analytic", "From the formula of the surface"};
    }
    return {};
}

constexpr Choice choice_of(NormalWeighting weighting) {
    switch (weighting) {
    case NormalWeighting::Uniform:
        return {"uniform", "Uniform", "Every facet counts equally"};
    case NormalWeighting::Area:
        return {"area", "Area", "Weighted by the facet's area"};
    case NormalWeighting::Angle:
        return {"angle", "Angle", "Weighted by the facet's angle at the vertex"};
    }
    return {};
}

struct NormalOptions {
    NormalSource source = NormalSource::Auto;
    NormalWeighting weighting = NormalWeighting::Angle;
    float crease_deg = 180;  // 0 to 180; facets that meet at a larger angle are not averaged; 180: no crease
    bool flip = false;       // shading uses -n for every normal; corner_normals() ignores it
    bool operator==(const NormalOptions&) const = default;
};

/// v / |v|; (0, 0, 0) is returned unchanged.
[[nodiscard]] glm::dvec3 unit_or_zero(const glm::dvec3& v);

/// The unit normal of triangle a, b, c, which points to the side from which the corners are
/// counter-clockwise. The points may be in any frame and any unit of length; the result is in the same frame.
/// Degenerate (equal or collinear corners): (0, 0, 0), which is lit black and counted by `glint info`.
/// Source: lecture, "Computing Normals": the cross product of two edges at one corner.
[[nodiscard]] glm::vec3 facet_normal(glm::vec3 a, glm::vec3 b, glm::vec3 c);

/// Unit normal of polygon f by Newell's method, object coordinates, outward; (0, 0, 0) if it has no area.
/// Source: M. Newell, in Sutherland, Sproull, Schumacker 1974.
[[nodiscard]] glm::vec3 facet_normal(const Mesh& mesh, std::size_t face);

/// Returns the source that corner_normals() uses: `asked`, or Vertex, File or Analytic for `auto` and for a
/// source that the mesh does not have.
[[nodiscard]] NormalSource used_source(const Mesh& mesh, NormalSource asked);

/// Normals of all corners, in object coordinates, normalized (or zero if undefined).
struct CornerNormals {
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t>
        corner;                 // #C, indices into normals; empty: corner c has normals[corner_position[c]]
    Warnings warnings;          // fallback to another source, corners without a normal
    std::size_t of_facets = 0;  // number of facet normals at the end of `normals`, used if a sum cancels
};
/// Computes the normals by the source, weighting and crease of `options`. A source that the mesh does not
/// have falls back like `auto`, with a warning; corners without a normal of the chosen source (or with a zero
/// one) use their vertex normal, with a counted warning. Only vertex normals use `crease_deg`. The result is
/// never NaN. 1 million triangles take about 60 ms; with a crease below 180 degrees, which needs the
/// topology, 300 ms.
[[nodiscard]] CornerNormals corner_normals(const Mesh& mesh, const NormalOptions& options);

/// The warning from corner_normals() about corners without a given normal, for `glint info`.
void warn_of_missing_normals(const Mesh& mesh, Warnings& warnings);

// Vertex normals: facet normals averaged around each vertex (lecture: "Vertex Normals").
// Source: G. Thürmer and C. Wüthrich, JGT 3(1), 1998 (weighting by angle).

/// Groups the corners at each place whose facets are joined there, directly or through other facets, across
/// manifold edges at which the facet normals differ by at most `crease_deg` (0 to 180). An edge of exactly
/// that angle is joined here, but drawn as a stroke (renderer/strokes/strokes.h). Source:
/// docs/scene_file.md, `normals/crease_deg`.
struct CreaseGroups {
    std::vector<std::uint32_t> group;  // #C, numbered from 0 in the order of their first corner
    std::size_t count = 0;
};
[[nodiscard]] CreaseGroups crease_groups(const Mesh& mesh, const Topology& topology, float crease_deg);

/// Sums the weighted unit facet normals around each place (with a crease below 180 degrees, those of each
/// group of crease_groups()), for each smoothing group of the mesh, and normalizes the sum; object
/// coordinates. If a sum cancels (is shorter than 1e-6 times the sum of its weights), each corner uses its
/// facet normal. Degenerate facets are ignored; their corners get 0 if no other facet is averaged. The angle
/// at a corner is the interior one, which may exceed 180 degrees in a polygon that is not convex. `corner`
/// stays empty if one normal per position is enough.
[[nodiscard]] CornerNormals vertex_normals(const Mesh& mesh, NormalWeighting weighting, float crease_deg);

}  // namespace glint
