#pragma once
// Form factors by random rays. Lecture: "Local vs. Global Illumination" (radiosity).

#include <cstdint>

#include "models/scene/scene.h"

namespace glint {

inline constexpr int max_form_factor_rays = 1'000'000'000;

/// The fraction of the light that leaves the front of an object, evenly from all its points and by the cosine
/// in all directions, and arrives at another object without meeting anything before.
struct FormFactor {
    double estimate = 0, standard_error = 0;  // of a share of `rays` independent rays
    std::int64_t rays = 0, arrived = 0;
    double area = 0;  // of the object that emits, square scene units
};

/// `from`, `to`: in Scene::objects, visible and with loaded meshes; they may be the same. The front of a
/// triangle is the side from which its corners run counter-clockwise (clockwise if the object is mirrored).
/// The same seed gives the same numbers on any number of threads (0: all cores). An object without area emits
/// nothing.
[[nodiscard]] FormFactor form_factor(const Scene& scene, std::size_t from, std::size_t to, int rays, int seed,
                                     int threads);

}  // namespace glint
