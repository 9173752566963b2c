#pragma once
// Degrees, the text and the allowed ranges of numbers, and cosines and sines that are the same on every
// machine.

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace glint {

/// One degree in radians.
inline constexpr double degree = std::numbers::pi / 180;

/// The shortest decimals from which the same float is read, as in scene files: "0.1", "-0.0".
[[nodiscard]] std::string number_text(float x);

// The allowed values of a number or a word in a scene: the reader rejects others, the window offers no
// others, and the documentation and the JSON Schema print them.

/// The largest magnitude of a number in a scene or a mesh (docs/limits.md). It keeps products in the lighting
/// equation (max_factor in renderer/lighting/light_job.h) and squared distances within the range of a float.
inline constexpr double max_number = 1e7;

/// The numbers from `low` to `high`, ends included unless they are open, and the number `also` if it is set.
struct Range {
    double low, high;
    std::string_view words;  // for "expected ..."
    bool low_open = false, high_open = false;
    std::optional<double> also = std::nullopt;

    /// Compares in the precision of x: a number that must be above 0 must also be above 0 as a float.
    template <class Real> [[nodiscard]] constexpr bool contains(Real x) const {
        const auto from = static_cast<Real>(low), to = static_cast<Real>(high);
        const bool above = low_open ? x > from : x >= from;
        const bool below = high_open ? x < to : x <= to;
        return (above && below) || (also && x == static_cast<Real>(*also));
    }
};

inline constexpr Range any_number{-max_number, max_number, "a number between -1e7 and 1e7"};
inline constexpr Range at_least_zero{0, max_number, "0 to 1e7"};
inline constexpr Range above_zero{0, max_number, "more than 0, up to 1e7", true};
inline constexpr Range zero_to_one{0, 1, "0 to 1"};
inline constexpr Range half_turn_deg{0, 180, "0 to 180"};

/// One member of a closed set, with its texts for users.
struct Choice {
    std::string_view word;     // in the scene file; ends with '\0', like all literals
    const char* label = "";    // in the window
    const char* meaning = "";  // for tooltips, the documentation and the JSON Schema
};

// Cosine and sine for making meshes. They use only + - x and integers, so a mesh has the same bytes on every
// machine (on a different CPU, a C library may use a different routine that differs in the last bit).

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
