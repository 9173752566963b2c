#include "renderer/shade/culled_by_light.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include "renderer/geometry/object_normals.h"
#include "renderer/shade/light_sources.h"

namespace glint {
namespace {

/// The first enabled light in camera coordinates: its position (w = 1; the centre of an area light) or the
/// direction towards it (w = 0).
glm::dvec4 first_light(const std::vector<LightSource>& sources) {
    glm::dvec3 sum(0);
    std::size_t count = 0;
    for (; count < sources.size() && sources[count].light == sources[0].light; ++count)
        sum += glm::dvec3(sources[count].xyz.x, sources[count].xyz.y, sources[count].xyz.z);
    return {sum / static_cast<double>(count), sources[0].w};
}

bool faces_away(const ObjectGeometry& object, std::uint32_t face, glm::dvec3 n, glm::dvec4 light) {
    return !(glm::dot(n, glm::dvec3(light) - light.w * object.centroid(face)) > 0);
}

}  // namespace

std::vector<std::uint8_t> culled_by_light(const Scene& scene, const Geometry& g) {
    if (!lights_cull(scene)) return {};
    const std::vector<LightSource> sources = light_sources(scene);
    if (sources.empty()) return {};
    const glm::dvec4 light = first_light(sources);
    const NormalMistakes mistakes = normal_mistakes(scene.shading.mistakes);
    std::vector<std::uint8_t> culled(g.triangle_count, 0);
    for (std::size_t o = 0; o < g.objects.size(); ++o) {
        const ObjectGeometry& object = g.objects[o];
        const std::vector<Triangle>& triangles = object.mesh->triangles;
        const bool flip = scene.objects[o].normals.flip;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size()), [&](const auto& range) {
            std::uint32_t face =
                no_index;  // of the previous triangle, so that a polygon of many triangles is tested once
            std::uint8_t away = 0;
            for (std::size_t t = range.begin(); t != range.end(); ++t) {
                if (triangles[t].face != face) {
                    face = triangles[t].face;
                    const glm::dvec3 n(camera_facet_normal(object, flip, face, mistakes));
                    away = faces_away(object, face, n, light) ? 1 : 0;
                }
                culled[object.first_triangle + t] = away;
            }
        });
    }
    return culled;
}

}  // namespace glint
