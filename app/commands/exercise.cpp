// glint exercise: writes sheets with different numbers, and their keys.
#include <fmt/core.h>

#include <limits>
#include <memory>
#include <utility>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "lessons/exercise_sheet.h"
#include "lessons/handout.h"
#include "models/io/file.h"
#include "renderer/image/html_image.h"

namespace glint {
namespace {

constexpr int max_seed = std::numeric_limits<int>::max();  // the last sheet's number

struct ExerciseArguments {
    std::string name, out;
    int seed = 1, count = 1, threads = 0;
};

/// The lesson's scene as an element of the page.
std::string picture_of(LessonRunner& runner, const Lesson& lesson) {
    const SceneDocument document = take(runner.open(lesson));
    const Picture picture = take(runner.picture(document, lesson, handout_size(lesson), 4));
    return html_image(picture, "The scene of the lesson");
}

Outcome exercise(const ExerciseArguments& arguments) {
    require_given(arguments.name, "NAME", "a lesson with exercises");
    require_given(arguments.out, "-o", "a file to write, .html or .tex");
    const std::string extension = lower_extension(arguments.out);
    if (extension != ".html" && extension != ".tex")
        throw wrong_usage("-o", arguments.out + " cannot be written", "a name that ends in .html or .tex");
    if (arguments.seed > max_seed - (arguments.count - 1))
        throw wrong_usage("--count", fmt::format("there are fewer sheets from {} on", arguments.seed),
                          fmt::format("1 to {}", max_seed - arguments.seed + 1));
    require_writable(arguments.out);
    const Lesson lesson = open_lesson(arguments.name);
    LessonRunner runner(arguments.threads);
    const std::vector<ExerciseSheet> sheets =
        take(exercise_sheets(runner, lesson, static_cast<std::uint64_t>(arguments.seed), arguments.count));
    const std::string text = extension == ".tex" ? exercises_tex(lesson, sheets)
                                                 : exercises_html(lesson, sheets, picture_of(runner, lesson));
    write_output(arguments.out, text);
    Warnings warnings = key_warnings(lesson, sheets);
    const std::string unset = extension == ".tex" ? unset_letters(text) : "";
    if (!unset.empty())
        warnings.push_back(
            fmt::format("{}: pdflatex does not set {}; xelatex or lualatex may, with a font that has them",
                        on_one_line(arguments.out), unset));
    return {{}, std::move(warnings)};
}

Run declare_exercise(Options& options) {
    auto arguments = std::make_shared<ExerciseArguments>();
    add_text(options, "NAME", "", "a lesson: its name, number or file", arguments->name);
    options.add_value("--seed", "N",
                      "number of the first sheet; the same number gives the same sheet; default 1",
                      [&seed = arguments->seed](const std::string& text) {
                          seed = read_count("--seed", text, 0, max_seed);
                      });
    options.add_value("--count", "K", "number of sheets, each with its own numbers; default 1",
                      [&count = arguments->count](const std::string& text) {
                          count = read_count("--count", text, 1, max_exercise_sheets);
                      });
    add_text(options, "-o", "OUT", "the file for the sheets and their keys, .html or .tex", arguments->out);
    add_threads(options, arguments->threads);
    add_memory(options);
    return [arguments] { return exercise(*arguments); };
}

}  // namespace

Command exercise_command() {
    return {"exercise", "NAME -o OUT", "write exercise sheets of a lesson, a different one for each student",
            "glint exercise lambert --seed 7 --count 30 -o sheets.html", declare_exercise};
}

}  // namespace glint
