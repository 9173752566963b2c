#include "diagnose/display_finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "diagnose/search/softness.h"

namespace glint {
namespace {

/// The background of a drawing; nothing where it shows none that the right picture shows, too.
std::optional<Rgb> background_in(const Exhibit& e, const Drawing& drawn) {
    for (std::size_t i = 0; i < e.kinds.size(); ++i)
        if (e.kinds[i] == PixelKind::Background && (drawn.bare.empty() || drawn.bare[i] != 0))
            return rgb_at(drawn.picture, i);
    return std::nullopt;
}

/// The background of the wrong picture where it is neither the drawing's nor what the display makes of that.
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

/// Crossings of silhouettes and creases along rows.
struct Crossings {
    std::size_t clear = 0;    // with colours far apart on their two sides
    std::size_t between = 0;  // of these, those with a pixel that is a mixture of both
};

/// Whether `c` lies on the way from one colour to another, near neither.
bool is_mixture(Rgb c, Rgb from, Rgb to) {
    constexpr double near_end = 0.2, near_line = 10;
    double along = 0, length = 0, off = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double way = double(to[i]) - double(from[i]);
        along += (double(c[i]) - double(from[i])) * way;
        length += way * way;
    }
    const double t = along / length;
    for (std::size_t i = 0; i < 3; ++i) {
        const double d = double(c[i]) - double(from[i]) - t * (double(to[i]) - double(from[i]));
        off += d * d;
    }
    return t > near_end && t < 1 - near_end && off < near_line * near_line;
}

/// Looks along each row for edge pixels between two others that are not. `colour` gives the colours of a
/// picture's pixels.
template <class Colour> Crossings crossings(const Exhibit& e, const Colour& colour) {
    constexpr int far = 48, widest = 8;
    Crossings found;
    const PictureSize size = e.right.size;
    for (int y = 0; y < size.height; ++y) {
        const auto kind = [&](int x) { return e.kinds[size.index(x, y)]; };
        for (int x = 1; x < size.width; ++x) {
            if (kind(x) != PixelKind::Edge || kind(x - 1) == PixelKind::Edge) continue;
            int end = x;
            while (end < size.width && end - x <= widest && kind(end) == PixelKind::Edge) ++end;
            if (end == size.width || kind(end) == PixelKind::Edge) continue;
            const Rgb from = colour(x - 1, y), to = colour(end, y);
            if (most_apart(from, to) < far) continue;
            bool between = false;
            for (int u = x; u < end; ++u) between |= is_mixture(colour(u, y), from, to);
            ++found.clear;
            found.between += between ? 1 : 0;
        }
    }
    return found;
}

/// Whether far more silhouettes are mixed in the picture than in one with hard edges, `drawn` as changed.
bool smooth_edges(const Exhibit& e, const Picture& drawn, const ByteRanges& ranges,
                  const DisplayChange& change) {
    constexpr std::size_t enough = 20;
    constexpr double more = 0.25;
    const auto share = [](const Crossings& c) {
        return static_cast<double>(c.between) / static_cast<double>(std::max<std::size_t>(1, c.clear));
    };
    const Crossings mine = crossings(e, [&](int x, int y) { return mine_at(e.wrong, change, x, y); });
    const Crossings hard =
        crossings(e, [&](int x, int y) { return shown(ranges, rgb_at(drawn, drawn.pixel(x, y))); });
    return mine.clear >= enough && share(mine) > share(hard) + more;
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
    finding.smooth_edges = smooth_edges(e, drawn, ranges, change);
    if (!change.soft) return finding;
    constexpr float least = 0.2f;  // of a pixel; what is left is the smoothing itself
    count_softened(finding, e, drawing);
    glm::vec2 shift = fitted_shift(e, drawn, change);
    for (int i = 0; i < 2; ++i)
        if (std::abs(shift[i]) < least) shift[i] = 0;
    finding.shift = shift;
    finding.smoothed = shift == glm::vec2(0);
    return finding;
}

namespace {

/// How a picture's outline differs from the scene's, in shares of 0 to 1.
struct Outline {
    double outside = 1;  // of what is background in the scene, what shows something
    double inside = 1;   // of the surfaces that are told from the background in the right picture, what shows
                         // the background
};

Outline outline_of(const Exhibit& e, const DisplayChange& turned, Rgb right_background) {
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
    const bool black = ground && most_apart(*ground, Rgb{}) <= dark;  // as a surface may be, too
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

std::optional<std::string> other_outline(const Exhibit& e) {
    constexpr double most_inside = 0.2;
    const std::optional<Rgb> background = background_in(e, {e.right, {}});
    if (!background) return std::nullopt;
    const auto misfit = [](const Outline& o) {
        return std::max(o.outside / most_outside, o.inside / most_inside);
    };
    Outline best;
    for (const DisplayChange& turned : ways_of_turning()) {
        const Outline outline = outline_of(e, turned, *background);
        if (misfit(outline) < misfit(best)) best = outline;
    }
    const char* const reason =
        "it has another aspect or camera, is another scene's, or went through a filter or lossy compression";
    if (best.outside > most_outside)
        return fmt::format("{:.0f} % of what is background in the scene shows something in the picture: {}",
                           100 * best.outside, reason);
    if (best.inside > most_inside)
        return fmt::format("{:.0f} % of what is surface in the scene is background in the picture: {}",
                           100 * best.inside, reason);
    return std::nullopt;
}

}  // namespace glint
