#pragma once
// A lesson in the window: the open one, its progress, and the effect of each step on the scene. While a
// question is unanswered, the picture is frozen and values read from it are hidden.

#include <imgui.h>

#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/json/json.h"
#include "models/scene/scene.h"
#include "ui/commands/keys.h"
#include "ui/document/job.h"
#include "ui/document/loading.h"
#include "ui/features/lessons/course.h"
#include "ui/picture/tool.h"

namespace glint {

struct UiState;
struct PictureView;

/// Which of a station's tasks the scene `of` fulfils.
struct WatchedTasks {
    std::shared_ptr<const Course> course;
    Scene of;
    std::size_t station = 0;
    std::vector<bool> done;  // in the order of the station's tasks; empty if unknown
};

/// The document that was open before the lessons.
struct SceneBefore {
    SceneDocument document;
    Scene saved;
    Camera saved_edited_camera;
    History history;
    Selection selection;
};

struct LessonState {
    std::string folder;                    // folder of the lessons that come with the program; empty: none
    std::string inventory;                 // file of the quiz's questions; empty: none
    std::shared_ptr<const Course> course;  // null: no lesson is open
    std::optional<SceneBefore> before;
    CourseProgress progress;
    bool lecturer = false;  // questions are shown without answer fields, and nothing is recorded
    bool scrolls_up = false, scrolls_down = false;  // requested: scroll to the top; to the newest text
    bool takes_keys = false;                        // requested: focus the answer field
    int lays_line = 0;  // remaining frames in which to place the reveal's pixel and line again
    // The answer being given to the first open question:
    std::string typed;                     // typed answer to a number question
    std::string reason;                    // the user's reason for the answer; may stay empty
    Json chosen;                           // answer to any other kind of question; null: none yet
    std::optional<glm::dvec2> sketched;    // the last position in a sketch: (index of the value, value)
    std::unique_ptr<LessonRunner> runner;  // used by `watching`; it caches its pictures
    JobPtr<std::vector<bool>> watching;
    WatchedTasks asked_of;  // what `watching` evaluates; a different lesson may be open when `watching` ends
    std::optional<WatchedTasks> watched;  // the last result of `watching`
    CourseProgress written;               // the progress as written to the file

