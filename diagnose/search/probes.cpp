#include "diagnose/search/probes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <iterator>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace glint {

RgbBounds bounds_around(const Picture& picture, glm::ivec2 pixel) {
    const int left = std::max(pixel.x - 1, 0), right = std::min(pixel.x + 1, picture.size.width - 1);
    RgbBounds bounds;
    for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, picture.size.height - 1); ++y)
        for (int x = left; x <= right; ++x) bounds.add(rgb_at(picture, picture.pixel(x, y)));
    return bounds;
}

namespace {

/// For each byte of a row of pixels, the smallest or the largest of it and the same byte of both neighbours.
template <class Choose>
std::vector<std::uint8_t> among_neighbours(const std::vector<std::uint8_t>& row, const Choose& choose) {
    constexpr std::size_t pixel = 4;
    std::vector<std::uint8_t> chosen = row;
    for (std::size_t i = pixel; i < row.size(); ++i) chosen[i] = choose(row[i], row[i - pixel]);
    for (std::size_t i = pixel; i < row.size(); ++i) chosen[i - pixel] = choose(chosen[i - pixel], row[i]);
    return chosen;
}

}  // namespace

RowBounds::RowBounds(const Picture& picture, int y) {
    const auto row = [&picture](int of) {
        return &picture.rgba[4 * picture.pixel(0, std::clamp(of, 0, picture.size.height - 1))];
    };
    const std::uint8_t *const above = row(y - 1), *const here = row(y), *const below = row(y + 1);
    const std::size_t bytes = 4 * static_cast<std::size_t>(picture.size.width);
    std::vector<std::uint8_t> low(bytes), high(bytes);
    for (std::size_t i = 0; i < bytes; ++i) {
        low[i] = std::min(std::min(above[i], here[i]), below[i]);
        high[i] = std::max(std::max(above[i], here[i]), below[i]);
    }
    low_ = among_neighbours(low, [](std::uint8_t a, std::uint8_t b) { return std::min(a, b); });
    high_ = among_neighbours(high, [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
}

BlockChoice blocks_of(const std::vector<Probe>& probes, PictureSize size) {
    constexpr int block = 16;
    const PictureSize in_blocks{(size.width + block - 1) / block, size.height};
    std::vector<std::uint8_t> blocks(in_blocks.pixels());
    for (const Probe& p : probes)
        for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, size.height - 1); ++y)
            for (const int x : {std::max(p.x - 1, 0), std::min(p.x + 1, size.width - 1)})
                blocks[in_blocks.index(x / block, y)] = 1;
    return std::make_shared<const std::vector<std::uint8_t>>(std::move(blocks));
}

DrawnProbes drawn_at(const std::vector<Probe>& probes, const Picture& picture, const IsBare& is_bare) {
    DrawnProbes drawn;
    for (ProbeLevels* levels : {&drawn.at, &drawn.low, &drawn.high}) levels->resize(3 * probes.size());
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const Probe& p = probes[i];
        const auto [low, high] = bounds_around(picture, {p.x, p.y});
        const Rgb at = rgb_at(picture, picture.pixel(p.x, p.y));
        std::copy(at.begin(), at.end(), &drawn.at[3 * i]);
        std::copy(low.begin(), low.end(), &drawn.low[3 * i]);
        std::copy(high.begin(), high.end(), &drawn.high[3 * i]);
        if (is_bare) drawn.bare.push_back(is_bare(p.x, p.y) ? 1 : 0);
    }
    if (std::count(drawn.bare.begin(), drawn.bare.end(), 1) == 0) drawn.bare.clear();
    return drawn;
}

namespace {

std::uint8_t median_of(const std::array<std::int64_t, 256>& counts, std::int64_t all) {
    std::size_t median = 0;
    for (std::int64_t below = counts[0]; 2 * below <= all && median < 255; below += counts[++median]) {
    }
    return static_cast<std::uint8_t>(median);
}

}  // namespace

