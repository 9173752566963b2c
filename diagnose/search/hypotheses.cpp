#include "diagnose/search/hypotheses.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "diagnose/search/cost_bound.h"
#include "diagnose/search/resample.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

constexpr std::size_t even_probes = 1200, probes_a_mistake = 24, changes_kept = 3;
constexpr double free_in_probes = 8;

/// Every n-th of some pixels, so that there are about `count`.
void add_every(std::vector<Probe>& probes, const std::vector<std::size_t>& pixels, PictureSize size,
               std::size_t count) {
    const std::size_t step = std::max<std::size_t>(1, pixels.size() / std::max<std::size_t>(1, count));
    const auto width = static_cast<std::size_t>(size.width);
    for (std::size_t i = step / 2; i < pixels.size(); i += step)
        probes.push_back({static_cast<int>(pixels[i] % width), static_cast<int>(pixels[i] / width)});
}

/// Probes from everywhere first, so that what is hopeless is seen soon.
std::vector<Probe> shuffled(const std::vector<Probe>& probes) {
    constexpr std::size_t stride = 7919;  // a prime
    if (probes.size() % stride == 0) return probes;
    std::vector<Probe> mixed;
    for (std::size_t i = 0; i < probes.size(); ++i) mixed.push_back(probes[i * stride % probes.size()]);
    return mixed;
}

int difference(const Picture& a, const Picture& b, std::size_t pixel) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c)
        most = std::max(most, std::abs(int{a.rgba[4 * pixel + c]} - int{b.rgba[4 * pixel + c]}));
    return most;
}

/// The pictures of a scene under each mistake alone, of those that change any.
struct Singles {
    std::vector<Picture> picture;  // that of no mistake first
    std::vector<BareMask> bare;    // of each
    std::vector<MistakeSet> mistakes;
    std::vector<PixelKind> kinds;
    std::vector<Probe> probes;
};

/// Probes everywhere, and where each mistake shows.
std::vector<Probe> choose_probes(const Singles& s, PictureSize size) {
    std::vector<std::size_t> surface;
    for (std::size_t i = 0; i < s.kinds.size(); ++i)
        if (s.kinds[i] == PixelKind::Surface) surface.push_back(i);
    std::vector<Probe> probes;
    add_every(probes, surface, size, even_probes);
    for (std::size_t m = 1; m < s.picture.size(); ++m) {
        std::vector<std::size_t> shows;
        int most = 0;
        for (const std::size_t i : surface) most = std::max(most, difference(s.picture[m], s.picture[0], i));
        for (const std::size_t i : surface)
            if (const int d = difference(s.picture[m], s.picture[0], i); d > 0 && 2 * d >= most)
                shows.push_back(i);
        add_every(probes, shows, size, probes_a_mistake);
    }
    return shuffled(probes);
}

Singles draw_singles(Renderer& renderer, const Scene& scene, PictureSize size,
                     const DiagnosisProgress& progress) {
    Singles s;
    BareMasks masks;
    const auto keep = [&](MistakeSet mistakes, const Picture& picture, BareMask bare) {
        s.picture.push_back(picture);
        s.bare.push_back(std::move(bare));
        s.mistakes.push_back(std::move(mistakes));
    };
    const Picture& right = renderer.render(under_mistakes(scene, {}), size);
    keep({}, right, masks.of(renderer, size));
    s.kinds = pixel_kinds(renderer, size);
    for (std::size_t m = 0; m < mistake_names().size(); ++m) {
        if (progress) progress(m, mistake_names().size());
        const Picture& picture = renderer.render(under_mistakes(scene, {m}), size);
        BareMask bare = masks.of(renderer, size);
        if (picture.rgba != s.picture[0].rgba)
            keep({m}, picture, std::move(bare));  // else inert in this scene
    }
    return s;
}

