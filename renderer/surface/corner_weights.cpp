// Weights of a face's corners for the colour or normal of a pixel: perspective-correct, linear on the screen,
// or along edges and then scanlines. Lecture: "Gouraud Shading", "Shading Artifacts: Orientation".
#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <numeric>
#include <optional>

#include "renderer/geometry/clip.h"
#include "renderer/geometry/interpolate.h"
#include "renderer/surface/surface.h"

namespace glint {
namespace {

template <Number F> ScreenPoint<F> ndc_of(PictureSize size, PixelPosition at) {
    return to_ndc(F(at.x), F(at.y), static_cast<F>(size.width), static_cast<F>(size.height));
}

/// Computes the weights of three corners from their clip coordinates, and the position from the weights and
/// the corners' camera coordinates.
template <Number F>
void place(SampleFace& face, const std::array<ClipCorner<F>, 3>& clip, const std::array<Vec3<F>, 3>& camera,
           ScreenPoint<F> at) {
    const Vec3<F> w = perspective_weights(clip[0], clip[1], clip[2], at);
    const Vec3<F> p = blend(w, camera[0], camera[1], camera[2]);
    face.weights = {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
    face.p = glm::vec3(p.x, p.y, p.z);
}

CornerWeights of_triangle(const Triangle& t, Vec3<float> w) {
    CornerWeights weights;
    weights.count = 3;
    std::copy(t.corner.begin(), t.corner.end(), weights.corner.begin());
    weights.weight = {w.x, w.y, w.z};
    return weights;
}

void add_clipped(CornerWeights& weights, const ClippedCorner& corner, double weight) {
    weights.add(corner.a, static_cast<float>(weight * (1 - corner.t)));
    if (corner.t > 0) weights.add(corner.b, static_cast<float>(weight * corner.t));
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Weights that are linear on the screen, over the fan of a triangle that the near plane clips. Returns
/// perspective-correct weights if no part of the fan contains the sample (a sliver, or numbers so large that
/// the intersection is lost to rounding).
CornerWeights clipped_screen_weights(const Geometry& g, const SampleFace& face, const Triangle& triangle) {
    ClipMemory memory;
    const auto cut = clip_at_near(g, face.object, triangle.corner, memory);
    const glm::dvec2 at(face.at.x, face.at.y);
    CornerWeights best = of_triangle(triangle, {face.weights.x, face.weights.y, face.weights.z});
    // The triangle of the fan with the largest minimum weight contains the sample. Because corners are
    // rounded to the rasterizer's grid, the sample may be slightly outside, so weights down to -1 are
    // accepted and then clamped to the inside.
    double best_inside = -1;
    for (std::size_t i = 2; i < cut.size(); ++i) {
        const ClippedCorner &a = cut[0], &b = cut[i - 1], &c = cut[i];
        const double area = cross(b.pixel - a.pixel, c.pixel - a.pixel);
        const double wb = cross(at - a.pixel, c.pixel - a.pixel) / area;
        const double wc = cross(b.pixel - a.pixel, at - a.pixel) / area;
        const double inside = std::min({1 - wb - wc, wb, wc});
        if (!(inside > best_inside)) continue;  // NaN: no area
        best_inside = inside;
        glm::dvec3 weights(1 - wb - wc, wb, wc);
        if (inside < 0) {
            weights = glm::max(weights, 0.0);
            weights /= weights.x + weights.y + weights.z;
        }
        best = {};
        add_clipped(best, a, weights.x);
        add_clipped(best, b, weights.y);
        add_clipped(best, c, weights.z);
    }
    return best;
}

/// The part of a face in front of the near plane.
using Polygon = std::pmr::vector<ClippedCorner>;

Polygon clipped_face(const Geometry& g, std::uint32_t object, std::uint32_t face, ClipMemory& memory) {
    const Mesh& mesh = *g.objects[object].mesh;
    std::pmr::vector<std::uint32_t> corners(mesh.first_corner[face + 1] - mesh.first_corner[face],
                                            &memory.pool);
    std::iota(corners.begin(), corners.end(), mesh.first_corner[face]);
    return clip_at_near(g, object, corners, memory);
}

/// An intersection of the scanline with an edge of the polygon.
struct Crossing {
    double x = 0, t = 0;  // t: parameter between the ends of the edge
    const ClippedCorner *from = nullptr, *to = nullptr;
};
using Crossings = std::pmr::vector<Crossing>;

/// Crossings of the scanline at height y, from left to right. An edge is crossed if y0 <= y < y1 or y1 <= y <
/// y0, so a corner counts once and a horizontal edge never counts.
void find_crossings(Crossings& found, const Polygon& polygon, double y) {
    found.clear();
    found.reserve(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClippedCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.pixel.y <= y) == (b.pixel.y <= y)) continue;
        const double t = (y - a.pixel.y) / (b.pixel.y - a.pixel.y);
        found.push_back({a.pixel.x + t * (b.pixel.x - a.pixel.x), t, &a, &b});
    }
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
}

/// The height of the sample, clamped to the polygon if the rasterizer's grid placed it slightly outside.
double height_within(const Polygon& polygon, double y) {
    const auto [low, high] = std::minmax_element(
        polygon.begin(), polygon.end(),
        [](const ClippedCorner& a, const ClippedCorner& b) { return a.pixel.y < b.pixel.y; });
    return std::clamp(y, low->pixel.y, std::nextafter(high->pixel.y, low->pixel.y));
}

/// Caches this thread's last large polygon and its crossings in the last row. Pixels are visited row by row.
/// Without the cache, a polygon of n corners costs O(n) per pixel, which takes minutes for 100,000 corners.
struct KnownFace {
    KnownFace(const Geometry& g, std::uint32_t of_object, std::uint32_t of_face)
        : geometry(g.state),
          object(of_object),
          face(of_face),
          polygon(clipped_face(g, object, face, memory)) {}

