#pragma once
// Lights drawn where they are: a handle in the light's own colour, what kind it is, and a stem to its foot on
// the ground so that depth can be judged.

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "ui/picture/picture_view.h"

namespace glint {

struct Handle {
    int light = 0;
    glm::dvec3 place{0};  // world
    OnScreen at;
    bool in_picture = false;  // else `at.pixel` is on the picture's border, towards where the light is
};

/// Handles of the scene's lights, in their order: of the first 300, which is more than an eye tells apart,
/// and of `selected` (-1: none).
[[nodiscard]] std::vector<Handle> light_handles(const Scene& scene, const PictureView& view, int selected);

/// The handle under the cursor (in the picture's pixels), or null; the nearest wins.
[[nodiscard]] const Handle* handle_under(const std::vector<Handle>& handles, glm::dvec2 cursor_px,
                                         const PictureView& view);

/// How a handle is to be drawn.
struct HandleLook {
    bool selected = false, hovered = false;
    bool hidden = false;  // behind an object
    bool stem = true;     // down to the ground; among many lights only the one in hand has it
    std::optional<glm::dvec3> shape_in_hand;  // the part of its shape under the hand, world
};
void draw_handle(ImDrawList& list, const PictureView& view, const Light& light, const Handle& handle,
                 HandleLook look);

/// A note beside the cursor: a title and lines of figures, kept inside the picture.
void draw_note(ImDrawList& list, const PictureView& view, ImVec2 at, const std::string& title,
               const std::string& numbers);

}  // namespace glint
