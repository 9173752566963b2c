#pragma once
// A table of grades for a class: the finding for each submitted file, with points and hints from a rubric.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "models/json/json.h"

namespace glint {

/// Points and advice. Source: docs/command_line.md, "grade".
struct RubricEntry {
    std::optional<double> points;
    std::string hint;
};

struct Rubric {
    std::optional<double> points;  // given to a picture without mistakes
    std::map<std::string, RubricEntry, std::less<>> mistakes, verdicts;
};
/// Problem: not JSON; an unknown key, mistake or verdict; or a wrong type.
[[nodiscard]] Result<Rubric> read_rubric(const std::string& text, const std::string& file);

// Verdicts that a diagnosis does not have.
inline constexpr const char* does_not_compile = "does not compile";
inline constexpr const char* does_not_end = "does not end";
inline constexpr const char* not_judged = "not judged";

/// A row of the table is a JSON object with the fields of `--format json` (docs/command_line.md), and for the
/// page `picture_html` and `reference_html`.
using GradeRow = Json;

/// Adds the rubric's `points` and `hint` to a row.
void apply_rubric(GradeRow& row, const Rubric& rubric);
/// Whether Glint judged the file.
[[nodiscard]] bool is_judged(const GradeRow& row);

[[nodiscard]] std::string grades_text(const std::vector<GradeRow>& rows);
/// One object per row, each on its own line, without the pictures.
[[nodiscard]] std::string grades_json(const std::vector<GradeRow>& rows);
[[nodiscard]] std::string grades_csv(const std::vector<GradeRow>& rows);
/// A self-contained page; `title` is the scene's name.
[[nodiscard]] std::string grades_html(const std::vector<GradeRow>& rows, const std::string& title);
/// A test case per file: a mistake is a failure, a file that was not judged an error.
[[nodiscard]] std::string grades_junit(const std::vector<GradeRow>& rows, const std::string& title);

}  // namespace glint
