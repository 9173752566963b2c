#include "renderer/diagnose/search/display_change.h"

#include <algorithm>
#include <cmath>

#include "renderer/lighting/display.h"

namespace glint {
namespace {

int steps_of(Code code) { return code == Code::Encoded ? 1 : code == Code::Decoded ? -1 : 0; }

float decoded(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

/// In levels.
float changed(const DisplayChange& change, float level) {
    const float in = coded(change.before, std::clamp(level / 255, 0.0f, 1.0f));
    return 255 * coded(change.after, std::min(change.gain * in, 1.0f));
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
    }
    return x;  // not reached
}

int DisplayChange::encodings() const { return steps_of(before) + steps_of(after); }

int DisplayChange::count() const {
    return int{upside_down} + int{mirrored} + int{red_blue} + int{encodings() != 0} + int{gain != 1} +
           int{soft};
}

std::array<DisplayChange, 4> ways_of_turning() {
    std::array<DisplayChange, 4> ways;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        ways[i].mirrored = (i & 1) != 0;
        ways[i].upside_down = (i & 2) != 0;
    }
    return ways;
}

std::size_t changed_index(const DisplayChange& change, PictureSize size, int x, int y) {
    return size.index(change.mirrored ? size.width - 1 - x : x, change.upside_down ? size.height - 1 - y : y);
}

ByteRanges byte_ranges(const DisplayChange& change) {
    ByteRanges ranges;
    const bool as_it_is = change.gain == 1 && change.before == Code::Same && change.after == Code::Same;
    constexpr float rounding = 0.5f;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const auto level = static_cast<float>(i);
        if (as_it_is) {
            ranges[i] = {level, level, level};
            continue;
        }
        // 255 may have been any brightness from there on before it was clamped.
        ranges[i] = {changed(change, level - rounding) - rounding, changed(change, level),
                     i == 255 ? 255 : changed(change, level + rounding) + rounding};
    }
    return ranges;
}

}  // namespace glint
