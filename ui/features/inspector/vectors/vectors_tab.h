#pragma once
// The vectors of the equation at the picked point: in both frames, in the plane of incidence, in the picture,
// and the construction of r and of the facet's normal.

#include <imgui.h>

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "ui/widgets/theme.h"

namespace glint {

struct UiState;
struct PictureView;

void vectors_tab(UiState& state, const PictureView& view);

/// Draws the plane of incidence at the picked point, seen from the side: n up, l, r, h and v with their
/// angles, and the lobe of this surface for this light. It is as wide as the column. The lobe is computed by
/// renderer/reflectance/lobes.h, in the channel chosen in the equation.
void lobe_diagram(const UiState& state, const ExplainedPoint& point, const ExplainedLight& light);

/// Draws n, l, v and r or h at the picked point in the picture, with their angles; the corners from which a
/// Gouraud pixel is interpolated; the facet's edges and normal. Draws nothing while they are switched off or
/// no object is picked.
void draw_point_vectors(ImDrawList& list, const UiState& state, const PictureView& view);

/// A row: a name in its symbol's colour, and three figures.
void vector_line(Symbol symbol, const char* name, glm::vec3 v);

/// The picked facet in object coordinates: the corners around it, two edges that leave one corner, their
/// cross product, and Newell's normal over all corners. Lecture: "Computing Normals".
struct Facet {
    std::vector<glm::vec3> corners;  // counter-clockwise seen from outside, as in the file
    glm::vec3 edge_a{0}, edge_b{0};  // from the first corner to the second and to the third
    glm::vec3 cross{0};              // edge_a x edge_b
    glm::vec3 of_edges{0};           // unit normal of the first three corners
    glm::vec3 newell{0};             // unit normal over all corners
};

/// nullopt if the explanation is not about a facet of this scene.
[[nodiscard]] std::optional<Facet> picked_facet(const Explanation& explanation, const Scene& scene);

/// Lists the picked facet's edges, their cross product and its length, and Newell's normal.
void facet_section(const UiState& state, const Explanation& explanation);

/// Draws the picked facet in the picture: its outline with numbered corners, two edges and its normal.
void draw_facet(ImDrawList& list, const UiState& state, const PictureView& view);

}  // namespace glint
