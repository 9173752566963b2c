#pragma once
// Parses the text of a number field: a number or a small calculation. Does not draw.

#include <string>
#include <string_view>

namespace glint {

struct Calculated {
    double value = 0;     // finite if `problem` is empty
    std::string problem;  // the error, a clause: "“)” is missing"
};

/// Calculates + − * / ^ ( ), also written × · and ÷, with pi (π), deg (π/180), sqrt, abs, and sin, cos, tan
/// of radians. A comma is a decimal point. A unit sign at the end (° or px) is ignored.
///
/// A text that begins with +, * or / continues from `before`: "+0.1", "*2", "/2"; so do "+=0.1", "-=0.1",
/// "*=2" and "/=2". But "-0.1" is a negative number. Problem: the text is empty, is not a calculation, or has
/// no finite value.
[[nodiscard]] Calculated calculated(std::string_view text, double before);

}  // namespace glint
