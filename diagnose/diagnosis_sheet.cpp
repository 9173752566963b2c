#include <algorithm>
#include <array>

#include "diagnose/diagnosis_format.h"
#include "renderer/image/compare.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

const SheetAxis one_row{"/", {""}};

SheetAxis columns_of(const Diagnosis& d) {
    SheetAxis axis{"/", {"yours", "right"}};
    if (!d.candidates.empty()) axis.values.push_back(name_of(d.candidates.front().mistakes));
    axis.values.emplace_back("yours - right");
    return axis;
}

/// Returns the picture of the scene as the diagnosed display would show it.
Picture as_displayed(Picture picture, const DisplayChange& change) {
    const ByteRanges ranges = byte_ranges(change);
    for (std::size_t pixel = 0; pixel < picture.size.pixels(); ++pixel) {
        const Rgb colour = shown(ranges, rgb_at(picture, pixel));
        std::copy(colour.begin(), colour.end(), &picture.rgba[4 * pixel]);
    }
    return picture;
}

/// The wrong picture the right way up, its channels in order.
Picture upright(const Picture& wrong, const DisplayChange& change) {
    Picture picture{wrong.size, std::vector<std::uint8_t>(wrong.rgba.size(), 255), {}};
    for (int y = 0; y < wrong.size.height; ++y)
        for (int x = 0; x < wrong.size.width; ++x) {
            const Rgb colour = mine_at(wrong, change, x, y);
            std::copy(colour.begin(), colour.end(), &picture.rgba[4 * wrong.pixel(x, y)]);
        }
    return picture;
}

/// The byte of which the change makes a level nearest to this one.
std::uint8_t drawn_byte(const ByteRanges& ranges, std::uint8_t wrong) {
    const auto nearest = std::min_element(
        ranges.begin(), ranges.end(),
        [wrong](const auto& a, const auto& b) { return a.from_middle(wrong) < b.from_middle(wrong); });
    return static_cast<std::uint8_t>(nearest - ranges.begin());
}

}  // namespace

Picture undone(const Picture& wrong, const DisplayChange& change) {
    Picture picture = upright(wrong, change);
    const ByteRanges ranges = byte_ranges(change);
    std::array<std::uint8_t, 256> drawn{};
    for (std::size_t i = 0; i < drawn.size(); ++i)
        drawn[i] = drawn_byte(ranges, static_cast<std::uint8_t>(i));
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) picture.rgba[i] = drawn[picture.rgba[i]];
    return picture;
}

PictureSize diagnosis_sheet_size(const Diagnosis& d, const Font& font) {
    return sheet_size(one_row, columns_of(d), d.size, font);
}

Picture diagnosis_sheet(const Diagnosis& d, const Scene& scene, const Picture& wrong, const Font& font,
                        int threads) {
    const DisplayChange& change = d.display.change;
    Renderer renderer(threads);
    std::vector<Picture> cells{upright(wrong, change)};
    cells.push_back(as_displayed(renderer.render(under_mistakes(scene, {}), d.size), change));
    const Comparison far = std::get<Comparison>(compare(cells[0], cells[1]));
    Picture difference = difference_picture(cells[0], cells[1], difference_gain(far));
    if (!d.candidates.empty())
        cells.push_back(
            as_displayed(renderer.render(scene_under(scene, d.candidates.front()), d.size), change));
    cells.push_back(std::move(difference));
    return make_sheet(one_row, columns_of(d), d.size, font,
                      [&](std::size_t, std::size_t column) -> const Picture& { return cells[column]; });
}

}  // namespace glint
