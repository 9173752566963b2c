// Compares the `--set` options of each explanation with the scene that the search draws for it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/search/probes.h"
#include "diagnose/search/supposition.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

namespace glint::test {
namespace {

/// The scene that a user draws with these options.
Scene set_by_options(const Scene& scene, const std::vector<std::string>& options) {
    std::vector<Assignment> assignments;
    for (const std::string& option : options) {
        const Result<Assignment> read = parse_assignment(option);
        REQUIRE(problem_of(read) == nullptr);
        assignments.push_back(std::get<Assignment>(read));
    }
    Result<Scene> read = parse_scene(scene_text(scene), "scene.json", assignments);
    INFO((problem_of(read) != nullptr ? problem_of(read)->text() : ""));
    REQUIRE(problem_of(read) == nullptr);
    Scene set = std::get<Scene>(std::move(read));
    for (std::size_t i = 0; i < set.objects.size(); ++i) set.objects[i].mesh = scene.objects[i].mesh;
    return set;
}

std::vector<Supposition> all_edits(const Scene& scene) {
    std::vector<Supposition> all = left_out_edits(scene);
    for (const auto& list : {setting_edits(scene), mistake_edits()})
        all.insert(all.end(), list.begin(), list.end());
    for (const Supposition& mistake : mistake_edits())
        for (const Supposition& e : restricted(mistake, scene)) all.push_back(e);
    for (const FreeNumber& number : free_numbers(scene)) all.push_back(number_edit(number, 0.5f, scene));
    for (const Convention& c : conventions_of(scene)) {
        Supposition e = with_convention({}, c);
        e.set = e.convention_set;
        all.push_back(e);
    }
    return all;
}

}  // namespace

TEST_CASE("the options of every explanation set the scene that was drawn for it", "[diagnose][release]") {
    for (const char* name : {"every-term.json", "lost-highlight.json"}) {
        const Scene scene = under_mistakes(shipped(name).scene, {});
        for (const Supposition& e : all_edits(scene)) {
            INFO(name << ": " << e.name << ": " << e.words);
            REQUIRE_FALSE(e.set.empty());
            Scene drawn = e.applied(scene);
            drawn.shading.mistakes.only = e.only;
            CHECK(set_by_options(scene, e.set) == drawn);
        }
    }
}

TEST_CASE("a mistake limited to one light does not change pixels lit only by other lights", "[diagnose]") {
    const Scene right = under_mistakes(shipped("every-term.json").scene, {});
    Scene wrong = right;
    wrong.shading.mistakes.half_lambert = true;
    Renderer renderer(1);
    const PictureSize size{80, 60};
    const Picture everywhere = renderer.render(wrong, size);
    const Picture correct = renderer.render(right, size);
    wrong.shading.mistakes.only.light = 0;
    const Picture first = renderer.render(wrong, size);
    CHECK(first.rgba != everywhere.rgba);
    CHECK(first.rgba != correct.rgba);
    // With the other lights off, the scope makes no difference.
    for (std::size_t i = 1; i < wrong.lights.size(); ++i) wrong.lights[i].enabled = false;
    const Picture scoped = renderer.render(wrong, size);
    wrong.shading.mistakes.only = {};
    CHECK(renderer.render(wrong, size).rgba == scoped.rgba);
}

}  // namespace glint::test

namespace glint {
namespace {

constexpr PictureSize size{37, 11};

/// Pixels with random levels; every tenth is background.
struct Sample {
    Picture drawn, wrong;
    std::vector<Probe> probes;
    std::vector<PixelKind> kinds;
    std::vector<std::uint8_t> bare;  // for each pixel

    explicit Sample(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_int_distribution<int> level(0, 255);
        for (Picture* picture : {&drawn, &wrong}) {
            picture->size = size;
            for (std::size_t i = 0; i < 4 * size.pixels(); ++i)
                picture->rgba.push_back(static_cast<std::uint8_t>(level(random)));
        }
        for (std::size_t i = 0; i < size.pixels(); ++i) {
            kinds.push_back(i % 10 == 0 ? PixelKind::Background : PixelKind::Surface);
            bare.push_back(level(random) < 40 ? 1 : 0);
            if (i % 10 == 0)  // the background has one colour
                for (std::size_t c = 0; c < 3; ++c)
                    wrong.rgba[4 * i + c] = static_cast<std::uint8_t>(60 + 20 * c);
            probes.push_back({static_cast<int>(i) % size.width, static_cast<int>(i) / size.width});
        }
    }

