#pragma once
// Formats a diagnosis as text, as JSON (docs/command_line.md lists the fields), and as a picture.

#include <optional>
#include <string>
#include <string_view>

#include "diagnose/diagnose.h"
#include "renderer/image/sheet.h"

namespace glint {

/// "no mistake", "left out", "another setting", "mistake", "another number", "not in the catalogue", "not
/// comparable", "not readable".
[[nodiscard]] std::string_view verdict_text(Verdict verdict);
/// The parts of the display finding as text, joined by "; "; empty if nothing was found.
[[nodiscard]] std::string display_text(const DisplayFinding& display);

/// "12 %"; "less than 1 %" for a share that is not 0 but would round to 0 %.
[[nodiscard]] std::string percent_text(double share);
/// The share of the wrong pixels that a candidate explains, in per cent. Rounded down, so that a share just
/// below a threshold is not printed as the threshold.
[[nodiscard]] int explained_percent(const Candidate& candidate);

/// The diagnosis as text of at most five lines that ends with a newline. `scene` is the one that was
/// diagnosed. For JSON, see diagnoses_json().
[[nodiscard]] std::string diagnosis_text(const Diagnosis& diagnosis, const Scene& scene);
/// The experiment as one line that ends with a newline, and as JSON. Without an experiment, a line that
/// says so, and null.
[[nodiscard]] std::string experiment_text(const std::optional<Experiment>& experiment);
[[nodiscard]] std::string experiment_json(const std::optional<Experiment>& experiment);

/// Returns the picture as it was drawn: the right way up, channels in order, gain and encoding removed.
[[nodiscard]] Picture undone(const Picture& wrong, const DisplayChange& change);
/// Four pictures in a row: the given one, the right way up and with its channels in order; the correct one
/// and the first candidate's, as that display would show them; and the difference between the first two.
/// Without a candidate there are three.
[[nodiscard]] Picture diagnosis_sheet(const Diagnosis& diagnosis, const Scene& scene, const Picture& wrong,
                                      const Font& font, int threads);
/// The size of the sheet in pixels.
[[nodiscard]] PictureSize diagnosis_sheet_size(const Diagnosis& diagnosis, const Font& font);

/// The gain that a candidate assumes, if it differs from the reported one:
/// "with brightness multiplied by 0.04"; otherwise empty.
[[nodiscard]] std::string own_brightness(const Diagnosis& diagnosis, const Candidate& candidate);

// Diagnoses of many pictures of one scene: one row each.

struct DiagnosedPicture {
    std::string name;  // the name of the picture's file
    Diagnosis diagnosis;
    Picture thumbnail;     // of the submitted picture; empty if it is not readable
    Picture as_explained;  // the scene under the first candidate, or the correct one if there is none
};

/// Fills in the thumbnails, which are at most 160 pixels wide and high.
[[nodiscard]] DiagnosedPicture diagnosed_picture(const std::string& name, Diagnosis diagnosis,
                                                 const Scene& scene, const Picture& wrong, int threads);

/// One JSON object per picture, each on its own line (docs/command_line.md lists the fields).
[[nodiscard]] std::string diagnoses_json(const std::vector<DiagnosedPicture>& pictures, const Scene& scene);

/// A line of column names, then one line per picture (RFC 4180, lines ending in "\n"): picture, verdict,
/// mistake, also, explained, residual, display, experiment, why. Missing values are empty.
/// A picture's name that begins like a spreadsheet formula gets the prefix "./".
[[nodiscard]] std::string diagnoses_csv(const std::vector<DiagnosedPicture>& pictures);

/// The diagnoses as a self-contained HTML page, with thumbnails. `title` is the scene's name.
[[nodiscard]] std::string diagnoses_html(const std::vector<DiagnosedPicture>& pictures,
                                         const std::string& title);

}  // namespace glint