    [[nodiscard]] const Station& station() const { return course->stations[progress.station]; }
    [[nodiscard]] std::vector<GivenAnswer>& given() { return progress.given[progress.station]; }
    [[nodiscard]] const std::vector<GivenAnswer>& given() const { return progress.given[progress.station]; }
};

/// Starts opening a lesson file; it may have any name.
[[nodiscard]] Opening opening_of_lesson(const std::string& path);

/// Opens the lesson's column at the last position. Precondition: Course::document is the open document, as
/// set by take_scene().
void begin_lesson(UiState& state, std::shared_ptr<const Course> course);
/// Closes the lesson; its scene remains open.
void leave_lesson(UiState& state);
/// Closes the lesson and returns to the document that was open before, unless the lesson's scene was saved
/// under a name. Changes to it are kept in RecentlyChanged.
void close_lesson(UiState& state);

/// Returns the first open question of this station; nullopt if there is none.
[[nodiscard]] std::optional<std::size_t> open_question(const LessonState& lesson);

// Every action that opens a scene of the lesson asks first if the open scene was saved under a name and has
// unsaved changes.

/// Goes `steps` stations forward, or back if negative, and shows the scene there. Notifies the user at either
/// end.
void go_on(UiState& state, int steps);
/// Handles PgDn and PgUp; for a lecturer, PgDn first shows the answer to an open question.
void page_lesson(UiState& state, int steps);
/// Restarts the lesson at its first station, without any answers.
void begin_again(UiState& state);
/// Restores the lesson's scene of this station, as one undo step.
void back_to_scene(UiState& state);
/// Returns why the given answer to the open question is incomplete; empty if it is complete.
[[nodiscard]] std::string why_no_answer(const LessonState& lesson);
/// Whether the open question has a complete answer.
[[nodiscard]] bool can_lock(const LessonState& lesson);
/// Answers the open question with a key: an option's letter chooses it, Enter locks in the answer. False if
/// the key has a different meaning.
bool answer_by_key(UiState& state, KeyPress press);
/// Makes the given answer final; after the station's last one, the answers are revealed.
void lock_in(UiState& state);
/// Shows all answers of the station; answers that were not locked in do not count.
void reveal_unanswered(UiState& state);
/// Whether the scene differs from the station's scene; a changed view also counts.
[[nodiscard]] bool has_strayed(const UiState& state);

/// Starts or stops the reveal's animation.
void play_reveal(UiState& state);
/// Briefly highlights the answer's number in its tab of the WHY column.
void mark_in_equation(UiState& state, const Prediction& question);
/// Picks the reveal's pixel and scrolls to the answer's number.
void show_in_equation(UiState& state, const Prediction& question);

/// During a question, undoes all edits made in this frame. Call it before the picture is drawn.
void hold_lesson(UiState& state);
/// Once a frame: evaluates the tasks' conditions on the current scene and writes the progress.
void poll_lesson(UiState& state);

/// The lesson's column: title, text, question, answer, tasks, and navigation. Draws nothing without a lesson.
void lesson_column(UiState& state);
extern const Tool lesson_tool;
/// Draws the positions and lines of a station's questions into the picture.
void draw_lesson(ImDrawList& list, UiState& state, const PictureView& view);

/// A short version of the lesson's question or text, for when the columns are hidden; empty without a lesson.
[[nodiscard]] std::string lesson_caption(const UiState& state);

/// Convert a pixel of the lesson's pictures to a fraction of the size of the window's picture, which has the
/// same camera, and back.
[[nodiscard]] glm::dvec2 share_of_lesson_pixel(const UiState& state, glm::dvec2 pixel);
[[nodiscard]] glm::dvec2 lesson_pixel_of_share(const UiState& state, glm::dvec2 share);

/// Returns the number of values in a sketch from A to B: one for each pixel.
[[nodiscard]] std::size_t sketch_length(const Prediction& question);
/// Adds a straight mouse stroke between `from` and `to`, each (index, value): the values between them follow
/// the stroke, and the others do not change. Null values have not been drawn yet.
void sketch(Json& values, std::size_t count, glm::dvec2 from, glm::dvec2 to);

// The list of lessons: those that come with the program, and those next to the open one, with their progress.

struct UiState;
struct UiInput;

struct LessonEntry {
    std::string path, title, topic;  // `title` is empty if the file cannot be read; opening it reports why
    std::optional<LessonRecord> record;
};

struct LessonListState {
    bool open = false;
    int chosen = -1;  // index chosen with the arrow keys, counted across the two lists
    std::vector<LessonEntry> own,
        beside;  // lessons that come with the program; lessons in the open one's folder, if different
};

/// The number at the beginning of the file's name, "05"; empty if there is none.
[[nodiscard]] std::string number_of(const LessonEntry& entry);

/// Reads the lessons that come with the program into the list; this takes a few milliseconds.
void list_own_lessons(UiState& state);
/// Opens the dialog; a click in it, or the arrow keys and Enter, opens a lesson.
void open_lessons(UiState& state);
/// Draws the dialog. Precondition: it is open.
void lessons_dialog(UiState& state, const UiInput& input);

// *Predict*: the user picks a pixel, changes the scene while the picture is frozen, predicts the pixel's
// colour, and then sees it.

struct UiState;

enum class PredictStage { Off, Pick, Change, Revealed };

struct PredictState {
    PredictState() noexcept(false) = default;  // JSON may allocate

    PredictStage stage = PredictStage::Off;
    std::optional<glm::dvec2> probe;           // the pixel, as a fraction of the picture's size
    std::array<int, 3> before{};               // the pixel's colour when the picture was frozen, 0 to 255
    Json mine;                                 // the prediction, channels from 0 to 1; null: none yet
    bool takes_keys = false;                   // the colour's first field gets focus
    std::optional<std::array<int, 3>> answer;  // the real colour, once the picture is unfrozen
};

/// Starts a prediction for the picked pixel, or requests a pixel; cancels a prediction in progress.
void switch_prediction(UiState& state);
/// Unfreezes the picture without an answer.
void end_prediction(UiState& state);

/// Enter focuses the colour's fields, then locks the colour in, then begins again. Returns true if the key is
/// consumed.
bool predict_by_key(UiState& state, KeyPress press);

/// Once a frame, before the columns: follows the picked pixel, and stores the answer once it has been drawn.
void poll_prediction(UiState& state);
/// Draws the prediction into the WHY column. True if the usual contents may follow below it.
[[nodiscard]] bool predict_panel(UiState& state);

}  // namespace glint
