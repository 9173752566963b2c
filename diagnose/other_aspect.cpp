#include "diagnose/other_aspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "diagnose/search/mistake_set.h"
#include "diagnose/search/resample.h"

namespace glint {
namespace {

constexpr PictureSize small{160, 120};

/// The gradient of the picture at each pixel, in which outlines stand out. Mean 0, length 1.
std::vector<double> outlines(const Picture& picture) {
    std::vector<double> steep(picture.size.pixels());
    const auto grey = [&](int x, int y) {
        const std::uint8_t* p = &picture.rgba[4 * picture.pixel(x, y)];
        return double(p[0]) + double(p[1]) + double(p[2]);
    };
    double mean = 0, square = 0;
    for (int y = 0; y + 1 < picture.size.height; ++y)
        for (int x = 0; x + 1 < picture.size.width; ++x) {
            const double here = grey(x, y);
            // The square root keeps a few bright outlines from drowning the others.
            const double rise = std::hypot(grey(x + 1, y) - here, grey(x, y + 1) - here);
            mean += steep[picture.size.index(x, y)] = std::sqrt(rise);
        }
    mean /= static_cast<double>(steep.size());
    for (double& s : steep) {
        s -= mean;
        square += s * s;
    }
    for (double& s : steep) s /= std::sqrt(std::max(square, 1e-12));
    return steep;
}

double likeness(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// So many lines of that aspect, or fewer where they would be wider than a picture can be.
PictureSize size_of_aspect(double aspect, int lines) {
    constexpr double widest = 4096;
    const double width = std::clamp(lines * aspect, 1.0, widest);
    const double height = std::min(width / aspect, static_cast<double>(lines));
    return {static_cast<int>(std::lround(width)), std::max(1, static_cast<int>(std::lround(height)))};
}

}  // namespace

std::optional<std::string> other_aspect(Renderer& renderer, const Scene& scene, const Picture& wrong) {
    struct Aspect {
        int width, height;
    };
    constexpr std::array aspects{Aspect{1, 1},  Aspect{5, 4}, Aspect{4, 3}, Aspect{3, 2}, Aspect{16, 10},
                                 Aspect{16, 9}, Aspect{2, 1}, Aspect{3, 4}, Aspect{2, 3}, Aspect{9, 16}};
    constexpr double clearly = 0.15, enough = 0.5, same = 0.02;
    const Scene right = under_mistakes(scene, {});
    const std::vector<double> mine = outlines(resampled(wrong, small));
    const auto likeness_at = [&](PictureSize size) {
        return likeness(mine, outlines(resampled(renderer.render(right, size), small)));
    };
    constexpr int lines = 240;
    const double aspect = static_cast<double>(wrong.size.width) / static_cast<double>(wrong.size.height);
    double best = likeness_at(size_of_aspect(aspect, lines)) + clearly;
    std::optional<std::string> found;
    for (const Aspect& a : aspects) {
        if (std::abs(aspect * a.height / a.width - 1) < same) continue;
        const double like = likeness_at({lines * a.width / a.height, lines});
        if (like <= best || like < enough) continue;
        best = like;
        found = fmt::format("{}:{}", a.width, a.height);
    }
    return found;
}

}  // namespace glint
