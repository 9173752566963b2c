#pragma once
// What is typed into a number's field: a number, or a small calculation. No drawing.

#include <string>
#include <string_view>

namespace glint {

struct Calculated {
    double value = 0;     // finite where `problem` is empty
    std::string problem;  // what is wrong, a clause: "“)” is missing"
};

/// Calculates + − * / ^ ( ), also written × · and ÷, with pi (π), deg (π/180), sqrt, abs, and sin, cos, tan
/// of radians. A comma is a decimal point. A unit sign at the end (° or px) is passed over.
///
/// What begins with + * or / goes on from `before`: "+0.1", "*2", "/2"; so do "+=0.1", "-=0.1", "*=2", "/=2".
/// "-0.1" is the number below 0. Problem: a text that is empty, says something else, or has no finite value.
[[nodiscard]] Calculated calculated(std::string_view text, double before);

}  // namespace glint
