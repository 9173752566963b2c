#pragma once
// Small pictures of the open scene under each mistake alone, drawn in the background while the mouse rests
// and the tab of mistakes is looked at.

#include <cstddef>
#include <span>

#include "models/scene/mistakes.h"
#include "models/scene/scene.h"
#include "ui/features/views/small_pictures.h"

namespace glint {

struct UiState;

/// The first replaces the picture of a mistake that changes nothing; the second lies over one that can hardly
/// be told from the scene without it.
inline constexpr const char* no_difference = "no difference here";
inline constexpr const char* hardly_differs = "hardly differs";

/// Samples a pixel of these pictures.
inline constexpr int mistake_samples = 4;

struct MistakePictures {
    SmallPictures pictures;  // the first without mistakes, then under each of mistakes_as_seen()
    Scene seen;              // the open scene, as of the last frame
    Scene asked;             // `seen` without mistakes: the pictures do not change when one is switched on
    PictureSize asked_size{0, 0};
    double asked_since = 0;  // time at which scene and size became what they are
    bool begun = false;      // since then the pictures were begun
    bool looked_at = false;  // in this frame
};

/// Places in mistake_names(), in the order of the tab: group by group, as all_seen_as has them.
[[nodiscard]] std::span<const std::size_t> mistakes_as_seen();

/// Takes what has been drawn, and begins anew if the scene or size has changed and stood still for a moment
/// with no button down. The tab calls this once a frame.
void look_at_mistake_pictures(UiState& state, PictureSize size);

/// Ends the drawing and keeps no mesh if nobody has looked at the pictures in this frame. Call it after
/// everything that might have.
void rest_mistake_pictures(MistakePictures& of_mistakes);

}  // namespace glint
