#pragma once
// A lesson as a value: what a window walks through step by step, what a hand-out prints, and what is run to
// see whether the text is true. docs/lessons.md describes the file. Nothing here draws; renderer/lessons
// does.

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

/// A stretch of text in one style.
struct ProseSpan {
    std::string text;  // UTF-8
    bool strong = false, emphasis = false, code = false;
    std::string link;  // where it leads; empty: nowhere
    bool operator==(const ProseSpan&) const = default;
};
enum class ProseKind { Paragraph, Heading, Item, Code, Quote };
/// A paragraph and the like.
struct ProseBlock {
    ProseKind kind = ProseKind::Paragraph;
    int level = 0;   // of a heading, 3 to 6; of an item, how deep its list is, from 1
    int number = 0;  // of an item of a numbered list, from 0 on; -1: a bullet
    std::vector<ProseSpan> spans;
    bool operator==(const ProseBlock&) const = default;
};

enum class RunKind { Explain, Render, Profile, Info, Lobe, Microfacets, Compare };
/// One command whose answer an expression reads: `e = explain --pixel 640,360 --set /shading/mode=flat`.
struct LessonRun {
    std::string name;  // in the expressions
    RunKind kind = RunKind::Explain;
    std::vector<Assignment> set;      // behind those of the step
    std::optional<PictureSize> size;  // else the lesson's
    glm::ivec2 from{0}, to{0};        // pixels: of explain (from) and profile
    int object = 0;                   // of lobe
    double angle_deg = 30, roughness = 0.25;
    std::optional<double> view_deg;  // of microfacets; else the mirror angle
    int rays = 200, facets = 400;
    std::string first, second;  // of compare: names of render runs above it
    int line = 0;               // in the file, from 1
};

enum class PredictionKind { Number, Choice, Click, Sketch, Colour };
/// One answer of a choice. Exactly one condition of a choice holds.
struct LessonOption {
    std::string text;
    Expression is_right;
    std::string thinks = {};   // what somebody believes who takes it for right; or empty
    std::string mistake = {};  // a mistake with which a program shows this; or empty
    int line = 0;
};
/// A question to be answered before anything moves.
struct Prediction {
    PredictionKind kind = PredictionKind::Number;
    std::string question;
    std::vector<LessonRun> runs;
    Expression answer;  // a number; a pixel [x, y]; a list along the line; a colour. None for a choice
    Expression
        tolerance;     // how far off still counts: in the answer's unit, in pixels, of each value of a list
    std::string unit;  // of a number
    std::string term;  // the field of an explanation that holds the answer, as "lights[0].n_dot_l"; or none
    std::vector<LessonOption> options;  // of a choice
    glm::ivec2 from{0}, to{0};          // ends of a sketch's line, pixels
    int line = 0;
};

/// What is set and shown once the prediction is locked in. The text behind it belongs to it.
struct Reveal {
    std::vector<Assignment> set;                             // behind those of the step
    std::optional<glm::ivec2> pick;                          // the pixel to explain
    std::optional<std::pair<glm::ivec2, glm::ivec2>> along;  // where the scope's line lies
    std::string play;  // pointer of a number that goes to and fro; empty: none
    double play_from = 0, play_to = 0;
    int line = 0;
};

/// What the student is to do by hand, and when it is done.
struct Task {
    std::string drag;                   // what, in words
    std::vector<std::string> controls;  // pointers into the scene that a hand is to move
    std::vector<LessonRun> runs;
    Expression done;
    std::vector<Assignment> solution;  // a way to do it; with it `done` holds, without it not
    int line = 0;
};

/// A sentence that is run.
struct Claim {
    std::string says;
    std::vector<LessonRun> runs;
    std::vector<Expression> checks;        // all of them hold
    std::vector<std::string> falls_under;  // names of mistakes under which one of them does not
    int line = 0;
};

/// A question whose numbers vary from sheet to sheet.
struct Exercise {
    struct Variable {
        std::string name;
        std::vector<double> values;  // to choose from
    };
    struct Line {
        std::string key, value;  // {names} in it are not replaced yet
        int line = 0;
        bool is_run = false;
    };
    std::vector<Variable> variables;  // none without values
    std::vector<Line> lines;
    int line = 0;
};
/// An exercise with its variables replaced.
struct ExerciseInstance {
    std::string question, unit;
    std::vector<Assignment> set;
    std::vector<LessonRun> runs;
    Expression answer, tolerance;
    Expression closed;   // a formula for the same, or none: what the engine's answer is held against
    NamedValues values;  // of the variables
};

using LessonPart = std::variant<std::vector<ProseBlock>, Prediction, Reveal, Task, Claim, Exercise>;

/// The part of a lesson from one second-level heading to the next. It begins with the lesson's scene and the
/// assignments in `set`, whatever the steps before it did.
struct LessonStep {
    std::string title;  // empty for what stands before the first such heading
    std::vector<Assignment> set;
    std::vector<Assignment> picture;  // behind `set`, for a picture on paper that must not tell the answer
    int line = 0;                     // of its block `scene`, or 0
    std::vector<LessonPart> parts;    // as they stand in the file; no two texts follow one another
};

struct Lesson {
    std::string title, topic;
    std::string path;            // of its file, as given
    std::string name;            // of its file, without folder and extension: "05-lambert"
    std::string scene;           // path of its scene, from where the program runs
    PictureSize size;            // of the pictures in which its pixels are counted
    std::vector<int> rows;       // of docs/lecture_map.md that it touches, from 1
    std::vector<int> questions;  // of the lecture's own that it answers, from 1
    std::vector<LessonStep> steps;
};

/// Most bytes of a lesson's file, and most steps and parts together.
inline constexpr std::size_t max_lesson_bytes = std::size_t{256} << 10;
inline constexpr std::size_t max_lesson_parts = 1000;
/// The longest side that a lesson's pictures may have, in pixels.
inline constexpr int max_lesson_side = 2048;

/// Text -> lesson. `path` is for messages, and its folder is where the scene's path begins. It does not check
/// that the scene exists. A problem has the number of its line.
[[nodiscard]] Result<Lesson> parse_lesson(std::string_view text, const std::string& path);
[[nodiscard]] Result<Lesson> read_lesson(const std::string& path);

/// The lesson files (.md) among `words`, each a file, or a folder whose files come in the order of their
/// names. A word that is not a folder is returned without a check.
[[nodiscard]] Result<std::vector<std::string>> lesson_files(const std::vector<std::string>& words);

/// The exercise with those values, one for each variable. A problem has `path` and the line.
[[nodiscard]] Result<ExerciseInstance> exercise_with(const Exercise& exercise,
                                                     const std::vector<double>& values,
                                                     const std::string& path);

}  // namespace glint
