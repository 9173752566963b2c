#include "renderer/strokes/strokes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>
#include <optional>
#include <utility>

#include "models/mesh/polygon.h"
#include "renderer/geometry/clip.h"

namespace glint {
namespace {

constexpr int band_height = 32;  // rows per task

/// Pixels from..to of a row, inclusive; empty if to < from.
struct Span {
    int from = 0, to = -1;
};

/// The pixels of row y whose centres may be within `reach` of the line.
Span pixels_near(const StrokeLine& line, float reach, int y, int width) {
    const double ax = line.a.x, ay = line.a.y, dx = line.b.x - ax, dy = line.b.y - ay;
    double low = std::min(0.0, dx) - reach, high = std::max(0.0, dx) + reach;  // relative to a.x
    const double length = std::hypot(dx, dy);
    if (std::abs(dy) > 1e-3 * length) {  // the slanted strip around the line is narrower
        const double middle = (y + 0.5 - ay) * dx / dy, half = reach * length / std::abs(dy);
        low = std::max(low, middle - half);
        high = std::min(high, middle + half);
    }
    const double first = std::ceil(ax + low - 0.5), last = std::floor(ax + high - 0.5);
    if (!(first <= last) || first >= width || last < 0) return {};
    return {static_cast<int>(std::max(first, 0.0)), static_cast<int>(std::min(last, width - 1.0))};
}

/// Draws strokes into the rows of the picture.
class Filler {
  public:
    Filler(const Geometry& g, const Visibility& visibility, std::span<const StrokeLine> lines, float width_px,
           std::vector<float>& coverage)
        : g_(g),
          visibility_(visibility),
          occlusion_(g),
          lines_(lines),
          width_px_(width_px),
          reach_(0.5f * width_px + 0.5f),
          coverage_(coverage) {
        sort_into_bands();
    }

    [[nodiscard]] int band_count() const { return static_cast<int>(bands_.size()); }

    void fill(int band) const {
        const int begin = band * band_height, end = std::min(begin + band_height, g_.size.height);
        for (const std::uint32_t i : bands_[static_cast<std::size_t>(band)])
            for (int y = begin; y < end; ++y) draw(lines_[i], y);
    }

  private:
    void sort_into_bands() {
        bands_.resize(static_cast<std::size_t>((g_.size.height + band_height - 1) / band_height));
        std::vector<std::size_t> counts(bands_.size(), 0);
        for (const StrokeLine& line : lines_) for_each_band(line, [&](std::size_t band) { ++counts[band]; });
        for (std::size_t band = 0; band < bands_.size(); ++band) bands_[band].reserve(counts[band]);
        for (std::uint32_t i = 0; i < lines_.size(); ++i)
            for_each_band(lines_[i], [&](std::size_t band) { bands_[band].push_back(i); });
    }

    /// Calls f with the index of each band that the line may touch.
    template <class F> void for_each_band(const StrokeLine& line, const F& f) const {
        const auto last = static_cast<float>(bands_.size() - 1);
        const auto [top, bottom] = std::minmax(line.a.y, line.b.y);
        const float from = std::max(0.0f, std::floor((top - reach_) / band_height));
        const float to = std::min(last, std::floor((bottom + reach_) / band_height));
        if (from > to) return;
        for (auto band = static_cast<std::size_t>(from); band <= static_cast<std::size_t>(to); ++band)
            f(band);
    }

    /// Draws one row of one line.
    void draw(const StrokeLine& line, int y) const {
        const Span span = pixels_near(line, reach_, y, g_.size.width);
        float* const row = &coverage_[g_.size.index(0, y)];
        const glm::vec2 along = line.b - line.a;
        const float squared = glm::dot(along, along);
        for (int x = span.from; x <= span.to; ++x) {
            if (row[x] >= 1) continue;
            const glm::vec2 at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const float t =
                squared > 0 ? std::clamp(glm::dot(at - line.a, along) / squared, 0.0f, 1.0f) : 0.0f;
            const float share = stroke_share(glm::distance(at, line.a + t * along), width_px_);
            if (share > row[x] && !is_behind_another(line, x, y, t)) row[x] = share;
        }
    }

