#pragma once
// A lesson that is ready to work through: its scenes are loaded, its answers computed, and it is divided into
// stations, each with its text, questions, reveal and tasks. Draws nothing.

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lessons/lesson.h"
#include "lessons/run_lesson.h"

namespace glint {

/// A question with the right answer for the station's scene.
struct StationQuestion {
    const Prediction* asks = nullptr;  // question in Course::lesson
    RightAnswer right;
};

/// A part that follows the answer: text, or a task.
struct StationPart {
    const std::vector<ProseBlock>* told = nullptr;  // either text or a task
    const Task* task = nullptr;
};

/// The parts from one question to the next: text, questions, the reveal once all of them are answered, and
/// the parts after it. A station without a question is revealed at once.
struct Station {
    std::size_t step = 0;  // index into Lesson::steps
    std::vector<const std::vector<ProseBlock>*> before;
    std::vector<StationQuestion> questions;
    const Reveal* reveal = nullptr;  // null: none
    std::vector<StationPart> after;
    Scene asked, revealed;  // the step's scene, and the same with the reveal's changes
};

struct Course {
    Lesson lesson;
    SceneDocument document;  // the lesson's scene with its meshes; has no path, so saving overwrites nothing
    std::vector<Station> stations;  // at least one; they point into `lesson`
};

/// Reads the lesson's file, loads its scene, and computes its answers. A problem is one line of text that
/// includes the line number. Ends early when this thread's load is cancelled (models/progress.h).
[[nodiscard]] Result<std::shared_ptr<const Course>> open_course(const std::string& path);

/// Whether a path names a lesson, that is, ends in .md.
[[nodiscard]] bool is_lesson_file(const std::string& path);

/// A user's answer to a question, and whether it is final.
struct GivenAnswer {  // NOLINT(bugprone-exception-escape): moving a Json does not throw
    Json value;       // null: not given yet
    bool locked = false, skipped = false;
    std::string why{};  // the user's reason, or empty
    [[nodiscard]] bool is_over() const { return locked || skipped; }
    bool operator==(const GivenAnswer&) const = default;
};

/// A locked-in answer is right if it is within the tolerance.
[[nodiscard]] bool is_right(const StationQuestion& question, const GivenAnswer& given);

/// A user's progress in a lesson; structured like the lesson's stations.
struct CourseProgress {
    std::size_t station = 0;
    std::vector<std::vector<GivenAnswer>> given;
    std::vector<std::vector<bool>> tasks;  // whether each is done, in the order of the parts
    bool operator==(const CourseProgress&) const = default;
};
[[nodiscard]] CourseProgress fresh_progress(const Course& course);

/// Whether all questions of the station are answered.
[[nodiscard]] bool is_answered(const CourseProgress& progress, std::size_t station);

/// The numbers of questions, answers, right answers, tasks and completed tasks.
struct CourseScore {
    int questions = 0, locked = 0, right = 0, tasks = 0, done = 0;
};
[[nodiscard]] CourseScore score_of(const Course& course, const CourseProgress& progress);

// Remembers the progress in each lesson in a small JSON file next to the window's settings: untrusted input.

struct UiState;

/// A lesson's state in the list of lessons.
struct LessonRecord {
    std::size_t at = 0, stations = 1;  // the last open station, counted from 0
    CourseScore score;
};

/// Returns the key of a lesson's record, as UTF-8: its name if it comes with the program, otherwise its
/// absolute path.
[[nodiscard]] std::string record_key(const std::string& folder, const std::string& path);

/// Returns the open station, the score, and every answer as JSON.
[[nodiscard]] Json progress_json(const Course& course, const CourseProgress& progress);
/// Reads the output of progress_json() for that lesson; nullopt if it no longer matches the questions.
[[nodiscard]] std::optional<CourseProgress> read_progress(const Json& json, const Course& course);
[[nodiscard]] std::optional<LessonRecord> read_record(const Json& json);

/// The records of all lessons, by key; an empty object if they cannot be read.
[[nodiscard]] Json lesson_records(const UiState& state);

/// The stored progress of the lesson, or fresh progress if there is none.
[[nodiscard]] CourseProgress recall_progress(const UiState& state, const Course& course);
/// Writes the progress of the open lesson if it has changed, unless a lecturer is presenting it.
void keep_progress(UiState& state);

}  // namespace glint
