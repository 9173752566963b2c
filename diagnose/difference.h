#pragma once
// Finds where a difference lies that no mistake explains: on which objects, and in which term of the
// equation.

#include <cstddef>

#include "diagnose/diagnose.h"

namespace glint {

struct DescribedDifference {
    std::vector<DifferenceRegion> regions;  // the largest first
    std::vector<DifferenceTerm> terms;      // the likeliest first
    std::size_t pixels = 0;                 // that are wrong, where they are counted
    double pixels_left = 0;                 // about how many of these the likeliest term does not explain
};

/// Of the picture minus the right one after `change` was taken away. `renderer` has drawn the right picture
/// last. Pixels are counted where `mistaken` differs visibly from the right picture, where there is such a
/// picture.
[[nodiscard]] DescribedDifference describe_difference(const Renderer& renderer, const Exhibit& exhibit,
                                                      const DisplayChange& change, const Display& display,
                                                      const Picture* mistaken = nullptr);

}  // namespace glint
