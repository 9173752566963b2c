#pragma once
// A diagnosis for people and for programs (docs/interface.md has the fields), and as a picture.

#include <optional>
#include <string>
#include <string_view>

#include "renderer/diagnose/diagnose.h"
#include "renderer/inspect/debug_views/sheet.h"

namespace glint {

/// "no mistake", "mistake", "not in the catalogue", "not comparable".
[[nodiscard]] std::string_view verdict_text(Verdict verdict);
/// What was taken away, in words, "; " between; empty when nothing was.
[[nodiscard]] std::string display_text(const DisplayFinding& display);

/// At most five lines; ends with a newline. `scene` is the one that was diagnosed.
[[nodiscard]] std::string diagnosis_text(const Diagnosis& diagnosis, const Scene& scene);
[[nodiscard]] std::string diagnosis_json(const Diagnosis& diagnosis, const Scene& scene);
/// One line that ends with a newline, and JSON; nothing was found: says so, null.
[[nodiscard]] std::string experiment_text(const std::optional<Experiment>& experiment);
[[nodiscard]] std::string experiment_json(const std::optional<Experiment>& experiment);

/// Four pictures in a row: the one that was brought, with what was taken away undone but for its curve and
/// gain; the right one and the first candidate as that display would show them; and the differences of the
/// first two. Without a candidate there are three.
[[nodiscard]] Picture diagnosis_sheet(const Diagnosis& diagnosis, const Scene& scene, const Picture& wrong,
                                      const Font& font, int threads);
/// Its size in pixels.
[[nodiscard]] PictureSize diagnosis_sheet_size(const Diagnosis& diagnosis, const Font& font);

}  // namespace glint
