#pragma once
// The window helps in a lecture: with large type, a clean picture, freeze, pen, a step wedge.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/scene/scene.h"
#include "ui/picture/pen.h"

namespace glint {

// The wedge has patches that differ little from their ground: a projector, in its room, tells some apart.

/// Differences in steps of 1/255 of the display's range.
inline constexpr std::array<int, 10> wedge_steps{1, 2, 3, 4, 6, 8, 12, 16, 24, 32};

/// The patches on one ground, and which of them are seen.
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

/// The meaning of a row's answer: "On black, differences below 6/255 are swallowed: a colour of 0.02 is
/// black."
[[nodiscard]] std::string wedge_words(const WedgeRow& row);

/// Covers the whole window while it is open.
void step_wedge(WedgeState& wedge);

// The scenes of a folder, in the order in which a person would count them.

/// Numbers within names count as numbers, capitals do not: "Step 2" < "step 10" < "step 10b".
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

/// The scene files (.json) of a folder in that order, as paths. Hidden ones are left out; empty when the
/// folder cannot be read.
[[nodiscard]] std::vector<std::string> folder_scenes(const std::string& folder);

/// The scene `step` places after `path` (before it, when negative) in its folder; for a path that is not in
/// the list the one that would be next to it. Empty when there is none.
[[nodiscard]] std::string scene_beside(const std::string& path, int step);

/// Type and widgets are so many times larger: the smallest type, 13 units, becomes 18.
inline constexpr float projector_scale = 1.4f;

struct LectureState {
    bool projector = false;           // large type, strong contrast
    bool hid_columns_before = false;  // the layout that it found
    std::optional<Scene> frozen;      // shown whatever is edited
    PenState pen;
    WedgeState wedge;
};

}  // namespace glint
