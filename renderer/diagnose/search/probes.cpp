#include "renderer/diagnose/search/probes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace glint {

DrawnProbes drawn_at(const std::vector<Probe>& probes, const Picture& picture, const IsBare& is_bare) {
    DrawnProbes drawn;
    for (const Probe& p : probes) {
        Rgb low{255, 255, 255}, high{};
        for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, picture.size.height - 1); ++y)
            for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, picture.size.width - 1); ++x) {
                const Rgb near = rgb_at(picture, picture.pixel(x, y));
                for (std::size_t c = 0; c < 3; ++c) {
                    low[c] = std::min(low[c], near[c]);
                    high[c] = std::max(high[c], near[c]);
                }
            }
        drawn.at.push_back(rgb_at(picture, picture.pixel(p.x, p.y)));
        drawn.low.push_back(low);
        drawn.high.push_back(high);
        drawn.bare.push_back(is_bare && is_bare(p.x, p.y) ? 1 : 0);
    }
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
    // What more than half have is the median of each channel, and noise leaves the median where it is.
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
    for (DisplayChange turned : ways_of_turning()) {
        turned.noise = noise;
        const std::size_t way = way_turned(turned);
        for (const Probe& p : probes)
            at_[way].push_back(rgb_at(wrong, changed_index(turned, wrong.size, p.x, p.y)));
        ground_[way] = ground_of(wrong, kinds, turned);
    }
}

double excess_at(const DrawnProbes& drawn, const WrongProbes& wrong, const DisplayChange& change,
                 const ByteBounds& bounds, double enough) {
    const std::vector<Rgb>& mine = wrong.at(change);
    const Ground& ground = wrong.ground(change);
    const std::vector<Rgb>& lows = change.soft ? drawn.low : drawn.at;
    const std::vector<Rgb>& highs = change.soft ? drawn.high : drawn.at;
    const float scatter = change.scatter();
    const std::array<std::size_t, 3> channel{changed_channel(change, 0), changed_channel(change, 1),
                                             changed_channel(change, 2)};
    double sum = 0;
    for (std::size_t i = 0; i < mine.size() && sum <= enough; ++i) {
        const Rgb &here = mine[i], &darkest = lows[i], &brightest = highs[i];
        const bool shows_ground = drawn.bare[i] != 0 && ground.is_known;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t k = channel[c];
            const float low = shows_ground ? ground.levels[k] - scatter : bounds.low[darkest[c]];
            const float high = shows_ground ? ground.levels[k] + scatter : bounds.high[brightest[c]];
            sum += double(excess_of(levels_outside(low, high, static_cast<float>(here[k]))));
        }
    }
    return sum;
}

namespace {

/// What a channel was before and after the gain, both far enough from black and from being clamped.
struct Pair {
    float drawn = 0, mine = 0;
};

Code inverse(Code code) {
    return code == Code::Encoded ? Code::Decoded : code == Code::Decoded ? Code::Encoded : Code::Same;
}

using CodeTable = std::array<float, 256>;
CodeTable filled_table(Code code) {
    CodeTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = coded(code, static_cast<float>(i) / 255);
    return table;
}
const CodeTable& code_table(Code code) {
    static const std::array<CodeTable, 3> tables = {filled_table(Code::Same), filled_table(Code::Encoded),
                                                    filled_table(Code::Decoded)};
    return tables[static_cast<std::size_t>(code)];
}

std::vector<Pair> gain_pairs(const DrawnProbes& drawn, const WrongProbes& wrong,
                             const DisplayChange& change) {
    constexpr std::uint8_t least = 4, most = 250;
    constexpr std::size_t enough = 200;
    const CodeTable& before = code_table(change.before);
    const CodeTable& after = code_table(inverse(change.after));
    const std::vector<Rgb>& mine = wrong.at(change);
    const std::size_t step = std::max<std::size_t>(1, mine.size() / enough);
    std::vector<Pair> pairs;
    pairs.reserve(3 * (enough + enough));
    for (std::size_t i = 0; i < mine.size(); i += step)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint8_t from = drawn.at[i][c], to = mine[i][changed_channel(change, c)];
            if (drawn.bare[i] != 0 || from < least || to < least || from > most || to > most) continue;
            pairs.push_back({before[from], after[to]});
        }
    return pairs;
}

/// The ratio that half of the light lies below: what is bright counts more, as rounding spoils it less.
/// Halves what is left to look at instead of sorting all.
float median_ratio(std::vector<Pair>& pairs) {
    const auto is_less = [](const Pair& a, const Pair& b) { return a.mine * b.drawn < b.mine * a.drawn; };
    const auto light = [](float sum, const Pair& p) { return sum + p.drawn; };
    const float all = std::accumulate(pairs.begin(), pairs.end(), 0.0f, light);
    auto first = pairs.begin(), last = pairs.end();
    float below = 0;  // the light before `first`
    while (last - first > 1) {
        const auto middle = first + (last - first) / 2;
        std::nth_element(first, middle, last, is_less);
        const float half = std::accumulate(first, middle, below, light);
        if (2 * half >= all) {
            last = middle;
        } else {
            below = half;
            first = middle;
        }
    }
    return first->mine / first->drawn;
}

}  // namespace

std::optional<float> fitted_gain(const DrawnProbes& drawn, const WrongProbes& wrong,
                                 const DisplayChange& change) {
    constexpr std::size_t enough = 12;
    constexpr float near = 0.02f, rounding = 1.5f / 255;
    std::vector<Pair> pairs = gain_pairs(drawn, wrong, change);
    if (pairs.size() < enough) return std::nullopt;
    const float median = median_ratio(pairs);
    float product = 0, square = 0;  // least squares among those that agree with the median
    for (const Pair& p : pairs) {
        if (std::abs(p.mine - median * p.drawn) > near * p.mine + rounding) continue;
        product += p.mine * p.drawn;
        square += p.drawn * p.drawn;
    }
    return square > 0 ? product / square : median;
}

}  // namespace glint
