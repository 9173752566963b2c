#pragma once
// Draws lines of the world over the picture.

#include <imgui.h>

#include "ui/picture/picture_view.h"

namespace glint {

struct WorldPen {
    ImDrawList& list;
    const PictureView& view;

    /// Cut where it passes the eye.
    void line(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float width) const;
    /// Light on dark, so that it is seen on every picture.
    void cased(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float opacity) const;
    /// centre + cos u + sin v.
    void circle(glm::dvec3 centre, glm::dvec3 u, glm::dvec3 v, ImU32 colour, float opacity) const;
    /// A small disc with a dark rim; larger when the hand is on it.
    void mark(glm::dvec3 place, ImU32 colour, float opacity, bool hovered) const;
};

}  // namespace glint
