#pragma once
// Judges explanations of a wrong picture on the whole picture.

#include <vector>

#include "diagnose/diagnose.h"

namespace glint {

/// An explanation judged on the whole picture.
struct Judged {
    MistakeSet mistakes;
    DisplayChange change;
    Score score;
    double cost = 0;
    Drawing drawing;
    bool is_right = false;     // the drawing is the right one, but for a level
    bool is_believed = false;  // it shows the whole picture, and costs less than no mistake does
};

/// The likeliest explanations, those that are believed first. One of them is that there is no mistake.
[[nodiscard]] std::vector<Judged> judge_all(Renderer& renderer, const Scene& scene, const Exhibit& exhibit,
                                            const DiagnosisOptions& options);

/// The one of judge_all() without a mistake.
[[nodiscard]] const Judged& of_no_mistake(const std::vector<Judged>& all);

/// Returns the best few mistakes, each with those that look like it. Leaves out a mistake that its own change
/// at the display undoes, because both together show the right picture. Also leaves out a mistake whose
/// change at the display does not agree with `told`, the change that the diagnosis reports.
[[nodiscard]] std::vector<Candidate> candidates_of(const Exhibit& exhibit, const std::vector<Judged>& all,
                                                   const DisplayChange& told);

}  // namespace glint
