#include "diagnose/search/drawings.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "renderer/lighting/display.h"
#include "renderer/scoped_mistakes.h"

namespace glint {

std::vector<std::uint8_t> bytes_of_linear(const std::vector<float>& linear, const Display& display) {
    const DisplayJob job{display.exposure, display.transfer == Transfer::Srgb};
    const std::size_t pixels = linear.size() / 3;
    std::vector<std::uint8_t> rgba(4 * pixels, 255);
    constexpr std::size_t part = 4096;
    tbb::parallel_for(std::size_t{0}, (pixels + part - 1) / part, [&](std::size_t p) {
        for (std::size_t i = p * part; i < std::min(pixels, (p + 1) * part); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                rgba[4 * i + c] = static_cast<std::uint8_t>(byte_of(displayed(job, linear[3 * i + c])));
    });
    return rgba;
}

Drawings::Linear Drawings::linear_of(const Scene& scene, const std::vector<Probe>* probes) {
    const Picture& picture = render(scene, true);
    if (probes == nullptr) return picture.linear;
    Linear at;
    at.reserve(3 * probes->size());
    for (const Probe& p : *probes) {
        const float* from = &picture.linear[3 * picture.pixel(p.x, p.y)];
        at.insert(at.end(), from, from + 3);
    }
    return at;
}

const Drawings::Linear& Drawings::kept(const std::string& key, const Scene& scene,
                                       const std::vector<Probe>* probes) {
    constexpr std::size_t most = 256;
    if (probes == nullptr || probes != kept_at_ || kept_.size() > most) kept_.clear();  // pictures are large
    kept_at_ = probes;
    const auto at = kept_.find(key);
    if (at != kept_.end()) return at->second;
    return kept_[key] = linear_of(scene, probes);
}

Drawings::Linear Drawings::composed(const Supposition& e, const std::vector<Probe>* probes) {
    const Scene all = e.applied(right_);
    Linear sum;
    if (e.only.is_all()) {
        sum = linear_of(all, probes);
    } else {
        std::string key;
        for (const std::string& convention : e.conventions) key += convention;
        const Scene program = e.program(right_);
        sum = kept(key, program, probes);
        Linear edited;
        if (e.only.is_of_light()) {
            key += fmt::format("|{}|{}|{}", e.only.light, static_cast<int>(e.only.lights),
                               static_cast<int>(e.only.term));
            const Linear& before = kept(key, isolated(program, e.only), probes);
            edited = linear_of(isolated(all, e.only), probes);
            for (std::size_t i = 0; i < sum.size(); ++i) edited[i] += sum[i] - before[i];
        } else {  // the same for each object
            for (std::size_t i = 0; i + 1 < e.set.size(); ++i)
                key += "|" + e.set[i];  // the last is the object
            edited = kept(key, all, probes);
        }
        if (e.only.object < 0) {
            sum = std::move(edited);
        } else {
            for (std::size_t i = 0; i < sum.size() / 3; ++i) {
                const int x = probes ? (*probes)[i].x : static_cast<int>(i % std::size_t(size_.width));
                const int y = probes ? (*probes)[i].y : static_cast<int>(i / std::size_t(size_.width));
                if (renderer_.object_at(x, y) == e.only.object) std::copy_n(&edited[3 * i], 3, &sum[3 * i]);
            }
        }
    }
    if (e.tone != ToneCurve::None)
        for (std::size_t i = 0; i < sum.size(); i += 3) {
            const glm::vec3 c =
                toned(e.tone, right_.display.exposure * glm::vec3(sum[i], sum[i + 1], sum[i + 2]));
            for (int k = 0; k < 3; ++k) sum[i + static_cast<std::size_t>(k)] = c[k] / right_.display.exposure;
        }
    return sum;
}

Picture Drawings::whole(const Supposition& e) {
    if (e.only.is_all() && e.tone == ToneCurve::None) return render(e.applied(right_), false);
    return {size_, bytes_of_linear(composed(e, nullptr), right_.display), {}};
}

DrawnProbes Drawings::at_probes(const Supposition& e, const std::vector<Probe>& probes) {
    const auto bare = [this](int x, int y) { return is_bare(x, y); };
    if (e.only.is_all() && e.tone == ToneCurve::None)
        return drawn_at(probes, render(e.applied(right_), false), bare);
    const std::vector<std::uint8_t> rgba = bytes_of_linear(composed(e, &probes), right_.display);
    DrawnProbes drawn;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        drawn.at.insert(drawn.at.end(), &rgba[4 * i], &rgba[4 * i] + 3);
        drawn.bare.push_back(bare(probes[i].x, probes[i].y) ? 1 : 0);
    }
    if (std::count(drawn.bare.begin(), drawn.bare.end(), 1) == 0) drawn.bare.clear();
    drawn.low = drawn.high = drawn.at;
    return drawn;
}

ProbeLevels Drawings::levels_at(const Scene& scene, const std::vector<Probe>& probes) {
    const Picture& picture = render(scene, false);
    ProbeLevels levels;
    levels.reserve(3 * probes.size());
    for (const Probe& p : probes) {
        const Rgb at = rgb_at(picture, picture.pixel(p.x, p.y));
        levels.insert(levels.end(), at.begin(), at.end());
    }
    return levels;
}

}  // namespace glint
