#pragma once
// Diagnoses of many pictures of one scene: a row for each.

#include <string>
#include <vector>

#include "diagnose/diagnose.h"

namespace glint {

struct DiagnosedPicture {
    std::string name;  // of its file
    Diagnosis diagnosis;
    Picture thumbnail;  // of the picture as it was brought; empty of one that is not readable
    Picture
        as_explained;  // of the scene under the first candidate, or right where there is none; never bigger
};

/// Fills in the small pictures, at most 160 pixels wide and high.
[[nodiscard]] DiagnosedPicture diagnosed_picture(const std::string& name, Diagnosis diagnosis,
                                                 const Scene& scene, const Picture& wrong, int threads);

/// One JSON object a picture, each on a line of its own (docs/command_line.md has the fields).
[[nodiscard]] std::string diagnoses_json(const std::vector<DiagnosedPicture>& pictures, const Scene& scene);

/// A line of names, then one a picture (RFC 4180, lines ending in "\n"): picture, verdict, mistake, also,
/// explained, residual, display, experiment, why. What there is not is empty.
/// A picture whose name begins as a formula of a spreadsheet does is written with "./" before it.
[[nodiscard]] std::string diagnoses_csv(const std::vector<DiagnosedPicture>& pictures);

/// The diagnoses as a self-contained HTML page, with the small pictures in it. `title` is the scene's name.
[[nodiscard]] std::string diagnoses_html(const std::vector<DiagnosedPicture>& pictures,
                                         const std::string& title);

}  // namespace glint
