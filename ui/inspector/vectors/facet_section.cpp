#include "ui/inspector/vectors/facet_section.h"

#include <fmt/core.h>
#include <imgui.h>

#include <glm/geometric.hpp>

#include "ui/inspector/equation/parts.h"
#include "ui/inspector/vectors/facet.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
void facet_section(UiState& state, const Explanation& why) {
    const auto facet = picked_facet(why, state.editor.scene());
    if (!facet) return;
    section("The facet's own normal, object coordinates");
    const Symbol edge = Symbol::Diffuse;
    vector_line(edge, "a = 2 − 1", facet->edge_a);
    vector_line(edge, "b = 3 − 1", facet->edge_b);
    vector_line(Symbol::N, "a × b", facet->cross);
    vector_line(Symbol::N, "made unit", facet->of_edges);
    vector_line(Symbol::N, "Newell", facet->newell);
    const float length = glm::length(facet->cross);
    small_dim(
        fmt::format("|a × b| = {:.4g}: twice the area of the triangle 1 2 3. {} corners, counter-clockwise "
                    "seen from outside; seen from here {}.",
                    length, facet->corners.size(), why.front_facing ? "too" : "clockwise"));
    if (glm::dot(facet->of_edges, facet->newell) < 0.9999f && length > 0)
        warning_text("The corners are not in one plane, or not convex: Newell's takes all of them.");
}

}  // namespace glint
