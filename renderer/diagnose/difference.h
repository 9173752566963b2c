#pragma once
// Finds where a difference lies that no mistake explains: on which objects, and in which term of the
// equation.

#include "renderer/diagnose/diagnose.h"

namespace glint {

struct DescribedDifference {
    std::vector<DifferenceRegion> regions;  // the largest first
    std::vector<DifferenceTerm> terms;      // the likeliest first
    double pixels_left = 0;                 // about how many wrong pixels the likeliest term does not explain
};

/// Of the picture minus the right one after `change` was taken away. `renderer` has drawn the right picture
/// last.
[[nodiscard]] DescribedDifference describe_difference(const Renderer& renderer, const Exhibit& exhibit,
                                                      const DisplayChange& change, const Display& display);

}  // namespace glint
