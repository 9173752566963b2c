#pragma once
// A lesson as plain data. The window steps through it, a handout prints it, and a check runs it to verify its
// text. docs/lessons.md describes the file format. Nothing here draws; run_lesson.h does.

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
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"

namespace glint {

/// A piece of text in one style.
struct ProseSpan {
    std::string text;  // UTF-8
    bool strong = false, emphasis = false, code = false;
    std::string link;  // link target, or empty
    bool operator==(const ProseSpan&) const = default;
};
enum class ProseKind { Paragraph, Heading, Item, Code, Quote };
/// A paragraph or similar block of text.
struct ProseBlock {
    ProseKind kind = ProseKind::Paragraph;
    int level = 0;   // heading level, 3 to 6; nesting depth of a list item, from 1
    int number = 0;  // index in a numbered list, from 0; -1: a bullet
    std::vector<ProseSpan> spans;
    bool operator==(const ProseBlock&) const = default;
};

[[nodiscard]] inline std::string plain_text(const ProseBlock& block) {
    std::string text;
    for (const ProseSpan& span : block.spans) text += span.text;
    return text;
}

enum class RunKind { Explain, Render, Profile, Info, Lobe, Microfacets, Compare };
/// A command whose output expressions can read: `e = explain --pixel 640,360 --set /shading/mode=flat`.
struct LessonRun {
    std::string name;  // by which expressions refer to it
    RunKind kind = RunKind::Explain;
    std::vector<Assignment> set;      // applied after the step's assignments
    std::optional<PictureSize> size;  // the lesson's size if not set
    glm::ivec2 from{0}, to{0};        // pixels: `from` for explain, the two for profile
    int object = 0;                   // for lobe: the object's index
    double angle_deg = 30, roughness = 0.25;
    std::optional<double> view_deg;  // for microfacets; the mirror angle if not set
    int rays = 200, facets = 400;
    std::string first, second;  // for compare: names of earlier render runs
    int line = 0;               // in the file, from 1
};

enum class PredictionKind { Number, Choice, Click, Sketch, Colour };
/// An option of a choice. The condition of exactly one option is true.
struct LessonOption {
    std::string text;
    Expression is_right;
    std::string thinks = {};   // the misconception that makes this option seem right, or empty
    std::string mistake = {};  // the mistake that makes a program show this result, or empty
    int line = 0;
};
/// A typical wrong answer and the misconception behind it.
struct TypicalWrong {
    Expression answer;  // of the same type as the right answer
    std::string thinks;
    int line = 0;
};
/// A question that the student answers before seeing any change.
struct Prediction {
    PredictionKind kind = PredictionKind::Number;
    std::string question;
    std::vector<LessonRun> runs;
    Expression answer;     // a number; a pixel [x, y]; a list along the line; a colour. Empty for a choice
    Expression tolerance;  // accepted difference: in the answer's unit, in pixels, or per list element
    std::string unit;      // for a number
    std::string term;      // field of the explanation, such as "lights[0].n_dot_l", or empty
    std::vector<LessonOption> options;  // for a choice
    std::vector<TypicalWrong> wrong;    // for all other kinds of prediction
    glm::ivec2 from{0}, to{0};          // for a sketch: the ends of the line, in pixels
    int line = 0;
};

/// The changes and views shown once the prediction is locked in. Includes the text that follows it.
struct Reveal {
    std::vector<Assignment> set;                             // applied after the step's assignments
    std::optional<glm::ivec2> pick;                          // the pixel to explain
    std::optional<std::pair<glm::ivec2, glm::ivec2>> along;  // ends of the intensity scope's line
    std::string play;  // JSON pointer of a number to animate back and forth, or empty
    double play_from = 0, play_to = 0;
    int line = 0;
};

/// An action for the student and the condition for completing it.
struct Task {
    std::string drag;                   // the instruction
    std::vector<std::string> controls;  // JSON pointers of the numbers that the student should change
    std::vector<LessonRun> runs;
    Expression done;
    std::vector<Assignment> solution;  // a possible solution: `done` is true with it and false without it
    int line = 0;
};

/// A statement that is verified by runs.
struct Claim {
    std::string says;
    std::vector<LessonRun> runs;
    std::vector<Expression> checks;        // all of them must be true
    std::vector<std::string> falls_under;  // names of mistakes that make one of them false
    int line = 0;
};

/// `key: value` or `name = run` in a block, including the indented lines that follow.
struct BlockLine {
    std::string key, value;
    int line = 0;  // in the file, from 1
    bool is_run = false;
};

/// A question whose numbers differ between sheets.
struct Exercise {
    struct Variable {
        std::string name;
        std::vector<double> values;  // the possible values
    };
    std::vector<Variable> variables;  // each with its possible values
    std::vector<BlockLine> lines;     // their values may contain {names}
    int line = 0;
};
/// An exercise with its variables substituted.
struct ExerciseInstance {
    std::string question, unit;
    std::vector<Assignment> set;
    std::vector<LessonRun> runs;
    Expression answer, tolerance;
    Expression closed;   // a formula for the answer, or empty; must agree with the engine's answer
    NamedValues values;  // the values of the variables
};

using LessonPart = std::variant<std::vector<ProseBlock>, Prediction, Reveal, Task, Claim, Exercise>;

/// Notes for the lecturer.
struct Teaching {
    int minutes = 0;                 // duration in a lecture; 0: unknown
    std::vector<std::string> goals;  // what students will be able to do
    std::string belief, source;      // the misconception that the lesson addresses; a study of it
    std::vector<std::string> says;   // suggested remarks and questions
};

/// The part of a lesson between two second-level headings. It starts with the lesson's scene and the
/// assignments in `set`, independently of earlier steps.
struct LessonStep {
    std::string title;  // empty for the part before the first second-level heading
    std::vector<Assignment> set;
    std::vector<Assignment> picture;  // applied after `set` for the printed picture, to hide the answer
    std::string shows;                // alternative text of that picture, or empty
    int line = 0;                     // of its `scene` block, or 0
    std::vector<LessonPart> parts;    // in file order; no two consecutive text parts
};

struct Lesson {
    std::string title, topic;
    std::string path;            // path of the lesson's file, as given
    std::string name;            // file name without folder and extension: "05-lambert"
    std::string scene;           // path of its scene, relative to the working directory
    PictureSize size;            // picture size to which pixel coordinates refer
    std::vector<int> rows;       // rows of docs/lecture_map.md that it covers, from 1
    std::vector<int> questions;  // lecture questions that it answers, from 1
    Teaching teaching;
    std::string form;  // for a quiz with parallel forms: "A", or empty
    // The number of initial questions in plain language, asked before and after the lessons; 0: all.
    int plain = 0;
    std::vector<LessonStep> steps;
};

/// Maximum size of a lesson file in bytes, and maximum total number of steps and parts.
inline constexpr std::size_t max_lesson_bytes = std::size_t{256} << 10;
inline constexpr std::size_t max_lesson_parts = 1000;
/// The maximum width and height of a lesson's pictures, in pixels.
inline constexpr int max_lesson_side = 2048;
/// Maximum angles from the normal, in degrees: of the light (`lobe`), and of light and viewer
/// (`microfacets`). At 90 a surface receives no light.
inline constexpr double max_lobe_deg = 89.9, max_microfacets_deg = 89;

/// Parses a lesson. `path` is used in messages, and the scene's path is relative to its folder. Does not
/// check that the scene exists. A problem includes the line number.
[[nodiscard]] Result<Lesson> parse_lesson(std::string_view text, const std::string& path);
[[nodiscard]] Result<Lesson> read_lesson(const std::string& path);

/// Expands `words`, each a file or a folder, to lesson files (.md). The files of a folder are sorted by name.
/// Returns anything other than a folder unchanged and unchecked.
[[nodiscard]] Result<std::vector<std::string>> lesson_files(const std::vector<std::string>& words);

/// Substitutes the values, one for each variable. A problem includes `path` and the line.
[[nodiscard]] Result<ExerciseInstance> exercise_with(const Exercise& exercise,
                                                     const std::vector<double>& values,
                                                     const std::string& path);

}  // namespace glint
