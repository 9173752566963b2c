#include "diagnose/judged.h"

#include <algorithm>
#include <cstdlib>

#include "diagnose/display_finding.h"
#include "diagnose/search/softness.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

constexpr std::uint64_t drawings_bytes = std::uint64_t{256} << 20;
constexpr std::size_t fewest_drawings = 3, most_drawings = 16;

/// Returns the size at which to search, of about `pixels` pixels. An odd divisor that divides both sides
/// without remainder keeps the centres of pixels, and with them a pattern of faces. Such a divisor is
/// preferred if it gives at most `room` times and at least one `room`-th of that many pixels.
PictureSize search_size(PictureSize size, std::size_t pixels, std::size_t room) {
    const auto pixels_at = [size](int divisor) {
        return size.pixels() / static_cast<std::size_t>(divisor * divisor);
    };
    const auto divides = [size](int divisor) {
        return size.width % divisor == 0 && size.height % divisor == 0;
    };
    int divisor = 1;
    while (pixels_at(divisor) > pixels) divisor += 2;
    int exact = divisor;
    while (exact > 1 && !divides(exact) && pixels_at(exact - 2) <= room * pixels) exact -= 2;
    if (!divides(exact))
        for (exact = divisor; !divides(exact) && room * pixels_at(exact + 2) >= pixels;) exact += 2;
    if (divides(exact)) divisor = exact;
    return {std::max(1, size.width / divisor), std::max(1, size.height / divisor)};
}

std::size_t drawings_of(PictureSize size) {
    return std::clamp<std::size_t>(drawings_bytes / (4 * size.pixels()), fewest_drawings, most_drawings);
}

constexpr double free_in_picture = 50;  // in excess_of() over a whole picture

void judge(Judged& j, const Exhibit& exhibit, const DisplayChange& change, int step) {
    j.change = change;
    j.score = score(exhibit, j.drawing, change, step);
    j.cost = explanation_cost(j.score.excess, free_in_picture / step, j.mistakes.size(), change) +
             (has_other_background(exhibit, j.drawing, change) ? 1 : 0);
}

/// Judges under another change, too, and keeps the cheaper one; at equal cost, the one with less error beyond
/// rounding. Also keeps the new change if it costs less than `for_much_nearer` more and has less than half
/// the RMS error.
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

/// Judges on every row. A soft change is judged as a hard one if that leaves no excess, or if the picture
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

/// The best of the changes that the hypothesis allows, judged by every so many rows.
Judged judged(Renderer& renderer, BareMasks& masks, const Scene& scene, const Exhibit& exhibit,
              const Hypothesis& hypothesis, int step) {
    const PictureSize size = exhibit.right.size;
    Judged best;
    best.mistakes = hypothesis.mistakes;
    best.drawing.picture = renderer.render(under_mistakes(scene, hypothesis.mistakes), size);
    best.drawing.bare = masks.of(renderer, size);
    judge(best, exhibit, hypothesis.changes.front(), step);
    for (std::size_t i = 1; i < hypothesis.changes.size(); ++i)
        judge_also(best, exhibit, hypothesis.changes[i], step);
    return best;
}

/// Whether two drawings are the same within one level wherever they can be compared.
bool look_alike(const Exhibit& exhibit, const Drawing& a, const Drawing& b) {
    for (std::size_t i = 0; i < exhibit.kinds.size(); ++i) {
        if (exhibit.kinds[i] != PixelKind::Surface) continue;
        for (std::size_t c = 4 * i; c < 4 * i + 3; ++c)
            if (std::abs(int{a.picture.rgba[c]} - int{b.picture.rgba[c]}) > 1) return false;
    }
    return true;
}

/// Also judges the right picture as encoded by a power (Code::Power): most programs that do not encode as
/// sRGB do that. It is tried only without a mistake. `change`: what else happened at the display.
void judge_by_power(Judged& none, const Exhibit& exhibit, DisplayChange change) {
    change.after = Code::Power;
    change.gain = 1;
    change.soft = false;
    for (const Code before : {Code::Same, Code::Decoded}) {
        change.before = before;
        judge_also(none, exhibit, change, 1, 1);
    }
}

/// Whether it supposes that colours were encoded twice, and decoded again.
bool encodes_and_decodes(const Judged& j) {
    const auto encodes = [](std::size_t m) { return mistake_names()[m].flag == &Mistakes::encoded_twice; };
    return j.change.encodings() < 0 && std::any_of(j.mistakes.begin(), j.mistakes.end(), encodes);
}

/// Whether two changes encode otherwise, or brighten by clearly other gains.
bool shows_otherwise(const DisplayChange& a, const DisplayChange& b) {
    constexpr float clearly = 1.1f;
    return a.before != b.before || a.after != b.after || a.gain > clearly * b.gain ||
           b.gain > clearly * a.gain;
}

