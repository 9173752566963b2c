#include "ui/picture/surface_patch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace glint {
namespace {

/// Whether both are adjacent parts of one smooth surface.
bool hang_together(const SeenPoint& a, const SeenPoint& b) {
    if (a.object != b.object || glm::dot(a.normal, b.normal) < 0.7f) return false;
    // The vector between two points of a smooth surface is perpendicular to the mean of their normals.
    const glm::vec3 way = b.position - a.position, normal = a.normal + b.normal;
    return std::abs(glm::dot(way, normal)) <= 1.2f * glm::length(way);
}

}  // namespace

std::optional<SeenPoint> seen_at(const Renderer& renderer, PictureSize size, glm::dvec2 pixel) {
    if (!is_inside(size, pixel)) return {};
    return renderer.seen_at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

std::optional<SurfacePatch> surface_patch(const Renderer& renderer, PictureSize size, glm::dvec2 pixel,
                                          int radius) {
    const auto middle = seen_at(renderer, size, pixel);
    if (!middle) return {};
    SurfacePatch patch;
    patch.radius = radius;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            const auto point = seen_at(renderer, size, pixel + glm::dvec2(x, y));
            const bool used = point && hang_together(*middle, *point);
            patch.points.push_back(used ? *point : *middle);
            patch.used.push_back(used);
        }
    return patch;
}

glm::dvec2 SurfacePatch::offset(std::size_t i) const {
    const int side = 2 * radius + 1;
    const int across = static_cast<int>(i) % side, down = static_cast<int>(i) / side;
    return {across - radius, down - radius};
}

glm::dvec2 SurfacePatch::slope_of_log(const std::vector<double>& values, int within) const {
    glm::dmat2 squares(0);
    glm::dvec2 rises(0);
    for (std::size_t i = 0; i < points.size() / 2; ++i) {
        const std::size_t opposite = points.size() - 1 - i;
        if (!used[i] || !used[opposite] || !(values[i] > 0) || !(values[opposite] > 0)) continue;
        const glm::dvec2 way = offset(opposite);
        if (std::max(std::abs(way.x), std::abs(way.y)) > within) continue;
        squares += glm::outerProduct(way, way);
        rises += (std::log(values[opposite]) - std::log(values[i])) / 2 * way;
    }
    if (!(glm::determinant(squares) > 0)) return glm::dvec2(0);
    return glm::inverse(squares) * rises;
}

double SurfacePatch::steepness(const std::function<double(const SeenPoint&)>& value) const {
    // Of the nine pixels, 1 is above the centre, 3 and 5 are to its left and right, 7 is below.
    const auto slope = [&](std::size_t before, std::size_t after) {
        const double span = (used[before] ? 1 : 0) + (used[after] ? 1 : 0);
        return span > 0 ? (value(points[after]) - value(points[before])) / span : 0.0;
    };
    return std::hypot(slope(3, 5), slope(1, 7));
}

double SurfacePatch::distance_of_maximum(const std::vector<double>& values) const {
    const std::size_t middle = points.size() / 2;
    if (!(values[middle] > 0)) return radius + 1;
    double largest = values[middle], distance = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double away = glm::length(offset(i));
        if (!used[i] || values[i] < largest || (values[i] == largest && away >= distance)) continue;
        largest = values[i];
        distance = away;
    }
    return distance;
}

}  // namespace glint
