#include "renderer/pipeline/near_weights.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "renderer/pipeline/clip.h"

namespace glint {
namespace {

/// A corner of the clipped triangle: where it is on the screen (pixels), and its weights of the original corners.
struct CutCorner {
    glm::dvec2 pixel;
    glm::dvec3 weights;
};

struct CutTriangle {
    std::array<CutCorner, 4> corner;
    std::size_t count = 0;
};

CutTriangle cut_at_near(const Geometry& g, const SampleFace& face) {
    const ObjectGeometry& object = g.objects[face.object];
    const glm::dmat4 clip_from_object =
        clip_from_view(g.camera.projection, g.size) * object.view_from_object;
    const auto index = g.position_indices(face.object, g.triangle(face.object, face.triangle));
    std::array<glm::dvec4, 3> clip;
    for (std::size_t i = 0; i < 3; ++i)
        clip[i] = clip_from_object * glm::dvec4(glm::dvec3(object.mesh->positions[index[i]]), 1.0);

    CutTriangle cut;
    const auto add = [&](glm::dvec4 c, glm::dvec3 weights) {
        cut.corner[cut.count++] = {{(c.x / c.w + 1) * 0.5 * g.size.width, (1 - c.y / c.w) * 0.5 * g.size.height},
                                   weights};
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double a = clip[i].z + clip[i].w, b = clip[j].z + clip[j].w;
        glm::dvec3 here(0), next(0);
        here[static_cast<int>(i)] = next[static_cast<int>(j)] = 1;
        if (a >= 0) add(clip[i], here);
        if ((a >= 0) != (b >= 0)) {
            const double t = a / (a - b);
            add(clip[i] + t * (clip[j] - clip[i]), here + t * (next - here));
        }
    }
    return cut;
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

bool near_is_crossed(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c) {
    return ((a.outside | b.outside | c.outside) & OutsideNear) != 0;
}

Vec3<float> near_clipped_screen_weights(const Geometry& g, const SampleFace& face, int x, int y) {
    const CutTriangle cut = cut_at_near(g, face);
    const glm::dvec2 at(x + 0.5, y + 0.5);
    glm::dvec3 best(1.0 / 3);
    double best_inside = -1e300;  // the smallest barycentric weight: the fan's triangle that holds the sample
    for (std::size_t i = 2; i < cut.count; ++i) {
        const CutCorner &a = cut.corner[0], &b = cut.corner[i - 1], &c = cut.corner[i];
        const double area = cross(b.pixel - a.pixel, c.pixel - a.pixel);
        if (area == 0) continue;
        const double wb = cross(at - a.pixel, c.pixel - a.pixel) / area;
        const double wc = cross(b.pixel - a.pixel, at - a.pixel) / area;
        const double inside = std::min({1 - wb - wc, wb, wc});
        if (inside <= best_inside) continue;
        best_inside = inside;
        best = (1 - wb - wc) * a.weights + wb * b.weights + wc * c.weights;
    }
    return {static_cast<float>(best.x), static_cast<float>(best.y), static_cast<float>(best.z)};
}

}  // namespace glint
