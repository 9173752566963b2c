#pragma once
// Remembers how far one has come in each lesson: a small JSON file beside the window's other memory, read as
// untrusted.

#include <optional>
#include <string>
#include <vector>

#include "ui/lessons/course.h"

namespace glint {

struct UiState;

/// What the list of lessons says of one.
struct LessonRecord {
    std::size_t at = 0, stations = 1;  // the station that one was at last, from 0
    CourseScore score;
};

/// Returns the key of a lesson's record, as UTF-8: its name if it comes with the program, else its absolute
/// path.
[[nodiscard]] std::string record_key(const std::string& folder, const std::string& path);

/// Writes as JSON which station is open, the score, and every answer.
[[nodiscard]] JsonValue progress_json(const Course& course, const CourseProgress& progress);
/// Reads what progress_json() has written for that lesson; nothing if it no longer fits the questions.
[[nodiscard]] std::optional<CourseProgress> read_progress(const JsonValue& json, const Course& course);
[[nodiscard]] std::optional<LessonRecord> read_record(const JsonValue& json);

/// The records of all lessons, by their keys; none where they cannot be read.
[[nodiscard]] JsonValue lesson_records(const UiState& state);

/// What is remembered of the lesson, else a fresh beginning.
[[nodiscard]] CourseProgress recall_progress(const UiState& state, const Course& course);
/// Returns `kept`, that another window may have written, with what was done between `before` and `now`. All
/// three are of one course.
[[nodiscard]] CourseProgress with_changes(CourseProgress kept, const CourseProgress& before,
                                          const CourseProgress& now);
/// Writes what has changed since, and leaves what another window has written of the same lesson. Not in a
/// lecturer's hand. While another window writes for longer than `patience` seconds, it is for a later frame.
void keep_progress(UiState& state, double patience = 0);

}  // namespace glint