    std::uint64_t geometry;  // Geometry::state
    std::uint32_t object, face;
    ClipMemory memory;
    Polygon polygon;
    std::optional<double> y;  // the row of `crossings`
    Crossings crossings;
};

const Crossings& known_crossings(const Geometry& g, std::uint32_t object, std::uint32_t face, double y) {
    thread_local std::optional<KnownFace> known;
    if (!known || known->geometry != g.state || known->object != object || known->face != face)
        known.emplace(g, object, face);
    if (known->y != y && !known->polygon.empty()) {
        known->y.reset();  // in case the allocation throws
        find_crossings(known->crossings, known->polygon, height_within(known->polygon, y));
        known->y = y;
    }
    return known->crossings;
}

/// The first of the two crossings around x. A concave polygon may have several such pairs. If x is in none of
/// them, returns the nearest pair, or the left one of two at equal distance. Precondition: there are at least
/// two crossings.
std::size_t nearest_two(const Crossings& crossings, double x) {
    const auto outside = [&](std::size_t two) {
        return std::max({crossings[2 * two].x - x, x - crossings[2 * two + 1].x, 0.0});
    };
    // Finds the first pair that ends at or after x, or the last pair.
    std::size_t low = 0, end = crossings.size() / 2 - 1;
    while (low < end) {
        const std::size_t middle = low + (end - low) / 2;
        if (crossings[2 * middle + 1].x < x)
            low = middle + 1;
        else
            end = middle;
    }
    while (low > 0 && outside(low - 1) <= outside(low)) --low;
    return 2 * low;
}

/// Interpolates between the crossings around x, and along their edges.
CornerWeights weights_between(const Crossings& crossings, double x) {
    const std::size_t first = nearest_two(crossings, x);
    const Crossing &left = crossings[first], &right = crossings[first + 1];
    const double span = right.x - left.x;
    const double s = span > 0 ? std::clamp((x - left.x) / span, 0.0, 1.0) : 0.0;
    CornerWeights weights;
    add_clipped(weights, *left.from, (1 - s) * (1 - left.t));
    add_clipped(weights, *left.to, (1 - s) * left.t);
    add_clipped(weights, *right.from, s * (1 - right.t));
    add_clipped(weights, *right.to, s * right.t);
    return weights;
}

CornerWeights scanline_weights(const Geometry& g, const SampleFace& face, const Triangle& triangle) {
    constexpr std::uint32_t few = 16;  // fewer corners are not worth caching
    const Mesh& mesh = *g.objects[face.object].mesh;
    const auto or_perspective = [&](const Crossings& crossings) {
        return crossings.size() >= 2
                   ? weights_between(crossings, face.at.x)
                   : of_triangle(triangle, {face.weights.x, face.weights.y, face.weights.z});
    };
    if (mesh.first_corner[triangle.face + 1] - mesh.first_corner[triangle.face] > few)
        return or_perspective(known_crossings(g, face.object, triangle.face, face.at.y));
    ClipMemory memory;
    const Polygon polygon = clipped_face(g, face.object, triangle.face, memory);
    Crossings crossings(&memory.pool);
    if (!polygon.empty()) find_crossings(crossings, polygon, height_within(polygon, face.at.y));
    return or_perspective(crossings);
}

}  // namespace

void CornerWeights::add(std::uint32_t which, float w) {
    const auto end = corner.begin() + count;
    const auto found = std::find(corner.begin(), end, which);
    const auto i = static_cast<std::size_t>(found - corner.begin());
    if (found == end) {
        corner[i] = which;
        ++count;
    }
    weight[i] += w;
}

void locate_on_face(SampleFace& face, const Geometry& g) {
    const ObjectGeometry& object = g.objects[face.object];
    const auto corner = g.position_indices(face.object, g.triangle(face.object, face.triangle));
    std::uint32_t outside = 0;
    for (const std::uint32_t c : corner) outside |= object.vertices[c].outside;
    if (!(outside & needs_clipping)) {
        std::array<ClipCorner<float>, 3> clip;
        std::array<Vec3<float>, 3> camera;
        for (std::size_t i = 0; i < 3; ++i) {
            const TransformedVertex& v = object.vertices[corner[i]];
            clip[i] = {v.clip_x, v.clip_y, v.clip_w};
            camera[i] = {v.x, v.y, v.z};
        }
        place(face, clip, camera, ndc_of<float>(g.size, face.at));
        return;
    }
    // A clipped face may extend far beyond the picture. Its corners are in double, because float would lose
    // the position between them.
    std::array<ClipCorner<double>, 3> clip;
    std::array<Vec3<double>, 3> camera;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec4 p =
            object.view_from_object * glm::dvec4(glm::dvec3(object.mesh->positions[corner[i]]), 1.0);
        const glm::dvec4 c = g.clip_from_view * p;
        clip[i] = {c.x, c.y, c.w};
        camera[i] = {p.x, p.y, p.z};
    }
    place(face, clip, camera, ndc_of<double>(g.size, face.at));
}

CornerWeights corner_weights(Interpolation interpolation, const Geometry& g, const SampleFace& face) {
    const Triangle& triangle = g.triangle(face.object, face.triangle);
    const Vec3<float> perspective{face.weights.x, face.weights.y, face.weights.z};
    switch (interpolation) {
    case Interpolation::Perspective:  // for groups of pixels: renderer/surface/interpolate_group.h
        break;
    case Interpolation::Scanline:
        return scanline_weights(g, face, triangle);
    case Interpolation::Screen: {
        const std::vector<TransformedVertex>& v = g.objects[face.object].vertices;
        const auto p = g.position_indices(face.object, triangle);
        if ((v[p[0]].outside | v[p[1]].outside | v[p[2]].outside) & OutsideNear)
            return clipped_screen_weights(g, face, triangle);
        return of_triangle(triangle,
                           screen_weights(perspective, v[p[0]].clip_w, v[p[1]].clip_w, v[p[2]].clip_w));
    }
    }
    return of_triangle(triangle, perspective);
}

}  // namespace glint
