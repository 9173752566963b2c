#pragma once
// A lesson in the window: which one is open, how far it has come, and what each step of it does to the scene.
// While a question waits for its answer the picture stands still, and nothing that is read off it is shown.

#include <imgui.h>

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/camera.h"
#include "ui/commands/keys.h"
#include "ui/document/job.h"
#include "ui/document/loading.h"
#include "ui/features/lessons/course.h"
#include "ui/picture/tool.h"

namespace glint {

struct UiState;
struct PictureView;

/// Which tasks of a course's station the scene `of` fulfils.
struct WatchedTasks {
    std::shared_ptr<const Course> course;
    Scene of;
    std::size_t station = 0;
    std::vector<bool> done;  // in the order of the station's tasks; empty where it cannot be told
};

struct LessonState {
    std::string folder;                    // of the lessons that come with the program; empty: none
    std::string inventory;                 // the questions of its quiz; empty: none
    std::shared_ptr<const Course> course;  // null: no lesson is open
    CourseProgress progress;
    bool lecturer = false;  // questions are shown without a way to answer them, and nothing is noted
    bool scrolls_up = false, scrolls_down = false;  // asked for: to the top, to what was just told
    bool takes_keys = false;                        // asked for: what is typed is the answer
    int lays_line = 0;  // frames in which pixel and line are laid where the reveal says: the room changes
    // The answer that is being given to the first open question:
    std::string typed;                     // of a number
    Json chosen;                           // of all other kinds; null: none yet
    std::optional<glm::dvec2> sketched;    // where the hand was on a sketch: (number of the value, value)
    std::unique_ptr<LessonRunner> runner;  // of `watching`: it keeps what it drew
    JobPtr<std::vector<bool>> watching;
    WatchedTasks asked_of;                // what `watching` is about: the lesson may be another by then
    std::optional<WatchedTasks> watched;  // the last answer
    CourseProgress written;               // as the file has it

    [[nodiscard]] const Station& station() const { return course->stations[progress.station]; }
    [[nodiscard]] std::vector<GivenAnswer>& given() { return progress.given[progress.station]; }
    [[nodiscard]] const std::vector<GivenAnswer>& given() const { return progress.given[progress.station]; }
};

/// Begins to open a lesson, whatever its file is called.
[[nodiscard]] Opening opening_of_lesson(const std::string& path);

/// Opens the lesson's column where it was left. Precondition: Course::document is the open document, as
/// take_scene() makes it.
void begin_lesson(UiState& state, std::shared_ptr<const Course> course);
/// The scene stays, the lesson goes.
void leave_lesson(UiState& state);

/// Returns the first question of this station that waits for an answer; nothing if none does.
[[nodiscard]] std::optional<std::size_t> open_question(const LessonState& lesson);

// Whatever opens a scene of the lesson asks first if the open scene was saved under a name and has unsaved
// changes.

/// Goes `steps` stations on, or back if negative, and shows the scene there. At the ends it says so.
void go_on(UiState& state, int steps);
/// Does what PgDn and PgUp do; for a lecturer, PgDn first shows an open answer.
void page_lesson(UiState& state, int steps);
/// Begins the lesson at its first station again, with nothing answered.
void begin_again(UiState& state);
/// Restores the lesson's scene of this station, as one step to undo.
void back_to_scene(UiState& state);
/// Says why what is given to the open question is not an answer yet; empty where it is one.
[[nodiscard]] std::string why_no_answer(const LessonState& lesson);
/// Whether what is given to the open question is an answer.
[[nodiscard]] bool can_lock(const LessonState& lesson);
/// Answers the open question by a key: the letter of an option takes it, Enter locks in what is given. False
/// where the key is for something else.
bool answer_by_key(UiState& state, KeyPress press);
/// Makes the given answer final; after the station's last one, the answers are revealed.
void lock_in(UiState& state);
/// Shows all answers of the station; what was not locked in counts as not answered.
void reveal_unanswered(UiState& state);
/// Whether the scene differs from the lesson's here; a changed view counts too.
[[nodiscard]] bool has_strayed(const UiState& state);

/// Plays what the reveal lets go to and fro, or stops it.
void play_reveal(UiState& state);
/// Marks the answer's number in its tab of the WHY column, for a moment.
void mark_in_equation(UiState& state, const Prediction& question);
/// Asks about the pixel that the reveal names and leads to where the answer's number stands.
void show_in_equation(UiState& state, const Prediction& question);

/// While a question waits, undoes whatever this frame did to its scene. Call it before the picture is drawn.
void hold_lesson(UiState& state);
/// Once a frame: tests the tasks' conditions on the scene in hand and writes the progress.
void poll_lesson(UiState& state);

/// The lesson's column: title, text, question, answer, tasks, and the ways on. Nothing without a lesson.
void lesson_column(UiState& state);
extern const Tool lesson_tool;
/// Draws the places and lines of a station's questions into the picture.
void draw_lesson(ImDrawList& list, UiState& state, const PictureView& view);

/// In a few words what the lesson asks or tells, for a picture without columns; empty without a lesson.
[[nodiscard]] std::string lesson_caption(const UiState& state);

/// A pixel of the lesson's pictures as a share of the window's picture, of the same camera; and back.
[[nodiscard]] glm::dvec2 share_of_lesson_pixel(const UiState& state, glm::dvec2 pixel);
[[nodiscard]] glm::dvec2 lesson_pixel_of_share(const UiState& state, glm::dvec2 share);

/// Returns the number of values in a sketch from A to B: one for each pixel.
[[nodiscard]] std::size_t sketch_length(const Prediction& question);
/// Draws with the mouse: values between `from` and `to`, each (number, value), follow the line; others stay.
/// Null values are not drawn yet.
void sketch(Json& values, std::size_t count, glm::dvec2 from, glm::dvec2 to);

}  // namespace glint
