#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "diagnose/judged.h"

namespace glint {
namespace {

/// Picture minus correct picture, in levels.
using Difference = std::array<double, 3>;

struct WrongPixel {
    glm::ivec2 at{0};
    Difference difference{};
};

/// Returns the pixels that differ visibly, and fills in the region of each object and all compared pixels.
std::vector<WrongPixel> wrong_pixels(const Exhibit& e, const Renderer& renderer, const DisplayChange& change,
                                     std::map<int, DifferenceRegion>& regions, std::vector<WrongPixel>& all) {
    const ByteRanges ranges = byte_ranges(change);
    std::vector<WrongPixel> wrong;
    std::map<int, std::size_t> compared;
    const PictureSize size = e.right.size;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (e.kinds[size.index(x, y)] != PixelKind::Surface) continue;
            const int object = renderer.object_at(x, y);
            ++compared[object];
            const Rgb right = rgb_at(e.right, size.index(x, y)), mine = mine_at(e.wrong, change, x, y);
            WrongPixel pixel{{x, y}, {}};
            float most = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                most = std::max(most, ranges[right[c]].distance(mine[c]));
                pixel.difference[c] = double(mine[c]) - double(ranges[right[c]].middle);
            }
            all.push_back(pixel);
            if (most <= visible_levels) continue;
            wrong.push_back(pixel);
            DifferenceRegion& region = regions[object];
            const bool first = region.pixels++ == 0;
            region.object = object;
            region.low = first ? pixel.at : glm::min(region.low, pixel.at);
            region.high = first ? pixel.at : glm::max(region.high, pixel.at);
            for (std::size_t c = 0; c < 3; ++c) region.mean[c] += std::abs(pixel.difference[c]);
        }
    for (auto& [object, region] : regions) {
        const auto pixels = static_cast<double>(region.pixels);
        region.share = pixels / static_cast<double>(compared[object]);
        for (double& mean : region.mean) mean /= pixels;
    }
    return wrong;
}

/// The terms of the sum at one pixel, in linear light, multiplied by the exposure.
using TermValues = std::map<std::pair<std::string, int>, glm::dvec3>;

void add_terms(TermValues& terms, const ExplainedPoint& at, double weight) {
    const bool are_many = at.lights.size() > 1;
    const auto add = [&](const char* name, int light, glm::vec3 value) {
        terms[{name, light}] += weight * glm::dvec3(value);
        if (light >= 0 && are_many) terms[{name, all_lights}] += weight * glm::dvec3(value);
    };
    add("emission", -1, at.emission);
    add("global_ambient", -1, at.global_ambient + at.bounces.term);
    for (const ExplainedLight& light : at.lights) {
        add("ambient", light.index, light.ambient);
        add("diffuse", light.index, light.diffuse);
        add("specular", light.index, light.specular);
        add("all", light.index, light.ambient + light.diffuse + light.specular);
    }
}

TermValues terms_at(const Renderer& renderer, glm::ivec2 pixel) {
    TermValues terms;
    const Explanation e = renderer.explain(pixel.x, pixel.y);
    if (!e.lit_per_corner) add_terms(terms, e.at, 1);
    for (const ExplainedCorner& corner : e.corners) add_terms(terms, corner.at, double(corner.weight));
    return terms;
}

/// One channel of a wrong pixel, in linear light. Terms add up there, so levels are converted back to it.
struct Sample {
    glm::ivec2 at{0};
    int channel = 0;
    double difference = 0;
};

/// The channels of a wrong pixel that are not clamped.
std::vector<Sample> samples_of(const WrongPixel& pixel, Rgb right, const Display& display) {
    constexpr double white = 254.5;
    const Code code = display.transfer == Transfer::Srgb ? Code::Decoded : Code::Same;
    const auto linear = [&](double level) {
        const double shown = double(coded(code, static_cast<float>(std::clamp(level / 255, 0.0, 1.0))));
        return shown / double(display.exposure);
    };
    std::vector<Sample> samples;
    for (int c = 0; c < 3; ++c) {
        const auto k = static_cast<std::size_t>(c);
        const double mine = double(right[k]) + pixel.difference[k];
        if (mine <= 0 || mine > white || double(right[k]) > white) continue;
        samples.push_back({pixel.at, c, linear(mine) - linear(double(right[k]))});
    }
    return samples;
}

/// Adds the samples of a few hundred pixels; the samples of one pixel are consecutive.
void add_samples(std::vector<Sample>& samples, const std::vector<WrongPixel>& pixels, const Picture& right,
                 const Display& display) {
    constexpr std::size_t count = 300;
    const std::size_t step = std::max<std::size_t>(1, pixels.size() / count);
    for (std::size_t i = step / 2; i < pixels.size(); i += step) {
        const glm::ivec2 at = pixels[i].at;
        for (const Sample& s : samples_of(pixels[i], rgb_at(right, right.pixel(at.x, at.y)), display))
            samples.push_back(s);
    }
}

/// Sums for a least-squares fit of a difference by one term.
struct Sums {
    double product = 0, square = 0, energy = 0;  // energy: the sum of the squared differences

    [[nodiscard]] double factor() const { return 1 + (square > 0 ? product / square : 0); }
    [[nodiscard]] double explained() const { return square > 0 ? product * product / square : 0; }
    Sums& operator+=(const Sums& other) {
        product += other.product;
        square += other.square;
        energy += other.energy;
        return *this;
    }
};
/// The sums for each object and channel.
using TermSums = std::map<int, std::array<Sums, 3>>;

