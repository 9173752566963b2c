#pragma once
// The picked facet: the corners around it, two edges that leave one corner, their cross product, and Newell's
// normal over all corners. Lecture: "Computing Normals".

#include <imgui.h>

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/inspect/explain/explanation.h"

namespace glint {

/// Object coordinates.
struct Facet {
    std::vector<glm::vec3> corners;  // counter-clockwise seen from outside, as the file gives them
    glm::vec3 edge_a{0}, edge_b{0};  // from the first corner to the second and to the third
    glm::vec3 cross{0};              // edge_a x edge_b
    glm::vec3 of_edges{0};           // unit normal of the first three corners
    glm::vec3 newell{0};             // unit normal over all corners
};

/// Nothing when the explanation is of no facet of this scene.
[[nodiscard]] std::optional<Facet> picked_facet(const Explanation& explanation, const Scene& scene);

struct UiState;

/// The picked facet's edges, their cross product and its length, and Newell's normal.
void facet_section(UiState& state, const Explanation& explanation);

struct PictureView;

/// The picked facet in the picture: its outline with the corners numbered in their order, two edges and its
/// normal.
void draw_facet(ImDrawList& list, const UiState& state, const PictureView& view);

}  // namespace glint
