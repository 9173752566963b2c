// The facet's own normal.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>
#include <vector>

#include "models/mesh/normals.h"
#include "ui/features/inspector/vectors/arrows.h"
#include "ui/features/inspector/vectors/vectors_tab.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {

std::optional<Facet> picked_facet(const Explanation& explanation, const Scene& scene) {
    const auto object = static_cast<std::size_t>(explanation.object_index);
    if (!explanation.hit || object >= scene.objects.size()) return {};
    const MeshPtr& mesh = scene.objects[object].mesh;
    if (!mesh || explanation.face >= mesh->face_count()) return {};
    Facet facet;
    for (const std::uint32_t p : mesh->corners_of(explanation.face))
        facet.corners.push_back(mesh->positions[p]);
    if (facet.corners.size() < 3) return {};
    facet.edge_a = facet.corners[1] - facet.corners[0];
    facet.edge_b = facet.corners[2] - facet.corners[0];
    facet.cross = glm::cross(facet.edge_a, facet.edge_b);
    facet.of_edges = facet_normal(facet.corners[0], facet.corners[1], facet.corners[2]);
    facet.newell = facet_normal(*mesh, explanation.face);
    return facet;
}

void facet_section(const UiState& state, const Explanation& explanation) {
    const auto facet = picked_facet(explanation, explained_scene(state));
    if (!facet) return;
    section_heading("The facet's own normal, object coordinates");
    const Symbol edge = Symbol::Construction;
    vector_line(edge, "1→2", facet->edge_a);
    vector_line(edge, "1→3", facet->edge_b);
    vector_line(Symbol::N, "1→2 × 1→3", facet->cross);
    vector_line(Symbol::N, "normalised", facet->of_edges);
    vector_line(Symbol::N, "Newell", facet->newell);
    const float length = glm::length(facet->cross);
    const Object& object = explained_scene(state).objects[static_cast<std::size_t>(explanation.object_index)];
    const bool is_mirrored = glm::determinant(glm::dmat3(world_from_object(object.transform))) < 0;
    small_dim(fmt::format(
        "The product is {:.4g} long: twice the area of the triangle 1 2 3. {} corners, counter-clockwise "
        "seen from outside; seen from here {}.",
        length, facet->corners.size(), explanation.front_facing != is_mirrored ? "too" : "clockwise"));
    if (glm::dot(facet->of_edges, facet->newell) < 0.9999f && length > 0)
        warning_text("The corners are not in one plane, or not convex: Newell's method uses all of them.");
}

void draw_facet(ImDrawList& list, const UiState& state, const PictureView& view) {
    const auto facet = picked_facet(*state.on_screen.explanation, explained_scene(state));
    if (!facet) return;
    const Object& object =
        explained_scene(state).objects[static_cast<std::size_t>(state.on_screen.explanation->object_index)];
    const glm::dmat4 world = world_from_object(object.transform);
    std::vector<glm::dvec3> corners;
    glm::dvec3 middle(0);
    for (const glm::vec3 corner : facet->corners) {
        corners.emplace_back(world * glm::dvec4(glm::dvec3(corner), 1));
        middle += corners.back() / double(facet->corners.size());
    }
    const WorldPen outline{list, view};
    for (const auto& [colour, width] : {std::pair(rim_colour(), 1.2f + rim_width), {IM_COL32_WHITE, 1.2f}})
        for (std::size_t i = 0; i < corners.size(); ++i)
            outline.line(corners[i], corners[(i + 1) % corners.size()], colour, px(width));
    for (const std::size_t to : {1, 2})
        if (const auto ends = view.shown(corners[0], corners[to]))
            draw_arrow(list, ends->first, ends->second, {dark_theme()[Symbol::Construction], 2.5f, ""});
    constexpr std::size_t max_numbered = 24;  // corners; more numbers than this would overlap
    for (std::size_t i = 0; i < std::min(corners.size(), max_numbered); ++i)
        if (const ProjectedPoint at = project(view.map, corners[i]); at.in_front)
            rimmed_text(list, view.to_window(at.pixel) + ImVec2(0, px(12)), {1, 1, 1, 1},
                        std::to_string(i + 1));
    if (!project(view.map, middle).in_front) return;
    // Normals transform by the inverse transpose; a mirrored scale reverses the winding.
    const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(glm::dmat3(world)));
    const glm::dvec3 n = normal_matrix * glm::dvec3(facet->newell);
    if (glm::length(n) == 0) return;
    const PointPen pen = pen_at(list, view, middle, 70);
    draw_arrow(list, pen.at(glm::dvec3(0)), pen.at(glm::normalize(n)), {dark_theme()[Symbol::N], 2.5f, "n"});
}

}  // namespace glint
