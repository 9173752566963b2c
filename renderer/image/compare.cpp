#include "renderer/image/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace glint {
namespace {

int difference(const Picture& a, const Picture& b, std::size_t i) {
    return std::abs(int{a.rgba[i]} - int{b.rgba[i]});
}

std::string text(PictureSize size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

}  // namespace

Result<Comparison> compare(const Picture& a, const Picture& b) {
    if (a.size != b.size) {
        Problem problem;
        problem.what = "the pictures have the sizes " + text(a.size) + " and " + text(b.size);
        problem.expected = "two of the same size";
        return problem;
    }
    Comparison result;
    result.size = a.size;
    std::array<std::uint64_t, 3> sum{},
        sum_of_squares{};  // integers, so that the sum does not depend on the order of addition
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        const int alpha = difference(a, b, i + 3);
        bool differs = alpha > 0;
        result.alpha_max = std::max(result.alpha_max, alpha);
        for (std::size_t c = 0; c < 3; ++c) {
            const int d = difference(a, b, i + c);
            differs |= d > 0;
            result.max[c] = std::max(result.max[c], d);
            sum[c] += static_cast<std::uint64_t>(d);
            sum_of_squares[c] += static_cast<std::uint64_t>(d) * static_cast<std::uint64_t>(d);
        }
        result.differing_pixels += differs ? 1 : 0;
    }
    const double pixels = std::max(1.0, static_cast<double>(a.size.pixels()));
    for (std::size_t c = 0; c < 3; ++c) {
        result.mean[c] = static_cast<double>(sum[c]) / pixels;
        result.rmse[c] = std::sqrt(static_cast<double>(sum_of_squares[c]) / pixels);
    }
    result.max_error = std::max(result.alpha_max, *std::max_element(result.max.begin(), result.max.end()));
    return result;
}

int difference_gain(const Comparison& comparison) {
    return comparison.max_error == 0 ? 1 : 255 / comparison.max_error;
}

Picture difference_picture(const Picture& a, const Picture& b, int gain) {
    Picture picture{a.size, std::vector<std::uint8_t>(a.rgba.size(), 255), {}};
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        const int alpha = difference(a, b, i + 3);
        for (std::size_t c = 0; c < 3; ++c) {
            const int far = gain * std::max(alpha, difference(a, b, i + c));
            picture.rgba[i + c] = static_cast<std::uint8_t>(std::min(far, 255));
        }
    }
    return picture;
}

}  // namespace glint