    [[nodiscard]] DrawnProbes at_probes(bool with_bare) const {
        if (!with_bare) return drawn_at(probes, drawn, {});
        return drawn_at(probes, drawn, [&](int x, int y) { return bare[size.index(x, y)] != 0; });
    }
};

/// The sum by its definition, channel by channel.
double excess_by_hand(const Sample& s, const DisplayChange& change, bool with_bare) {
    const ByteBounds bounds = byte_bounds(change);
    const std::array<double, 3> ground{60, 80, 100};
    double sum = 0;
    for (const Probe& p : s.probes) {
        const int x = change.mirrored ? size.width - 1 - p.x : p.x;
        const int y = change.upside_down ? size.height - 1 - p.y : p.y;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t k = change.red_blue ? 2 - c : c;
            const double mine = s.wrong.rgba[4 * size.index(x, y) + k];
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (int v = p.y - 1; v <= p.y + 1; ++v)
                for (int u = p.x - 1; u <= p.x + 1; ++u) {
                    const bool itself = u == p.x && v == p.y;
                    if (u < 0 || v < 0 || u >= size.width || v >= size.height || (!change.soft && !itself))
                        continue;
                    const std::uint8_t level = s.drawn.rgba[4 * size.index(u, v) + c];
                    low = std::min(low, double(bounds.low[level]));
                    high = std::max(high, double(bounds.high[level]));
                }
            if (with_bare && s.bare[size.index(p.x, p.y)] != 0) low = high = ground[k];
            const double off = std::max({low - mine, mine - high, 0.0}), beyond = std::max(off - 1, 0.0);
            sum += std::min(beyond * beyond, 16.0);
        }
    }
    return sum;
}

/// The minimum and maximum of a channel over a pixel and its neighbours.
std::pair<int, int> least_and_largest(const Picture& picture, int x, int y, std::size_t channel) {
    int low = 255, high = 0;
    for (int v = 0; v < picture.size.height; ++v)
        for (int u = 0; u < picture.size.width; ++u) {
            if (std::abs(u - x) > 1 || std::abs(v - y) > 1) continue;
            const int level = picture.rgba[4 * picture.size.index(u, v) + channel];
            low = std::min(low, level), high = std::max(high, level);
        }
    return {low, high};
}

TEST_CASE("the bounds around a pixel are the minimum and maximum of nine pixels") {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> level(0, 255);
    for (const PictureSize of : {size, PictureSize{1, 1}, {1, 5}, {6, 1}, {2, 3}, {3, 2}}) {
        Picture picture{of, {}, {}};
        for (std::size_t i = 0; i < 4 * of.pixels(); ++i)
            picture.rgba.push_back(static_cast<std::uint8_t>(level(random)));
        for (int y = 0; y < of.height; ++y) {
            const RowBounds row(picture, y);
            for (int x = 0; x < of.width; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    INFO(of.width << " x " << of.height << ", " << x << ", " << y << ", channel " << c);
                    const auto [low, high] = least_and_largest(picture, x, y, c);
                    CHECK((row.at(x).low[c] == low && row.at(x).high[c] == high));
                    const RgbBounds one = bounds_around(picture, {x, y});
                    CHECK((one.low[c] == low && one.high[c] == high));
                }
        }
    }
}

TEST_CASE("the excess at probe pixels is summed over their channels under every flip") {
    for (const unsigned seed : {1U, 2U}) {
        const Sample s(seed);
        for (const bool with_bare : {false, true}) {
            const DrawnProbes drawn = s.at_probes(with_bare);
            const WrongProbes wrong(s.probes, s.wrong, s.kinds, 0);
            for (int ways = 0; ways < 16; ++ways) {
                DisplayChange change;
                change.upside_down = (ways & 1) != 0;
                change.mirrored = (ways & 2) != 0;
                change.red_blue = (ways & 4) != 0;
                change.soft = (ways & 8) != 0;
                change.gain = 1.3f;
                // A flip moves the background to other pixels, so it has no colour of its own.
                if (with_bare && (change.upside_down || change.mirrored)) continue;
                INFO("seed " << seed << ", way " << ways << ", bare " << with_bare);
                const double excess = excess_at(drawn, wrong, change, byte_bounds(change),
                                                std::numeric_limits<double>::infinity());
                CHECK(excess == Approx(excess_by_hand(s, change, with_bare)).epsilon(1e-6));
            }
        }
    }
}

TEST_CASE("summing the excess stops early only above the limit") {
    const Sample s(3);
    const DrawnProbes drawn = s.at_probes(false);
    const WrongProbes wrong(s.probes, s.wrong, s.kinds, 0);
    const DisplayChange change;
    const double all = excess_by_hand(s, change, false), enough = all / 4;
    const double excess = excess_at(drawn, wrong, change, byte_bounds(change), enough);
    CHECK(excess > enough);
    CHECK(excess < all / 2);
}

TEST_CASE("the estimated gain is that of most pixels, regardless of the others") {
    for (const double gain : {0.1, 0.3, 0.7, 1.0, 1.3}) {
        Sample s(4);
        std::mt19937 random(5);
        for (std::size_t i = 0; i < s.wrong.rgba.size(); ++i) {
            const bool other = random() % 10 < 3;  // shows something other than the scene
            if (other) continue;
            s.wrong.rgba[i] = static_cast<std::uint8_t>(std::min(std::lround(gain * s.drawn.rgba[i]), 255L));
        }
        INFO(gain);
        const auto fitted = fitted_gain(s.at_probes(false), WrongProbes(s.probes, s.wrong, s.kinds, 0), {});
        REQUIRE(fitted.has_value());
        CHECK(double(*fitted) == Approx(gain).epsilon(0.01));
    }
}

}  // namespace
}  // namespace glint
