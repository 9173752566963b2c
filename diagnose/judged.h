#pragma once
// The parts of a diagnosis: judges explanations on the complete picture, finds display changes, and describes
// what no explanation covers.

#include <algorithm>
#include <vector>

#include "diagnose/diagnose.h"

namespace glint {

/// An explanation judged on the whole picture.
struct Judged {
    Supposition explanation;
    std::vector<Supposition> same;  // others that give the same picture
    DisplayChange change;
    Score score;
    double cost = 0;
    Drawing drawing;
    bool is_right = false;  // same picture as the correct scene to within a level, or only conventions differ
    bool is_lossy = false;  // individual pixels differ, but the means of squares hardly do
    bool is_almost = false;    // believed, but a small residual remains
    bool is_believed = false;  // it explains the entire picture, and costs less than "no mistake"

    /// Whether the explanation assumes nothing about the scene and its program.
    [[nodiscard]] bool is_plain() const {
        const Supposition& e = explanation;
        return e.kind == ExplanationKind::Right && e.conventions.empty() && e.tone == ToneCurve::None;
    }
};

/// The likeliest explanations, believed ones first. They include the explanation that the picture is right.
[[nodiscard]] std::vector<Judged> judge_all(Renderer& renderer, const Scene& scene, const Exhibit& exhibit,
                                            const DiagnosisOptions& options);

/// Returns the element of judge_all() that assumes no mistake.
[[nodiscard]] const Judged& of_no_mistake(const std::vector<Judged>& all);

/// Returns the best few mistakes, each with those that look like it. Leaves out a mistake that is undone by
/// its own display change, because the two together show the correct picture. Also leaves out a mistake whose
/// display change does not match `told`, the change that the diagnosis reports.
[[nodiscard]] std::vector<Candidate> candidates_of(const Exhibit& exhibit, const std::vector<Judged>& all,
                                                   const DisplayChange& told);

/// `drawn`: the drawing that explains the picture under `change`.
[[nodiscard]] DisplayFinding display_finding(const Exhibit& exhibit, const Drawing& drawn,
                                             const DisplayChange& change);

/// Whether the picture's background differs from the drawing's, as is and after the change.
[[nodiscard]] bool has_other_background(const Exhibit& exhibit, const Drawing& drawn,
                                        const DisplayChange& change);

/// Whether the picture, flipped like `turned`, shows something in a large part of the scene's background.
[[nodiscard]] bool covers_background(const Exhibit& exhibit, const DisplayChange& turned);

/// How a picture's outline differs from the scene's, as shares from 0 to 1.
struct OutlineMisfit {
    double outside = 1;  // of the scene's background: where the picture shows something
    double inside = 1;   // of the surfaces that differ from the background in the correct picture: where the
                         // picture shows the background
    [[nodiscard]] double most() const { return std::max(outside, inside); }
};
/// Returns the misfit of the flipped picture; nothing if it is unknown.
[[nodiscard]] std::optional<OutlineMisfit> outline_misfit(const Exhibit& exhibit,
                                                          const DisplayChange& turned);

/// Why the picture cannot be of this scene; nothing if its outline matches the scene's or is unknown.
[[nodiscard]] std::optional<std::string> other_outline(const Exhibit& exhibit);

struct DescribedDifference {
    std::vector<DifferenceRegion> regions;  // the largest region first
    std::vector<DifferenceTerm> terms;      // the likeliest term first
    double pixels_left = 0;                 // about how many wrong pixels the likeliest term does not explain
};

/// Describes the difference from the correct picture after undoing `change`. Precondition: the last picture
/// that `renderer` drew is the correct one.
[[nodiscard]] DescribedDifference describe_difference(const Renderer& renderer, const Exhibit& exhibit,
                                                      const DisplayChange& change, const Display& display);

}  // namespace glint
