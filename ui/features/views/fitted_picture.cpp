#include "ui/features/views/fitted_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "diagnose/search/display_change.h"
#include "ui/picture/screen.h"

namespace glint {
namespace {

constexpr std::uint8_t beyond = 118;  // the grey that surrounds every picture (Theme::surround)

/// Computes linear colours, before exposure, from the displayed bytes.
void fill_linear(Picture& picture, const Display& display) {
    picture.linear.resize(3 * picture.size.pixels());
    const Code code = display.transfer == Transfer::Srgb ? Code::Decoded : Code::Same;
    for (std::size_t i = 0; i < picture.linear.size(); ++i) {
        const auto level = static_cast<float>(picture.rgba[i / 3 * 4 + i % 3]);
        picture.linear[i] = coded(code, level / 255) / std::max(display.exposure, 1e-6f);
    }
}

}  // namespace

PixelsBetween pixels_between(const Camera& camera, PictureSize from, PictureSize to) {
    const ScreenMap first = screen_map(camera, from), second = screen_map(camera, to);
    const double depth = glm::distance(camera.eye, camera.target);
    const auto carried = [&](glm::dvec2 pixel) {
        return project(second, unproject(first, pixel, depth)).pixel;
    };
    const glm::dvec2 end(from.width, from.height), low = carried({0, 0});
    return {(carried(end) - low) / end, low};
}

std::optional<glm::ivec2> pixel_in(const PixelsBetween& between, glm::ivec2 pixel, PictureSize to) {
    const glm::dvec2 at = between(glm::dvec2(pixel) + 0.5);
    if (!is_inside(to, at)) return std::nullopt;
    return nearest_pixel(to, at);
}

Picture fitted_picture(const Picture& picture, const Scene& scene, const Picture& shown, bool fills) {
    const PictureSize size = shown.size;
    const PixelsBetween between = pixels_between(scene.camera, size, picture.size);
    Picture fitted{size, fills ? shown.rgba : std::vector<std::uint8_t>(4 * size.pixels(), beyond), {}};
    std::vector<int> columns(static_cast<std::size_t>(size.width), -1);
    for (int x = 0; x < size.width; ++x) {
        const double at = std::floor(between({x + 0.5, 0}).x);
        if (at >= 0 && at < picture.size.width) columns[static_cast<std::size_t>(x)] = static_cast<int>(at);
    }
    for (int y = 0; y < size.height; ++y) {
        const double row = std::floor(between({0, y + 0.5}).y);
        for (int x = 0; x < size.width; ++x) {
            const std::size_t to = 4 * size.index(x, y);
            fitted.rgba[to + 3] = 255;
            const int column = columns[static_cast<std::size_t>(x)];
            if (column < 0 || row < 0 || row >= picture.size.height) continue;
            std::copy_n(&picture.rgba[4 * picture.pixel(column, static_cast<int>(row))], 3, &fitted.rgba[to]);
        }
    }
    if (!shown.linear.empty()) fill_linear(fitted, scene.display);
    return fitted;
}

}  // namespace glint