/// Every curve that a display may have put its numbers through, with its gain to be found.
std::vector<DisplayChange> curves() {
    std::vector<DisplayChange> all;
    for (const auto& [before, after] : {std::pair{Code::Same, Code::Same},
                                        {Code::Encoded, Code::Same},
                                        {Code::Decoded, Code::Same},
                                        {Code::Same, Code::Encoded},
                                        {Code::Decoded, Code::Encoded}}) {
        DisplayChange change;
        change.before = before;
        change.after = after;
        all.push_back(change);
    }
    return all;
}

/// Every way in which colours may have got lost, with its gain to be found.
std::vector<DisplayChange> all_changes() {
    std::vector<DisplayChange> all;
    for (DisplayChange change : curves())
        for (int ways = 0; ways < 8; ++ways) {
            change.upside_down = (ways & 1) != 0;
            change.mirrored = (ways & 2) != 0;
            change.red_blue = (ways & 4) != 0;
            all.push_back(change);
        }
    return all;
}

IsBare is_bare(const BareMask& mask, PictureSize size) {
    if (mask.empty()) return {};
    return [&mask, size](int x, int y) { return mask[size.index(x, y)] != 0; };
}

struct CostedChange {
    DisplayChange change;
    double cost = 0;
};

/// Returns the excess above which a change costs more than `cost`. It is a hair larger, so that rounding
/// never stops the trial of a change of equal cost early.
double most_excess(double cost, std::size_t mistakes, const DisplayChange& change) {
    constexpr double hair = 1 + 1e-9;
    return std::exp2(cost - explanation_cost(1, 0, mistakes, change)) * hair - free_in_probes;
}

/// Tries every change at the display, each with the gain that fits it, supposing that the picture was drawn
/// as `drawn`. `enough(change)` returns the excess above which the cost does not matter. `take(change, cost)`
/// receives a cost that is exact up to there.
template <class Enough, class Take>
void try_changes(std::size_t mistakes, const DrawnProbes& drawn, const WrongProbes& wrong,
                 const Enough& enough, const Take& take) {
    static const std::vector<DisplayChange> changes = all_changes();
    constexpr float no_gain = 0.004f;
    const auto attempt = [&](DisplayChange change) {
        change.noise = wrong.noise();
        const ByteBounds bounds = byte_bounds(change);
        for (const bool soft : {false, true}) {
            change.soft = soft;
            const double excess = excess_at(drawn, wrong, change, bounds, enough(change));
            take(change, explanation_cost(excess, free_in_probes, mistakes, change));
        }
    };
    for (DisplayChange change : changes) {
        if (change.after == Code::Same) attempt(change);  // without a gain the others say the same
        const auto gain = fitted_gain(drawn, wrong, change);
        if (!gain || std::abs(*gain - 1) < no_gain) continue;
        change.gain = *gain;
        attempt(change);
    }
}

/// The likeliest things that happened at the display if the picture was drawn as `drawn`.
Hypothesis judged(const MistakeSet& mistakes, const DrawnProbes& drawn, const WrongProbes& wrong) {
    std::vector<CostedChange> kept;
    const auto enough = [&](const DisplayChange& change) {
        if (kept.size() < changes_kept) return std::numeric_limits<double>::infinity();
        return most_excess(kept.back().cost, mistakes.size(), change);
    };
    try_changes(mistakes.size(), drawn, wrong, enough, [&](const DisplayChange& change, double cost) {
        const auto after =
            std::find_if(kept.begin(), kept.end(), [cost](const CostedChange& c) { return cost < c.cost; });
        kept.insert(after, {change, cost});
        if (kept.size() > changes_kept) kept.pop_back();
    });
    Hypothesis hypothesis{mistakes, {}, kept.front().cost};
    for (const CostedChange& c : kept) hypothesis.changes.push_back(c.change);
    return hypothesis;
}