std::optional<Rgb> background_of(const Picture& wrong, const std::vector<PixelKind>& kinds,
                                 const DisplayChange& change, double share) {
    const PictureSize size = wrong.size;
    const auto for_each = [&](const auto& take) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (kinds[size.index(x, y)] == PixelKind::Background)
                    take(rgb_at(wrong, changed_index(change, size, x, y)));
    };
    std::array<std::array<std::int64_t, 256>, 3> counts{};
    std::int64_t all = 0, agree = 0;
    for_each([&](const Rgb& one) {
        for (std::size_t c = 0; c < 3; ++c) ++counts[c][one[c]];
        ++all;
    });
    // If more than half of the pixels have one colour, each channel's median is that colour. Noise does not
    // move the median.
    const Rgb colour{median_of(counts[0], all), median_of(counts[1], all), median_of(counts[2], all)};
    for_each([&](const Rgb& one) {
        bool near = true;
        for (std::size_t c = 0; c < 3; ++c)
            near = near && static_cast<float>(std::abs(int{one[c]} - int{colour[c]})) <= change.scatter();
        agree += near ? 1 : 0;
    });
    if (static_cast<double>(agree) <= share * static_cast<double>(all)) return std::nullopt;
    return colour;
}

Ground ground_of(const Picture& wrong, const std::vector<PixelKind>& kinds, const DisplayChange& change) {
    constexpr double nearly_all = 0.97;
    constexpr float no_byte = 1000;
    Ground ground;
    ground.is_known = std::find(kinds.begin(), kinds.end(), PixelKind::Background) != kinds.end();
    ground.levels.fill(no_byte);
    if (const auto colour = background_of(wrong, kinds, change, nearly_all))
        std::copy(colour->begin(), colour->end(), ground.levels.begin());
    return ground;
}

WrongProbes::WrongProbes(const std::vector<Probe>& probes, const Picture& wrong,
                         const std::vector<PixelKind>& kinds, float noise)
    : noise_(noise) {
    for (DisplayChange change : ways_of_turning()) {
        change.noise = noise;
        const Ground ground = ground_of(wrong, kinds, change);
        for (const bool exchanged : {false, true}) {
            change.red_blue = exchanged;
            for (const Probe& p : probes) {
                const Rgb stored = rgb_at(wrong, changed_index(change, wrong.size, p.x, p.y));
                for (std::size_t c = 0; c < 3; ++c)
                    at_[way(change)].push_back(stored[changed_channel(change, c)]);
            }
            Ground& turned = ground_[way(change)] = ground;
            if (exchanged) std::swap(turned.levels[0], turned.levels[2]);
        }
    }
}

namespace {

/// The number of channels that are looked up together, and then computed side by side.
constexpr std::size_t block_probes = 16, block = 3 * block_probes;

struct Block {
    std::array<float, block> low{}, high{};  // what the channels may show
    std::array<float, block> mine{};         // what they do show
};

/// Sum of excess_of() over a block.
float excess_in(const Block& at) {
    constexpr int lanes = 4;
    Lanes<lanes> sum;
    for (std::size_t i = 0; i < block; i += lanes) {
        const auto channels = [i](const auto& values) { return load<Lanes<lanes>>(values.data() + i); };
        sum = sum + excess_of(levels_outside(channels(at.low), channels(at.high), channels(at.mine)));
    }
    return sum.v[0] + sum.v[1] + sum.v[2] + sum.v[3];
}

/// Sets the expected levels of all probes that show no surface to the ground's.
void show_ground(Block& at, const std::uint8_t* bare, std::size_t probes, const Ground& ground,
                 float scatter) {
    for (std::size_t i = 0; i < 3 * probes; ++i) {
        if (bare[i / 3] == 0) continue;
        at.low[i] = ground.levels[i % 3] - scatter;
        at.high[i] = ground.levels[i % 3] + scatter;
    }
}

}  // namespace

double excess_at(const DrawnProbes& drawn, const WrongProbes& wrong, const DisplayChange& change,
                 const ByteBounds& bounds, double enough) {
    const ProbeLevels& mine = wrong.at(change);
    const Ground& ground = wrong.ground(change);
    const ProbeLevels& lows = change.soft ? drawn.low : drawn.at;
    const ProbeLevels& highs = change.soft ? drawn.high : drawn.at;
    const bool shows_ground = ground.is_known && !drawn.bare.empty();
    Block at;
    double sum = 0;
    for (std::size_t first = 0; first < mine.size() && sum <= enough; first += block) {
        const std::size_t count = std::min(block, mine.size() - first);
        if (count < block) at = {};  // channels without a probe do not count
        for (std::size_t i = 0; i < count; ++i) {
            at.low[i] = bounds.low[lows[first + i]];
            at.high[i] = bounds.high[highs[first + i]];
            at.mine[i] = static_cast<float>(mine[first + i]);
        }
        if (shows_ground) show_ground(at, &drawn.bare[first / 3], count / 3, ground, change.scatter());
        sum += double(excess_in(at));
    }
    return sum;
}

