#pragma once
// A mistake in the list of them: its small picture, a switch, how it is recognised, and who asked.

#include <imgui.h>

#include <string>

#include "models/scene/mistakes.h"
#include "ui/features/views/small_pictures.h"

namespace glint {

/// "clamp_each_light" as a title: "Clamp each light".
[[nodiscard]] std::string title_of(const MistakeName& mistake);

/// Small pictures, and how large they are shown.
struct SmallLook {
    const SmallPictures& pictures;
    PictureSize size;  // in ImGui's units

    [[nodiscard]] ImVec2 extent() const { return {float(size.width), float(size.height)}; }
    /// About a picture, or in its place; empty before it was drawn first.
    [[nodiscard]] std::string words(int index) const;
};

/// Returns the distance between the picture of a row and the row's edges.
[[nodiscard]] float small_inset();

/// Draws a small picture with its corner at `low`, pale while it is of another scene than the open one, or
/// the words in its place.
void draw_small(const SmallLook& look, int index, ImVec2 low);

/// A click anywhere in it switches the mistake. True while it is pointed at. `index`: of its small picture.
[[nodiscard]] bool mistake_row(const MistakeName& mistake, bool& on, const SmallLook& look, int index);

}  // namespace glint
