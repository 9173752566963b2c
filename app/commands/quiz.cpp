// glint quiz: writes a concept inventory as a page or for a learning platform, or evaluates a class's
// answers.
#include "lessons/quiz.h"

#include <fmt/format.h>

#include <algorithm>
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
    bool key = false, analyse = false, csv = false, form_b = false;
};

Lesson inventory(const QuizArguments& arguments, bool form_b) {
    const std::string name = form_b ? "inventory-b.md" : "inventory.md";
    const std::string path = arguments.questions.empty() ? asset_path(name) : arguments.questions;
    if (path.empty())
        throw Failure{ExitStatus::Impossible, {"", "", "no inventory is installed", asset_places(name)}};
    return take(read_lesson(path));
}

/// Sorts the answers by form. Answers that do not name a form belong to the first form.
std::vector<AnsweredForm> answered_forms(const QuizArguments& arguments) {
    constexpr std::size_t max_answer_bytes = std::size_t{1} << 20;
    std::vector<AnsweredForm> forms{{inventory(arguments, arguments.form_b), {}}};
    if (arguments.questions.empty()) forms.push_back({inventory(arguments, !arguments.form_b), {}});
    for (const std::string& file : arguments.answers) {
        const std::string text = take(read_file(file, max_answer_bytes));
        const auto named = std::find_if(forms.begin(), forms.end(), [&](const AnsweredForm& form) {
            return names_quiz(form.lesson, text);
        });
        AnsweredForm& form = named == forms.end() ? forms.front() : *named;
        form.answers.push_back(take(read_answers(form.lesson, text, file)));
    }
    return forms;
}

/// Returns the statistics of each form that has answers.
std::string statistics(LessonRunner& runner, const std::vector<AnsweredForm>& forms) {
    Json all = Json::array();
    for (const AnsweredForm& form : forms)
        if (!form.answers.empty()) all.push_back(take(quiz_statistics(runner, form.lesson, form.answers)));
    return json_text(elements_of(all).size() == 1 ? elements_of(all)[0] : Json{{"forms", all}});
}

Outcome evaluate(const QuizArguments& arguments) {
    const std::vector<AnsweredForm> forms = answered_forms(arguments);
    LessonRunner runner(arguments.threads);
    if (arguments.analyse) return {take(quiz_analysis(runner, forms)), {}, ExitStatus::Done};
    if (arguments.csv) return {take(quiz_csv(runner, forms)), {}, ExitStatus::Done};
    return {statistics(runner, forms), {}, ExitStatus::Done};
}

Outcome quiz(const QuizArguments& arguments) {
    if (arguments.analyse && arguments.csv)
        throw wrong_usage("--csv", "cannot be combined with --analyse", "one of the two");
    if (!arguments.answers.empty()) {
        if (!arguments.out.empty())
            throw wrong_usage("-o", "cannot be combined with ANSWERS", "one of the two");
        if (arguments.key) throw wrong_usage("--key", "cannot be combined with ANSWERS", "-o OUT.html");
        return evaluate(arguments);
    }
    if (arguments.analyse || arguments.csv)
        throw wrong_usage(arguments.csv ? "--csv" : "--analyse", "requires ANSWERS", "ANSWERS.json");
    require_given(arguments.out, "-o", "a page to write, .html, or ANSWERS.json to evaluate");
    const std::string extension = arguments.out == "-" ? ".html" : lower_extension(arguments.out);
    const bool is_page = extension == ".html";
    if (!is_page && extension != ".xml" && extension != ".zip")
        throw wrong_usage("-o", arguments.out + " cannot be written",
                          "a name that ends in .html, .xml or .zip, or -");
    if (arguments.key && !is_page) throw wrong_usage("--key", "applies only to a page", "-o OUT.html");
    if (arguments.out != "-") require_writable(arguments.out);
    const Lesson lesson = inventory(arguments, arguments.form_b);
    LessonRunner runner(arguments.threads);
    write_output(arguments.out,
                 is_page ? take(quiz_html(runner, lesson, arguments.key))
                         : exported(extension, lesson.title, take(quiz_questions(runner, lesson))));
    return {};
}

Run declare_quiz(Options& options) {
    auto arguments = std::make_shared<QuizArguments>();
    options.add_words("ANSWERS", "answers saved from the page, to be evaluated",
                      [&answers = arguments->answers](const std::string& text) { answers.push_back(text); });
    add_text(options, "-o", "OUT",
             "write the questions: a page, .html, or - for standard output; for a learning platform .xml "
             "(Moodle) or "
             ".zip (QTI 2.1)",
             arguments->out);
    options.add_value("--form", "FORM",
                      "a (default) or b: the same questions with different numbers and objects",
                      [&form_b = arguments->form_b](const std::string& text) {
                          form_b = read_word("--form", text, {"a", "b"}) == 1;
                      });
    options.add_flag("--key", arguments->key,
                     "include the answers and the misconception behind each wrong one");
    options.add_flag("--analyse", arguments->analyse,
                     "print difficulty, discrimination, reliability and gain");
    options.add_flag("--csv", arguments->csv, "print a line for each person and question");
    add_text(options, "--of", "FILE", "use this question file instead of Glint's own", arguments->questions);
    add_threads(options, arguments->threads);
    add_memory(options);
    return [arguments] { return quiz(*arguments); };
}

}  // namespace

Command quiz_command() {
    return {"quiz", "-o OUT", "write the lighting quiz, or evaluate answers to it", "glint quiz -o quiz.html",
            declare_quiz};
}

}  // namespace glint
