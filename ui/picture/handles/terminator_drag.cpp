#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/inspect/reflectance/highlight.h"
#include "ui/picture/handles/highlight_drag.h"
#include "ui/picture/handles/surface_patch.h"

namespace glint {

bool terminator_under(const SurfaceView& view, const Light& light, glm::dvec2 pixel, double reach) {
    const auto patch = surface_patch(view.renderer, view.map.size, pixel, 1);
    if (!patch) return false;
    const auto cosine = [&](std::size_t i) {
        return cosine_at(view.scene, view.map.size, light, patch->points[i]);
    };
    // Of the nine pixels the four beside the middle: 1 above, 3 and 5 left and right, 7 below.
    const auto slope = [&](std::size_t before, std::size_t after) {
        const double span = (patch->used[before] ? 1 : 0) + (patch->used[after] ? 1 : 0);
        return span > 0 ? (cosine(after) - cosine(before)) / span : 0.0;
    };
    const double steepness = std::hypot(slope(3, 5), slope(1, 7));
    return steepness > 1e-6 && std::abs(cosine(4)) <= reach * steepness;
}

std::optional<Light> dragged_terminator(const TerminatorDrag& drag, const SurfaceView& view,
                                        glm::dvec2 pixel) {
    const auto point = seen_at(view.renderer, view.map.size, pixel);
    if (!point) return {};
    const glm::dvec3 n(view.map.world_from_view * glm::dvec4(glm::dvec3(point->normal), 0));
    if (drag.start.kind == LightKind::Directional) {
        const glm::dvec3 l = direction_of(drag.start, view.map), flat = l - glm::dot(l, n) * n;
        if (glm::length(flat) < 1e-3) return {};
        return placed_at(drag.start, view.dome.centre + flat, view.dome, view.map);
    }
    const glm::dvec3 p(view.map.world_from_view * glm::dvec4(glm::dvec3(point->place), 1));
    const glm::dvec3 from = handle_of(drag.start, view.dome, view.map), way = from - p;
    const glm::dvec3 flat = way - glm::dot(way, n) * n;
    if (glm::length(flat) < 1e-3 * glm::length(way)) return {};
    return placed_at(drag.start, p + flat, view.dome, view.map);
}

}  // namespace glint
