#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "diagnose/search/score.h"

namespace glint {
namespace {

constexpr std::array<glm::ivec2, 9> offsets{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
constexpr std::size_t unknowns = offsets.size() + 1;

/// Returns n such that sampling every n-th row is enough.
int row_step(PictureSize size) { return std::max(1, size.height / 200); }

/// A least-squares fit of the differences between the wrong picture's levels and the drawing's. Each level of
/// the picture is modelled as a weighted mean of nine pixels of the drawing, plus a gain. The unknowns are
/// the nine weights and the gain; the coefficients of the weights are the differences of the nine levels from
/// the level at the pixel, and the coefficient of the gain is that level.
class MixtureFit {
  public:
    void add(const std::array<double, unknowns>& of, double off) {
        for (std::size_t i = 0; i < unknowns; ++i) {
            for (std::size_t j = 0; j <= i; ++j) normal_[i][j] += of[i] * of[j];
            right_[i] += of[i] * off;
        }
        squares_ += off * off;
        ++count_;
    }

    /// The share of the squared differences that no mixture explains, not counting noise of this standard
    /// deviation.
    [[nodiscard]] double share_left(double noise) const {
        const double of_noise = static_cast<double>(count_) * noise * noise;
        const double all = squares_ - of_noise;
        return all <= 0 ? 0 : (squares_ - explained() - of_noise) / all;
    }

  private:
    /// By Cholesky factorization: the solution of L y = right gives right · x = y · y. A direction in which
    /// nothing varies explains nothing.
    [[nodiscard]] double explained() const {
        std::array<std::array<double, unknowns>, unknowns> l{};
        std::array<double, unknowns> y{};
        double sum = 0;
        for (std::size_t i = 0; i < unknowns; ++i) {
            double pivot = normal_[i][i], rest = right_[i];
            for (std::size_t j = 0; j < i; ++j) {
                if (l[j][j] == 0) continue;
                double product = normal_[i][j];
                for (std::size_t k = 0; k < j; ++k) product -= l[i][k] * l[j][k];
                l[i][j] = product / l[j][j];
                pivot -= l[i][j] * l[i][j];
                rest -= l[i][j] * y[j];
            }
            constexpr double hardly_any = 1e-9;
            if (pivot <= hardly_any * normal_[i][i]) continue;
            l[i][i] = std::sqrt(pivot);
            y[i] = rest / l[i][i];
            sum += y[i] * y[i];
        }
        return sum;
    }

    std::array<std::array<double, unknowns>, unknowns> normal_{};
    std::array<double, unknowns> right_{};
    double squares_ = 0;
    std::size_t count_ = 0;
};

/// A drawing in the wrong picture's levels, read at its pixels or between them; positions are clamped to its
/// border.
class Levels {
  public:
    Levels(const Picture& drawn, const ByteRanges& ranges) : drawn_(drawn), ranges_(ranges) {}

    [[nodiscard]] double at(glm::dvec2 point, std::size_t channel) const {
        const glm::dvec2 corner(std::floor(point.x), std::floor(point.y)), t = point - corner;
        const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
        return (1 - t.y) * ((1 - t.x) * at(x, y, channel) + t.x * at(x + 1, y, channel)) +
               t.y * ((1 - t.x) * at(x, y + 1, channel) + t.x * at(x + 1, y + 1, channel));
    }

    [[nodiscard]] double at(int x, int y, std::size_t channel) const {
        const PictureSize size = drawn_.size;
        const std::size_t pixel =
            size.index(std::clamp(x, 0, size.width - 1), std::clamp(y, 0, size.height - 1));
        return double(ranges_[drawn_.rgba[4 * pixel + channel]].middle);
    }

  private:
    const Picture& drawn_;
    const ByteRanges& ranges_;
};

/// The step that a least-squares fit of picture(x) = drawn(x - shift) over all surfaces adds to a shift.
glm::dvec2 shift_step(const Exhibit& e, const Levels& levels, const DisplayChange& change, glm::dvec2 shift,
                      int rows) {
    double xx = 0, xy = 0, yy = 0, xd = 0, yd = 0;
    const PictureSize size = e.right.size;
    const glm::dvec2 right(1, 0), down(0, 1);
    for (int y = 1; y + 1 < size.height; y += rows)
        for (int x = 1; x + 1 < size.width; ++x) {
            if (e.kinds[size.index(x, y)] != PixelKind::Surface) continue;
            const Rgb mine = mine_at(e.wrong, change, x, y);
            const glm::dvec2 from = glm::dvec2(x, y) - shift;
            for (std::size_t c = 0; c < 3; ++c) {
                const double gx = (levels.at(from + right, c) - levels.at(from - right, c)) / 2;
                const double gy = (levels.at(from + down, c) - levels.at(from - down, c)) / 2;
                const double d = levels.at(from, c) - double(mine[c]);
                xx += gx * gx, xy += gx * gy, yy += gy * gy;
                xd += gx * d, yd += gy * d;
            }
        }
    const double determinant = xx * yy - xy * xy;
    if (determinant <= 1e-6 * xx * yy) return glm::dvec2(0);
    return glm::dvec2(yy * xd - xy * yd, xx * yd - xy * xd) / determinant;
}

/// Visits every level of the surfaces, with its pixel, its channel, and how far it is from the drawing.
template <class Visit>
void for_each_level(const Exhibit& e, const Drawing& drawn, const DisplayChange& change,
                    const ByteRanges& ranges, const Visit& visit) {
    const PictureSize size = e.right.size;
    for (int y = 1; y + 1 < size.height; y += row_step(size))
        for (int x = 1; x + 1 < size.width; ++x) {
            if (e.kinds[size.index(x, y)] != PixelKind::Surface) continue;
            const Rgb mine = mine_at(e.wrong, change, x, y), ours = rgb_at(drawn.picture, size.index(x, y));
            for (std::size_t c = 0; c < 3; ++c)
                visit(glm::ivec2(x, y), c, double(mine[c]) - double(ranges[ours[c]].middle));
        }
}

/// Returns the share of the difference that a mixture may leave unexplained. In a resampled picture the
/// mixture changes from place to place, so a single one explains only a part; but such a picture differs in
/// few places. The more levels differ, the more must be explained.
double may_be_left(const Exhibit& e, const Drawing& drawn, const DisplayChange& change) {
    constexpr double nearly_all = 0.7, most = 0.79, least = 0.3;
    constexpr double few = 0.01, many = 0.06, a_share = 3.8;
    const double clearly = double(visible_levels) + double(change.scatter());
    double sum = 0, all = 0, differ = 0, count = 0;
    for_each_level(e, drawn, change, byte_ranges(change), [&](glm::ivec2, std::size_t, double off) {
        ++count;
        if (std::abs(off) <= clearly) return;
        ++differ;
        sum += off;
        all += std::abs(off);
    });
    const bool one_sided = std::abs(sum) > nearly_all * all;
    if (one_sided || differ > many * count) return least;
    return most - a_share * std::max(differ / count - few, 0.0);
}

/// Returns the share of the difference that no mixture of nine pixels explains. The nine surround the pixel
/// from which a pixel was shifted. `with_gain`: the mixture may also have a gain.
double share_unmixed(const Exhibit& e, const Drawing& drawn, const DisplayChange& change, glm::ivec2 shift,
                     bool with_gain) {
    const ByteRanges ranges = byte_ranges(change);
    const Levels levels(drawn.picture, ranges);
    MixtureFit fit;
    for_each_level(e, drawn, change, ranges, [&](glm::ivec2 at, std::size_t c, double off) {
        const double here = levels.at(at.x, at.y, c);
        std::array<double, unknowns> of{};
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            const glm::ivec2 near = at - shift + offsets[i];
            of[i] = levels.at(near.x, near.y, c) - here;
        }
        if (with_gain) of.back() = here;
        fit.add(of, off);
    });
    return fit.share_left(double(change.noise));
}

/// The share of the squared differences that remains after a shift.
double share_unshifted(const Exhibit& e, const Drawing& drawn, const DisplayChange& change,
                       glm::dvec2 shift) {
    const ByteRanges ranges = byte_ranges(change);
    const Levels levels(drawn.picture, ranges);
    double all = 0, left = 0;
    for_each_level(e, drawn, change, ranges, [&](glm::ivec2 at, std::size_t c, double off) {
        const double mine = levels.at(at.x, at.y, c) + off;
        const double rest = mine - levels.at(glm::dvec2(at) - shift, c);
        all += off * off;
        left += rest * rest;
    });
    return all > 0 ? left / all : 0;
}

/// Steps in brightness from one side of a silhouette to the other.
struct Steps {
    int all = 0, hard = 0;  // hard: no value in between, and an even colour on each side
    [[nodiscard]] double share_hard() const { return all > 0 ? double(hard) / all : 0; }
};

/// Looks for a step in the middle of four pixels of a row or column. `flat`: the maximum difference, in
/// levels, between each outer pixel and its neighbour.
void add_step(Steps& steps, const std::array<Rgb, 4>& row, int flat) {
    constexpr int high = 48;  // levels
    for (std::size_t c = 0; c < 3; ++c) {
        const auto rise = [&](std::size_t from) {
            return std::abs(int(row[from + 1][c]) - int(row[from][c]));
        };
        const bool is_step =
            std::abs(int(row[3][c]) - int(row[0][c])) >= high && rise(1) >= rise(0) && rise(1) >= rise(2);
        if (!is_step) continue;
        ++steps.all;
        if (rise(0) <= flat && rise(2) <= flat) ++steps.hard;
        return;
    }
}

/// The steps at silhouettes of a picture whose colours color_at(pixel) returns.
template <class ColorAt> Steps steps_of(const Exhibit& e, const ColorAt& color_at, int flat) {
    Steps steps;
    const PictureSize size = e.right.size;
    const auto is_edge = [&](glm::ivec2 at) { return e.kinds[size.index(at.x, at.y)] == PixelKind::Edge; };
    for (const glm::ivec2 along : {glm::ivec2(1, 0), glm::ivec2(0, 1)})
        for (int y = along.y; y + 2 * along.y < size.height; ++y)
            for (int x = along.x; x + 2 * along.x < size.width; ++x) {
                const glm::ivec2 at(x, y);
                if (!is_edge(at) || !is_edge(at + along)) continue;
                add_step(steps,
                         {color_at(at - along), color_at(at), color_at(at + along), color_at(at + 2 * along)},
                         flat);
            }
    return steps;
}

/// The hardness of the steps at silhouettes, in the drawing and in the wrong picture.
std::pair<Steps, Steps> steps_at_silhouettes(const Exhibit& e, const Drawing& drawn,
                                             const DisplayChange& change) {
    const int flat = 4 + static_cast<int>(2 * change.noise);
    const PictureSize size = e.right.size;
    return {steps_of(
                e, [&](glm::ivec2 at) { return rgb_at(drawn.picture, size.index(at.x, at.y)); }, flat),
            steps_of(
                e, [&](glm::ivec2 at) { return mine_at(e.wrong, change, at.x, at.y); }, flat)};
}

/// Whether the steps at the wrong picture's silhouettes are as hard as the drawing's.
bool has_hard_edges(const Exhibit& e, const Drawing& drawn, const DisplayChange& change) {
    constexpr int enough_steps = 20;
    constexpr double as_hard = 0.6;
    const auto [ours, theirs] = steps_at_silhouettes(e, drawn, change);
    return ours.hard >= enough_steps && theirs.share_hard() >= as_hard * ours.share_hard();
}

}  // namespace

bool has_smooth_edges(const Exhibit& e, const Drawing& drawn, const DisplayChange& change) {
    constexpr double as_smooth = 0.7, by_chance = 3;  // standard deviations
    const auto [ours, theirs] = steps_at_silhouettes(e, drawn, change);
    const double expected = theirs.all * ours.share_hard(), missing = expected - theirs.hard;
    return theirs.hard < as_smooth * expected && missing > by_chance * std::sqrt(expected);
}

glm::vec2 fitted_shift(const Exhibit& e, const Picture& drawn, const DisplayChange& change, int rows) {
    const ByteRanges ranges = byte_ranges(change);
    const Levels levels(drawn, ranges);
    constexpr int steps = 4;        // Newton steps: brightness is not linear in the shift
    constexpr double farthest = 4;  // pixels
    glm::dvec2 shift(0);
    for (int i = 0; i < steps; ++i) {
        shift += shift_step(e, levels, change, shift, rows);
        if (glm::length(shift) > farthest) return glm::vec2(0);
    }
    return shift;
}

/// The shift that fits best, estimated from a sample of the rows.
static glm::vec2 coarse_shift(const Exhibit& e, const Drawing& drawn, const DisplayChange& change) {
    return fitted_shift(e, drawn.picture, change, row_step(e.right.size));
}

/// `shift` computes the shift that fits best; it is called only if the edges are hard.
template <class Shift>
static bool is_hard(const Exhibit& e, const Drawing& drawn, const DisplayChange& change, const Shift& shift) {
    constexpr double most_left_by_shift = 0.6;
    return has_hard_edges(e, drawn, change) &&
           share_unshifted(e, drawn, change, glm::dvec2(shift())) > most_left_by_shift;
}

bool is_hard(const Exhibit& e, const Drawing& drawn, const DisplayChange& change) {
    return is_hard(e, drawn, change, [&] { return coarse_shift(e, drawn, change); });
}

bool may_be_softened(const Exhibit& e, const Drawing& drawn, const DisplayChange& change) {
    constexpr double most_left_beside_gain = 0.1;
    constexpr float hardly = 1.1f;
    std::optional<glm::vec2> fitted;  // slow to compute, and often not needed
    const auto shift = [&] { return fitted ? *fitted : fitted.emplace(coarse_shift(e, drawn, change)); };
    if (is_hard(e, drawn, change, shift)) return false;
    const auto is_mixed = [&](const DisplayChange& told, double enough, bool with_gain) {
        if (share_unmixed(e, drawn, told, glm::ivec2(0), with_gain) <= enough) return true;
        const glm::ivec2 whole(glm::round(shift()));
        return whole != glm::ivec2(0) && share_unmixed(e, drawn, told, whole, with_gain) <= enough;
    };
    if (!is_mixed(change, may_be_left(e, drawn, change), false)) return false;
    // A gain near 1 may only compensate for a highlight of a different width: fit the gain and the mixture
    // together.
    if (change.gain == 1 || change.gain >= hardly || change.gain * hardly <= 1) return true;
    DisplayChange without = change;
    without.gain = 1;
    return is_mixed(without, most_left_beside_gain, true);
}

namespace {

/// The number of possible absolute responses of the mask (1 -2 1, -2 4 -2, 1 -2 1): up to 16 times a
/// channel's range.
constexpr std::size_t responses = 16 * 255 + 1;

/// The mask's absolute response in one channel at a pixel; nothing if the pixel and its neighbours are
/// equal. The response is 0 where levels are linear or constant along rows or columns.
std::optional<std::size_t> response_at(const Picture& picture, int x, int y, std::size_t channel) {
    constexpr std::array<int, 3> weight{1, -2, 1};
    const int middle = picture.rgba[4 * picture.pixel(x, y) + channel];
    int sum = 0;
    bool flat = true;
    for (int v = 0; v < 3; ++v)
        for (int u = 0; u < 3; ++u) {
            const int level = picture.rgba[4 * picture.pixel(x + u - 1, y + v - 1) + channel];
            sum += weight[std::size_t(u)] * weight[std::size_t(v)] * level;
            flat = flat && level == middle;
        }
    if (flat) return {};
    return static_cast<std::size_t>(std::abs(sum));
}

/// The mask's response in one channel at every pixel; no_answer at the border and in areas of one colour.
constexpr std::uint16_t no_answer = 0xFFFF;
std::vector<std::uint16_t> answers_of(const Picture& picture, std::size_t channel) {
    std::vector<std::uint16_t> answers(picture.size.pixels(), no_answer);
    for (int y = 1; y + 1 < picture.size.height; ++y)
        for (int x = 1; x + 1 < picture.size.width; ++x)
            if (const auto response = response_at(picture, x, y, channel))
                answers[picture.size.index(x, y)] = static_cast<std::uint16_t>(*response);
    return answers;
}

/// Returns the median of the mask's absolute responses over all channels. The mask also responds to edges
/// between areas of one colour. Only noise gives responses on all sides of a pixel, so only such pixels are
/// counted. Returns 0 if they are fewer than one in four.
std::size_t median_response(const Picture& picture) {
    constexpr int apart = 3;          // in addition to the mask's own width
    constexpr std::size_t share = 4;  // at least one response in this many is counted
    std::array<std::uint64_t, responses> counts{};
    std::uint64_t all = 0, answered = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<std::uint16_t> answers = answers_of(picture, c);
        const auto answers_at = [&](int x, int y) { return answers[picture.size.index(x, y)] != no_answer; };
        answered += static_cast<std::uint64_t>(
            std::count_if(answers.begin(), answers.end(), [](std::uint16_t a) { return a != no_answer; }));
        for (int y = apart; y + apart < picture.size.height; ++y)
            for (int x = apart; x + apart < picture.size.width; ++x) {
                if (!answers_at(x, y) || !answers_at(x - apart, y) || !answers_at(x + apart, y) ||
                    !answers_at(x, y - apart) || !answers_at(x, y + apart))
                    continue;
                ++counts[answers[picture.size.index(x, y)]];
                ++all;
            }
    }
    if (share * all < answered) return 0;
    std::uint64_t below = 0;
    std::size_t median = 0;
    while (median + 1 < responses && 2 * (below + counts[median]) < all) below += counts[median++];
    return median;
}

}  // namespace

float noise_of(const Picture& wrong, const Picture& right) {
    constexpr std::size_t least = 4, more_than_right = 2;  // rounding alone gives 1 or 2
    // The response has 6 times the noise's standard deviation, and its median absolute value is 0.6745 of
    // that.
    constexpr float median_of_unit = 6 * 0.6745f;
    const std::size_t median = median_response(wrong);
    if (median < least || median < more_than_right * median_response(right)) return 0;
    return static_cast<float>(median) / median_of_unit;
}

}  // namespace glint
