#include "ui/inspector/vectors/facet.h"

#include <glm/geometric.hpp>

#include "models/mesh/normals.h"

namespace glint {

std::optional<Facet> picked_facet(const Explanation& why, const Scene& scene) {
    const auto object = static_cast<std::size_t>(why.object_index);
    if (!why.hit || object >= scene.objects.size()) return {};
    const MeshPtr& mesh = scene.objects[object].mesh;
    if (!mesh || why.face >= mesh->face_count()) return {};
    Facet facet;
    for (const std::uint32_t p : mesh->corners_of(why.face)) facet.corners.push_back(mesh->positions[p]);
    if (facet.corners.size() < 3) return {};
    facet.edge_a = facet.corners[1] - facet.corners[0];
    facet.edge_b = facet.corners[2] - facet.corners[0];
    facet.cross = glm::cross(facet.edge_a, facet.edge_b);
    facet.of_edges = facet_normal(facet.corners[0], facet.corners[1], facet.corners[2]);
    facet.newell = facet_normal(*mesh, why.face);
    return facet;
}

}  // namespace glint
