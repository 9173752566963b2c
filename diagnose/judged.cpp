#include "diagnose/judged.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "diagnose/search/hypotheses.h"
#include "diagnose/search/score.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

constexpr std::size_t drawings = 14;    // how many are judged on only some of the rows
constexpr double free_in_picture = 50;  // sum of excess_of() over a whole picture

void judge(Judged& j, const Exhibit& exhibit, const DisplayChange& change, int step) {
    j.change = change;
    j.score = score(exhibit, j.drawing, change, step);
    j.cost = explanation_cost(j.score.excess, free_in_picture / step, j.explanation.belief, change) +
             (has_other_background(exhibit, j.drawing, change) ? 1 : 0);
}

/// Also judges the explanation under a different change, and keeps the cheaper one; at equal cost, the one
/// with less error beyond rounding. Also keeps the new change if it costs less than `for_much_nearer` more
/// and has less than half the RMS error.
void judge_also(Judged& j, const Exhibit& exhibit, const DisplayChange& change, int step,
                double for_much_nearer = 0) {
    const Score score = j.score;
    const DisplayChange kept = j.change;
    const double cost = j.cost;
    judge(j, exhibit, change, step);
    if (j.cost < cost || (j.cost == cost && j.score.squares < score.squares)) return;
    if (j.cost < cost + for_much_nearer && 4 * j.score.squares < score.squares) return;
    j.score = score;
    j.change = kept;
    j.cost = cost;
}

/// Judges using every row. A soft change is judged as a hard one if that leaves no excess, or if the picture
/// cannot have been softened. Where the hard change fits, only hard edges (is_hard()) prove the latter;
/// elsewhere may_be_softened() decides.
void judge_whole(Judged& j, const Exhibit& exhibit) {
    const DisplayChange change = j.change;
    if (change.soft) {
        DisplayChange hard = change;
        hard.soft = false;
        judge(j, exhibit, hard, 1);
        if (j.score.excess == 0) return;
        const bool fits = j.score.fits();
        if (fits ? is_hard(exhibit, j.drawing, change) : !may_be_softened(exhibit, j.drawing, change)) return;
    }
    judge(j, exhibit, change, 1);
}

/// The best of the changes that the hypothesis allows, judged by every `step`-th row.
Judged judged(Drawings& drawings, BareMasks& masks, const Exhibit& exhibit, const Hypothesis& hypothesis,
              int step) {
    Judged best;
    best.explanation = hypothesis.explanation;
    best.same = hypothesis.same;
    best.drawing.picture = drawings.whole(hypothesis.explanation);
    best.drawing.bare = masks.of(drawings.renderer(), exhibit.right.size);
    judge(best, exhibit, hypothesis.changes.front(), step);
    for (std::size_t i = 1; i < hypothesis.changes.size(); ++i)
        judge_also(best, exhibit, hypothesis.changes[i], step);
    return best;
}

/// Whether two drawings are the same to within one level on all compared pixels.
bool look_alike(const Exhibit& exhibit, const Drawing& a, const Drawing& b) {
    for (std::size_t i = 0; i < exhibit.kinds.size(); ++i) {
        if (exhibit.kinds[i] != PixelKind::Surface) continue;
        for (std::size_t c = 4 * i; c < 4 * i + 3; ++c)
            if (std::abs(int{a.picture.rgba[c]} - int{b.picture.rgba[c]}) > 1) return false;
    }
    return true;
}

/// Also judges the correct picture as encoded by a power (Code::Power): most programs that do not use
/// sRGB's curve encode like that. It is tried only without a mistake. `change`: what else the display
/// changed.
void judge_by_power(Judged& none, const Exhibit& exhibit, DisplayChange change) {
    change.after = Code::Power;
    change.gain = 1;
    change.soft = false;
    for (const Code before : {Code::Same, Code::Decoded}) {
        change.before = before;
        judge_also(none, exhibit, change, 1, 1);
    }
}

/// Whether an explanation assumes that colours were encoded twice, and then decoded again.
bool encodes_and_decodes(const Judged& j) {
    return j.change.encodings() < 0 && j.explanation.makes(&Mistakes::encoded_twice);
}

