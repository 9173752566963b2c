#include "diagnose/difference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace glint {
namespace {

/// Picture minus right picture, in levels.
using Difference = std::array<double, 3>;

struct WrongPixel {
    glm::ivec2 at{0};
    Difference difference{};
};

/// Returns the pixels that differ visibly, and fills in the region of each object.
std::vector<WrongPixel> wrong_pixels(const Exhibit& e, const Renderer& renderer, const DisplayChange& change,
                                     std::map<int, DifferenceRegion>& regions) {
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
            if (most <= visible_levels) continue;
            wrong.push_back(pixel);
            DifferenceRegion& region = regions[object];
            const bool first = region.pixels++ == 0;
            region.object = object;
            region.low = first ? pixel.at : glm::min(region.low, pixel.at);
            region.high = first ? pixel.at : glm::max(region.high, pixel.at);
            for (std::size_t c = 0; c < 3; ++c) region.mean[c] += pixel.difference[c];
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
    double room = 0;  // what rounding to levels may have done to it
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
        constexpr double rounding = 0.75;  // levels, of both pictures
        samples.push_back({pixel.at, c, linear(mine) - linear(double(right[k])),
                           (linear(mine + rounding) - linear(mine - rounding)) / 2});
    }
    return samples;
}

/// Those of some hundred pixels, a pixel's one after another.
std::vector<Sample> sampled(const std::vector<WrongPixel>& wrong, const Picture& right,
                            const Display& display) {
    constexpr std::size_t pixels = 300;
    std::vector<Sample> samples;
    const std::size_t step = std::max<std::size_t>(1, wrong.size() / pixels);
    for (std::size_t i = step / 2; i < wrong.size(); i += step) {
        const glm::ivec2 at = wrong[i].at;
        for (const Sample& s : samples_of(wrong[i], rgb_at(right, right.pixel(at.x, at.y)), display))
            samples.push_back(s);
    }
    return samples;
}

/// Whether a pixel of a drawing differs visibly from that of the right picture.
bool shows(const Picture& drawn, const Picture& right, glm::ivec2 at) {
    const std::size_t pixel = right.pixel(at.x, at.y);
    const Rgb a = rgb_at(drawn, pixel), b = rgb_at(right, pixel);
    for (std::size_t c = 0; c < 3; ++c)
        if (std::abs(float(a[c]) - float(b[c])) > visible_levels) return true;
    return false;
}

/// Sums of a least-squares fit of the difference by each term alone.
struct Fits {
    struct Sums {
        double product = 0, square = 0;
    };
    std::map<std::pair<std::string, int>, Sums> of;
    double energy = 0;  // of the difference

    /// `terms`: of the sample's pixel.
    void add(const Sample& s, const TermValues& terms) {
        energy += s.difference * s.difference;
        for (const auto& [name, value] : terms) {
            Sums& sums = of[name];
            sums.product += s.difference * value[s.channel];
            sums.square += value[s.channel] * value[s.channel];
        }
    }
};

std::vector<DifferenceTerm> likely_terms(const Fits& fits) {
    constexpr std::size_t most = 3;
    constexpr double least_explained = 0.5;
    std::vector<DifferenceTerm> terms;
    for (const auto& [name, sums] : fits.of) {
        if (sums.square <= 0 || fits.energy <= 0) continue;
        const double gain = sums.product / sums.square, explained = gain * sums.product / fits.energy;
        if (explained >= least_explained) terms.push_back({name.first, name.second, 1 + gain, explained});
    }
    // Where one light's term explains as much as that of all, it is that light's.
    constexpr double as_much = 0.005;
    const auto is_of_one = [all = terms](const DifferenceTerm& t) {
        return t.light == all_lights && std::any_of(all.begin(), all.end(), [&t](const DifferenceTerm& one) {
                   return one.term == t.term && one.light >= 0 && one.explained > t.explained - as_much;
               });
    };
    std::erase_if(terms, is_of_one);
    std::stable_sort(terms.begin(), terms.end(),
                     [](const auto& a, const auto& b) { return a.explained > b.explained; });
    if (terms.size() > most) terms.resize(most);
    return terms;
}

/// Returns the share of the samples that the likeliest term does not explain; 1 if there is no term. The
/// terms of each pixel are computed again, because those of all pixels would take gigabytes under thousands
/// of lights.
double share_left(const Renderer& renderer, const std::vector<Sample>& samples,
                  const std::vector<DifferenceTerm>& terms, double near) {
    if (terms.empty() || samples.empty()) return 1;
    const DifferenceTerm& term = terms.front();
    glm::ivec2 known(-1);
    glm::dvec3 value(0);
    const auto left = std::count_if(samples.begin(), samples.end(), [&](const Sample& s) {
        if (s.at != known) value = terms_at(renderer, s.at).at({term.term, term.light});
        known = s.at;  // its other channels follow
        const double explained = (term.factor - 1) * value[s.channel];
        return std::abs(s.difference - explained) > near * std::abs(s.difference) + s.room;
    });
    return static_cast<double>(left) / static_cast<double>(samples.size());
}

}  // namespace

DescribedDifference describe_difference(const Renderer& renderer, const Exhibit& exhibit,
                                        const DisplayChange& change, const Display& display,
                                        const Picture* mistaken) {
    std::map<int, DifferenceRegion> regions;
    std::vector<WrongPixel> wrong = wrong_pixels(exhibit, renderer, change, regions);
    DescribedDifference found;
    for (const auto& [object, region] : regions) found.regions.push_back(region);
    std::stable_sort(found.regions.begin(), found.regions.end(),
                     [](const auto& a, const auto& b) { return a.pixels > b.pixels; });
    Fits fits;
    std::vector<Sample> samples = sampled(wrong, exhibit.right, display);
    for (auto s = samples.begin(); s != samples.end();) {
        const TermValues terms = terms_at(renderer, s->at);
        for (const glm::ivec2 at = s->at; s != samples.end() && s->at == at; ++s) fits.add(*s, terms);
    }
    found.terms = likely_terms(fits);
    double near = 0.1;  // of a difference, by which a term may miss it
    if (mistaken != nullptr) {
        near = 0.03;
        std::erase_if(wrong,
                      [&](const WrongPixel& pixel) { return !shows(*mistaken, exhibit.right, pixel.at); });
        samples = sampled(wrong, exhibit.right, display);
    }
    found.pixels = wrong.size();
    found.pixels_left = share_left(renderer, samples, found.terms, near) * static_cast<double>(wrong.size());
    return found;
}

}  // namespace glint
