#pragma once
// A half-disc of directions above a surface: angles from the normal, lengths for amounts.

#include "ui/plots/plot.h"

namespace glint {

/// n points up; an amount of `most` reaches the rim.
struct PolarArea {
    ImVec2 centre;
    float radius = 1;
    double most = 1;

    /// Where `amount` in the direction `deg` from n (positive to the right) lies.
    [[nodiscard]] ImVec2 at(double deg, double amount) const;
};

/// Draws surface, rim, a ring with its number and n into `all`, as large as fits, `most` > 0.
[[nodiscard]] PolarArea draw_polar_axes(ImDrawList& list, const Rect& all, double most);

/// A closed outline of (degrees, amount).
void draw_polar_curve(ImDrawList& list, const PolarArea& area, std::span<const glm::dvec2> curve,
                      const ImVec4& colour, float width = 1.6f);

/// An arrow from the rim to the centre (arriving) or out to the rim, with its letter.
void draw_direction(ImDrawList& list, const PolarArea& area, double deg, const ImVec4& colour,
                    const char* letter, bool arrives);

}  // namespace glint
