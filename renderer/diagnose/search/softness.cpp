#include "renderer/diagnose/search/softness.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace glint {
namespace {

constexpr std::array<glm::ivec2, 8> offsets{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
constexpr std::size_t unknowns = offsets.size() + 1;

/// Least squares of how far each level is off by how far the eight around it are from it, which gives what
/// each of them has in the mixture, and by the level itself, which gives a gain.
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

    /// The share of the squares that no mixture explains, without what noise of this deviation adds.
    [[nodiscard]] double share_left(double noise) const {
        const double of_noise = static_cast<double>(count_) * noise * noise;
        const double all = squares_ - of_noise;
        return all <= 0 ? 0 : (squares_ - explained() - of_noise) / all;
    }

  private:
    /// By Cholesky's factors, whose solution of L y = right gives right · x = y · y. A direction in which
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

/// Visits every level of a surface: its pixel, its channel, and how far it is off the drawing.
template <class Visit>
void for_each_level(const Exhibit& e, const Drawing& drawn, const DisplayChange& change,
                    const ByteRanges& ranges, const Visit& visit) {
    const PictureSize size = e.right.size;
    for (int y = 1; y + 1 < size.height; ++y)
        for (int x = 1; x + 1 < size.width; ++x) {
            if (e.kinds[size.index(x, y)] != PixelKind::Surface) continue;
            const Rgb mine = mine_at(e.wrong, change, x, y), ours = rgb_at(drawn.picture, size.index(x, y));
            for (std::size_t c = 0; c < 3; ++c)
                visit(glm::ivec2(x, y), c, double(mine[c]) - double(ranges[ours[c]].middle));
        }
}

/// Whether nearly all of what is off is so in one direction.
bool is_one_sided(const Exhibit& e, const Drawing& drawn, const DisplayChange& change,
                  const ByteRanges& ranges) {
    constexpr double nearly_all = 0.7;
    const double clearly = double(visible_levels) + double(change.scatter());
    double sum = 0, all = 0;
    for_each_level(e, drawn, change, ranges, [&](glm::ivec2, std::size_t, double off) {
        if (std::abs(off) <= clearly) return;
        sum += off;
        all += std::abs(off);
    });
    return std::abs(sum) > nearly_all * all;
}

}  // namespace

bool may_be_softened(const Exhibit& e, const Drawing& drawn, const DisplayChange& change) {
    constexpr double most_left = 0.3;
    constexpr float hardly = 1.1f;
    // A gain near 1 may be what makes a highlight of another width look even: it is fitted beside the
    // mixture.
    DisplayChange judged = change;
    const bool fits_gain = change.gain != 1 && change.gain < hardly && change.gain * hardly > 1;
    if (fits_gain) judged.gain = 1;
    const ByteRanges ranges = byte_ranges(judged);
    if (!is_one_sided(e, drawn, judged, ranges)) return true;
    MixtureFit fit;
    for_each_level(e, drawn, judged, ranges, [&](glm::ivec2 at, std::size_t c, double off) {
        const auto level = [&](glm::ivec2 pixel) {
            return double(ranges[rgb_at(drawn.picture, e.right.size.index(pixel.x, pixel.y))[c]].middle);
        };
        const double here = level(at);
        std::array<double, unknowns> of{};
        for (std::size_t i = 0; i < offsets.size(); ++i) of[i] = level(at + offsets[i]) - here;
        if (fits_gain) of.back() = here;
        fit.add(of, off);
    });
    return fit.share_left(double(change.noise)) <= most_left;
}

}  // namespace glint
