#pragma once
// One quantity behind the picture in place of its colours, with a colour bar that says what they mean; and
// stripes over what is too bright to be shown.

#include <imgui.h>

#include <memory>
#include <optional>
#include <string>

#include "renderer/inspect/debug_views/look.h"
#include "ui/picture/picture_view.h"

namespace glint {

/// What is looked at: changes to it change the picture.
struct LookSet {
    LookChoice choice;
    bool over_range = false;  // stripes where a channel exceeds 1
    bool operator==(const LookSet&) const = default;
};

struct LookState {
    LookSet set;
    std::unique_ptr<LookPainter> painter;  // once it was needed
    Picture striped;
    std::uint64_t clipped = 0;  // striped pixels
};

struct LookInfo {
    Look look;
    const char* label;
    const char* what;
};
/// What the window says of a look.
[[nodiscard]] const LookInfo& info_of(Look look);

/// The next look after `look`, or the one before it, round and round.
[[nodiscard]] Look look_after(Look look, int steps);

/// Draws drop-downs for the look and its light into the current line. True when a look was chosen.
bool look_controls(LookState& state, const Scene& scene);

/// The colour bar in the picture's lower left corner, with the values at the picked pixel and at the cursor.
void draw_look_legend(ImDrawList& list, const LookState& state, const Scene& scene, const PictureView& view,
                      std::optional<glm::ivec2> picked);

}  // namespace glint
