#pragma once
// Arrows, arcs and letters, drawn so that they can be read on any picture: a dark rim below a bright line.

#include <imgui.h>

#include <glm/vec3.hpp>
#include <string>

#include "ui/gizmo.h"
#include "ui/theme.h"

namespace glint {

/// Where things are drawn that live in the world at one point.
struct WorldPen {
    ImDrawList& list;
    const PictureView& view;
    glm::dvec3 origin{0};  // world
    double reach = 1;      // scene units: how long a unit vector is drawn

    /// On the window; the place `offset` times the reach away from the origin.
    [[nodiscard]] ImVec2 at(glm::dvec3 offset) const;
};

/// A pen at `origin` whose unit vectors are `length` units of the design long when seen from the side.
[[nodiscard]] WorldPen pen_at(ImDrawList& list, const PictureView& view, glm::dvec3 origin, float length);

struct ArrowLook {
    ImVec4 colour;
    float width = 2;  // units of the design
    const char* letter = "";
};
/// From `from` to `to` with its letter at the tip; where the arrow points at us or away, a circle with a dot.
void draw_arrow(ImDrawList& list, ImVec2 from, ImVec2 to, const ArrowLook& look);

inline const ImVec2 nowhere{-1e6f, -1e6f};

/// The arc from direction a to b (unit) with its degrees, at `radius` of the pen's reach. The degrees are
/// left out where there is no room, and where they would cover what is written at `taken`. Where they stand,
/// or nowhere.
ImVec2 draw_arc(const WorldPen& pen, glm::dvec3 a, glm::dvec3 b, double radius, const ImVec4& colour,
                ImVec2 taken = nowhere);

/// Text with a dark rim, its middle at `centre`.
void rimmed_text(ImDrawList& list, ImVec2 centre, const ImVec4& colour, const std::string& text);

}  // namespace glint
