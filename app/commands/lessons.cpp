// glint lessons: lists lessons, checks their claims, or prints one.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <utility>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/options.h"
#include "lessons/check_lesson.h"
#include "lessons/handout.h"
#include "models/io/file.h"
#include "models/json/json.h"
#include "models/problem.h"

namespace glint {
namespace {

struct LessonsArguments {
    std::vector<std::string> names;
    std::string out;
    int threads = 0;
    bool check = false, key = false, slides = false, instructor = false, as_json = false;
};

std::vector<Lesson> lessons_of(const LessonsArguments& arguments) {
    std::vector<Lesson> lessons;
    for (const std::string& file : named_lessons(arguments.names)) lessons.push_back(take(read_lesson(file)));
    return lessons;
}

template <class Part> std::size_t count_of(const Lesson& lesson) {
    std::size_t count = 0;
    for (const LessonStep& step : lesson.steps)
        for (const LessonPart& part : step.parts) count += std::holds_alternative<Part>(part);
    return count;
}

std::string list_text(const std::vector<Lesson>& lessons) {
    std::string text;
    for (const Lesson& l : lessons)
        text += fmt::format("{:<28}{}\n{:28}{}\n", on_one_line(l.name), on_one_line(l.title), "",
                            on_one_line(l.topic));
    return text;
}

std::string list_json(const std::vector<Lesson>& lessons) {
    Json all = Json::array();
    for (const Lesson& l : lessons)
        all.push_back({{"name", l.name},
                       {"title", l.title},
                       {"topic", l.topic},
                       {"path", l.path},
                       {"scene", l.scene},
                       {"rows", l.rows},
                       {"answers", l.questions},
                       {"steps", l.steps.size()},
                       {"predictions", count_of<Prediction>(l)},
                       {"tasks", count_of<Task>(l)},
                       {"claims", count_of<Claim>(l)},
                       {"exercises", count_of<Exercise>(l)}});
    return json_text({{"lessons", all}});
}

struct CheckedLesson {
    Lesson lesson;
    std::vector<Checked> items;
};

std::string check_text(const std::vector<CheckedLesson>& lessons) {
    std::string text;
    std::size_t held = 0, all = 0;
    for (const auto& [lesson, items] : lessons)
        for (const Checked& item : items) {
            ++all;
            held += item.holds;
            if (!item.holds)
                text += fmt::format("{}:{}: {}: {}\n    {}\n", on_one_line(lesson.path), item.line,
                                    name_of(item.kind), on_one_line(item.says), on_one_line(item.why));
        }
    return text + fmt::format("{} of {} hold\n", held, all);
}

std::string check_json(const std::vector<CheckedLesson>& lessons) {
    Json all = Json::array();
    for (const auto& [lesson, items] : lessons)
        for (const Checked& item : items)
            all.push_back({{"lesson", lesson.name},
                           {"line", item.line},
                           {"kind", name_of(item.kind)},
                           {"says", item.says},
                           {"holds", item.holds},
                           {"why", item.why}});
    return json_text({{"checked", all}});
}

Outcome check(const LessonsArguments& arguments) {
    std::vector<Lesson> lessons = lessons_of(arguments);
    std::vector<CheckedLesson> checked;
    bool all_hold = true;
    LessonRunner runner(arguments.threads);
    Progress progress("lesson", lessons.size());
    for (Lesson& lesson : lessons) {
        progress.at(checked.size());
        std::vector<Checked> items = take(check_lesson(runner, lesson));
        for (const Checked& item : items) all_hold &= item.holds;
        checked.push_back({std::move(lesson), std::move(items)});
    }
    return {arguments.as_json ? check_json(checked) : check_text(checked),
            {},
            all_hold ? ExitStatus::Done : ExitStatus::Impossible};
}

Outcome hand_out(const LessonsArguments& arguments) {
    if (arguments.names.size() != 1) throw wrong_usage("-o", "writes a single lesson", "the name of one");
    if (arguments.out != "-" && lower_extension(arguments.out) != ".html")
        throw wrong_usage("-o", arguments.out + " cannot be written", "a name that ends in .html, or -");
    if (arguments.out != "-") require_writable(arguments.out);
    const Lesson lesson = open_lesson(arguments.names[0]);
    LessonRunner runner(arguments.threads);
    const PageKind kind = arguments.instructor ? PageKind::Instructor
                          : arguments.slides   ? PageKind::Slides
                          : arguments.key      ? PageKind::Key
                                               : PageKind::Student;
    const std::string page = take(handout_html(runner, lesson, kind));
    write_output(arguments.out, page);
    return {};
}

Outcome lessons(const LessonsArguments& arguments) {
    if (arguments.check && !arguments.out.empty())
        throw wrong_usage("--check", "cannot be combined with -o", "one of the two");
    if (arguments.as_json && !arguments.out.empty())
        throw wrong_usage("--format", "cannot be json with -o, which writes a page", "one of the two");
    const std::array<std::pair<const char*, bool>, 3> kinds{
        {{"--key", arguments.key}, {"--slides", arguments.slides}, {"--instructor", arguments.instructor}}};
    const char* first = nullptr;
    for (const auto& [option, given] : kinds) {
        if (!given) continue;
        if (arguments.out.empty()) throw wrong_usage(option, "requires -o", "-o OUT.html");
        if (first != nullptr)
            throw wrong_usage(option, std::string("cannot be combined with ") + first, "one of the two");
        first = option;
    }
    if (arguments.check) return check(arguments);
    if (!arguments.out.empty()) return hand_out(arguments);
    const std::vector<Lesson> all = lessons_of(arguments);
    return {arguments.as_json ? list_json(all) : list_text(all), {}, ExitStatus::Done};
}

Run declare_lessons(Options& options) {
    auto arguments = std::make_shared<LessonsArguments>();
    options.add_words(
        "NAME",
        "a lesson (its name or number), a file, or a folder of lessons; default: all of Glint's lessons",
        [&names = arguments->names](const std::string& text) { names.push_back(text); });
    options.add_flag("--check", arguments->check,
                     "check every claim; print those that fail and exit with status 1");
    add_text(options, "-o", "OUT.html", "write one lesson as a page with its pictures; - is standard output",
             arguments->out);
    options.add_flag("--key", arguments->key, "include the answers");
    options.add_flag("--slides", arguments->slides, "write slides, with each answer on a separate slide");
    options.add_flag("--instructor", arguments->instructor,
                     "write notes for the lecturer: goals, answers, misconceptions");
    add_json_format(options, arguments->as_json);
    add_threads(options, arguments->threads);
    add_memory(options);
    return [arguments] { return lessons(*arguments); };
}

}  // namespace

Command lessons_command() {
    return {"lessons", "[NAME...]", "list lessons, check them, or print one",
            "glint lessons lambert -o lambert.html --key", declare_lessons};
}

}  // namespace glint
