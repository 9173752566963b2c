// glint quiz: writes a concept inventory as a page, or evaluates a class's answers.
#include "lessons/quiz.h"

#include <memory>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/io/file.h"
#include "models/json/json.h"

namespace glint {
namespace {

struct QuizArguments {
    std::string questions, out;
    std::vector<std::string> answers;
    int threads = 0;
    bool key = false;
};

Lesson inventory(const QuizArguments& arguments) {
    const std::string path = arguments.questions.empty() ? asset_path("inventory.md") : arguments.questions;
    if (path.empty())
        throw Failure{ExitStatus::Impossible,
                      {"", "", "no inventory is installed", asset_places("inventory.md")}};
    return take(read_lesson(path));
}

Outcome statistics(const QuizArguments& arguments) {
    constexpr std::size_t max_answer_bytes = std::size_t{1} << 20;
    const Lesson lesson = inventory(arguments);
    std::vector<QuizAnswers> all;
    for (const std::string& file : arguments.answers)
        all.push_back(take(read_answers(lesson, take(read_file(file, max_answer_bytes)), file)));
    LessonRunner runner(arguments.threads);
    return {json_text(take(quiz_statistics(runner, lesson, all))), {}, ExitStatus::Done};
}

Outcome quiz(const QuizArguments& arguments) {
    if (!arguments.answers.empty()) {
        if (!arguments.out.empty())
            throw wrong_usage("-o", "cannot be combined with ANSWERS", "one of the two");
        if (arguments.key) throw wrong_usage("--key", "cannot be combined with ANSWERS", "-o OUT.html");
        return statistics(arguments);
    }
    require_given(arguments.out, "-o", "a page to write, .html, or ANSWERS.json to count");
    if (arguments.out != "-" && lower_extension(arguments.out) != ".html")
        throw wrong_usage("-o", arguments.out + " cannot be written", "a name that ends in .html, or -");
    if (arguments.out != "-") require_writable(arguments.out);
    const Lesson lesson = inventory(arguments);
    LessonRunner runner(arguments.threads);
    write_output(arguments.out, take(quiz_html(runner, lesson, arguments.key)));
    return {};
}

Run declare_quiz(Options& options) {
    auto arguments = std::make_shared<QuizArguments>();
    options.add_words("ANSWERS", "answers saved from the page, to be counted",
                      [&answers = arguments->answers](const std::string& text) { answers.push_back(text); });
    add_text(options, "-o", "OUT.html", "write the questions as a page; - is standard output",
             arguments->out);
    options.add_flag("--key", arguments->key, "include the answers and the belief behind each wrong one");
    add_text(options, "--of", "FILE", "use another file of questions than that of Glint",
             arguments->questions);
    add_threads(options, arguments->threads);
    add_memory(options);
    return [arguments] { return quiz(*arguments); };
}

}  // namespace

Command quiz_command() {
    return {"quiz", "-o OUT.html", "write the quiz about lighting, or count its answers",
            "glint quiz -o quiz.html", declare_quiz};
}

}  // namespace glint