/// Whether two changes encode differently, or have clearly different gains.
bool shows_otherwise(const DisplayChange& a, const DisplayChange& b) {
    constexpr float clearly = 1.1f;
    return a.before != b.before || a.after != b.after || a.gain > clearly * b.gain ||
           b.gain > clearly * a.gain;
}

/// Whether an explanation assumes more than the one without a mistake, but gives the same picture: for
/// example a gain of pi together with a mistake that divides by pi. If the encoding or the gain of the two
/// differs, one pixel in a hundred may differ.
bool undoes_itself(const Exhibit& exhibit, const Judged& j, const Judged& none) {
    constexpr std::uint64_t few = 100;  // one pixel in 100
    if (encodes_and_decodes(j)) return true;
    if (j.explanation.belief + j.change.count() <= none.change.count()) return false;
    if (way_turned(j.change) != way_turned(none.change) || j.change.red_blue != none.change.red_blue)
        return false;
    const ByteRanges ranges = byte_ranges(j.change), right = byte_ranges(none.change);
    std::uint64_t all = 0, unlike = 0;
    for (std::size_t i = 0; i < exhibit.kinds.size(); ++i) {
        if (exhibit.kinds[i] != PixelKind::Surface) continue;
        bool same = true;
        for (std::size_t c = 4 * i; c < 4 * i + 3; ++c) {
            const ByteRange& shows = ranges[j.drawing.picture.rgba[c]];
            same = same && levels_outside(shows.low, shows.high, right[exhibit.right.rgba[c]].middle) <= 1;
        }
        ++all;
        unlike += same ? 0 : 1;
    }
    return shows_otherwise(j.change, none.change) ? few * unlike <= all : unlike == 0;
}

/// Whether the picture contradicts the assumed change of brightness: most pixels that the change would alter
/// clearly are the same as in the correct picture. A supposed mistake that brightens could cancel a supposed
/// gain that darkens, and vice versa.
bool kept_its_brightness(const Exhibit& exhibit, const DisplayChange& change) {
    if (change.gain == 1 && change.before == Code::Same && change.after == Code::Same) return false;
    const ByteRanges ranges = byte_ranges(change);
    const float same = 1 + change.scatter(), clearly = visible_levels + change.scatter();
    const PictureSize size = exhibit.right.size;
    std::uint64_t changed = 0, kept = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::size_t pixel = size.index(x, y);
            if (exhibit.kinds[pixel] != PixelKind::Surface) continue;
            const Rgb right = rgb_at(exhibit.right, pixel), mine = mine_at(exhibit.wrong, change, x, y);
            float by = 0, off = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                by = std::max(by, ranges[right[c]].from_middle(right[c]));
                off = std::max(off, std::abs(float(mine[c]) - float(right[c])));
            }
            changed += by > clearly ? 1 : 0;
            kept += by > clearly && off <= same ? 1 : 0;
        }
    return 2 * kept > changed;
}

/// Whether the surfaces of the correct picture show at most four colours, each within 8 levels, such as
/// plates of one colour each. Then a mistake with a gain and another display change can turn them into any
/// other colours.
bool has_few_colours(const Exhibit& exhibit) {
    constexpr std::size_t few = 4;
    constexpr int near = 8;
    std::vector<Rgb> colours;
    for (std::size_t i = 0; i < exhibit.kinds.size() && colours.size() <= few; ++i) {
        if (exhibit.kinds[i] != PixelKind::Surface) continue;
        const Rgb colour = rgb_at(exhibit.right, i);
        const auto is_same = [&colour](const Rgb& other) { return most_apart(colour, other) <= near; };
        if (std::none_of(colours.begin(), colours.end(), is_same)) colours.push_back(colour);
    }
    return colours.size() <= few;
}

