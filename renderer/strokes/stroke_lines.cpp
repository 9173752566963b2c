#include "renderer/strokes/stroke_lines.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <optional>

#include "renderer/geometry/clip.h"

namespace glint {

Occlusion::Occlusion(const Geometry& g)
    : g_(g),
      orthographic_(is_orthographic(g.camera.projection)),
      near_(near_of(g.camera.projection)),
      far_(far_of(g.camera.projection)),
      half_pixel_(glm::abs(1 / (g.clip_from_view[1][1] * g.size.height))) {}

bool Occlusion::hides(std::uint32_t triangle, glm::dvec2 pixel, double inv_w) const {
    // On the screen, inv_w over a plane is k . (x, y, 1). At each corner, in clip coordinates, k . (x, y, w)
    // = inv_w w, which is 1 in perspective for any corner. Solved by Cramer's rule.
    const std::uint32_t o = g_.object_of(triangle);
    const auto corner = g_.position_indices(o, g_.triangle(o, triangle));
    glm::dmat3 corners;
    glm::dvec3 right(1);
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t c = corner[static_cast<std::size_t>(i)];
        const TransformedVertex& v = g_.objects[o].vertices[c];
        corners[i] = {v.clip_x, v.clip_y, v.clip_w};
        if (orthographic_) right[i] = (v.z + far_) / (far_ - near_);
    }
    const glm::dvec3 across = glm::cross(corners[1], corners[2]);
    const double determinant = glm::dot(corners[0], across);
    if (determinant == 0) return false;
    const glm::dvec3 k = (right[0] * across + right[1] * glm::cross(corners[2], corners[0]) +
                          right[2] * glm::cross(corners[0], corners[1])) /
                         determinant;
    const glm::dvec3 at(to_ndc(viewport_of(g_.camera, g_.size), pixel), 1);
    const double tolerance = orthographic_ ? half_pixel_ / (far_ - near_) : half_pixel_ * inv_w;
    return glm::dot(k, at) > inv_w + tolerance;
}

namespace {

constexpr std::size_t edges_a_task = 256;  // edges per task
/// In pixels. No edge in a picture is longer. Edges so far away that their length is NaN are omitted.
constexpr double longest = 1e6;

/// An edge on the screen.
struct Projected {
    glm::dvec2 a, b;  // pixels
    double inv_w_a, inv_w_b;
    [[nodiscard]] glm::dvec2 position(double t) const { return a + t * (b - a); }
    [[nodiscard]] double inv_w(double t) const { return inv_w_a + t * (inv_w_b - inv_w_a); }
};

/// Traces the edges of one object.
class Follower {
  public:
    Follower(const Geometry& g, const Visibility& visibility, std::uint32_t object, const MeshEdges& mesh,
             double margin_px)
        : g_(g),
          visibility_(visibility),
          object_(object),
          mesh_(mesh),
          occlusion_(g),
          clip_from_object_(g.objects[object].clip_from_object),
          viewport_(viewport_of(g.camera, g.size)),
          reach_x_(1 + 2 * margin_px / g.size.width),
          reach_y_(1 + 2 * margin_px / g.size.height) {}

    void follow(const StrokeEdge& edge, std::vector<StrokeLine>& lines) const {
        const std::optional<Projected> line = project(edge.edge);
        if (!line) return;
        const double length = glm::distance(line->a, line->b);
        if (!(length < longest)) return;
        const int steps = std::max(1, static_cast<int>(std::ceil(length)));
        int first = -1;  // start of the current run of visible steps; -1: none
        for (int i = 0; i <= steps; ++i) {
            const bool seen = i < steps && is_seen(edge, *line, (i + 0.5) / steps);
            if (seen && first < 0) first = i;
            if (seen || first < 0) continue;
            add(*line, static_cast<double>(first) / steps, static_cast<double>(i) / steps, lines);
            first = -1;
        }
    }

  private:
    /// The part of the edge between the near and far planes and within the picture plus margin; nothing if it
    /// is empty.
    [[nodiscard]] std::optional<Projected> project(std::uint32_t edge) const {
        const auto& p = mesh_.mesh->positions;
        const auto [i, j] = mesh_.topology.edges[edge];
        const glm::dvec4 a = clip_from_object_ * glm::dvec4(glm::dvec3(p[i]), 1.0);
        const glm::dvec4 d = clip_from_object_ * glm::dvec4(glm::dvec3(p[j]), 1.0) - a;
        double from = 0, to = 1;  // parameters on the line from a to b
        for (const glm::dvec4& plane : view_planes(reach_x_, reach_y_)) {
            const double at_a = glm::dot(plane, a), change = glm::dot(plane, d);
            if (change > 0) from = std::max(from, -at_a / change);
            if (change < 0) to = std::min(to, -at_a / change);
            if (change == 0 && at_a < 0) return std::nullopt;
        }
        if (!(from <= to)) return std::nullopt;
        const glm::dvec4 start = held(a + from * d), end = held(a + to * d);
        return Projected{to_pixel(viewport_, start), to_pixel(viewport_, end), inv_w_of(viewport_, start),
                         inv_w_of(viewport_, end)};
    }