namespace {

/// A channel's value before and after the gain, both far enough from black and from being clamped.
struct Pair {
    float drawn = 0, mine = 0, ratio = 0;
};

Code inverse(Code code) {
    return code == Code::Encoded ? Code::Decoded : code == Code::Decoded ? Code::Encoded : Code::Same;
}

std::vector<Pair> gain_pairs(const DrawnProbes& drawn, const WrongProbes& wrong,
                             const DisplayChange& change) {
    constexpr std::uint8_t least = 4, most = 250;
    constexpr std::size_t enough = 80, few = 60;
    const Code undo = inverse(change.after);
    const ProbeLevels& mine = wrong.at(change);
    const std::size_t probes = mine.size() / 3, step = std::max<std::size_t>(1, probes / enough);
    std::vector<Pair> pairs;
    pairs.reserve(3 * (enough + enough));
    const auto add_every = [&](std::size_t nth) {
        for (std::size_t i = 0; i < probes; i += nth) {
            if (!drawn.bare.empty() && drawn.bare[i] != 0) continue;
            for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
                const std::uint8_t from = drawn.at[k], to = mine[k];
                if (from < least || to < least || from > most || to > most) continue;
                const float drawn_light = coded_byte(change.before, from), mine_light = coded_byte(undo, to);
                pairs.push_back({drawn_light, mine_light, mine_light / drawn_light});
            }
        }
    };
    add_every(step);
    if (pairs.size() < few && step > 1) {  // most of the drawing is black or clamped
        pairs.clear();
        add_every(1);
    }
    return pairs;
}

/// Bins for ratios from 2^-8 to 2^8, each a 16th of an octave wide; other ratios go into the first or last
/// bin.
constexpr int bins_an_octave = 16, bins = 16 * bins_an_octave;
std::size_t bin_of(float ratio) {
    constexpr int mantissa = 23, smallest = 127 - 8;  // bits of a float; the exponent of 2^-8
    return static_cast<std::size_t>(std::clamp(
        bits_of(ratio) / ((1 << mantissa) / bins_an_octave) - smallest * bins_an_octave, 0, bins - 1));
}

/// Returns the median of the ratios, weighted by the drawn brightness, because rounding changes the ratio of
/// a bright pair less. Finds the bin that contains the median and sorts only that bin.
float median_ratio(const std::vector<Pair>& pairs) {
    std::array<float, bins> light{};
    for (const Pair& p : pairs) light[bin_of(p.ratio)] += p.drawn;
    const float half = std::accumulate(light.begin(), light.end(), 0.0f) / 2;
    std::size_t bin = 0;
    float below = 0;
    while (bin + 1 < bins && below + light[bin] < half) below += light[bin++];
    std::vector<Pair> in_bin;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(in_bin),
                 [bin](const Pair& p) { return bin_of(p.ratio) == bin; });
    std::sort(in_bin.begin(), in_bin.end(), [](const Pair& a, const Pair& b) { return a.ratio < b.ratio; });
    std::size_t i = 0;
    while (i + 1 < in_bin.size() && below + in_bin[i].drawn < half) below += in_bin[i++].drawn;
    return in_bin[i].ratio;
}

}  // namespace

std::optional<float> fitted_gain(const DrawnProbes& drawn, const WrongProbes& wrong,
                                 const DisplayChange& change) {
    constexpr std::size_t enough = 12;
    constexpr float near = 0.02f, rounding = 1.5f / 255;
    const std::vector<Pair> pairs = gain_pairs(drawn, wrong, change);
    if (pairs.size() < enough) return std::nullopt;
    const float median = median_ratio(pairs);
    float product = 0, square = 0;  // least squares over the pairs that agree with the median
    for (const Pair& p : pairs) {
        if (std::abs(p.mine - median * p.drawn) > near * p.mine + rounding) continue;
        product += p.mine * p.drawn;
        square += p.drawn * p.drawn;
    }
    return square > 0 ? product / square : median;
}

namespace {

using SeenRow = std::vector<std::optional<SeenPoint>>;

/// If more than this share of the vector from one point to the next is along the normal, it leaves the
/// surface: it crosses a crease, or leads to a part behind.
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

/// Marks the pixels of row y that show a different surface from the pixel to the right or the one below.
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
