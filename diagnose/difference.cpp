#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "diagnose/judged.h"

namespace glint {
namespace {

/// Picture minus right picture, in levels.
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

/// The terms of the sum at one pixel, linear times exposure.
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

/// Adds those of some hundred pixels, a pixel's one after another.
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

/// Sums of a least-squares fit of a difference by one term.
struct Sums {
    double product = 0, square = 0, energy = 0;  // energy: of the difference

    [[nodiscard]] double factor() const { return 1 + (square > 0 ? product / square : 0); }
    [[nodiscard]] double explained() const { return square > 0 ? product * product / square : 0; }
    Sums& operator+=(const Sums& other) {
        product += other.product;
        square += other.square;
        energy += other.energy;
        return *this;
    }
};
/// By object, and by channel.
using TermSums = std::map<int, std::array<Sums, 3>>;

/// The term as a factor of the whole picture, else one for each channel, else one for the object on which
/// most of the difference is. Nothing where none of these explains nearly all of the difference: a hint that
/// is not so sends the reader to the wrong line.
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
    // Where one light's term explains as much as that of all, it is that light's.
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
    add_samples(samples, all, exhibit.right, display);  // where a term shows and nothing is wrong
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

}  // namespace glint
