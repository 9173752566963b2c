#include "renderer/strokes/strokes.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "renderer/strokes/stroke.h"
#include "renderer/strokes/stroke_coverage.h"

namespace glint {
namespace {

/// Drops the edges of meshes that are gone and finds those of new ones.
void update_meshes(std::vector<MeshEdges>& meshes, const Geometry& g) {
    const auto is_gone = [&g](const MeshEdges& m) {
        return std::none_of(g.objects.begin(), g.objects.end(),
                            [&m](const ObjectGeometry& o) { return o.mesh == m.mesh; });
    };
    meshes.erase(std::remove_if(meshes.begin(), meshes.end(), is_gone), meshes.end());
    for (const ObjectGeometry& o : g.objects)
        if (std::none_of(meshes.begin(), meshes.end(), [&o](const MeshEdges& m) { return m.mesh == o.mesh; }))
            meshes.push_back(mesh_edges(o.mesh));
}

const MeshEdges& edges_of(const std::vector<MeshEdges>& meshes, const MeshPtr& mesh) {
    return *std::find_if(meshes.begin(), meshes.end(), [&](const MeshEdges& m) { return m.mesh == mesh; });
}

/// The eye in object coordinates: straight from the world's, so that an eye in the plane of a facet stays
/// there.
EdgeView edge_view(const Camera& camera, const ObjectGeometry& object) {
    const glm::dmat4 object_from_world = glm::inverse(world_from_object(object.transform));
    const glm::dvec4 eye = is_orthographic(camera.projection)
                               ? glm::dvec4(glm::dvec3(camera.eye) - glm::dvec3(camera.target), 0.0)
                               : glm::dvec4(glm::dvec3(camera.eye), 1.0);
    return {object_from_world * eye, object.normal_matrix};
}

std::vector<float> draw_strokes(Strokes& kept, const Geometry& g, const Visibility& visibility) {
    update_meshes(kept.meshes, g);
    const double margin = 1 + 0.5 * static_cast<double>(kept.width_px);
    std::vector<StrokeLine> lines;
    for (std::uint32_t o = 0; o < g.objects.size(); ++o) {
        const MeshEdges& mesh = edges_of(kept.meshes, g.objects[o].mesh);
        const auto edges = stroke_edges(mesh, edge_view(g.camera, g.objects[o]), kept.choice);
        const auto seen = visible_lines(g, visibility, o, mesh, edges, margin);
        lines.insert(lines.end(), seen.begin(), seen.end());
    }
    return stroke_coverage(g, visibility, lines, kept.width_px);
}

}  // namespace

bool update_strokes(Strokes& kept, const Scene& scene, const Geometry& g, const Visibility& visibility,
                    bool visibility_redone) {
    const Npr& npr = scene.npr;
    const EdgeChoice choice{npr.silhouettes, npr.creases, npr.crease_deg, scene.shading.cull};
    const float width_px = std::min(npr.stroke_width_px, max_stroke_width_px);
    const bool wanted = (npr.silhouettes || npr.creases) && width_px > 0;
    if (!wanted && kept.coverage.empty()) return false;
    if (wanted && !kept.coverage.empty() && !visibility_redone && kept.choice == choice &&
        kept.width_px == width_px)
        return false;
    kept.choice = choice;
    kept.width_px = width_px;
    if (wanted)
        kept.coverage = draw_strokes(kept, g, visibility);
    else
        kept.coverage = {};
    return true;
}

bool draw_over(const Strokes& strokes, const glm::vec3& stroke, std::size_t first_pixel, std::uint16_t mask,
               ColorBlock& colors) {
    if (strokes.coverage.empty()) return false;
    bool any = false;
    for (std::size_t i = 0; i < block_size; ++i) {
        if (!(mask >> i & 1u) || strokes.coverage[first_pixel + i] == 0) continue;
        any = true;
        const Vec3<float> shaded{colors.r[i], colors.g[i], colors.b[i]};
        const Vec3<float> c = drawn_over(shaded, strokes.coverage[first_pixel + i], broadcast<float>(stroke));
        colors.r[i] = c.x;
        colors.g[i] = c.y;
        colors.b[i] = c.z;
    }
    return any;
}

}  // namespace glint
