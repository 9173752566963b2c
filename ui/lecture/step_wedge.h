#pragma once
// Patches that differ little from their ground: which of them a projector, in its room, still tells apart.

#include <array>
#include <string>

namespace glint {

/// Differences in steps of 1/255 of the display's range.
inline constexpr std::array<int, 10> wedge_steps{1, 2, 3, 4, 6, 8, 12, 16, 24, 32};

/// A ground and what is seen on it.
struct WedgeRow {
    const char* name;  // "black"
    int ground;        // 0 .. 255
    int sign;          // patches are ground + sign * step
    int seen = -1;     // index of the smallest step seen; -1: not asked yet; wedge_steps.size(): none
    bool operator==(const WedgeRow&) const = default;
};

struct WedgeState {
    bool open = false;
    std::array<WedgeRow, 3> rows{{{"black", 0, 1}, {"grey", 128, 1}, {"white", 255, -1}}};
};

/// What a row's answer means: "On black, differences below 6/255 are swallowed: a colour of 0.02 is black."
[[nodiscard]] std::string wedge_words(const WedgeRow& row);

/// The whole window, while it is open.
void step_wedge(WedgeState& wedge);

}  // namespace glint
