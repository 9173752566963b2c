#include "diagnose/search/comparable.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

namespace glint {
namespace {

using SeenRow = std::vector<std::optional<SeenPoint>>;

/// Beyond this share of the way from one point to the next, that way leads away from the surface: across a
/// crease, or from one part to another behind it.
constexpr float steep = 0.6f;

bool same_surface(const std::optional<SeenPoint>& a, const std::optional<SeenPoint>& b) {
    if (!a || !b) return !a && !b;
    if (a->object != b->object || a->front != b->front) return false;
    const glm::vec3 way = b->position - a->position;
    const float most = steep * glm::length(way);
    const auto unit = [](glm::vec3 n) { return glm::dot(n, n) > 0 ? glm::normalize(n) : n; };
    return std::abs(glm::dot(way, unit(a->normal))) <= most &&
           std::abs(glm::dot(way, unit(b->normal))) <= most;
}

SeenRow seen_row(const Renderer& renderer, PictureSize size, int y) {
    SeenRow row(static_cast<std::size_t>(size.width));
    for (int x = 0; x < size.width; ++x) row[static_cast<std::size_t>(x)] = renderer.seen_at(x, y);
    return row;
}

/// Marks the pixels of row y that differ in surface from the one at their right or the one below.
void mark_row(std::vector<std::uint8_t>& breaks, PictureSize size, int y, const SeenRow& row,
              const SeenRow* below) {
    for (int x = 0; x < size.width; ++x) {
        const auto i = static_cast<std::size_t>(x);
        const bool right = x + 1 < size.width && !same_surface(row[i], row[i + 1]);
        const bool under = below != nullptr && !same_surface(row[i], (*below)[i]);
        breaks[size.index(x, y)] = static_cast<std::uint8_t>((right ? 1 : 0) | (under ? 2 : 0));
    }
}

/// Whether a break between two neighbours is within one pixel of (x, y).
bool near_break(const std::vector<std::uint8_t>& breaks, PictureSize size, int x, int y) {
    const int left = std::max(x - 2, 0), right = std::min(x + 1, size.width - 1);
    const int top = std::max(y - 2, 0), bottom = std::min(y + 1, size.height - 1);
    for (int v = top; v <= bottom; ++v)
        for (int u = left; u <= right; ++u)
            if (breaks[size.index(u, v)] != 0) return true;
    return false;
}

}  // namespace

std::vector<PixelKind> pixel_kinds(const Renderer& renderer, PictureSize size) {
    std::vector<std::uint8_t> breaks(size.pixels());
    tbb::parallel_for(tbb::blocked_range<int>(0, size.height, 16), [&](const auto& range) {
        SeenRow row = seen_row(renderer, size, range.begin());
        for (int y = range.begin(); y != range.end(); ++y) {
            SeenRow below = y + 1 < size.height ? seen_row(renderer, size, y + 1) : SeenRow();
            mark_row(breaks, size, y, row, below.empty() ? nullptr : &below);
            row.swap(below);
        }
    });
    std::vector<PixelKind> kinds(size.pixels());
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const bool shown = renderer.object_at(x, y) >= 0;
            const bool edge = near_break(breaks, size, x, y) || renderer.stroke_at(x, y) > 0;
            kinds[size.index(x, y)] = edge    ? PixelKind::Edge
                                      : shown ? PixelKind::Surface
                                              : PixelKind::Background;
        }
    });
    return kinds;
}

BareMask BareMasks::of(const Renderer& renderer, PictureSize size) {
    const bool is_first = last_.empty();
    if (is_first || renderer.stats().redone[static_cast<std::size_t>(Stage::Visibility)]) {
        last_.resize(size.pixels());
        tbb::parallel_for(0, size.height, [&](int y) {
            for (int x = 0; x < size.width; ++x)
                last_[size.index(x, y)] = renderer.object_at(x, y) < 0 ? 1 : 0;
        });
    }
    if (is_first) right_ = last_;
    return last_ == right_ ? BareMask() : last_;
}

}  // namespace glint
