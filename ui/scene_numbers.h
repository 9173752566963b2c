#pragma once
// Numbers of the scene that stand in a panel and in the equation: range, habits and words, once for both.

#include "ui/widgets.h"

namespace glint {

struct NumberSpec {
    Number number;
    const char* what;  // for the tooltip
};

inline constexpr NumberSpec shininess_spec{{.min = 0,
                                            .max = 10'000,
                                            .initial = 32,
                                            .speed = 0.01f,
                                            .format = "%.1f",
                                            .shown_max = 1000,
                                            .logarithmic = true},
                                           "Exponent of the highlight: more is smaller and sharper"};
inline constexpr NumberSpec roughness_spec{
    {.min = 0, .max = 1, .initial = 0.5f, .speed = 0.004f, .format = "%.2f", .shown_max = 1},
    "0 smooth, 1 rough; Oren–Nayar and Cook–Torrance"};
inline constexpr NumberSpec intensity_spec{{.min = 0, .initial = 1, .speed = 0.005f, .shown_max = 4},
                                           "I: multiplies the light's three colours"};
inline constexpr NumberSpec falloff_constant_spec{{.min = 0, .initial = 1, .speed = 0.004f, .shown_max = 2},
                                                  "c: the same at every distance"};
inline constexpr NumberSpec falloff_linear_spec{{.min = 0, .initial = 0, .speed = 0.004f, .shown_max = 2},
                                                "l: with the distance r, per scene unit"};
inline constexpr NumberSpec falloff_quadratic_spec{{.min = 0, .initial = 0, .speed = 0.004f, .shown_max = 2},
                                                   "q: with its square, as light spreads"};
inline constexpr NumberSpec cutoff_spec{
    {.min = 0, .max = 90, .initial = 30, .speed = 0.1f, .format = "%.1f°", .unit = "°", .shown_max = 90},
    "Angle from the axis to the edge of the cone"};
inline constexpr NumberSpec spot_exponent_spec{
    {.min = 0, .initial = 1, .speed = 0.02f, .format = "%.2f", .shown_max = 64, .logarithmic = true},
    "cos(angle from the axis) to this power: 0 is even, more is softer to the edge"};

/// The same number where it stands in a line of text, with other figures.
[[nodiscard]] constexpr Number shown_as(Number number, const char* format) {
    number.format = format;
    return number;
}

}  // namespace glint
