// glint exercise: writes exercise sheets with different numbers, and the answer keys to a separate file.
#include <fmt/core.h>

#include <limits>
#include <memory>
#include <utility>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "lessons/exercise_sheet.h"
#include "models/io/file.h"

namespace glint {
namespace {

constexpr int max_seed = std::numeric_limits<int>::max();  // number of the last possible sheet

struct ExerciseArguments {
    std::string name, out, key;
    int seed = 1, count = 1, threads = 0;
};

std::string sheets_text(LessonRunner& runner, const Lesson& lesson, const std::vector<ExerciseSheet>& sheets,
                        const std::string& out) {
    const std::string extension = lower_extension(out);
    if (extension == ".tex") return exercises_tex(lesson, sheets);
    if (extension == ".html") return exercises_html(lesson, sheets, take(sheet_picture(runner, lesson)));
    return exported(extension, lesson.title, sheet_questions(sheets));
}

Outcome exercise(const ExerciseArguments& arguments) {
    require_given(arguments.name, "NAME", "a lesson with exercises");
    require_given(arguments.out, "-o", "a file to write: .html, .tex, .xml or .zip");
    const std::string extension = lower_extension(arguments.out), of_key = lower_extension(arguments.key);
    if (extension != ".html" && extension != ".tex" && extension != ".xml" && extension != ".zip")
        throw wrong_usage("-o", arguments.out + " cannot be written",
                          "a name that ends in .html, .tex, .xml or .zip");
    if (!arguments.key.empty() && of_key != ".html" && of_key != ".tex")
        throw wrong_usage("--key", arguments.key + " cannot be written", "a name that ends in .html or .tex");
    if (arguments.key == arguments.out)
        throw wrong_usage("--key", "is the same file as -o", "a different file");
    if (arguments.seed > max_seed - (arguments.count - 1))
        throw wrong_usage("--count", fmt::format("there are fewer sheets from seed {} on", arguments.seed),
                          fmt::format("1 to {}", max_seed - arguments.seed + 1));
    require_writable(arguments.out);
    if (!arguments.key.empty()) require_writable(arguments.key);
    const Lesson lesson = open_lesson(arguments.name);
    LessonRunner runner(arguments.threads);
    const std::vector<ExerciseSheet> sheets =
        take(exercise_sheets(runner, lesson, static_cast<std::uint64_t>(arguments.seed), arguments.count));
    const std::string text = sheets_text(runner, lesson, sheets, arguments.out);
    std::string tex = extension == ".tex" ? text : "";
    write_output(arguments.out, text);
    if (!arguments.key.empty()) {
        const std::string keys =
            of_key == ".tex" ? exercise_keys_tex(lesson, sheets) : exercise_keys_html(lesson, sheets);
        write_output(arguments.key, keys);
        if (of_key == ".tex") tex += keys;
    }
    Warnings warnings = key_warnings(lesson, sheets);
    const std::string unset = unset_letters(tex);
    if (!unset.empty())
        warnings.push_back(
            fmt::format("{}: pdflatex cannot typeset {}; xelatex or lualatex can, with a suitable font",
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
    add_text(options, "-o", "OUT",
             "the sheets: .html, .tex, or for a learning platform .xml (Moodle) or .zip (QTI 2.1)",
             arguments->out);
    add_text(options, "--key", "KEY", "a file for the answer keys and their working, .html or .tex",
             arguments->key);
    add_threads(options, arguments->threads);
    add_memory(options);
    return [arguments] { return exercise(*arguments); };
}

}  // namespace

Command exercise_command() {
    return {"exercise", "NAME -o OUT", "write exercise sheets for a lesson, a different one for each student",
            "glint exercise lambert --seed 7 --count 30 -o sheets.html --key keys.html", declare_exercise};
}

}  // namespace glint