/// The cost of the likeliest change; one above `bound` need not be exact.
double least_cost(std::size_t mistakes, const DrawnProbes& drawn, const WrongProbes& wrong,
                  const CostBound& bound) {
    double least = std::numeric_limits<double>::infinity();
    const auto enough = [&](const DisplayChange& change) {
        return most_excess(std::min(least, bound.get()), mistakes, change);
    };
    try_changes(mistakes, drawn, wrong, enough,
                [&](const DisplayChange&, double cost) { least = std::min(least, cost); });
    return least;
}

/// An explanation as it was drawn at the probes.
struct Drawn {
    MistakeSet mistakes;
    DrawnProbes at;
    double cost = 0;  // least_cost()
};

/// Adds all pairs of mistakes that together show what neither shows alone. A mistake that changes nothing
/// alone may have an effect beside another: exchanged coefficients bring a highlight, and then the vectors
/// matter.
void draw_pairs(std::vector<Drawn>& all, Renderer& renderer, const Scene& scene, PictureSize size, Singles& s,
                const DiagnosisProgress& progress) {
    const std::size_t n = mistake_names().size(), twos = n * (n - 1) / 2;
    std::vector<std::size_t> alone(n);  // where each stands in `all`; what is inert is the right picture
    for (std::size_t i = 1; i < s.mistakes.size(); ++i) alone[s.mistakes[i][0]] = i;
    std::size_t done = 0;
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b) {
            if (progress) progress(++done, twos);
            const Picture& picture = renderer.render(under_mistakes(scene, {a, b}), size);
            DrawnProbes at =
                drawn_at(s.probes, picture, [&](int x, int y) { return renderer.object_at(x, y) < 0; });
            if (at == all[alone[a]].at || at == all[alone[b]].at) continue;  // one hides the other
            all.push_back({{a, b}, std::move(at)});
        }
}

/// The first, and of the others the cheapest, `count` in all.
std::vector<Hypothesis> likeliest(std::vector<Drawn>& all, const WrongProbes& wrong, std::size_t count) {
    CostBound bound(count - 1);
    tbb::parallel_for(std::size_t{1}, all.size(), [&](std::size_t i) {
        all[i].cost = least_cost(all[i].mistakes.size(), all[i].at, wrong, bound);
        bound.add(all[i].cost);
    });
    std::stable_sort(all.begin() + 1, all.end(),
                     [](const Drawn& a, const Drawn& b) { return a.cost < b.cost; });
    std::vector<Hypothesis> found(std::min(count, all.size()));
    tbb::parallel_for(std::size_t{0}, found.size(),
                      [&](std::size_t i) { found[i] = judged(all[i].mistakes, all[i].at, wrong); });
    return found;
}

}  // namespace

double explanation_cost(double excess, double free, std::size_t mistakes, const DisplayChange& change) {
    // Where explanations are equal, one mistake is preferred to a change at the display, and that to two
    // mistakes; softness, which leaves room for much, comes last.
    constexpr double nearly = 0.01;
    const double preference = (mistakes == 1 ? 0 : nearly) + (change.soft ? nearly : 0);
    return std::log2(excess + free) + static_cast<double>(mistakes) + change.count() + preference;
}

std::vector<Hypothesis> likely_hypotheses(const Scene& scene, const Picture& wrong, float noise,
                                          PictureSize at, bool pairs, std::size_t count, int threads,
                                          const DiagnosisProgress& progress) {
    Renderer renderer(threads);
    Singles s = draw_singles(renderer, scene, at, pairs ? DiagnosisProgress() : progress);
    s.probes = choose_probes(s, at);
    const WrongProbes mine(s.probes, resampled(wrong, at), s.kinds, noise);
    std::vector<Drawn> all;
    for (std::size_t m = 0; m < s.mistakes.size(); ++m)
        all.push_back({s.mistakes[m], drawn_at(s.probes, s.picture[m], is_bare(s.bare[m], at))});
    if (pairs) draw_pairs(all, renderer, scene, at, s, progress);
    return likeliest(all, mine, count);
}

}  // namespace glint
