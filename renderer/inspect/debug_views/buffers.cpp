#include "renderer/inspect/debug_views/buffers.h"

#include <tbb/parallel_for.h>

#include <array>

namespace glint {
namespace {

constexpr std::array names{"position",       "normal",  "depth",   "face",     "side", "emission",
                           "global_ambient", "ambient", "diffuse", "specular", "sum"};
using PixelValues = std::array<glm::vec3, names.size()>;
constexpr std::size_t first_term = 5, last = names.size() - 1;

void add_terms(PixelValues& values, const ExplainedPoint& at, float weight) {
    std::array<glm::vec3, 5> terms{at.emission, at.global_ambient, glm::vec3(0), glm::vec3(0), glm::vec3(0)};
    for (const ExplainedLight& light : at.lights) {
        terms[2] += light.ambient;
        terms[3] += light.diffuse;
        terms[4] += light.specular;
    }
    for (std::size_t i = 0; i < terms.size(); ++i) values[first_term + i] += weight * terms[i];
}

PixelValues values_at(const Renderer& renderer, int x, int y) {
    PixelValues values{};
    const Explanation e = renderer.explain(x, y);
    values[last] = e.sum;
    if (!e.hit) return values;
    values[0] = e.at.point.camera;
    values[1] = e.at.normal.camera;
    values[2] = glm::vec3(-e.at.point.camera.z);
    values[3] = glm::vec3(1, static_cast<float>(e.object_index), static_cast<float>(e.face));
    values[4] = glm::vec3(e.front_facing ? 1 : -1);
    if (!e.lit_per_corner) add_terms(values, e.at, 1);
    for (const ExplainedCorner& corner : e.corners) add_terms(values, corner.at, corner.weight);
    return values;
}

}  // namespace

std::uint64_t buffers_memory(PictureSize size) {
    return std::uint64_t{names.size()} * 3 * sizeof(float) * size.pixels();
}

std::vector<PixelBuffer> pixel_buffers(const Renderer& renderer, PictureSize size) {
    std::vector<PixelBuffer> buffers;
    const std::size_t pixels = size.pixels();
    for (const char* name : names) {
        PixelBuffer buffer;
        buffer.name = name;
        buffer.picture.size = size;
        buffer.picture.linear.resize(3 * pixels);
        buffers.push_back(std::move(buffer));
    }
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const PixelValues values = values_at(renderer, x, y);
            for (std::size_t i = 0; i < names.size(); ++i) {
                float* to = &buffers[i].picture.linear[3 * buffers[i].picture.pixel(x, y)];
                for (int c = 0; c < 3; ++c) to[c] = values[i][c];
            }
        }
    });
    return buffers;
}

}  // namespace glint