    [[nodiscard]] bool is_behind_another(const StrokeLine& line, int x, int y, float t) const {
        const std::uint32_t triangle = visibility_.triangle_at(g_.size.index(x, y));
        if (triangle == no_triangle || g_.object_of(triangle) == line.object) return false;
        return occlusion_.hides(triangle, line.a + t * (line.b - line.a),
                                line.inv_w_a + t * (line.inv_w_b - line.inv_w_a));
    }

    const Geometry& g_;
    const Visibility& visibility_;
    Occlusion occlusion_;
    std::span<const StrokeLine> lines_;
    float width_px_, reach_;
    std::vector<float>& coverage_;
    std::vector<std::vector<std::uint32_t>> bands_;  // indices of the lines that may touch each band
};

}  // namespace

float stroke_share(float distance_px, float width_px) {
    // The overlap between a pixel and a stroke of that width, measured across the stroke.
    const float overlap = 0.5f * width_px + 0.5f - distance_px;
    return std::clamp(std::min(overlap, width_px), 0.0f, 1.0f);
}

namespace {

/// Returns width x height coverages, 0 to 1: the maximum over all lines, so that lines are not darker where
/// they meet or overlap. Ends are round. A line does not cover a pixel that shows a different object in front
/// of it. The result is bit-identical for any order of the lines.
std::vector<float> stroke_coverage(const Geometry& g, const Visibility& visibility,
                                   std::span<const StrokeLine> lines, float width_px) {
    std::vector<float> coverage(g.size.pixels(), 0.0f);
    const Filler filler(g, visibility, lines, width_px, coverage);
    tbb::parallel_for(0, filler.band_count(), [&filler](int band) { filler.fill(band); });
    return coverage;
}

/// Removes the edges of deleted meshes and finds those of new ones.
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

/// The eye in object coordinates, transformed directly from world coordinates, so that an eye in the plane of
/// a facet stays in it.
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
        if (!g.objects[o].visible) continue;
        const MeshEdges& mesh = edges_of(kept.meshes, g.objects[o].mesh);
        EdgeChoice choice = kept.choice;
        if (g.objects[o].double_sided) choice.cull = Cull::None;
        const auto edges = stroke_edges(mesh, edge_view(g.camera, g.objects[o]), choice);
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
/// Edges of this length in pixels or longer, or with a length of NaN, are omitted. No visible edge is that
/// long.
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
    /// The part of the edge between the near and far planes and within the picture plus margin; nullopt if it
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

    /// Returns an end of the edge's visible part. If the edge is so long that the position is lost to
    /// rounding, returns a position near the picture.
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

// Selects the edges drawn as strokes: silhouettes, between a front-facing facet and one that is not, and
// creases, between two facets at a sharp angle.

namespace {

constexpr std::size_t chunk_size = 16384;  // edges per task

/// Tests individual edges. Stores the values common to all of them.
class Selector {
  public:
    Selector(const MeshEdges& edges, const EdgeView& view, const EdgeChoice& choice)
        : edges_(edges),
          view_(view),
          choice_(choice),
          max_cosine_(std::cos(glm::radians(static_cast<double>(choice.crease_deg))) + crease_tolerance) {}

