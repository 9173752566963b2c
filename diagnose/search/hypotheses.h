#pragma once
// Tries every mistake, alone or in twos, with everything that may have happened at the display, on probes of
// a small picture, and keeps the likeliest to be judged on the whole one.

#include <functional>
#include <vector>

#include "diagnose/search/mistake_set.h"
#include "diagnose/search/probes.h"
#include "models/scene/scene.h"

namespace glint {

/// An explanation of a picture, and what may have happened to it at the display: the likeliest changes first.
struct Hypothesis {
    MistakeSet mistakes;
    std::vector<DisplayChange> changes;
    double cost = 0;  // of the first
};

/// How much a wrong picture speaks against an explanation: `excess` is the sum of excess_of(). One thing more
/// that is supposed to have happened must take away more than half of the excess, and more than `free`.
[[nodiscard]] double explanation_cost(double excess, double free, std::size_t mistakes,
                                      const DisplayChange& change);

/// The search tells it how many explanations have been tried, and of how many, on the thread that asked. An
/// exception that it throws ends the search.
using DiagnosisProgress = std::function<void(std::size_t done, std::size_t all)>;

/// The `count` likeliest explanations, without mistakes that change no byte. The first holds no mistake, the
/// others follow by their costs. `wrong` has any size of the picture's aspect, and noise as DisplayChange has
/// it; `at` is the size to draw at. `progress` counts mistakes, or with `pairs` the twos of them.
[[nodiscard]] std::vector<Hypothesis> likely_hypotheses(const Scene& scene, const Picture& wrong, float noise,
                                                        PictureSize at, bool pairs, std::size_t count,
                                                        int threads, const DiagnosisProgress& progress);

}  // namespace glint
