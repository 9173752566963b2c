#include "ui/inspector/vectors/facet_overlay.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "ui/inspector/vectors/arrows.h"
#include "ui/inspector/vectors/facet.h"
#include "ui/ui.h"

namespace glint {
namespace {

constexpr std::size_t most_numbered = 24;  // corners; more numbers than this hide one another

}  // namespace

void draw_facet(ImDrawList& list, const UiState& state, const PictureView& view) {
    const auto facet = picked_facet(*state.why, state.editor.scene());
    if (!facet) return;
    const Object& object = state.editor.scene().objects[static_cast<std::size_t>(state.why->object_index)];
    const glm::dmat4 world = world_from_object(object.transform);
    const auto place = [&](glm::vec3 p) { return glm::dvec3(world * glm::dvec4(glm::dvec3(p), 1)); };
    const auto window = [&](glm::dvec3 p) { return view.to_window(project(view.map, p).pixel); };
    glm::dvec3 middle(0);
    std::vector<ImVec2> outline;
    for (const glm::vec3 corner : facet->corners) {
        middle += place(corner) / double(facet->corners.size());
        outline.push_back(window(place(corner)));
    }
    const int count = static_cast<int>(outline.size());
    list.AddPolyline(outline.data(), count, packed({0, 0, 0, 1}, 0.6f), ImDrawFlags_Closed, px(3.6f));
    list.AddPolyline(outline.data(), count, packed({1, 1, 1, 1}), ImDrawFlags_Closed, px(1.2f));
    const ImVec4& edge = dark_theme()[Symbol::Diffuse];
    draw_arrow(list, outline[0], outline[1], {edge, 2.5f, "a"});
    draw_arrow(list, outline[0], outline[2], {edge, 2.5f, "b"});
    for (std::size_t i = 0; i < std::min(outline.size(), most_numbered); ++i)
        rimmed_text(list, {outline[i].x, outline[i].y + px(12)}, {1, 1, 1, 1}, std::to_string(i + 1));
    // Normals go by the inverse transpose; a mirrored scale turns the winding round.
    const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(glm::dmat3(world)));
    const glm::dvec3 n = normal_matrix * glm::dvec3(facet->newell);
    if (glm::length(n) == 0) return;
    const PointPen pen = pen_at(list, view, middle, 70);
    draw_arrow(list, pen.at(glm::dvec3(0)), pen.at(glm::normalize(n)),
               {dark_theme()[Symbol::N], 2.5f, "a×b"});
}

}  // namespace glint
