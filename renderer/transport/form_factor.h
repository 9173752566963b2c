#pragma once
// Form factors estimated with random rays. Lecture: "Local vs. Global Illumination" (radiosity).

#include <cstdint>

#include "models/scene/scene.h"

namespace glint {

inline constexpr int max_form_factor_rays = 1'000'000'000;

/// The fraction of the light emitted by the front of an object, uniformly from all points and cosine-weighted
/// in direction, that reaches another object without being blocked.
struct FormFactor {
    double estimate = 0, standard_error = 0;  // the fraction of `rays` independent rays
    std::int64_t rays = 0, arrived = 0;
    double area = 0;  // surface area of the emitting object, in square scene units
};

/// `from`, `to`: indices into Scene::objects, visible and with loaded meshes; they may be equal. The front of
/// a triangle is the side from which its corners are counter-clockwise (clockwise if the object is mirrored).
/// The same seed gives the same numbers for any number of threads (0: all cores). An object without area
/// emits nothing.
[[nodiscard]] FormFactor form_factor(const Scene& scene, std::size_t from, std::size_t to, int rays, int seed,
                                     int threads);

}  // namespace glint
