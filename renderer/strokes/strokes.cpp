#include "renderer/strokes/strokes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numeric>

#include "renderer/strokes/stroke_lines.h"

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

}  // namespace glint
