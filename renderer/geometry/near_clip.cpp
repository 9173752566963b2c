#include "renderer/geometry/near_clip.h"

#include <glm/vec4.hpp>

#include "renderer/geometry/to_screen.h"

namespace glint {

std::pmr::vector<CutCorner> cut_at_near(const Geometry& g, std::uint32_t object_index,
                                        std::span<const std::uint32_t> corners, CutMemory& memory) {
    const ObjectGeometry& object = g.objects[object_index];
    const glm::dmat4 clip_from_object = clip_from_view(g.camera.projection, g.size) * object.view_from_object;
    std::pmr::vector<glm::dvec4> clip(&memory.pool);
    clip.reserve(corners.size());
    for (const std::uint32_t c : corners)
        clip.push_back(clip_from_object *
                       glm::dvec4(glm::dvec3(object.mesh->positions[object.mesh->corner_position[c]]), 1.0));

    std::pmr::vector<CutCorner> cut(&memory.pool);
    cut.reserve(corners.size() + 1);
    const auto add = [&](const glm::dvec4& corner, std::size_t i, std::size_t j, double t) {
        const glm::dvec4 c = before_eye(g.camera.projection, corner);
        cut.push_back({{(c.x / c.w + 1) * 0.5 * g.size.width, (1 - c.y / c.w) * 0.5 * g.size.height},
                       corners[i],
                       corners[j],
                       t});
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t j = (i + 1) % corners.size();
        const double here = clip[i].z + clip[i].w, next = clip[j].z + clip[j].w;  // in front where >= 0
        if (here >= 0) add(clip[i], i, i, 0);
        if ((here >= 0) == (next >= 0)) continue;
        const double t = here / (here - next);
        add(clip[i] + t * (clip[j] - clip[i]), i, j, t);
    }
    return cut;
}

}  // namespace glint
