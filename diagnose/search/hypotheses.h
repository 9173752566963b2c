#pragma once
// Tries explanations together with display changes at probes, and keeps the likeliest to be judged on the
// complete picture.

#include <functional>
#include <vector>

#include "diagnose/search/drawings.h"
#include "diagnose/search/probes.h"
#include "diagnose/search/supposition.h"
#include "models/scene/scene.h"

namespace glint {

/// An explanation of a picture, and possible changes at the display, the likeliest first.
struct Hypothesis {
    Supposition explanation;
    std::vector<DisplayChange> changes;
    std::vector<Supposition> same;  // others with the same colours at the probes
    double cost = 0;                // of the first change
};

/// The cost of an explanation, lower is likelier: log2(excess + free), plus the cost of believing it, plus 1
/// for each part of the change. So a further change must more than halve `excess` + `free`. `excess` is the
/// sum of excess_of().
[[nodiscard]] double explanation_cost(double excess, double free, double belief, const DisplayChange& change);

/// Called with the number of finished steps and of all steps, on the thread that started the search. An
/// exception that it throws ends the search.
using DiagnosisProgress = std::function<void(std::size_t done, std::size_t all)>;

struct SearchJob {
    const Picture &wrong, &right;  // right: without mistakes
    const std::vector<PixelKind>& kinds;
    float noise = 0;              // of DisplayChange
    std::array<bool, 4> turns{};  // which flips are tried: see way_turned()
    bool pairs = false;
    const std::vector<std::string>& declared;  // conventions that the program is known to have
    std::size_t count = 12;
    DiagnosisProgress progress;
};

/// Returns the likeliest explanations. The first is that the picture is right, without conventions; the
/// others are sorted by cost.
[[nodiscard]] std::vector<Hypothesis> likely_hypotheses(Drawings& drawings, const SearchJob& job);

}  // namespace glint
