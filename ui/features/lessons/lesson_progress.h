#pragma once
// Remembers the progress in each lesson: a small JSON file next to the window's settings, read as untrusted.

#include <optional>
#include <string>
#include <vector>

#include "ui/features/lessons/course.h"

namespace glint {

struct UiState;

/// A lesson's state in the list of lessons.
struct LessonRecord {
    std::size_t at = 0, stations = 1;  // the last open station, from 0
    CourseScore score;
};

/// Returns the key of a lesson's record, as UTF-8: its name if it comes with the program, else its absolute
/// path.
[[nodiscard]] std::string record_key(const std::string& folder, const std::string& path);

/// Returns the open station, the score, and every answer as JSON.
[[nodiscard]] Json progress_json(const Course& course, const CourseProgress& progress);
/// Reads the output of progress_json() for that lesson; nothing if it no longer matches the questions.
[[nodiscard]] std::optional<CourseProgress> read_progress(const Json& json, const Course& course);
[[nodiscard]] std::optional<LessonRecord> read_record(const Json& json);

/// The records of all lessons, by their keys; none if they cannot be read.
[[nodiscard]] Json lesson_records(const UiState& state);

/// The stored progress of the lesson, else a fresh one.
[[nodiscard]] CourseProgress recall_progress(const UiState& state, const Course& course);
/// Writes the progress of the open lesson if it has changed, unless a lecturer presents it.
void keep_progress(UiState& state);

}  // namespace glint
