#include "renderer/shade/culled_by_light.h"

#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include "renderer/geometry/object_normals.h"
#include "renderer/shade/light_sources.h"

namespace glint {
namespace {

/// The first enabled light, camera coordinates: its place (w = 1; of an area light its centre) or the
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
        tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t t) {
            const std::uint32_t face = triangles[t].face;
            const glm::vec3 n = camera_facet_normal(object, scene.objects[o].normals.flip, face, mistakes);
            culled[object.first_triangle + t] = faces_away(object, face, glm::dvec3(n), light);
        });
    }
    return culled;
}

}  // namespace glint
