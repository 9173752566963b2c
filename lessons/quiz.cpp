#include "lessons/quiz.h"

#include <fmt/format.h>

#include <iterator>
#include <sstream>

#include "lessons/handout.h"
#include "lessons/page.h"
#include "models/io/markup.h"
#include "renderer/image/html_image.h"

namespace glint {
namespace {

/// A question and its scene.
struct Posed {
    const LessonStep* step = nullptr;
    const Prediction* question = nullptr;
};

std::vector<Posed> questions_of(const Lesson& lesson) {
    std::vector<Posed> posed;
    for (const LessonStep& step : lesson.steps)
        for (const LessonPart& part : step.parts)
            if (const auto* p = std::get_if<Prediction>(&part))
                if (p->kind == PredictionKind::Choice) posed.push_back({&step, p});
    return posed;
}

/// The number of the right option, from 0.
Result<std::size_t> key_of(LessonRunner& runner, const Lesson& lesson, const Posed& posed) {
    const Result<SceneDocument> opened = runner.open(lesson);
    if (const Problem* problem = problem_of(opened)) return *problem;
    const Result<SceneDocument> set =
        LessonRunner::with(std::get<SceneDocument>(opened), posed.step->set, lesson, posed.step->line);
    if (const Problem* problem = problem_of(set)) return *problem;
    const Result<RightAnswer> right =
        right_answer(runner, std::get<SceneDocument>(set), lesson, *posed.question);
    if (const Problem* problem = problem_of(right)) return *problem;
    return static_cast<std::size_t>(std::get<RightAnswer>(right).value.get<double>());
}

/// The script that saves the answers as a JSON file, created in the page itself.
constexpr std::string_view saving = R"JS(
<p><label><input type="radio" name="when" value="before" checked> before the lessons</label>
<label><input type="radio" name="when" value="after"> after them</label></p>
<p><button type="button" id="save">Save my answers</button></p>
<script>
document.getElementById("save").onclick = () => {
  const answers = [...document.querySelectorAll("fieldset")].map(f => {
    const taken = f.querySelector("input:checked");
    return taken ? Number(taken.value) : null;
  });
  const when = document.querySelector("input[name=when]:checked").value;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([JSON.stringify({quiz: document.title, when, answers})],
    {type: "application/json"}));
  link.download = "answers-" + when + ".json";
  link.click();
};
</script>
)JS";

std::string options_html(const Prediction& p, std::size_t number, std::optional<std::size_t> right) {
    std::string html = fmt::format("<fieldset class=\"box\"><p>{}</p>\n", html_escaped(p.question));
    for (std::size_t i = 0; i < p.options.size(); ++i) {
        const LessonOption& option = p.options[i];
        const std::string text = html_escaped(option.text);
        if (!right) {
            html += fmt::format("<p><label><input type=\"radio\" name=\"q{}\" value=\"{}\"> {}</label></p>\n",
                                number, i, text);
            continue;
        }
        html +=
            fmt::format("<p{}>{} {}", i == *right ? " class=\"right\"" : "", i == *right ? "☑" : "☐", text);
        if (!option.thinks.empty()) html += fmt::format("<br><small>{}</small>", html_escaped(option.thinks));
        if (!option.mistake.empty())
            html += fmt::format(" <small>(<code>{}</code>)</small>", html_escaped(option.mistake));
        html += "</p>\n";
    }
    return html + "</fieldset>\n";
}

/// Whether this is the page's title as a browser reports it, with white space collapsed.
bool is_title(const Json& told, const std::string& title) {
    const auto words = [](const std::string& text) {
        std::istringstream in(text);
        return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
    };
    return told.is_string() && words(told.get_ref<const std::string&>()) == words(title);
}

/// Null if nobody answered.
Json share_of(std::size_t part, std::size_t whole) {
    if (whole == 0) return {};
    return static_cast<double>(part) / static_cast<double>(whole);
}

/// How often each option was chosen, before or after the lessons.
std::vector<std::size_t> taken(const std::vector<QuizAnswers>& all, std::size_t question, std::size_t options,
                               bool after) {
    std::vector<std::size_t> counts(options, 0);
    for (const QuizAnswers& answers : all)
        if (answers.after == after && answers.options[question]) ++counts[*answers.options[question]];
    return counts;
}

}  // namespace

