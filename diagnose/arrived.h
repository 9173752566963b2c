#pragma once
// Pictures as they arrive: copies of a window, with a border or with each pixel as a square.

#include <algorithm>
#include <string>

#include "renderer/picture.h"

namespace glint {

struct ArrivedPicture {
    Picture picture;
    std::string words;  // what was undone; empty if nothing was
};

/// Returns the bytes of the picture without a border or letterbox of one colour, and with each square of k x
/// k equal pixels, k up to 4, as one pixel.
[[nodiscard]] ArrivedPicture as_arrived(Picture picture);

/// The bytes of a picture at another size, each pixel the nearest one: nothing is blended.
[[nodiscard]] inline Picture resampled(const Picture& picture, PictureSize size) {
    if (picture.size == size) return picture;
    Picture other{size, std::vector<std::uint8_t>(4 * size.pixels()), {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int from_x = (2 * x + 1) * picture.size.width / (2 * size.width);
            const int from_y = (2 * y + 1) * picture.size.height / (2 * size.height);
            std::copy_n(&picture.rgba[4 * picture.pixel(from_x, from_y)], 4,
                        &other.rgba[4 * size.index(x, y)]);
        }
    return other;
}

}  // namespace glint