    /// Returns an end of the part. If the edge is so long that the position is lost to rounding, returns a
    /// position near the picture.
    [[nodiscard]] glm::dvec4 held(const glm::dvec4& clip) const {
        const glm::dvec4 c = before_eye(g_.camera.projection, clip);
        const double x = 2 * reach_x_ * c.w, y = 2 * reach_y_ * c.w;
        return {std::clamp(c.x, -x, x), std::clamp(c.y, -y, y), c.z, c.w};
    }

    [[nodiscard]] bool is_seen(const StrokeEdge& edge, const Projected& line, double t) const {
        const glm::dvec2 at = line.position(t);
        const double inv_w = line.inv_w(t);
        const auto leaves_it_seen = [&](std::uint32_t triangle) {
            return triangle == no_triangle || is_own(edge.edge, triangle) ||
                   !occlusion_.hides(triangle, at, inv_w);
        };
        const std::uint32_t nearest = triangle_at(pixel_index(at.x), pixel_index(at.y));
        if (edge.facing == EdgeFacing::Towards) return leaves_it_seen(nearest);
        if (edge.facing == EdgeFacing::Away) return is_of_object(nearest) && leaves_it_seen(nearest);
        const int x = pixel_index(at.x - 0.5), y = pixel_index(at.y - 0.5);
        for (int k = 0; k < 4; ++k)
            if (leaves_it_seen(triangle_at(x + k % 2, y + k / 2))) return true;
        return false;
    }

    static int pixel_index(double coordinate) { return static_cast<int>(std::floor(coordinate)); }

    /// The triangle visible at a pixel. Positions outside the picture are clamped to its border.
    [[nodiscard]] std::uint32_t triangle_at(int x, int y) const {
        x = std::clamp(x, 0, g_.size.width - 1);
        y = std::clamp(y, 0, g_.size.height - 1);
        return visibility_.triangle_at(g_.size.index(x, y));
    }

    [[nodiscard]] bool is_of_object(std::uint32_t triangle) const {
        return triangle != no_triangle && triangle >= g_.objects[object_].first_triangle &&
               triangle - g_.objects[object_].first_triangle < mesh_.mesh->triangles.size();
    }

    /// Whether a triangle belongs to a polygon adjacent to the edge.
    [[nodiscard]] bool is_own(std::uint32_t edge, std::uint32_t triangle) const {
        if (!is_of_object(triangle)) return false;
        const std::uint32_t face = mesh_.mesh->triangles[triangle - g_.objects[object_].first_triangle].face;
        const auto uses = mesh_.topology.uses_of(edge);
        return std::any_of(uses.begin(), uses.end(), [face](const EdgeUse& use) { return use.face == face; });
    }

    void add(const Projected& line, double from, double to, std::vector<StrokeLine>& lines) const {
        lines.push_back({glm::vec2(line.position(from)), glm::vec2(line.position(to)),
                         static_cast<float>(line.inv_w(from)), static_cast<float>(line.inv_w(to)), object_});
    }

    const Geometry& g_;
    const Visibility& visibility_;
    std::uint32_t object_;
    const MeshEdges& mesh_;
    Occlusion occlusion_;
    glm::dmat4 clip_from_object_;
    Viewport viewport_;
    double reach_x_, reach_y_;  // extent of the relevant lines, in half picture widths and heights
};

}  // namespace

std::vector<StrokeLine> visible_lines(const Geometry& g, const Visibility& visibility, std::uint32_t object,
                                      const MeshEdges& mesh, std::span<const StrokeEdge> edges,
                                      double margin_px) {
    const Follower follower(g, visibility, object, mesh, margin_px);
    std::vector<std::vector<StrokeLine>> found((edges.size() + edges_a_task - 1) / edges_a_task);
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t chunk) {
        for (std::size_t i = chunk * edges_a_task; i < std::min(edges.size(), (chunk + 1) * edges_a_task);
             ++i)
            follower.follow(edges[i], found[chunk]);
    });
    std::vector<StrokeLine> all;
    for (auto& part : found) {
        all.insert(all.end(), part.begin(), part.end());
        part = {};
    }
    return all;
}

}  // namespace glint
