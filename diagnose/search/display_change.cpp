#include "diagnose/search/display_change.h"

#include <algorithm>
#include <cmath>

#include "renderer/lighting/display.h"

namespace glint {
namespace {

int steps_of(Code code) {
    return code == Code::Encoded || code == Code::Power ? 1 : code == Code::Decoded ? -1 : 0;
}

float decoded(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

/// The curve `code` at every half level from -0.5 to 255.5, clamped to 0 to 1: [0] is that of -0.5.
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

/// What happens to brightnesses, in levels.
class Change {
  public:
    explicit Change(const DisplayChange& change)
        : in_(half_levels_of(change.before)), gain_(change.gain), after_(change.after) {}
    /// What a level of half / 2 - 0.5 becomes.
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
    bounds.high[255] = 255;  // may have been any brightness from there on before it was clamped
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

}  // namespace glint
