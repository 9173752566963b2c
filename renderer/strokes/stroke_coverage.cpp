#include "renderer/strokes/stroke_coverage.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/strokes/occlusion.h"

namespace glint {
namespace {

constexpr int band_height = 32;  // rows that one task fills

/// Pixels of a row from..to, inclusive; none when to < from.
struct Span {
    int from = 0, to = -1;
};

/// The pixels of row y whose centres may lie within `reach` of the line.
Span pixels_near(const StrokeLine& line, float reach, int y, int width) {
    const double ax = line.a.x, ay = line.a.y, dx = line.b.x - ax, dy = line.b.y - ay;
    double low = std::min(0.0, dx) - reach, high = std::max(0.0, dx) + reach;  // from a.x
    const double length = std::hypot(dx, dy);
    if (std::abs(dy) > 1e-3 * length) {  // the slanted strip around the whole line is narrower
        const double middle = (y + 0.5 - ay) * dx / dy, half = reach * length / std::abs(dy);
        low = std::max(low, middle - half);
        high = std::min(high, middle + half);
    }
    const double first = std::ceil(ax + low - 0.5), last = std::floor(ax + high - 0.5);
    if (!(first <= last) || first >= width || last < 0) return {};
    return {static_cast<int>(std::max(first, 0.0)), static_cast<int>(std::min(last, width - 1.0))};
}

/// Fills the rows of the picture.
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
        const auto last = static_cast<float>(bands_.size() - 1);
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            const auto [top, bottom] = std::minmax(lines_[i].a.y, lines_[i].b.y);
            const float from = std::max(0.0f, std::floor((top - reach_) / band_height));
            const float to = std::min(last, std::floor((bottom + reach_) / band_height));
            if (from > to) continue;
            const auto end = static_cast<std::size_t>(to) + 1;
            for (auto band = static_cast<std::size_t>(from); band < end; ++band) bands_[band].push_back(i);
        }
    }

    /// One row of one line.
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
    std::vector<std::vector<std::uint32_t>> bands_;  // numbers of the lines that may touch each
};

}  // namespace

float stroke_share(float distance_px, float width_px) {
    // What a band of that width and a pixel, both seen from their side, have in common.
    const float overlap = 0.5f * width_px + 0.5f - distance_px;
    return std::clamp(std::min(overlap, width_px), 0.0f, 1.0f);
}

std::vector<float> stroke_coverage(const Geometry& g, const Visibility& visibility,
                                   std::span<const StrokeLine> lines, float width_px) {
    std::vector<float> coverage(g.size.pixels(), 0.0f);
    const Filler filler(g, visibility, lines, width_px, coverage);
    tbb::parallel_for(0, filler.band_count(), [&filler](int band) { filler.fill(band); });
    return coverage;
}

}  // namespace glint