/// Returns which flips are worth trying: no flip, and those under which the silhouettes match clearly better,
/// or under which only the flipped background has the scene's colour.
std::array<bool, 4> likely_turns(const Exhibit& exhibit) {
    constexpr double clearly = 0.6, at_least = 0.004;
    std::array<bool, 4> turns{true, false, false, false};
    const std::array<DisplayChange, 4> ways = ways_of_turning();
    const std::optional<OutlineMisfit> as_it_is = outline_misfit(exhibit, ways[0]);
    if (!as_it_is) return {true, true, true, true};
    const auto is_better = [](double turned, double before) {
        return turned < clearly * before && turned < before - at_least;
    };
    const std::optional<Rgb> ground = background_of(exhibit.right, exhibit.kinds, {});
    const auto shows_ground = [&](std::size_t way) {
        constexpr int near = 1;
        const std::optional<Rgb>& mine = exhibit.grounds[way];
        return ground && mine && most_apart(*ground, *mine) <= near;
    };
    for (std::size_t i = 1; i < turns.size(); ++i) {
        const OutlineMisfit turned = *outline_misfit(exhibit, ways[i]);
        // Surfaces that a mistake removes are missing under every flip. A surface may have the background's
        // colour, so a silhouette supports a flip only if the flipped picture covers less of the background.
        const bool misses_as_much = turned.outside < at_least && turned.inside < as_it_is->inside + at_least;
        turns[i] = (is_better(turned.most(), as_it_is->most()) && turned.outside < as_it_is->outside) ||
                   (misses_as_much && is_better(turned.outside, as_it_is->outside)) ||
                   (shows_ground(i) && !shows_ground(0));
    }
    return turns;
}

Candidate candidate_of(const Exhibit& exhibit, const Judged& j) {
    Candidate c;
    static_cast<Supposition&>(c) = j.explanation;
    c.almost = j.is_almost;
    c.change = j.change;
    c.residual = j.score.residual();
    c.explained = j.score.share_explained();
    c.pixel = j.score.pixel;
    const ByteRanges ranges = byte_ranges(j.change);
    const std::size_t pixel = exhibit.right.pixel(c.pixel.x, c.pixel.y);
    c.mine = mine_at(exhibit.wrong, j.change, c.pixel.x, c.pixel.y);
    c.reference = shown_beside(ranges, rgb_at(exhibit.right, pixel), c.mine);
    const std::optional<Rgb>& ground = exhibit.grounds[way_turned(j.change)];
    const bool is_bare = !j.drawing.bare.empty() && j.drawing.bare[pixel] != 0;
    c.as_mistaken = is_bare && ground ? exchanged(j.change, *ground)
                                      : shown_beside(ranges, rgb_at(j.drawing.picture, pixel), c.mine);
    return c;
}

}  // namespace

const Judged& of_no_mistake(const std::vector<Judged>& all) {
    return *std::find_if(all.begin(), all.end(), [](const Judged& j) { return j.is_plain(); });
}

namespace {

/// Adds the name of another explanation that gives the same picture to a candidate.
void add_also(Candidate& c, const Supposition& e) {
    if (e.name == c.name || std::find(c.also_named.begin(), c.also_named.end(), e.name) != c.also_named.end())
        return;
    constexpr std::size_t most = 8;
    if (c.also_named.size() >= most || e.belief > 2) return;
    c.also_named.push_back(e.name);
    if (e.kind == ExplanationKind::Mistake && c.kind == e.kind && e.mistakes.size() == c.mistakes.size() &&
        e.only.is_all())
        c.also.push_back(e.mistakes);
}

}  // namespace

std::vector<Candidate> candidates_of(const Exhibit& exhibit, const std::vector<Judged>& all,
                                     const DisplayChange& told) {
    constexpr std::size_t most = 3;
    std::vector<Candidate> candidates;
    std::vector<const Judged*> shown;
    const Judged& none = of_no_mistake(all);
    // The same edit under other conventions, or for part of the equation, counts as one candidate: the
    // likeliest.
    const auto is_named = [&candidates](const Judged& j) {
        return std::any_of(candidates.begin(), candidates.end(), [&j](const Candidate& c) {
            return c.kind == j.explanation.kind && c.name == j.explanation.name;
        });
    };
    for (const Judged& j : all) {
        if (j.is_right || undoes_itself(exhibit, j, none)) continue;
        const auto like = std::find_if(shown.begin(), shown.end(), [&](const Judged* s) {
            return look_alike(exhibit, s->drawing, j.drawing);
        });
        if (like != shown.end()) {
            Candidate& first = candidates[static_cast<std::size_t>(like - shown.begin())];
            add_also(first, j.explanation);
            for (const Supposition& e : j.same) add_also(first, e);
        } else if (candidates.size() < most && !is_named(j) && are_of_one_display(j.change, told)) {
            candidates.push_back(candidate_of(exhibit, j));
            for (const Supposition& e : j.same) add_also(candidates.back(), e);
            shown.push_back(&j);
        }
    }
    return candidates;
}

