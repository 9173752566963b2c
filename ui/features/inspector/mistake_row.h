#pragma once
// A row in the list of mistakes: its thumbnail, a switch, how to recognise it, and who reported it.

#include <imgui.h>

#include <string>

#include "models/scene/mistakes.h"
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

/// Draws the row; a click anywhere in it toggles the mistake. True while hovered. `index`: of its thumbnail.
[[nodiscard]] bool mistake_row(const MistakeName& mistake, bool& on, const SmallLook& look, int index);

}  // namespace glint
