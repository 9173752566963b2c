#include "renderer/diagnose/diagnose.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "models/memory_limit.h"
#include "renderer/diagnose/difference.h"
#include "renderer/diagnose/display_finding.h"
#include "renderer/diagnose/experiment.h"
#include "renderer/diagnose/other_aspect.h"
#include "renderer/lighting/display.h"

namespace glint {
namespace {

constexpr std::uint64_t drawings_bytes = std::uint64_t{256} << 20;
constexpr std::uint64_t fewest_compared = 16;

/// The size of about so many pixels to search at; odd divisors keep the centres of pixels.
PictureSize search_size(PictureSize size, std::size_t pixels) {
    int divisor = 1;
    while (size.pixels() / static_cast<std::size_t>(divisor * divisor) > pixels) divisor += 2;
    return {std::max(1, size.width / divisor), std::max(1, size.height / divisor)};
}

/// An explanation judged on the whole picture.
struct Judged {
    MistakeSet mistakes;
    DisplayChange change;
    Score score;
    double cost = 0;
    Drawing drawing;
};

constexpr double noise = 50;  // in excess_of() over a whole picture

void judge(Judged& j, const Exhibit& exhibit, const DisplayChange& change, int step) {
    j.change = change;
    j.score = score(exhibit, j.drawing, change, step);
    j.cost = explanation_cost(j.score.excess, noise / step, j.mistakes.size(), change);
}

/// The best of the changes that the hypothesis allows, judged by every so many rows.
Judged judged(Renderer& renderer, const Scene& scene, const Exhibit& exhibit, const Hypothesis& hypothesis,
              int step) {
    const PictureSize size = exhibit.right.size;
    Judged best;
    best.mistakes = hypothesis.mistakes;
    best.drawing.picture = renderer.render(under_mistakes(scene, hypothesis.mistakes), size);
    best.drawing.bare = bare_mask(renderer, size);
    judge(best, exhibit, hypothesis.changes.front(), step);
    for (std::size_t i = 1; i < hypothesis.changes.size(); ++i) {
        const double before = best.cost;
        const DisplayChange kept = best.change;
        judge(best, exhibit, hypothesis.changes[i], step);
        if (best.cost < before) continue;
        best.cost = before;
        best.change = kept;
    }
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

Candidate candidate_of(const Exhibit& exhibit, const Judged& j) {
    Candidate c;
    c.mistakes = j.mistakes;
    c.change = j.change;
    c.residual = j.score.residual();
    c.explained = j.score.share_explained();
    c.fits = j.score.fits();
    c.pixel = j.score.pixel;
    const ByteRanges ranges = byte_ranges(j.change);
    const std::size_t pixel = exhibit.right.pixel(c.pixel.x, c.pixel.y);
    c.mine = mine_at(exhibit.wrong, j.change, c.pixel.x, c.pixel.y);
    c.reference = shown(ranges, rgb_at(exhibit.right, pixel));
    c.as_mistaken = shown(ranges, rgb_at(j.drawing.picture, pixel));
    return c;
}

/// The best few mistakes, each with those that look like it. The right picture's look-alikes are none.
std::vector<Candidate> candidates_of(const Exhibit& exhibit, const std::vector<Judged>& all) {
    constexpr std::size_t most = 3;
    const Drawing right{exhibit.right, {}};
    std::vector<Candidate> candidates;
    std::vector<const Judged*> shown;
    for (const Judged& j : all) {
        if (j.mistakes.empty() || look_alike(exhibit, j.drawing, right)) continue;
        const auto like = std::find_if(shown.begin(), shown.end(), [&](const Judged* s) {
            return look_alike(exhibit, s->drawing, j.drawing);
        });
        if (like != shown.end()) {
            Candidate& first = candidates[static_cast<std::size_t>(like - shown.begin())];
            if (first.mistakes.size() == j.mistakes.size()) first.also.push_back(j.mistakes);
        } else if (candidates.size() < most) {
            candidates.push_back(candidate_of(exhibit, j));
            shown.push_back(&j);
        }
    }
    return candidates;
}

std::vector<Judged> judge_all(Renderer& renderer, const Scene& scene, const Exhibit& exhibit,
                              const DiagnosisOptions& options) {
    constexpr std::size_t singles_pixels = 400'000, pairs_pixels = 24'000, most = 16, fewest = 3;
    constexpr std::size_t judged_whole = 8;
    constexpr int coarse_rows = 100, most_step = 8;
    const PictureSize size = exhibit.right.size;
    const PictureSize at = search_size(size, options.pairs ? pairs_pixels : singles_pixels);
    const std::vector<Hypothesis> likely =
        likely_hypotheses(scene, exhibit.wrong, at, options.pairs, options.threads, options.progress);
    const std::size_t count = std::clamp<std::size_t>(drawings_bytes / (4 * size.pixels()), fewest, most);
    const int step = std::clamp(size.height / coarse_rows, 1, most_step);
    std::vector<Judged> all;
    for (std::size_t i = 0; i < std::min(count, likely.size()); ++i)
        all.push_back(judged(renderer, scene, exhibit, likely[i], step));
    // All but the likeliest are hopeless; no mistake at all is judged with them.
    std::stable_sort(all.begin() + 1, all.end(),
                     [](const Judged& a, const Judged& b) { return a.cost < b.cost; });
    all.resize(std::min(all.size(), judged_whole));
    for (Judged& j : all) judge(j, exhibit, j.change, 1);
    std::stable_sort(all.begin(), all.end(), [](const Judged& a, const Judged& b) {
        return a.score.fits() != b.score.fits() ? a.score.fits() : a.cost < b.cost;
    });
    return all;
}

/// The sets that an experiment is to tell apart: the first candidate and those like it, or else the next.
std::vector<MistakeSet> to_tell_apart(const std::vector<Candidate>& candidates) {
    constexpr std::size_t most = 4;
    std::vector<MistakeSet> sets;
    if (candidates.empty()) return sets;
    sets.push_back(candidates[0].mistakes);
    sets.insert(sets.end(), candidates[0].also.begin(), candidates[0].also.end());
    if (sets.size() == 1 && candidates.size() > 1) sets.push_back(candidates[1].mistakes);
    if (sets.size() > most) sets.resize(most);
    return sets;
}

/// What may have happened at the display of a picture that nothing explains, the least first.
std::vector<DisplayChange> cautious_changes(const Exhibit& exhibit, const Judged& none) {
    constexpr std::uint64_t clearly = 4;  // a gain or a curve takes away something of any difference
    DisplayChange turned = none.change;
    turned.before = turned.after = Code::Same;
    turned.gain = 1;
    turned.soft = false;
    std::vector<DisplayChange> changes{DisplayChange{}};
    std::uint64_t least = score(exhibit, none.drawing, changes.front()).unlike;
    for (const DisplayChange& change : {turned, none.change}) {
        const std::uint64_t unlike = score(exhibit, none.drawing, change).unlike;
        if (clearly * unlike > least) continue;
        least = unlike;
        changes.push_back(change);
    }
    return changes;
}

/// Why the picture cannot be of this scene, if it cannot.
std::optional<std::string> why_not_comparable(Renderer& renderer, const Scene& scene,
                                              const Exhibit& exhibit) {
    if (const auto aspect = other_aspect(renderer, scene, exhibit.wrong))
        return "the picture shows the scene as it is at the aspect " + *aspect + ", stretched";
    return other_outline(exhibit);
}

void say_what_is_unexplained(Diagnosis& d, Renderer& renderer, const Scene& scene, const Exhibit& exhibit,
                             const Judged& none) {
    if (const auto why = why_not_comparable(renderer, scene, exhibit)) {
        d = Diagnosis{};
        d.size = exhibit.wrong.size;
        d.why = *why;
        return;
    }
    d.verdict = Verdict::NotInCatalogue;
    constexpr double much = 0.5;  // the nearest are told where they explain this share
    std::erase_if(d.candidates, [](const Candidate& c) { return c.explained < much; });
    constexpr double nearly_all = 0.9;
    (void)renderer.render(under_mistakes(scene, {}), d.size);
    for (const DisplayChange& change : cautious_changes(exhibit, none)) {
        d.display = display_finding(exhibit, none.drawing.picture, change);
        describe_difference(d, renderer, exhibit, change, scene.display);
        if (!d.terms.empty() && d.terms.front().explained > nearly_all) break;
    }
}

void conclude(Diagnosis& d, Renderer& renderer, const SceneDocument& document, const Exhibit& exhibit,
              const std::vector<Judged>& all, int threads) {
    const Judged& best = all.front();
    const Judged& none =
        *std::find_if(all.begin(), all.end(), [](const Judged& j) { return j.mistakes.empty(); });
    d.unlike = static_cast<double>(none.score.unlike) / static_cast<double>(none.score.compared);
    d.display = display_finding(exhibit, best.drawing.picture, best.change);
    if (best.score.fits() && best.mistakes.empty()) {
        d.verdict = Verdict::NoMistake;
        return;
    }
    d.candidates = candidates_of(exhibit, all);
    if (!best.score.fits()) return say_what_is_unexplained(d, renderer, document.scene, exhibit, none);
    d.verdict = Verdict::Mistake;
    d.experiment = find_experiment(document, d.size, to_tell_apart(d.candidates), threads);
}

Diagnosis diagnosis_of(const SceneDocument& document, const Picture& wrong, const DiagnosisOptions& options) {
    Diagnosis d;
    d.size = wrong.size;
    const MemoryShare share(memory_need(
        MemoryUse::Pixels,
        std::min<std::uint64_t>(drawings_bytes + 3 * picture_memory(d.size), 19 * picture_memory(d.size))));
    Renderer renderer(options.threads);
    const Picture right = renderer.render(under_mistakes(document.scene, {}), d.size);
    const std::vector<PixelKind> kinds = pixel_kinds(renderer, d.size);
    const auto compared = std::count(kinds.begin(), kinds.end(), PixelKind::Surface);
    if (static_cast<std::uint64_t>(compared) < fewest_compared) {
        d.why = "the scene shows no surface of some size in a picture of this size";
        return d;
    }
    const Exhibit exhibit(wrong, right, kinds);
    conclude(d, renderer, document, exhibit, judge_all(renderer, document.scene, exhibit, options),
             options.threads);
    return d;
}

}  // namespace

Diagnosis diagnose(const SceneDocument& document, const Picture& wrong, const DiagnosisOptions& options) {
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    Diagnosis found;
    arena.execute([&] { found = diagnosis_of(document, wrong, options); });
    return found;
}

Picture as_shown(Picture picture, const Display& display) {
    if (!picture.rgba.empty()) return picture;
    const DisplayJob job{1, display.transfer == Transfer::Srgb};
    picture.rgba.assign(4 * picture.size.pixels(), 255);
    for (std::size_t i = 0; i < picture.linear.size(); ++i)
        picture.rgba[i / 3 * 4 + i % 3] =
            static_cast<std::uint8_t>(byte_of(displayed(job, picture.linear[i])));
    picture.linear.clear();
    return picture;
}

}  // namespace glint