namespace {

/// Whether the residual is so much smaller than that of the correct picture that only a small difference
/// between the programs can remain.
bool fits_almost(const Judged& j, const Judged& none) {
    constexpr double most_residual = 1.0, of_right = 0.06, least_explained = 0.93, most_unlike = 0.04;
    const Supposition& e = j.explanation;
    if (e.kind == ExplanationKind::Number || e.mistakes.size() > 1 || !e.only.is_all()) return false;
    return j.score.residual() < most_residual && j.score.residual() < of_right * none.score.residual() &&
           j.score.share_explained() > least_explained &&
           static_cast<double>(j.score.unlike) < most_unlike * static_cast<double>(j.score.compared);
}

/// Whether every other explanation leaves a clearly larger residual.
bool stands_alone(const Judged& j, const std::vector<Judged>& all, const Exhibit& exhibit) {
    constexpr double clearly = 2;
    return std::none_of(all.begin(), all.end(), [&](const Judged& other) {
        return &other != &j && other.score.residual() < clearly * j.score.residual() &&
               other.explanation.name != j.explanation.name && !look_alike(exhibit, other.drawing, j.drawing);
    });
}

/// Whether an explanation without a mistake misses the picture by only a few levels, in few pixels. A mistake
/// that is visible at a glance leaves more.
bool is_nearly_right(const Judged& j) {
    constexpr double most_residual = 1;
    constexpr std::uint64_t per_unlike = 20, per_far = 1000;
    return j.score.residual() < most_residual && j.score.unlike * per_unlike <= j.score.compared &&
           j.score.far * per_far <= j.score.compared;
}

/// The sums of differences over a square, by channel, and the sum of their squares.
struct SquareSums {
    std::array<double, 3> sums{};
    double squares = 0;
    void add(const SquareSums& other) {
        for (std::size_t c = 0; c < 3; ++c) sums[c] += other.sums[c];
        squares += other.squares;
    }
};

/// Whether the difference changes more where the 8 x 8 blocks of a JPEG meet than within them.
bool shows_blocks(const Exhibit& e, const Judged& j) {
    constexpr double more = 1.15;
    const ByteRanges ranges = byte_ranges(j.change);
    const PictureSize size = e.right.size;
    const auto off = [&](int x, int y) {
        return double(mine_at(e.wrong, j.change, x, y)[1]) -
               double(ranges[j.drawing.picture.rgba[4 * size.index(x, y) + 1]].middle);
    };
    struct Mean {
        double sum = 0, count = 0;
    };
    std::array<Mean, 2> between{}, within{};  // the steps to the right and down
    for (int y = 0; y + 1 < size.height; ++y)
        for (int x = 0; x + 1 < size.width; ++x) {
            if (e.kinds[size.index(x, y)] != PixelKind::Surface) continue;
            for (const int k : {0, 1}) {
                const bool meets = (k == 0 ? x : y) % 8 == 7;
                const double step = std::abs(off(x + 1 - k, y + k) - off(x, y));
                Mean& mean = (meets ? between : within)[k];
                mean.sum += step;
                ++mean.count;
            }
        }
    const auto jumps = [&](int k) {
        return between[k].sum * within[k].count > more * within[k].sum * between[k].count;
    };
    return jumps(0) && jumps(1);
}

/// Whether individual pixels differ, but the means of 16 x 16 squares hardly do. Lossy compression and
/// dithering do this, but no lighting mistake. `few`: how many squares in a thousand may differ.
bool means_fit(const Exhibit& e, const Judged& j, std::uint64_t few) {
    constexpr int edge = 16, part = 8;  // JPEG averages colours over 16 x 16 pixels and codes blocks of 8 x 8
    constexpr double most_residual = 3.5, near = 1.6;  // levels
    constexpr double most_even = 8;  // noise gives 1, a locally constant difference part * part
    constexpr std::uint64_t enough = 20, per_unlike = 50;  // a convention or a small highlight changes fewer
    if (j.score.residual() > most_residual || j.score.unlike * per_unlike < j.score.compared) return false;
    const ByteRanges ranges = byte_ranges(j.change);
    const PictureSize size = e.right.size;
    const auto sums_at = [&](int left, int top) -> std::optional<SquareSums> {
        SquareSums s;
        for (int v = top; v < top + part; ++v)
            for (int u = left; u < left + part; ++u) {
                if (e.kinds[size.index(u, v)] != PixelKind::Surface) return std::nullopt;
                const Rgb mine = mine_at(e.wrong, j.change, u, v);
                for (std::size_t c = 0; c < 3; ++c) {
                    const ByteRange& r = ranges[j.drawing.picture.rgba[4 * size.index(u, v) + c]];
                    const double off = r.off(mine[c]) > 0 ? double(mine[c]) - double(r.middle) : 0;
                    s.sums[c] += off;
                    s.squares += off * off;
                }
            }
        return s;
    };
    std::uint64_t squares = 0, unlike = 0;
    double even = 0, all = 0;
    for (int y = 0; y + edge <= size.height; y += edge)
        for (int x = 0; x + edge <= size.width; x += edge) {
            SquareSums whole;
            int parts = 0;
            for (const auto& [u, v] : {std::pair{0, 0}, {part, 0}, {0, part}, {part, part}}) {
                const auto sums = sums_at(x + u, y + v);
                if (!sums) break;
                ++parts;
                for (const double sum : sums->sums) even += sum * sum / (part * part);
                whole.add(*sums);
            }
            if (parts < 4) continue;
            all += whole.squares;
            ++squares;
            double most = 0;
            for (const double sum : whole.sums) most = std::max(most, std::abs(sum));
            unlike += most > near * edge * edge ? 1 : 0;
        }
    return squares >= enough && unlike * 1000 <= few * squares &&
           (even * part * part <= most_even * all || shows_blocks(e, j));
}

/// Decides which explanations are believed. The first of `all` assumes that nothing is wrong.
void believe(std::vector<Judged>& all, const Exhibit& exhibit, const Drawing& right) {
    constexpr double rounding = 0.3;  // levels, RMS
    constexpr double most_wrong = 0.9;
    const bool tells_little = has_few_colours(exhibit);
    const Judged& none = all.front();
    // In a lossy picture, a mistake may fit the compression error by chance: require a tiny residual. In a
    // noisy picture, require that it explains nearly all wrong pixels.
    const bool is_lossy = !none.score.fits() && means_fit(exhibit, none, 0);
    for (Judged& j : all) {
        const bool is_of_right = j.explanation.kind == ExplanationKind::Right;
        j.is_right = is_of_right || look_alike(exhibit, j.drawing, right);
        j.is_lossy =
            !j.score.fits() && means_fit(exhibit, j, 20) && (is_of_right || shows_blocks(exhibit, j));
        const bool fits = j.score.fits() || j.is_lossy;
        j.is_almost = !fits && (is_of_right ? is_nearly_right(j)
                                            : fits_almost(j, none) && stands_alone(j, all, exhibit));
        const bool may_be =
            (fits || j.is_almost) && !encodes_and_decodes(j) && !kept_its_brightness(exhibit, j.change);
        const bool is_overdone = tells_little && j.change.gain != 1 && j.change.count() > 1;
        const bool is_better = j.cost < none.cost && j.score.comes_nearer() && !is_overdone &&
                               (!is_lossy || j.score.residual() < rounding) &&
                               (j.change.noise == 0 || j.score.share_explained() > most_wrong);
        // The last two conditions read all pixels again.
        j.is_believed = may_be && (j.is_right || (is_better && !undoes_itself(exhibit, j, none))) &&
                        !(way_turned(j.change) != 0 && covers_background(exhibit, j.change));
    }
}

/// Returns the given flips, and those whose silhouettes match as well as the unflipped picture's.
std::array<bool, 4> with_hidden_turns(std::array<bool, 4> turns, const Exhibit& exhibit) {
    constexpr double nearly = 0.002;
    const std::optional<OutlineMisfit> as_it_is = outline_misfit(exhibit, {});
    if (!as_it_is) return turns;
    for (const DisplayChange& way : ways_of_turning())
        if (outline_misfit(exhibit, way)->most() <= as_it_is->most() + nearly) turns[way_turned(way)] = true;
    return turns;
}

/// Also considers flips of the correct picture that leave its silhouettes the same. An explanation without a
/// flip is preferred.
void consider_hidden_flips(std::vector<Judged>& all, const Exhibit& exhibit,
                           const std::array<bool, 4>& tried) {
    if (all.front().is_believed && all.front().is_right) return;
    constexpr std::array names{"", "mirrored", "upside down", "turned by 180 degrees"};
    for (DisplayChange change : ways_of_turning()) {
        const std::size_t way = way_turned(change);
        if (tried[way]) continue;
        change.noise = exhibit.least_change.noise;
        Judged turned;
        turned.drawing.picture = exhibit.right;
        judge(turned, exhibit, change, 1);
        if (!turned.score.fits() || covers_background(exhibit, change)) continue;
        turned.explanation.name = fmt::format("the right picture, {}", names[way]);
        if (all.front().is_believed) {
            all.front().same.push_back(turned.explanation);
        } else {
            turned.is_right = turned.is_believed = true;
            all.insert(all.begin(), turned);
        }
        return;
    }
}

/// Searches for explanations under these flips.
std::vector<Judged> judged_with(const std::array<bool, 4>& turns, Renderer& renderer, const Scene& scene,
                                const Exhibit& exhibit, const DiagnosisOptions& options) {
    constexpr std::size_t judged_whole = 8;
    constexpr int coarse_rows = 100, most_step = 8;
    const PictureSize size = exhibit.right.size;
    const Scene right = under_mistakes(scene, {});
    Drawings drawn(renderer, right, size);
    std::size_t tried = 0;
    const auto search_progress = [&](std::size_t done, std::size_t of) {
        tried = of;
        options.progress(done, of + drawings);
    };
    const SearchJob job{exhibit.wrong,
                        exhibit.right,
                        exhibit.kinds,
                        exhibit.least_change.noise,
                        turns,
                        options.pairs,
                        options.conventions,
                        drawings,
                        options.progress ? DiagnosisProgress(search_progress) : DiagnosisProgress()};
    const std::vector<Hypothesis> likely = likely_hypotheses(drawn, job);
    const int step = std::clamp(size.height / coarse_rows, 1, most_step);
    std::vector<Judged> all;
    BareMasks masks;  // the first hypothesis is that nothing is wrong
    for (std::size_t i = 0; i < likely.size(); ++i) {
        if (options.progress) options.progress(tried + i, tried + drawings);
        all.push_back(judged(drawn, masks, exhibit, likely[i], step));
    }
    // Only the likeliest explanations are judged on the whole picture; the hypothesis that there is no
    // mistake, which comes first, always is.
    std::stable_sort(all.begin() + 1, all.end(),
                     [](const Judged& a, const Judged& b) { return a.cost < b.cost; });
    all.resize(std::min(all.size(), judged_whole));
    const Drawing of_right{exhibit.right, {}};
    for (Judged& j : all) judge_whole(j, exhibit);
    // The entire picture may contradict a change that was chosen from only a few rows.
    const DisplayChange of_few_rows = all.front().change;
    judge_also(all.front(), exhibit, exhibit.least_change, 1);
    for (Judged& j : all) {
        if (j.explanation.kind != ExplanationKind::Right) continue;
        judge_by_power(j, exhibit, exhibit.least_change);
        if (!(of_few_rows == exhibit.least_change)) judge_by_power(j, exhibit, of_few_rows);
    }
    believe(all, exhibit, of_right);
    std::stable_sort(all.begin(), all.end(), [](const Judged& a, const Judged& b) {
        if (a.is_believed != b.is_believed) return a.is_believed;
        return a.cost != b.cost ? a.cost < b.cost : a.score.squares < b.score.squares;
    });
    consider_hidden_flips(all, exhibit, turns);
    return all;
}

}  // namespace

std::vector<Judged> judge_all(Renderer& renderer, const Scene& scene, const Exhibit& exhibit,
                              const DiagnosisOptions& options) {
    const std::array<bool, 4> turns = likely_turns(exhibit);
    std::vector<Judged> all = judged_with(turns, renderer, scene, exhibit, options);
    if (all.front().is_believed) return all;
    const std::array<bool, 4> hidden = with_hidden_turns(turns, exhibit);
    if (hidden == turns) return all;
    std::vector<Judged> flipped = judged_with(hidden, renderer, scene, exhibit, options);
    return flipped.front().is_believed ? flipped : all;
}

}  // namespace glint
