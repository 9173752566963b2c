#pragma once
// A row in the list of mistakes: the mistake's thumbnail, switch, appearance and sources.

#include <imgui.h>

#include <cstddef>
#include <span>
#include <string>

#include "models/scene/mistakes.h"
#include "models/scene/scene.h"
#include "ui/features/views/small_pictures.h"

namespace glint {

/// "clamp_each_light" as a title: "Clamp each light".
[[nodiscard]] std::string title_of(const MistakeName& mistake);

/// Thumbnails, and their displayed size.
struct SmallLook {
    const SmallPictures& pictures;
    PictureSize size;  // displayed size, in ImGui's units

    [[nodiscard]] ImVec2 extent() const { return {float(size.width), float(size.height)}; }
    /// The text about a picture, or the text shown in its place; empty before the first drawing.
    [[nodiscard]] std::string words(int index) const;
};

/// Returns the distance between the picture of a row and the row's edges.
[[nodiscard]] float small_inset();

/// Draws a thumbnail with its corner at `low`, pale if it is outdated, or the text in its place.
void draw_small(const SmallLook& look, int index, ImVec2 low);

/// Draws the row; a click anywhere in it toggles the mistake. True while hovered. `index`: of the thumbnail.
[[nodiscard]] bool mistake_row(const MistakeName& mistake, bool& on, const SmallLook& look, int index);

// Thumbnails of the open scene with each mistake, drawn in the background while the mouse is idle and the
// Mistakes tab is visible.

struct UiState;

/// The first text replaces the picture of a mistake that changes nothing. The second is drawn over a picture
/// that is hard to distinguish from the one without mistakes.
inline constexpr const char* no_difference = "no difference here";
inline constexpr const char* hardly_differs = "hardly differs";

/// Samples per pixel of the thumbnails.
inline constexpr int mistake_samples = 4;

struct MistakePictures {
    SmallPictures pictures;  // the first without mistakes, then with each of mistakes_as_seen()
    Scene seen;              // the open scene, as of the last frame
    Scene asked;             // `seen` without mistakes: the pictures do not change when one is switched on
    PictureSize asked_size{0, 0};
    double asked_since = 0;  // time of the last change to the scene or size
    bool begun = false;      // whether the pictures have been started since then
    bool looked_at = false;  // whether they were visible in this frame
};

/// Indices into mistake_names(), in the tab's order: group by group, as in all_seen_as.
[[nodiscard]] std::span<const std::size_t> mistakes_as_seen();

/// Collects finished pictures. Starts again if the scene or size has changed and then stayed the same for a
/// moment with no button down. The tab calls this once a frame.
void look_at_mistake_pictures(UiState& state, PictureSize size);

/// Whether the mistakes of the open scene change any pixel: determined in the background while nothing moves.
struct MistakeEffect {
    Scene of;  // the compared scene
    PictureSize size{0, 0};
    double since = 0;  // ImGui time of the last change to the scene or size
    bool is_known = false, is_none = false;
    JobPtr<bool> job, ending;
};

}  // namespace glint
