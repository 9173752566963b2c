#pragma once
// Cosine and sine for making meshes. They use only + - x and integers, so that a mesh has the same bytes on
// every machine (on another CPU a C library may use a different routine that differs in the last bit).

#include <cstdint>

namespace glint {

struct CosSin {
    double c, s;
};

/// Cosine and sine of the angle 2 pi k / n, n >= 1, |k| and n below 2^59. Exactly symmetric: eighths of a
/// turn are reflections of one another, and the results on the four axes are exact. Error below 1e-15.
[[nodiscard]] CosSin on_circle(std::int64_t k, std::int64_t n);

/// Cosine and sine of an angle in radians, |angle| below 1000. Error below 1e-13.
[[nodiscard]] CosSin cos_sin(double angle);

/// The angle in radians, 0 to pi, of the direction (x, y) with y >= 0; 0 for (0, 0). Error below 1e-9.
[[nodiscard]] double angle_of(double x, double y);

}  // namespace glint
