#pragma once
// Vertex normals: facet normals averaged around each vertex (lecture: "Vertex Normals").
// Sources: G. Thürmer and C. Wüthrich, JGT 3(1), 1998 (weighting by angle).

#include "models/mesh/mesh.h"
#include "models/mesh/normals.h"

namespace glint {

/// Object coordinates, unit. Sum of the weighted unit facet normals of a vertex (below 180 degrees: of each
/// group of crease_groups() there), made unit. A sum that cancels (shorter than 1e-6 of its weights) leaves
/// each corner its facet normal; a degenerate facet takes no part and its corners, where no other facet is
/// averaged, get 0. The angle at a corner is the interior one, so that it may pass 180 degrees in a polygon
/// that is not convex. `corner` stays empty when one normal a position says it all.
[[nodiscard]] CornerNormals vertex_normals(const Mesh& mesh, NormalWeighting weighting, float crease_deg);

}  // namespace glint