Result<std::string> quiz_html(LessonRunner& runner, const Lesson& lesson, bool key) {
    const Result<SceneDocument> opened = runner.open(lesson);
    if (const Problem* problem = problem_of(opened)) return *problem;
    std::string body;
    body += fmt::format("<p class=\"topic\">{}</p>\n<h1>{}</h1>\n", html_escaped(lesson.topic),
                        html_escaped(lesson.title));
    std::size_t number = 0;
    for (const LessonStep& step : lesson.steps) {
        if (!step.title.empty()) body += fmt::format("<h2>{}</h2>\n", html_escaped(step.title));
        const Result<SceneDocument> set =
            LessonRunner::with(std::get<SceneDocument>(opened), step.set, lesson, step.line);
        if (const Problem* problem = problem_of(set)) return *problem;
        if (!step.title.empty()) {
            const Result<SceneDocument> shown =
                LessonRunner::for_paper(std::get<SceneDocument>(set), step, lesson, key);
            if (const Problem* problem = problem_of(shown)) return *problem;
            const Result<Picture> picture =
                runner.picture(std::get<SceneDocument>(shown), lesson, handout_size(lesson), 4);
            if (const Problem* problem = problem_of(picture)) return *problem;
            body += html_image(std::get<Picture>(picture), "What the question is about") + "\n";
        }
        for (const LessonPart& part : step.parts) {
            if (const auto* prose = std::get_if<std::vector<ProseBlock>>(&part)) body += prose_html(*prose);
            const auto* p = std::get_if<Prediction>(&part);
            if (p == nullptr || p->kind != PredictionKind::Choice) continue;
            std::optional<std::size_t> right;
            if (key) {
                const Result<std::size_t> found = key_of(runner, lesson, {&step, p});
                if (const Problem* problem = problem_of(found)) return *problem;
                right = std::get<std::size_t>(found);
            }
            body += options_html(*p, ++number, right);
        }
    }
    if (number == 0) return Problem{lesson.path, "", "there is no question", "a block \"predict choice\""};
    if (!key) body += saving;
    return page_html(lesson.title, body);
}

Json answers_json(const Lesson& lesson, const QuizAnswers& answers) {
    Json options = Json::array();
    for (const std::optional<std::size_t>& option : answers.options)
        options.push_back(option ? Json(*option) : Json());
    return {{"quiz", lesson.title}, {"when", answers.after ? "after" : "before"}, {"answers", options}};
}

Result<QuizAnswers> read_answers(const Lesson& lesson, std::string_view text, const std::string& file) {
    const std::vector<Posed> questions = questions_of(lesson);
    const bool is_blank = text.find_first_not_of(" \t\r\n") == std::string_view::npos;
    const Result<Json> read_text = read_json(is_blank ? "null" : text, file);
    if (const Problem* problem = problem_of(read_text)) return *problem;
    const auto& json = std::get<Json>(read_text);
    if (const Json* quiz = find_member(json, "quiz"); quiz != nullptr && !is_title(*quiz, lesson.title))
        return Problem{file, "/quiz", "answers to " + json_line(*quiz), json_string(lesson.title)};
    const Json* when = find_member(json, "when");
    const Json* answers = find_member(json, "answers");
    const bool known =
        when != nullptr && when->is_string() &&
        (when->get_ref<const std::string&>() == "before" || when->get_ref<const std::string&>() == "after");
    if (!known || answers == nullptr || elements_of(*answers).size() != questions.size())
        return Problem{
            file, "", "these are not answers to " + json_string(lesson.title),
            fmt::format("\"when\": \"before\" or \"after\", and {} \"answers\"", questions.size())};
    QuizAnswers read{when->get_ref<const std::string&>() == "after", {}};
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const Json& answer = elements_of(*answers)[i];
        const std::size_t options = questions[i].question->options.size();
        if (answer == Json()) {
            read.options.emplace_back();
        } else if (answer.is_number_integer() && answer.get<double>() >= 0 &&
                   answer.get<double>() < static_cast<double>(options)) {
            read.options.emplace_back(static_cast<std::size_t>(answer.get<double>()));
        } else {
            return Problem{file, fmt::format("/answers/{}", i), "is not an option",
                           fmt::format("0 to {}, or null", options - 1)};
        }
    }
    return read;
}

Result<Json> quiz_statistics(LessonRunner& runner, const Lesson& lesson,
                             const std::vector<QuizAnswers>& all) {
    const std::vector<Posed> questions = questions_of(lesson);
    std::size_t people[2] = {0, 0}, right_answers[2] = {0, 0};
    for (const QuizAnswers& answers : all) ++people[answers.after ? 1 : 0];
    Json list = Json::array();
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const Prediction& p = *questions[i].question;
        const Result<std::size_t> found = key_of(runner, lesson, questions[i]);
        if (const Problem* problem = problem_of(found)) return *problem;
        const std::size_t right = std::get<std::size_t>(found);
        const std::vector<std::size_t> before = taken(all, i, p.options.size(), false),
                                       after = taken(all, i, p.options.size(), true);
        right_answers[0] += before[right];
        right_answers[1] += after[right];
        Json options = Json::array();
        for (std::size_t o = 0; o < p.options.size(); ++o)
            options.push_back({{"option", p.options[o].text},
                               {"right", o == right},
                               {"thinks", p.options[o].thinks},
                               {"mistake", p.options[o].mistake},
                               {"before", before[o]},
                               {"after", after[o]}});
        list.push_back({{"question", p.question},
                        {"right_before", share_of(before[right], people[0])},
                        {"right_after", share_of(after[right], people[1])},
                        {"options", options}});
    }
    const Json before = share_of(right_answers[0], people[0] * questions.size()),
               after = share_of(right_answers[1], people[1] * questions.size());
    Json gain;  // null if there is nothing to compare or to gain
    if (before.is_number() && after.is_number() && before.get<double>() < 1)
        gain = (after.get<double>() - before.get<double>()) / (1 - before.get<double>());
    return Json{{"quiz", lesson.title},
                {"people", {{"before", people[0]}, {"after", people[1]}}},
                {"right", {{"before", before}, {"after", after}}},
                {"gain", gain},
                {"questions", list}};
}

}  // namespace glint