/// The term with one factor for the entire picture, or else with a factor for each channel, or else with a
/// factor for the object that has most of the difference. Nothing if none of these explains nearly all of the
/// difference: a wrong hint would send the reader to the wrong line.
std::optional<DifferenceTerm> term_of(const std::pair<std::string, int>& name, const TermSums& sums) {
    constexpr double nearly_all = 0.95;
    DifferenceTerm term{name.first, name.second};
    const auto accept = [&](double explained, double energy) {
        term.explained = energy > 0 ? explained / energy : 0;
        return term.explained >= nearly_all;
    };
    Sums all;
    std::array<Sums, 3> channels{};
    std::pair<int, Sums> most{-1, {}};
    for (const auto& [object, of_object] : sums) {
        Sums one;
        for (std::size_t c = 0; c < 3; ++c) {
            channels[c] += of_object[c];
            one += of_object[c];
        }
        all += one;
        if (one.energy > most.second.energy) most = {object, one};
    }
    term.factor = all.factor();
    if (term.factor >= 0 && accept(all.explained(), all.energy)) return term;
    double explained = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        term.channels[c] = channels[c].factor();
        explained += channels[c].explained();
    }
    const bool is_negative = *std::min_element(term.channels.begin(), term.channels.end()) < 0;
    if (!is_negative && accept(explained, all.energy)) return term;
    term.channels = {};
    term.object = most.first;
    term.factor = most.second.factor();
    if (sums.size() > 1 && term.factor >= 0 && accept(most.second.explained(), most.second.energy))
        return term;
    return std::nullopt;
}

std::vector<DifferenceTerm> likely_terms(const std::map<std::pair<std::string, int>, TermSums>& fits) {
    constexpr std::size_t most = 3;
    std::vector<DifferenceTerm> terms;
    for (const auto& [name, sums] : fits)
        if (const auto term = term_of(name, sums)) terms.push_back(*term);
    // If one light's term explains as much as that of all lights, only the former is reported.
    constexpr double as_much = 0.005;
    const auto is_of_one = [all = terms](const DifferenceTerm& t) {
        return t.light == all_lights && std::any_of(all.begin(), all.end(), [&t](const DifferenceTerm& one) {
                   return one.term == t.term && one.light >= 0 && one.explained > t.explained - as_much;
               });
    };
    std::erase_if(terms, is_of_one);
    std::stable_sort(terms.begin(), terms.end(), [](const auto& a, const auto& b) {
        const auto is_partial = [](const DifferenceTerm& t) { return t.object >= 0; };
        return is_partial(a) != is_partial(b) ? is_partial(b) : a.explained > b.explained;
    });
    if (terms.size() > most) terms.resize(most);
    return terms;
}

}  // namespace

DescribedDifference describe_difference(const Renderer& renderer, const Exhibit& exhibit,
                                        const DisplayChange& change, const Display& display) {
    std::map<int, DifferenceRegion> regions;
    std::vector<WrongPixel> all;
    const std::vector<WrongPixel> wrong = wrong_pixels(exhibit, renderer, change, regions, all);
    DescribedDifference found;
    for (const auto& [object, region] : regions) found.regions.push_back(region);
    std::stable_sort(found.regions.begin(), found.regions.end(),
                     [](const auto& a, const auto& b) { return a.pixels > b.pixels; });
    std::map<std::pair<std::string, int>, TermSums> fits;
    std::vector<Sample> samples;
    add_samples(samples, wrong, exhibit.right, display);
    add_samples(samples, all, exhibit.right, display);  // a term may also be visible where nothing is wrong
    for (auto s = samples.begin(); s != samples.end();) {
        const TermValues terms = terms_at(renderer, s->at);
        const int object = renderer.object_at(s->at.x, s->at.y);
        for (const glm::ivec2 at = s->at; s != samples.end() && s->at == at; ++s)
            for (const auto& [name, value] : terms) {
                Sums& sums = fits[name][object][static_cast<std::size_t>(s->channel)];
                sums.product += s->difference * value[s->channel];
                sums.square += value[s->channel] * value[s->channel];
                sums.energy += s->difference * s->difference;
            }
    }
    found.terms = likely_terms(fits);
    const double left = found.terms.empty() ? 1 : 1 - found.terms.front().explained;
    found.pixels_left = left * static_cast<double>(wrong.size());
    return found;
}

namespace {

/// The background of a drawing; nothing if it shows none where the correct picture does.
std::optional<Rgb> background_in(const Exhibit& e, const Drawing& drawn) {
    for (std::size_t i = 0; i < e.kinds.size(); ++i)
        if (e.kinds[i] == PixelKind::Background && (drawn.bare.empty() || drawn.bare[i] != 0))
            return rgb_at(drawn.picture, i);
    return std::nullopt;
}

/// The wrong picture's background if it differs from the drawing's, both as drawn and after the change.
std::optional<Rgb> other_background(const Exhibit& e, const Drawing& drawn, const ByteRanges& ranges,
                                    const DisplayChange& change) {
    std::optional<Rgb> ground = e.grounds[way_turned(change)];
    if (!ground) return std::nullopt;  // saves a search for the drawing's background
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

/// Counts the pixels whose difference is explained only by softness.
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
    constexpr float least = 0.2f;  // in pixels; smoothing alone gives a smaller shift
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
    const bool black = ground && most_apart(*ground, Rgb{}) <= dark;  // a surface may also be black
    return {share(outside, background), black ? 0 : share(bare, surface)};
}

/// The largest share of the scene's background pixels that may show something, as pixels at outlines do.
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
        "it has a different aspect or camera, shows a different scene, or was filtered or compressed lossily";
    if (best.outside > most_outside)
        return fmt::format("{:.0f} % of the scene's background shows something in the picture: {}",
                           100 * best.outside, reason);
    if (best.inside > most_inside)
        return fmt::format("{:.0f} % of the scene's surfaces are background in the picture: {}",
                           100 * best.inside, reason);
    return std::nullopt;
}

}  // namespace glint
