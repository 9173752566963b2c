#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "diagnose/search/hypotheses.h"
#include "renderer/lighting/display.h"
#include "renderer/renderer.h"

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
        } else {  // the same edit of each object
            for (std::size_t i = 0; i + 1 < e.set.size(); ++i)
                key += "|" + e.set[i];  // the last names the object
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

// Fits each number of the scene to a wrong picture, one at a time.

namespace {

class Fit {
  public:
    Fit(Drawings& drawings, const std::vector<Probe>& probes, const ProbeLevels& wrong,
        const std::vector<Convention>& conventions)
        : drawings_(drawings),
          conventions_(conventions),
          scene_(drawings.right()),
          probes_(probes),
          wrong_(wrong) {
        for (const Convention& c : conventions_) c.edit(scene_);
        right_ = drawings_.levels_at(scene_, probes_);
        misfit_ = misfit(right_);
        for (const Probe& p : probes_) object_.push_back(drawings_.renderer().object_at(p.x, p.y));
    }

    /// Fits the number; returns false if that does not explain the picture.
    [[nodiscard]] bool fit(const FreeNumber& number, Supposition& found);

  private:
    [[nodiscard]] static double off(std::uint8_t a, std::uint8_t b) {
        constexpr int most = 32;
        return std::min(most, std::abs(int{a} - int{b}));
    }
    [[nodiscard]] double misfit(const ProbeLevels& drawn) const {
        double sum = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) sum += off(drawn[i], wrong_[i]);
        return sum;
    }
    ProbeLevels drawn(const FreeNumber& number, float value) {
        Scene scene = scene_;
        set_number(scene, number, value);
        return drawings_.levels_at(scene, probes_);
    }
    double misfit(const FreeNumber& number, float value) { return misfit(drawn(number, value)); }
    /// Whether much of the difference is at pixels that the number cannot change.
    [[nodiscard]] bool misses(const FreeNumber& number, const ProbeLevels& changed) const;
    float golden(const FreeNumber& number, float low, float high);

    Drawings& drawings_;
    const std::vector<Convention>& conventions_;
    Scene scene_;  // under the program's conventions
    const std::vector<Probe>& probes_;
    const ProbeLevels& wrong_;
    std::vector<int> object_;  // the object at each probe
    ProbeLevels right_;
    double misfit_ = 0;
};

bool Fit::misses(const FreeNumber& number, const ProbeLevels& changed) const {
    constexpr double few = 0.05;
    double all = 0, missed = 0;
    for (std::size_t i = 0; i < right_.size(); ++i) {
        const double wrong = off(right_[i], wrong_[i]);
        if (wrong <= 2) continue;  // only rounding
        all += wrong;
        const bool is_other = number.object >= 0 && object_[i / 3] != number.object;
        if (is_other || (number.object < 0 && changed[i] == right_[i] && right_[i] < 255)) missed += wrong;
    }
    return missed > few * all;
}

float Fit::golden(const FreeNumber& number, float low, float high) {
    constexpr float ratio = 0.618034f;
    constexpr int steps = 14;
    float a = high - ratio * (high - low), b = low + ratio * (high - low);
    double at_a = misfit(number, a), at_b = misfit(number, b);
    for (int i = 0; i < steps; ++i) {
        if (at_a < at_b) {
            high = b;
            b = a;
            at_b = at_a;
            at_a = misfit(number, a = high - ratio * (high - low));
        } else {
            low = a;
            a = b;
            at_a = at_b;
            at_b = misfit(number, b = low + ratio * (high - low));
        }
    }
    return at_a < at_b ? a : b;
}

/// Returns `value` rounded to this many significant digits.
float rounded_to(float value, int digits) {
    if (value == 0) return 0;
    const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(double(value)))));
    return static_cast<float>(std::round(double(value) * scale) / scale);
}

bool Fit::fit(const FreeNumber& number, Supposition& found) {
    constexpr double scanned = 0.75, fitted = 0.15;
    const float v = value_in(scene_, number);
    std::vector<float> values;
    if (number.is_signed()) {
        for (const float d : {0.25f, 0.5f, 1.0f, 2.0f, 4.0f}) values.insert(values.end(), {v - d, v + d});
        values.insert(values.end(), {-v, 0.0f});
    } else if (v == 0) {
        values = {0.05f, 0.1f, 0.25f, 0.5f, 1};
    } else {
        for (const float f :
             {0.0f, 0.1f, 0.25f, 0.5f, 0.7f, 0.85f, 1.2f, 1.5f, 2.0f, 3.0f, 5.0f, 10.0f, 25.0f})
            values.push_back(f * v);
    }
    for (float& value : values) value = std::clamp(value, number.least, number.most);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    const auto cannot = [&](float value) {
        return misses(number, number.object < 0 ? drawn(number, value) : right_);  // no drawing is needed
    };
    if (cannot(values.back()) && cannot(values.front())) return false;
    std::size_t best = 0;
    double least = misfit_;
    bool any = false;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (const double m = misfit(number, values[i]); m < least) {
            least = m;
            best = i;
            any = true;
        }
    if (!any || least > scanned * misfit_) return false;
    float value = values[best];
    if (least > 0.01 * misfit_)
        value = golden(number,
                       best > 0 ? std::min(v < value ? v : values[best - 1], values[best - 1]) : values[0],
                       best + 1 < values.size() ? values[best + 1] : values.back());
    least = misfit(number, value);
    if (least > fitted * misfit_) return false;
    for (int digits = 1; digits <= 4; ++digits) {
        constexpr double as_good = 1.02, hardly = 0.002;
        const float rounded = rounded_to(value, digits);
        if (misfit(number, rounded) > as_good * least + hardly * misfit_) continue;
        value = rounded;
        break;
    }
    found = number_edit(number, value, scene_);
    for (const Convention& c : conventions_) found = with_convention(found, c);
    return true;
}

}  // namespace

std::vector<Supposition> fitted_numbers(Drawings& drawings, const std::vector<Probe>& probes,
                                        const ProbeLevels& wrong,
                                        const std::vector<Convention>& conventions) {
    Fit fit(drawings, probes, wrong, conventions);
    std::vector<Supposition> found;
    for (const FreeNumber& number : free_numbers(drawings.right())) {
        Supposition e;
        if (fit.fit(number, e)) found.push_back(std::move(e));
    }
    return found;
}

}  // namespace glint
