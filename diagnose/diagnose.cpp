#include "diagnose/diagnose.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "diagnose/difference.h"
#include "diagnose/display_finding.h"
#include "diagnose/experiment.h"
#include "diagnose/search/noise.h"
#include "diagnose/unexplained.h"
#include "renderer/lighting/display.h"
#include "renderer/threads.h"

namespace glint {
namespace {

constexpr std::uint64_t fewest_compared = 16;
/// Levels. Stronger noise of light is clipped and encoded, which moves its mean: mistakes were named in right
/// pictures from 17 on.
constexpr float most_noise = 12;

/// The sets of mistakes that an experiment is to tell apart: the first candidate and those that look like it,
/// or else the second candidate.
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

/// Whether an explanation leaves no more error than rounding does. A soft one is never exact: the range
/// between a pixel's neighbours has room for noise, too.
bool is_exact(const Judged& best) {
    constexpr double rounding = 0.3;  // levels
    return best.is_believed && !best.change.soft && best.score.residual() < rounding;
}

/// The term of the equation that, multiplied by a number, explains nearly all that is wrong where an
/// explanation differs from the right picture; nothing where none does.
std::optional<DifferenceTerm> term_that_explains(Renderer& renderer, const Scene& scene,
                                                 const Exhibit& exhibit, const Judged& explained) {
    constexpr double nearly_all = 0.98, hardly_any = 0.02;  // of the difference's energy; of the wrong pixels
    (void)renderer.render(under_mistakes(scene, {}), exhibit.right.size);
    const DescribedDifference found =
        describe_difference(renderer, exhibit, exhibit.least_change, scene.display,
                            explained.is_right ? nullptr : &explained.drawing.picture);
    if (found.terms.empty() || found.terms.front().explained <= nearly_all ||
        found.pixels_left > hardly_any * static_cast<double>(found.pixels))
        return std::nullopt;
    return found.terms.front();
}

bool is_left_out(const std::optional<DifferenceTerm>& term) {
    constexpr double rounding = 0.01;
    return term && std::abs(term->factor) < rounding;
}

void conclude(Diagnosis& d, Renderer& renderer, const SceneDocument& document, const Exhibit& exhibit,
              const std::vector<Judged>& all, int threads) {
    const Judged& best = all.front();
    const Judged& none = of_no_mistake(all);
    d.display = display_finding(exhibit, best.drawing, best.change);
    constexpr double rounded_twice = 0.6;  // levels; rounding in two programs leaves less
    // A single term is the simpler explanation: simpler than a mistake with a change at the display, or two
    // such changes where the picture is right, or a mistake that leaves more error than rounding does.
    const bool supposes_more = best.change.count() > (best.is_right ? 1 : 0) ||
                               (!best.is_right && best.score.residual() > rounded_twice);
    std::optional<DifferenceTerm> term;
    if (best.is_believed && (supposes_more || !best.is_right))
        term = term_that_explains(renderer, document.scene, exhibit, best);
    const bool is_believed = best.is_believed && !(supposes_more && term);
    const Judged& shown = is_believed ? best : none;
    d.pixels = count_unlike(exhibit, shown.drawing, shown.change);
    if (is_believed && best.is_right) {
        d.verdict = Verdict::NoMistake;
        return;
    }
    d.candidates = candidates_of(exhibit, all, shown.change);
    // The candidates that are not believed are sorted by the share that they explain; below 1 % they are
    // dropped.
    constexpr double hardly_any = 0.01;
    const auto others = d.candidates.begin() + (is_believed ? 1 : 0);
    std::stable_sort(others, d.candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.explained > b.explained; });
    d.candidates.erase(
        std::find_if(others, d.candidates.end(), [](const Candidate& c) { return c.explained < hardly_any; }),
        d.candidates.end());
    if (!is_believed) return say_what_is_unexplained(d, renderer, document.scene, exhibit, none);
    d.verdict = Verdict::Mistake;
    if (is_left_out(term)) d.left_out = term;
    d.experiment = find_experiment(document, d.size, to_tell_apart(d.candidates), threads);
}

/// Levels between the darkest and the brightest pixel, of the channel in which they are farthest apart.
int spread_of(const Picture& picture) {
    std::array<std::uint8_t, 3> low{255, 255, 255}, high{};
    for (std::size_t i = 0; i < picture.size.pixels(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], picture.rgba[4 * i + c]);
            high[c] = std::max(high[c], picture.rgba[4 * i + c]);
        }
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

/// Whether the picture has a single colour, within rounding and `room` levels, although the right picture has
/// clearly more than one. A program that draws nothing gives such a picture, and so do many mistakes.
bool is_of_one_colour(const Picture& wrong, const Picture& right, float room) {
    constexpr float rounding = 1, clearly = 8;
    return static_cast<float>(spread_of(wrong)) <= rounding + room &&
           static_cast<float>(spread_of(right)) > clearly;
}

/// Returns the mean colours of the picture's squares of 8 x 8 pixels. The means hold hardly any of the noise
/// of single pixels.
Picture means_of_squares(const Picture& picture) {
    constexpr int edge = 8;
    Picture means{{picture.size.width / edge, picture.size.height / edge}, {}, {}};
    means.rgba.resize(4 * means.size.pixels());
    for (int y = 0; y < means.size.height; ++y)
        for (int x = 0; x < means.size.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                int sum = edge * edge / 2;
                for (int i = 0; i < edge * edge; ++i)
                    sum += picture.rgba[4 * picture.pixel(edge * x + i % edge, edge * y + i / edge) + c];
                means.rgba[4 * means.pixel(x, y) + c] = static_cast<std::uint8_t>(sum / (edge * edge));
            }
    return means;
}

Diagnosis diagnosis_of(const SceneDocument& document, const Picture& wrong, const DiagnosisOptions& options) {
    Diagnosis d;
    d.size = wrong.size;
    d.of_pairs = options.pairs;
    Renderer renderer(options.threads);
    const Picture right = renderer.render(under_mistakes(document.scene, {}), d.size);
    const std::vector<PixelKind> kinds = pixel_kinds(renderer, d.size);
    const auto compared = std::count(kinds.begin(), kinds.end(), PixelKind::Surface);
    if (static_cast<std::uint64_t>(compared) < fewest_compared) {
        d.why = "the scene's surfaces cover too few pixels of a picture of this size";
        return d;
    }
    if (is_of_one_colour(wrong, right, 0)) {
        d.why = fmt::format("it has a single colour, ({}, {}, {}): nothing was drawn, or nothing was lit",
                            wrong.rgba[0], wrong.rgba[1], wrong.rgba[2]);
        return d;
    }
    const Exhibit clean(wrong, right, kinds);
    std::vector<Judged> all = judge_all(renderer, document.scene, clean, options);
    const float noise = is_exact(all.front()) ? 0 : noise_of(wrong, right);
    if (noise == 0) {
        conclude(d, renderer, document, clean, all, options.threads);
        return d;
    }
    if (noise > most_noise) {
        d.why = fmt::format(
            "noise of about {:.0f} levels hides what mistakes would change; {:.0f} at most can be judged",
            noise, most_noise);
        return d;
    }
    if (is_of_one_colour(means_of_squares(wrong), right, 1.5f * noise)) {
        d.why = fmt::format("it has a single colour but for noise of about {:.0f} levels", noise);
        return d;
    }
    all.clear();  // its drawings are large
    const Exhibit noisy(wrong, right, kinds, noise);
    conclude(d, renderer, document, noisy, judge_all(renderer, document.scene, noisy, options),
             options.threads);
    return d;
}

}  // namespace

Diagnosis diagnose(const SceneDocument& document, const Picture& wrong, const DiagnosisOptions& options) {
    tbb::task_arena arena(arena_threads(options.threads));
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
