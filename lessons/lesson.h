#pragma once
// A lesson as a value: the window goes through its steps, a handout prints it, and a check runs it to verify
// its text. docs/lessons.md describes the file. Nothing here draws; run_lesson.h does.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lessons/expression.h"
#include "models/problem.h"
#include "models/scene/camera.h"
#include "models/scene_file/scene_file.h"

namespace glint {

/// A run of text in one style.
struct ProseSpan {
    std::string text;  // UTF-8
    bool strong = false, emphasis = false, code = false;
    std::string link;  // its target; empty: none
    bool operator==(const ProseSpan&) const = default;
};
enum class ProseKind { Paragraph, Heading, Item, Code, Quote };
/// A paragraph or similar block of text.
struct ProseBlock {
    ProseKind kind = ProseKind::Paragraph;
    int level = 0;   // of a heading, 3 to 6; of an item, the depth of its list, from 1
    int number = 0;  // of an item of a numbered list, from 0 on; -1: a bullet
    std::vector<ProseSpan> spans;
    bool operator==(const ProseBlock&) const = default;
};

[[nodiscard]] inline std::string plain_text(const ProseBlock& block) {
    std::string text;
    for (const ProseSpan& span : block.spans) text += span.text;
    return text;
}

enum class RunKind { Explain, Render, Profile, Info, Lobe, Microfacets, Compare };
/// One command whose output expressions read: `e = explain --pixel 640,360 --set /shading/mode=flat`.
struct LessonRun {
    std::string name;  // in the expressions
    RunKind kind = RunKind::Explain;
    std::vector<Assignment> set;      // after those of the step
    std::optional<PictureSize> size;  // else the lesson's
    glm::ivec2 from{0}, to{0};        // pixels: of explain (from) and profile
    int object = 0;                   // of lobe
    double angle_deg = 30, roughness = 0.25;
    std::optional<double> view_deg;  // of microfacets; else the mirror angle
    int rays = 200, facets = 400;
    std::string first, second;  // of compare: names of earlier render runs
    int line = 0;               // in the file, from 1
};

enum class PredictionKind { Number, Choice, Click, Sketch, Colour };
/// One answer of a choice. Exactly one condition of a choice holds.
struct LessonOption {
    std::string text;
    Expression is_right;
    std::string thinks = {};   // the misconception that makes this answer look right; or empty
    std::string mistake = {};  // a mistake with which a program shows this; or empty
    int line = 0;
};
/// A wrong answer that students give, with the misconception behind it.
struct TypicalWrong {
    Expression answer;  // of the same form as the right one
    std::string thinks;
    int line = 0;
};
/// A question to be answered before anything moves.
struct Prediction {
    PredictionKind kind = PredictionKind::Number;
    std::string question;
    std::vector<LessonRun> runs;
    Expression answer;     // a number; a pixel [x, y]; a list along the line; a colour. None for a choice
    Expression tolerance;  // accepted difference: in the answer's unit, in pixels, per value of a list
    std::string unit;      // of a number
    std::string term;  // the field of an explanation with the answer, such as "lights[0].n_dot_l"; or none
    std::vector<LessonOption> options;  // of a choice
    std::vector<TypicalWrong> wrong;    // of all other kinds
    glm::ivec2 from{0}, to{0};          // ends of a sketch's line, pixels
    int line = 0;
};

/// The changes and views after the prediction is locked in. The text after it belongs to it.
struct Reveal {
    std::vector<Assignment> set;                             // after those of the step
    std::optional<glm::ivec2> pick;                          // the pixel to explain
    std::optional<std::pair<glm::ivec2, glm::ivec2>> along;  // ends of the scope's line
    std::string play;  // pointer of a number that moves back and forth; empty: none
    double play_from = 0, play_to = 0;
    int line = 0;
};

/// An action for the student, and the condition for its completion.
struct Task {
    std::string drag;                   // the instruction
    std::vector<std::string> controls;  // JSON pointers of the numbers that the student should move
    std::vector<LessonRun> runs;
    Expression done;
    std::vector<Assignment> solution;  // a possible solution; `done` holds with it and fails without it
    int line = 0;
};

/// A sentence that is checked by runs.
struct Claim {
    std::string says;
    std::vector<LessonRun> runs;
    std::vector<Expression> checks;        // all of them hold
    std::vector<std::string> falls_under;  // names of mistakes with which one of them fails
    int line = 0;
};

/// A question whose numbers vary from sheet to sheet.
struct Exercise {
    struct Variable {
        std::string name;
        std::vector<double> values;  // to choose from
    };
    struct Line {
        std::string key, value;  // with {names} still in place
        int line = 0;
        bool is_run = false;
    };
    std::vector<Variable> variables;  // each has values
    std::vector<Line> lines;
    int line = 0;
};
/// An exercise with its variables replaced.
struct ExerciseInstance {
    std::string question, unit;
    std::vector<Assignment> set;
    std::vector<LessonRun> runs;
    Expression answer, tolerance;
    Expression closed;   // a formula for the answer, or none; the engine's answer must agree
    NamedValues values;  // of the variables
};

using LessonPart = std::variant<std::vector<ProseBlock>, Prediction, Reveal, Task, Claim, Exercise>;

/// Notes for the lecturer.
struct Teaching {
    int minutes = 0;                 // in a lecture; 0: unknown
    std::vector<std::string> goals;  // what a student can do afterwards
    std::string belief, source;      // the misconception that the lesson meets; who described it
    std::vector<std::string> says;   // what to say or ask next
};

/// The part of a lesson from one second-level heading to the next. It starts with the lesson's scene and the
/// assignments in `set`, independent of earlier steps.
struct LessonStep {
    std::string title;  // empty for the part before the first such heading
    std::vector<Assignment> set;
    std::vector<Assignment> picture;  // after `set`, for a picture on paper that must not show the answer
    std::string shows;                // describes that picture to those who cannot see it; or empty
    int line = 0;                     // of its block `scene`, or 0
    std::vector<LessonPart> parts;    // in the order of the file; no two consecutive texts
};

struct Lesson {
    std::string title, topic;
    std::string path;            // of its file, as given
    std::string name;            // of its file, without folder and extension: "05-lambert"
    std::string scene;           // path of its scene, relative to the working directory
    PictureSize size;            // of the pictures to which its pixels refer
    std::vector<int> rows;       // of docs/lecture_map.md that it covers, from 1
    std::vector<int> questions;  // of the lecture that it answers, from 1
    Teaching teaching;
    std::string form;  // of a quiz that has parallel forms: "A"; or empty
    int plain = 0;     // so many first questions are in plain language, for before and after; 0: all
    std::vector<LessonStep> steps;
};

/// Maximum bytes of a lesson's file, and maximum number of steps and parts together.
inline constexpr std::size_t max_lesson_bytes = std::size_t{256} << 10;
inline constexpr std::size_t max_lesson_parts = 1000;
/// The maximum width and height of a lesson's pictures, in pixels.
inline constexpr int max_lesson_side = 2048;
/// Maximum angles between the normal and the light (of `lobe`), or light and viewer (of `microfacets`), in
/// degrees. At 90 a surface receives no light.
inline constexpr double max_lobe_deg = 89.9, max_microfacets_deg = 89;

/// Text -> lesson. `path` is for messages, and the scene's path is relative to its folder. Does not check
/// that the scene exists. A problem has a line number.
[[nodiscard]] Result<Lesson> parse_lesson(std::string_view text, const std::string& path);
[[nodiscard]] Result<Lesson> read_lesson(const std::string& path);

/// The lesson files (.md) among `words`, each a file, or a folder, whose files are sorted by name. A word
/// that is not a folder is returned without a check.
[[nodiscard]] Result<std::vector<std::string>> lesson_files(const std::vector<std::string>& words);

/// The exercise with those values, one for each variable. A problem has `path` and the line.
[[nodiscard]] Result<ExerciseInstance> exercise_with(const Exercise& exercise,
                                                     const std::vector<double>& values,
                                                     const std::string& path);

}  // namespace glint
