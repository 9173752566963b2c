#include "diagnose/search/display_change.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "diagnose/search/probes.h"
#include "diagnose/search/supposition.h"
#include "renderer/lighting/display.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

int steps_of(Code code) {
    return code == Code::Encoded || code == Code::Power ? 1 : code == Code::Decoded ? -1 : 0;
}

float decoded(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

/// The curve `code` at every half level from -0.5 to 255.5, clamped to 0 to 1: [0] is its value at -0.5.
using HalfLevels = std::array<float, 513>;
HalfLevels half_levels(Code code) {
    HalfLevels table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float level = (static_cast<float>(i) - 1) / 2;
        table[i] = coded(code, std::clamp(level / 255, 0.0f, 1.0f));
    }
    return table;
}
const HalfLevels& half_levels_of(Code code) {
    static const std::array<HalfLevels, 3> tables = {half_levels(Code::Same), half_levels(Code::Encoded),
                                                     half_levels(Code::Decoded)};
    return tables[static_cast<std::size_t>(code)];
}

/// The change in brightness, in levels.
class Change {
  public:
    explicit Change(const DisplayChange& change)
        : in_(half_levels_of(change.before)), gain_(change.gain), after_(change.after) {}
    /// The level that half / 2 - 0.5 becomes.
    [[nodiscard]] float at(std::size_t half) const {
        return 255 * coded(after_, std::min(gain_ * in_[half], 1.0f));
    }

  private:
    const HalfLevels& in_;
    float gain_;
    Code after_;
};

bool keeps_brightness(const DisplayChange& change) {
    return change.gain == 1 && change.before == Code::Same && change.after == Code::Same;
}

}  // namespace

float coded(Code code, float x) {
    switch (code) {
    case Code::Same:
        return x;
    case Code::Encoded:
        return srgb_encoded(x);
    case Code::Decoded:
        return decoded(x);
    case Code::Power:
        return std::pow(x, static_cast<float>(1 / encoding_power));
    }
    return x;  // not reached
}

float coded_byte(Code code, std::uint8_t byte) { return half_levels_of(code)[2 * std::size_t{byte} + 1]; }

int DisplayChange::encodings() const { return steps_of(before) + steps_of(after); }

int DisplayChange::count() const {
    return int{upside_down} + int{mirrored} + int{red_blue} + int{encodings() != 0 || is_by_power()} +
           int{gain != 1} + int{gain < 0.33f || gain > 3} + int{soft};
}

std::array<DisplayChange, 4> ways_of_turning() {
    std::array<DisplayChange, 4> ways;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        ways[i].mirrored = (i & 1) != 0;
        ways[i].upside_down = (i & 2) != 0;
    }
    return ways;
}

bool are_of_one_display(const DisplayChange& a, const DisplayChange& b) {
    return way_turned(a) == way_turned(b) && a.red_blue == b.red_blue && a.before == b.before &&
           a.after == b.after;
}

glm::ivec2 changed_place(const DisplayChange& change, PictureSize size, glm::ivec2 pixel) {
    return {change.mirrored ? size.width - 1 - pixel.x : pixel.x,
            change.upside_down ? size.height - 1 - pixel.y : pixel.y};
}

std::size_t changed_index(const DisplayChange& change, PictureSize size, int x, int y) {
    const glm::ivec2 place = changed_place(change, size, {x, y});
    return size.index(place.x, place.y);
}

ByteBounds byte_bounds(const DisplayChange& change) {
    constexpr float rounding = 0.5f;
    const float scatter = change.scatter();
    ByteBounds bounds;
    if (keeps_brightness(change)) {
        for (std::size_t i = 0; i < 256; ++i) {
            bounds.low[i] = static_cast<float>(i) - scatter;
            bounds.high[i] = static_cast<float>(i) + scatter;
        }
        return bounds;
    }
    const Change curve(change);
    for (std::size_t i = 0; i < 256; ++i) {
        const float edge = curve.at(2 * i);  // between the level before and this one
        bounds.low[i] = edge - rounding - scatter;
        if (i > 0) bounds.high[i - 1] = edge + rounding + scatter;
    }
    bounds.high[255] = 255;  // before clamping, it may have been any brightness from `low` up
    return bounds;
}

ByteRanges byte_ranges(const DisplayChange& change) {
    const ByteBounds bounds = byte_bounds(change);
    const Change curve(change);
    ByteRanges ranges;
    for (std::size_t i = 0; i < ranges.size(); ++i)
        ranges[i] = {bounds.low[i], keeps_brightness(change) ? static_cast<float>(i) : curve.at(2 * i + 1),
                     bounds.high[i], i == 255};
    return ranges;
}

namespace {

/// A rectangle of pixels; the ends are exclusive.
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

/// The picture without its border, which is on two opposite sides or on all four. If the colour also covers
/// much of the inner rectangle's edges, it is the background's, not a border's.
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

bool draws_border(const Scene& scene, PictureSize size) {
    Scene plain = under_mistakes(scene, {});
    plain.transport = {};  // light from other surfaces takes long, and changes no outline
    const Picture drawn = Renderer(1).render(plain, size);
    return inside_border(drawn).size() != drawn.size;
}

}  // namespace

ArrivedPicture as_arrived(Picture picture, const Scene& scene) {
    std::vector<std::string> words;
    const PictureSize drawn_size = picture.size;
    const bool keeps_width = std::exchange(picture.size.keeps_width, false);
    const Rectangle inner = inside_border(picture);
    if (inner.size() != picture.size && !draws_border(scene, drawn_size)) {
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
