#include "diagnose/arrived.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "diagnose/search/probes.h"

namespace glint {
namespace {

/// A rectangle of pixels; the ends are outside.
struct Rectangle {
    int left, top, right, bottom;
    [[nodiscard]] PictureSize size() const { return {right - left, bottom - top}; }
};

Picture cut(const Picture& picture, const Rectangle& r) {
    Picture inner{r.size(), {}, {}};
    for (int y = r.top; y < r.bottom; ++y) {
        const auto row = picture.rgba.begin();
        inner.rgba.insert(inner.rgba.end(), row + std::ptrdiff_t(4 * picture.pixel(r.left, y)),
                          row + std::ptrdiff_t(4 * picture.pixel(r.right - 1, y)) + 4);
    }
    return inner;
}

/// The picture without its border, which has two opposite sides or all four. A background of that colour
/// touches the inner rectangle nearly everywhere; then nothing is a border.
Rectangle inside_border(const Picture& picture) {
    constexpr int near = 2;
    const PictureSize size = picture.size;
    const Rectangle all{0, 0, size.width, size.height};
    const Rgb colour = rgb_at(picture, 0);
    const auto is_border = [&](int x, int y) {
        return most_apart(rgb_at(picture, picture.pixel(x, y)), colour) <= near;
    };
    const auto in_row = [&](const Rectangle& r, int y) {
        int count = 0;
        for (int x = r.left; x < r.right; ++x) count += is_border(x, y) ? 1 : 0;
        return count;
    };
    const auto in_column = [&](const Rectangle& r, int x) {
        int count = 0;
        for (int y = r.top; y < r.bottom; ++y) count += is_border(x, y) ? 1 : 0;
        return count;
    };
    Rectangle r = all;
    while (r.top < r.bottom && in_row(r, r.top) == size.width) ++r.top;
    while (r.bottom > r.top && in_row(r, r.bottom - 1) == size.width) --r.bottom;
    while (r.left < r.right && in_column(r, r.left) == r.bottom - r.top) ++r.left;
    while (r.right > r.left && in_column(r, r.right - 1) == r.bottom - r.top) --r.right;
    if ((r.top == 0) != (r.bottom == size.height) || (r.left == 0) != (r.right == size.width)) return all;
    constexpr int least = 16, few = 20;  // one pixel in 20 of the inner edges may have the border's colour
    if (r.right - r.left < least || r.bottom - r.top < least) return all;
    const int edges =
        in_row(r, r.top) + in_row(r, r.bottom - 1) + in_column(r, r.left) + in_column(r, r.right - 1);
    return few * edges <= 2 * (r.size().width + r.size().height) ? r : all;
}

/// Whether the picture consists of squares of equal pixels.
bool has_squares(const Picture& picture, int edge) {
    const PictureSize size = picture.size;
    if (size.width % edge != 0 || size.height % edge != 0) return false;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (rgb_at(picture, picture.pixel(x, y)) !=
                rgb_at(picture, picture.pixel(x / edge * edge, y / edge * edge)))
                return false;
    return true;
}

}  // namespace

ArrivedPicture as_arrived(Picture picture) {
    std::vector<std::string> words;
    const bool keeps_width = std::exchange(picture.size.keeps_width, false);
    const Rectangle inner = inside_border(picture);
    if (inner.size() != picture.size) {
        words.push_back(
            fmt::format("a border of one colour: the picture inside it is {} x {} pixels, from {},{}",
                        inner.size().width, inner.size().height, inner.left, inner.top));
        picture = cut(picture, inner);
    }
    for (int edge = 4; edge > 1; --edge) {
        if (!has_squares(picture, edge)) continue;
        words.push_back(fmt::format("each pixel is a square of {} x {} pixels", edge, edge));
        picture = resampled(picture, {picture.size.width / edge, picture.size.height / edge});
        break;
    }
    picture.size.keeps_width = keeps_width;
    return {std::move(picture), fmt::format("{}", fmt::join(words, "; "))};
}

}  // namespace glint
