#pragma once
// A diagnosis for people and for programs (docs/command_line.md has the fields), and as a picture.

#include <optional>
#include <string>
#include <string_view>

#include "diagnose/diagnose.h"
#include "renderer/image/sheet.h"

namespace glint {

/// "no mistake", "mistake", "not in the catalogue", "not comparable", "not readable".
[[nodiscard]] std::string_view verdict_text(Verdict verdict);
/// The display finding in words, joined by "; "; empty when nothing was found.
[[nodiscard]] std::string display_text(const DisplayFinding& display);

/// "12 %"; "less than 1 %" of a share that is not 0 and would round to it.
[[nodiscard]] std::string percent_text(double share);
/// The share of the wrong pixels that a candidate explains, in whole per cent, rounded down: what is too few
/// does not read as enough.
[[nodiscard]] int explained_percent(const Candidate& candidate);

/// The diagnosis as text of at most five lines that ends with a newline. `scene` is the one that was
/// diagnosed. As JSON: diagnoses_json().
[[nodiscard]] std::string diagnosis_text(const Diagnosis& diagnosis, const Scene& scene);
/// The experiment as one line that ends with a newline, and as JSON; without an experiment, a line that says
/// so, and null.
[[nodiscard]] std::string experiment_text(const std::optional<Experiment>& experiment);
[[nodiscard]] std::string experiment_json(const std::optional<Experiment>& experiment);

/// Four pictures in a row: the given one, the right way up and with its channels in order; the right one and
/// the first candidate's as that display would show them; and the difference of the first two. Without a
/// candidate there are three.
[[nodiscard]] Picture diagnosis_sheet(const Diagnosis& diagnosis, const Scene& scene, const Picture& wrong,
                                      const Font& font, int threads);
/// The size of the sheet in pixels.
[[nodiscard]] PictureSize diagnosis_sheet_size(const Diagnosis& diagnosis, const Font& font);

/// "Or the specular term of Sun is left out: that shows the same." `term`: Diagnosis::left_out.
[[nodiscard]] std::string left_out_text(const DifferenceTerm& term, const Scene& scene);

/// What a candidate supposes of the brightness beyond what is said to have happened at the display:
/// "with all brightness times 0.04"; empty where that is nothing.
[[nodiscard]] std::string own_brightness(const Diagnosis& diagnosis, const Candidate& candidate);

}  // namespace glint
