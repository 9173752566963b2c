#pragma once
// How a highlight might fall off, and which power of a cosine comes nearest. Lecture: "How might we model
// this falloff?"

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "models/scene/shading.h"

namespace glint {

/// Shapes that could stand in place of cos^n: a bell and a straight line, each 1 at 0 degrees and 1/2 where
/// cos^n is.
enum class HighlightShape { Gaussian, Linear };

/// The angle in degrees where cos^n is 1/2: 60 for n = 1; 90 where it stays above (n near 0). n >= 0.
[[nodiscard]] double half_angle_deg(double n);

/// (degrees, value) from 0 to 90.
[[nodiscard]] std::vector<glm::dvec2> highlight_shape(HighlightShape shape, double n, int steps);

struct HighlightFit {
    double shininess = 0;  // 0 to 10,000
    double error = 0;      // root of the mean square of what is left
};
/// The shininess with which a reflection model's highlight (Phong or Blinn-Phong, light at the normal) comes
/// nearest to points (degrees from the highlight's middle, 0 to 90; value), by least squares. Nothing with
/// fewer than two points.
[[nodiscard]] std::optional<HighlightFit> fitted_highlight(Reflection reflection,
                                                           std::span<const glm::dvec2> points);

/// The shininess n' with which Blinn-Phong's highlight comes nearest to Phong's with `shininess` (>= 0), by
/// least squares over angles from 0 to 90 degrees. About 4 n.
[[nodiscard]] double blinn_shininess_like(float shininess);

}  // namespace glint