/// Whether an explanation supposes more than the one without a mistake, and shows the same: for example a
/// gain of pi together with a mistake that divides by pi. If its encoding or gain differs from that one's,
/// one pixel in a hundred may be unlike.
bool undoes_itself(const Exhibit& exhibit, const Judged& j, const Judged& none) {
    constexpr std::uint64_t few = 100;  // one pixel of so many
    if (encodes_and_decodes(j)) return true;
    if (j.change.count() + static_cast<int>(j.mistakes.size()) <= none.change.count()) return false;
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

/// Whether the picture contradicts the supposed change of brightness: most pixels that the change would alter
/// clearly are as in the right picture. A mistake that brightens may hide a gain that does not exist, and the
/// other way round.
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

/// Whether the surfaces of the right picture show at most four colours, each within 8 levels, such as plates
/// of one colour each. Then a mistake with a gain and another change at the display can turn them into any
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

/// Returns the explanations that are worth drawing at full size, at most `count`. Pairs of mistakes are
/// searched in a smaller picture, where another gain may fit. So explanations that need no pair come from the
/// search without pairs.
std::vector<Hypothesis> worth_drawing(const Scene& scene, const Exhibit& exhibit,
                                      const DiagnosisOptions& options, std::size_t count,
                                      const DiagnosisProgress& progress) {
    constexpr std::size_t singles_pixels = 400'000, pairs_pixels = 24'000;
    const auto likely = [&](bool pairs, std::size_t of_these, const DiagnosisProgress& told) {
        const PictureSize at = pairs ? search_size(exhibit.right.size, pairs_pixels, 3)
                                     : search_size(exhibit.right.size, singles_pixels, 1);
        return likely_hypotheses(scene, exhibit.wrong, exhibit.least_change.noise, at, pairs, of_these,
                                 options.threads, told);
    };
    if (!options.pairs) return likely(false, count, progress);
    std::vector<Hypothesis> found = likely(false, std::max<std::size_t>(2, count / 4), {});
    for (Hypothesis& h : likely(true, count, progress)) {
        const auto is_same = [&h](const Hypothesis& other) { return other.mistakes == h.mistakes; };
        if (found.size() < count && std::none_of(found.begin(), found.end(), is_same))
            found.push_back(std::move(h));
    }
    return found;
}

Candidate candidate_of(const Exhibit& exhibit, const Judged& j) {
    Candidate c;
    c.mistakes = j.mistakes;
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
    return *std::find_if(all.begin(), all.end(), [](const Judged& j) { return j.mistakes.empty(); });
}

std::vector<Candidate> candidates_of(const Exhibit& exhibit, const std::vector<Judged>& all,
                                     const DisplayChange& told) {
    constexpr std::size_t most = 3;
    std::vector<Candidate> candidates;
    std::vector<const Judged*> shown;
    const Judged& none = of_no_mistake(all);
    for (const Judged& j : all) {
        if (j.is_right || undoes_itself(exhibit, j, none)) continue;
        const auto like = std::find_if(shown.begin(), shown.end(), [&](const Judged* s) {
            return look_alike(exhibit, s->drawing, j.drawing);
        });
        if (like != shown.end()) {
            Candidate& first = candidates[static_cast<std::size_t>(like - shown.begin())];
            if (first.mistakes.size() == j.mistakes.size()) first.also.push_back(j.mistakes);
        } else if (candidates.size() < most && are_of_one_display(j.change, told)) {
            candidates.push_back(candidate_of(exhibit, j));
            shown.push_back(&j);
        }
    }
    return candidates;
}

std::vector<Judged> judge_all(Renderer& renderer, const Scene& scene, const Exhibit& exhibit,
                              const DiagnosisOptions& options) {
    constexpr std::size_t judged_whole = 8;
    constexpr int coarse_rows = 100, most_step = 8;
    const PictureSize size = exhibit.right.size;
    const std::size_t drawings = drawings_of(size);
    std::size_t tried = 0;
    const auto search_progress = [&](std::size_t done, std::size_t of) {
        tried = of;
        options.progress(done, of + drawings);
    };
    const std::vector<Hypothesis> likely =
        worth_drawing(scene, exhibit, options, drawings,
                      options.progress ? DiagnosisProgress(search_progress) : DiagnosisProgress());
    const int step = std::clamp(size.height / coarse_rows, 1, most_step);
    std::vector<Judged> all;
    BareMasks masks;  // the first hypothesis is that of no mistake
    for (std::size_t i = 0; i < std::min(drawings, likely.size()); ++i) {
        if (options.progress) options.progress(tried + i, tried + drawings);
        all.push_back(judged(renderer, masks, scene, exhibit, likely[i], step));
    }
    // Only the likeliest are judged on the whole picture; the hypothesis of no mistake, which comes first,
    // always is.
    std::stable_sort(all.begin() + 1, all.end(),
                     [](const Judged& a, const Judged& b) { return a.cost < b.cost; });
    all.resize(std::min(all.size(), judged_whole));
    const Drawing right{exhibit.right, {}};
    for (Judged& j : all) judge_whole(j, exhibit);
    // The whole picture may speak against a change that few rows chose.
    const DisplayChange of_few_rows = all.front().change;
    judge_also(all.front(), exhibit, exhibit.least_change, 1);
    judge_by_power(all.front(), exhibit, exhibit.least_change);
    if (!(of_few_rows == exhibit.least_change)) judge_by_power(all.front(), exhibit, of_few_rows);
    const bool tells_little = has_few_colours(exhibit);
    for (Judged& j : all) {
        j.is_right = j.mistakes.empty() || look_alike(exhibit, j.drawing, right);
        const bool may_be =
            j.score.fits() && !encodes_and_decodes(j) && !kept_its_brightness(exhibit, j.change);
        const bool is_overdone = tells_little && j.change.gain != 1 && j.change.count() > 1;
        const bool is_better = j.cost < all.front().cost && j.score.comes_nearer() && !is_overdone;
        // The last two look at all pixels again.
        j.is_believed = may_be && (j.is_right || (is_better && !undoes_itself(exhibit, j, all.front()))) &&
                        !(way_turned(j.change) != 0 && covers_background(exhibit, j.change));
    }
    std::stable_sort(all.begin(), all.end(), [](const Judged& a, const Judged& b) {
        if (a.is_believed != b.is_believed) return a.is_believed;
        return a.cost != b.cost ? a.cost < b.cost : a.score.squares < b.score.squares;
    });
    return all;
}

}  // namespace glint