    void examine(std::size_t edge, std::vector<StrokeEdge>& found) const {
        const auto uses = edges_.topology.uses_of(edge);
        const glm::dvec3 e = to_eye(edge);
        int facets = 0, min_side = 1, max_side = -1;
        for (const EdgeUse& use : uses) {
            const glm::dvec3& n = edges_.facet_normals[use.face];
            if (n == glm::dvec3(0)) continue;
            ++facets;
            min_side = std::min(min_side, side(e, n));
            max_side = std::max(max_side, side(e, n));
        }
        if (facets == 0 || (choice_.cull == Cull::Back && max_side < 0) ||
            (choice_.cull == Cull::Front && min_side > 0))
            return;
        // One facet faces the eye and another does not, or one is seen edge-on.
        const bool differ = facets > 1 && min_side <= 0 && max_side >= 0;
        const bool is_silhouette = choice_.silhouettes && (uses.size() == 1 || differ);
        if (is_silhouette || (choice_.creases && facets > 1 && is_crease(uses)))
            found.push_back({static_cast<std::uint32_t>(edge), differ || facets == 1 ? EdgeFacing::Rim
                                                               : min_side > 0        ? EdgeFacing::Towards
                                                                                     : EdgeFacing::Away});
    }

  private:
    // In floating point, cos 90 degrees is not exactly 0, and the facets of a rotated cube are not exactly at
    // right angles.
    static constexpr double crease_tolerance = 1e-6;
    // The sine of the angle below which a facet counts as seen edge-on. Only rounding errors are this small.
    static constexpr double edge_on = 1e-12;
    // A crease compares every pair of facets. The limit prevents 10^12 steps for a file with a million facets
    // at one edge.
    static constexpr std::size_t max_compared = 256;

    [[nodiscard]] glm::dvec3 to_eye(std::size_t edge) const {
        const auto& p = edges_.mesh->positions;
        const auto [a, b] = edges_.topology.edges[edge];
        const glm::dvec3 middle = 0.5 * (glm::dvec3(p[a]) + glm::dvec3(p[b]));
        return glm::dvec3(view_.eye) - view_.eye.w * middle;
    }

    /// 1 if the facet is front-facing, -1 if back-facing, 0 if edge-on.
    static int side(const glm::dvec3& e, const glm::dvec3& n) {
        const double towards_eye = glm::dot(e, n), limit = edge_on * std::sqrt(glm::dot(e, e));
        return towards_eye > limit ? 1 : towards_eye < -limit ? -1 : 0;
    }

    [[nodiscard]] bool is_crease(std::span<const EdgeUse> uses) const {
        uses = uses.first(std::min(uses.size(), max_compared));
        for (std::size_t i = 0; i < uses.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (meet_sharply(edges_.facet_normals[uses[i].face], edges_.facet_normals[uses[j].face]))
                    return true;
        return false;
    }

    [[nodiscard]] bool meet_sharply(const glm::dvec3& n0, const glm::dvec3& n1) const {
        const glm::dvec3 m0 = view_.normal_matrix * n0, m1 = view_.normal_matrix * n1;
        const double lengths = std::sqrt(glm::dot(m0, m0) * glm::dot(m1, m1));
        return lengths > 0 && glm::dot(m0, m1) <= max_cosine_ * lengths;
    }

    const MeshEdges& edges_;
    const EdgeView& view_;
    const EdgeChoice& choice_;
    double max_cosine_;
};

}  // namespace

MeshEdges mesh_edges(MeshPtr mesh) {
    MeshEdges edges;
    edges.topology = make_topology(*mesh);
    edges.facet_normals.resize(mesh->face_count());
    tbb::parallel_for(std::size_t{0}, edges.facet_normals.size(),
                      [&](std::size_t f) { edges.facet_normals[f] = polygon_plane(*mesh, f).normal; });
    edges.mesh = std::move(mesh);
    return edges;
}

std::vector<StrokeEdge> stroke_edges(const MeshEdges& edges, const EdgeView& view, const EdgeChoice& choice) {
    const Selector selector(edges, view, choice);
    const std::size_t count = edges.topology.edges.size();
    std::vector<std::vector<StrokeEdge>> found((count + chunk_size - 1) / chunk_size);
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t chunk) {
        for (std::size_t e = chunk * chunk_size; e < std::min(count, (chunk + 1) * chunk_size); ++e)
            selector.examine(e, found[chunk]);
    });
    std::vector<StrokeEdge> all;
    for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace glint
