#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "diagnose/judged.h"
#include "diagnose/search/softness.h"

namespace glint {
namespace {

/// The background of a drawing; nothing if it shows none that the right picture shows.
std::optional<Rgb> background_in(const Exhibit& e, const Drawing& drawn) {
    for (std::size_t i = 0; i < e.kinds.size(); ++i)
        if (e.kinds[i] == PixelKind::Background && (drawn.bare.empty() || drawn.bare[i] != 0))
            return rgb_at(drawn.picture, i);
    return std::nullopt;
}

/// The background of the wrong picture if it differs from the drawing's, as is and as the display changes it.
std::optional<Rgb> other_background(const Exhibit& e, const Drawing& drawn, const ByteRanges& ranges,
                                    const DisplayChange& change) {
    std::optional<Rgb> ground = e.grounds[way_turned(change)];
    if (!ground) return std::nullopt;  // before all pixels are looked at for one of the drawing
    const std::optional<Rgb> wanted = background_in(e, drawn);
    if (!wanted) return std::nullopt;
    ground = exchanged(change, *ground);
    const float near = 2 + change.scatter();
    if (static_cast<float>(most_apart(*ground, *wanted)) <= near) return std::nullopt;
    bool as_displayed = true;
    for (std::size_t c = 0; c < 3; ++c) as_displayed &= ranges[(*wanted)[c]].distance((*ground)[c]) <= near;
    if (as_displayed) return std::nullopt;
    return ground;
}

/// Counts what only softness explains.
void count_softened(DisplayFinding& finding, const Exhibit& e, const Drawing& drawn) {
    DisplayChange hard = finding.change;
    hard.soft = false;
    const PixelCounts counts = count_unlike(e, drawn, hard);
    const PixelCount& surface = count_of(counts, PixelKind::Surface);
    finding.softened = surface.unlike;
    finding.softened_most = surface.unlike > 0 ? static_cast<int>(std::lround(surface.most)) : 0;
}

}  // namespace

bool has_other_background(const Exhibit& e, const Drawing& drawn, const DisplayChange& change) {
    return other_background(e, drawn, byte_ranges(change), change).has_value();
}

DisplayFinding display_finding(const Exhibit& e, const Drawing& drawing, const DisplayChange& change) {
    const Picture& drawn = drawing.picture;
    const ByteRanges ranges = byte_ranges(change);
    DisplayFinding finding;
    finding.change = change;
    finding.background = other_background(e, drawing, ranges, change);
    finding.smooth_edges = has_smooth_edges(e, drawing, change);
    if (!change.soft) return finding;
    constexpr float least = 0.2f;  // of a pixel; the smoothing itself leaves less
    count_softened(finding, e, drawing);
    glm::vec2 shift = fitted_shift(e, drawn, change);
    for (int i = 0; i < 2; ++i)
        if (std::abs(shift[i]) < least) shift[i] = 0;
    finding.shift = shift;
    finding.smoothed = shift == glm::vec2(0);
    return finding;
}

namespace {

OutlineMisfit outline_of(const Exhibit& e, const DisplayChange& turned, Rgb right_background) {
    constexpr int dark = 8, clear = 16;
    const float near = 3 + e.least_change.scatter();
    const std::optional<Rgb> ground = e.grounds[way_turned(turned)];
    std::size_t outside = 0, background = 0, bare = 0, surface = 0;
    const PictureSize size = e.right.size;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const PixelKind kind = e.kinds[size.index(x, y)];
            const Rgb mine = rgb_at(e.wrong, changed_index(turned, size, x, y));
            const bool is_ground = ground && static_cast<float>(most_apart(mine, *ground)) <= near;
            if (kind == PixelKind::Background) {
                ++background;
                outside += is_ground ? 0 : 1;
            } else if (kind == PixelKind::Surface &&
                       most_apart(rgb_at(e.right, size.index(x, y)), right_background) > clear) {
                ++surface;
                bare += is_ground ? 1 : 0;
            }
        }
    const auto share = [](std::size_t part, std::size_t of) {
        return of == 0 ? 0 : static_cast<double>(part) / static_cast<double>(of);
    };
    const bool black = ground && most_apart(*ground, Rgb{}) <= dark;  // as a surface may be
    return {share(outside, background), black ? 0 : share(bare, surface)};
}

/// The largest share of the scene's background pixels that may show something: pixels at outlines may.
constexpr double most_outside = 0.02;

}  // namespace

bool covers_background(const Exhibit& e, const DisplayChange& turned) {
    const std::optional<Rgb> background = background_in(e, {e.right, {}});
    return background && e.grounds[way_turned(turned)] &&
           outline_of(e, turned, *background).outside > most_outside;
}

std::optional<OutlineMisfit> outline_misfit(const Exhibit& e, const DisplayChange& turned) {
    const std::optional<Rgb> background = background_in(e, {e.right, {}});
    if (!background) return std::nullopt;
    return e.grounds[way_turned(turned)] ? outline_of(e, turned, *background) : OutlineMisfit();
}

std::optional<std::string> other_outline(const Exhibit& e) {
    constexpr double most_inside = 0.2;
    const std::optional<Rgb> background = background_in(e, {e.right, {}});
    if (!background) return std::nullopt;
    const auto misfit = [](const OutlineMisfit& o) {
        return std::max(o.outside / most_outside, o.inside / most_inside);
    };
    OutlineMisfit best;
    for (const DisplayChange& turned : ways_of_turning()) {
        const OutlineMisfit outline = outline_of(e, turned, *background);
        if (misfit(outline) < misfit(best)) best = outline;
    }
    const char* const reason =
        "it has another aspect or camera, is another scene's, or went through a filter or lossy compression";
    if (best.outside > most_outside)
        return fmt::format("{:.0f} % of the scene's background shows something in the picture: {}",
                           100 * best.outside, reason);
    if (best.inside > most_inside)
        return fmt::format("{:.0f} % of the scene's surfaces are background in the picture: {}",
                           100 * best.inside, reason);
    return std::nullopt;
}

}  // namespace glint
