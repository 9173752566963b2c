#include "lessons/quiz.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "lessons/handout.h"
#include "lessons/lesson_source.h"
#include "models/utf8.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

/// A question and the scene that it is about.
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

/// The index of the right option. This function and its callees throw ProblemFound.
std::size_t key_of(LessonRunner& runner, const Lesson& lesson, const Posed& posed) {
    const SceneDocument set = value_or_throw(
        LessonRunner::with(value_or_throw(runner.open(lesson)), posed.step->set, lesson, posed.step->line));
    return static_cast<std::size_t>(
        value_or_throw(right_answer(runner, set, lesson, *posed.question)).value.get<double>());
}

/// The picture of a question. Hides the answer unless it is for the `key`.
std::pair<Picture, std::string> picture_of(LessonRunner& runner, const Lesson& lesson, const LessonStep& step,
                                           bool key) {
    const SceneDocument set =
        value_or_throw(LessonRunner::with(value_or_throw(runner.open(lesson)), step.set, lesson, step.line));
    const SceneDocument shown = value_or_throw(LessonRunner::for_paper(set, step, lesson, key));
    return {value_or_throw(runner.picture(shown, lesson, handout_size(lesson), 4)),
            alternative_text(step, shown.scene)};
}

/// The input fields and the script that saves the answers as a JSON file, generated in the page itself. Hides
/// the questions that use the course's terms in the quiz before the lessons.
constexpr std::string_view saving = R"JS(
<div class="window"><p><label>Your number or code: <input id="person" size="12"></label></p>
<p><label><input type="radio" name="when" value="before"> before the lessons</label>
<label><input type="radio" name="when" value="after"> after the lessons</label></p>
<p id="missing" role="status"></p>
<p><button type="button" id="save">Save my answers</button></p></div>
<script>
const items = [...document.querySelectorAll("fieldset")], seconds = items.map(() => 0);
const taken = f => f.querySelector("input:checked");
let since = Date.now();
items.forEach((f, i) => f.onchange = () => {
  seconds[i] += Math.round((Date.now() - since) / 100) / 10;
  since = Date.now();
});
const when = () => document.querySelector("input[name=when]:checked");
document.querySelectorAll("input[name=when]").forEach(r => r.onchange = () =>
  document.querySelectorAll(".course").forEach(s => s.hidden = when().value === "before"));
let warned = "";
document.getElementById("save").onclick = () => {
  const person = document.getElementById("person").value.trim();
  const open = items.filter(f => !f.closest("[hidden]") && !taken(f)).length;
  let missing = "";
  if (!when()) missing = "Choose first: before or after the lessons?";
  else if (!person) missing = "Enter your number or code: the same one before and after.";
  else if (open) missing = "Questions without an answer: " + open + ". Press again to save anyway.";
  document.getElementById("missing").textContent = missing;
  if (missing && (!open || !when() || !person || warned !== missing)) { warned = missing; return; }
  const answers = items.map(f => taken(f) && !f.closest("[hidden]") ? Number(taken(f).value) : null);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([JSON.stringify({quiz: document.title, person, when: when().value, answers,
    seconds})], {type: "application/json"}));
  link.download = "answers-" + person + "-" + when().value + ".json";
  link.click();
};
</script>
)JS";

std::string options_html(const Prediction& p, std::size_t number, std::optional<std::size_t> right) {
    std::string html = fmt::format("<fieldset class=\"box\"><legend>Question {}</legend><p>{}</p>\n", number,
                                   lesson_html(p.question));
    for (std::size_t i = 0; i < p.options.size(); ++i) {
        const LessonOption& option = p.options[i];
        const std::string text = lesson_html(option.text);
        if (!right) {
            html += fmt::format("<p><label><input type=\"radio\" name=\"q{}\" value=\"{}\"> {}</label></p>\n",
                                number, i, text);
            continue;
        }
        html += fmt::format("<p{}>{} {}{}", i == *right ? " class=\"right\"" : "", static_cast<char>('A' + i),
                            text, i == *right ? " (right)" : "");
        if (!option.thinks.empty()) html += fmt::format("<br>{}", lesson_html(option.thinks));
        if (!option.mistake.empty()) html += fmt::format(" (<code>{}</code>)", html_escaped(option.mistake));
        html += "</p>\n";
    }
    return html + "</fieldset>\n";
}

/// Compares a title with that of the page as a browser reports it, ignoring differences in white space.
bool is_title(const Json& told, const std::string& title) {
    return told.is_string() && words_of(told.get_ref<const std::string&>()) == words_of(title);
}

/// The share of a part, or null if there are no answers.
Json share_of(std::size_t part, std::size_t whole) {
    if (whole == 0) return {};
    return static_cast<double>(part) / static_cast<double>(whole);
}

/// The number of scored questions: those in plain language, equally many in all forms.
std::size_t scored(const Lesson& lesson, std::size_t questions) {
    return lesson.plain == 0 ? questions : std::min(questions, static_cast<std::size_t>(lesson.plain));
}

/// The right option of each question of a form.
std::vector<std::size_t> keys_of(LessonRunner& runner, const Lesson& lesson) {
    std::vector<std::size_t> keys;
    for (const Posed& posed : questions_of(lesson)) keys.push_back(key_of(runner, lesson, posed));
    return keys;
}

bool is_right(const QuizAnswers& answers, std::size_t question, const std::vector<std::size_t>& keys) {
    return answers.options[question] == keys[question];
}

double score_of(const QuizAnswers& answers, std::size_t count, const std::vector<std::size_t>& keys) {
    double score = 0;
    for (std::size_t i = 0; i < count; ++i) score += is_right(answers, i, keys) ? 1 : 0;
    return score;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
/// The population covariance.
double covariance(const std::vector<double>& a, const std::vector<double>& b) {
    const double mean_a = mean_of(a), mean_b = mean_of(b);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - mean_a) * (b[i] - mean_b);
    return sum / static_cast<double>(a.size());
}

/// The correlation; NaN if there are no values or they do not vary.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    return covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
}

std::string two_digits(double value) { return std::isfinite(value) ? fmt::format("{:.2f}", value) : "-"; }

/// The table of one form, before or after the lessons. `all`: the answers to include.
std::string table_of(const std::vector<const QuizAnswers*>& all, std::size_t count,
                     const std::vector<std::size_t>& keys, const std::string& title) {
    std::string text = fmt::format("{}, people: {}\nitem  difficulty  discrimination\n", title, all.size());
    std::vector<double> scores;
    scores.reserve(all.size());
    for (const QuizAnswers* answers : all) scores.push_back(score_of(*answers, count, keys));
    double spread = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> right, others;
        for (std::size_t person = 0; person < all.size(); ++person) {
            right.push_back(is_right(*all[person], i, keys) ? 1 : 0);
            others.push_back(scores[person] - right.back());
        }
        const double share = mean_of(right);
        spread += share * (1 - share);
        text += fmt::format("{:>4}  {:>10}  {:>14}\n", i + 1, two_digits(share),
                            two_digits(correlation(right, others)));
    }
    const auto k = static_cast<double>(count);
    return text + fmt::format("reliability (KR-20) {}\n\n",
                              two_digits(k / (k - 1) * (1 - spread / covariance(scores, scores))));
}

/// The scores before and after the lessons of each person who gave a code.
using Matched = std::map<std::string, std::array<std::optional<double>, 2>>;

std::string gain_text(const Matched& people) {
    std::vector<double> gains;
    for (const auto& [person, share] : people)
        if (share[0] && share[1] && *share[0] < 1) gains.push_back((*share[1] - *share[0]) / (1 - *share[0]));
    if (gains.empty()) return "gain: nobody answered before and after with the same code\n";
    const double error = std::sqrt(covariance(gains, gains) / static_cast<double>(gains.size()));
    return fmt::format("gain: {} (standard error {}), people: {}, matched by their codes\n",
                       two_digits(mean_of(gains)), two_digits(error), gains.size());
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
    return result_of(lesson.path, [&] {
        std::string body = fmt::format("<p class=\"topic\">{}</p>\n<h1>{}</h1>\n", lesson_html(lesson.topic),
                                       lesson_html(lesson.title));
        std::size_t number = 0;
        for (const LessonStep& step : lesson.steps) {
            const bool is_course =
                !key && lesson.plain > 0 && number >= static_cast<std::size_t>(lesson.plain);
            body += is_course ? "<section class=\"course\">\n" : "<section>\n";
            if (!step.title.empty()) {
                const auto [picture, alt] = picture_of(runner, lesson, step, key);
                body += fmt::format("<h2>{}</h2>\n{}\n", lesson_html(step.title), html_image(picture, alt));
            }
            for (const LessonPart& part : step.parts) {
                if (const auto* prose = std::get_if<std::vector<ProseBlock>>(&part))
                    body += prose_html(*prose);
                const auto* p = std::get_if<Prediction>(&part);
                if (p == nullptr || p->kind != PredictionKind::Choice) continue;
                body += options_html(*p, ++number,
                                     key ? std::optional(key_of(runner, lesson, {&step, p})) : std::nullopt);
            }
            body += "</section>\n";
        }
        if (number == 0)
            throw ProblemFound({lesson.path, "", "there is no question", "a block \"predict choice\""});
        return page_html(lesson.title, key ? body : body + std::string(saving));
    });
}

Json answers_json(const Lesson& lesson, const QuizAnswers& answers) {
    Json options = Json::array();
    for (const std::optional<std::size_t>& option : answers.options)
        options.push_back(option ? Json(*option) : Json());
    Json json{{"quiz", lesson.title}, {"when", answers.after ? "after" : "before"}, {"answers", options}};
    if (!answers.person.empty()) json["person"] = answers.person;
    if (!answers.seconds.empty()) json["seconds"] = answers.seconds;
    return json;
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
    if (const Json* person = find_member(json, "person"); person != nullptr && person->is_string())
        read.person = person->get<std::string>();
    if (const Json* seconds = find_member(json, "seconds"); seconds != nullptr) {
        const auto is_time = [](const Json& s) { return s.is_number() && s.get<double>() >= 0; };
        const Json::array_t& list = elements_of(*seconds);
        if (list.size() != questions.size() || !std::all_of(list.begin(), list.end(), is_time))
            return Problem{file, "/seconds", "is not a list of times",
                           fmt::format("{} numbers", questions.size())};
        for (const Json& s : list) read.seconds.push_back(s.get<double>());
    }
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
    return result_of(lesson.path, [&] {
        const std::vector<Posed> questions = questions_of(lesson);
        const std::vector<std::size_t> keys = keys_of(runner, lesson);
        std::size_t people[2] = {0, 0}, right_answers[2] = {0, 0};
        for (const QuizAnswers& answers : all) ++people[answers.after ? 1 : 0];
        Json list = Json::array();
        for (std::size_t i = 0; i < questions.size(); ++i) {
            const Prediction& p = *questions[i].question;
            const std::size_t right = keys[i];
            const std::vector<std::size_t> before = taken(all, i, p.options.size(), false),
                                           after = taken(all, i, p.options.size(), true);
            if (i < scored(lesson, questions.size())) {
                right_answers[0] += before[right];
                right_answers[1] += after[right];
            }
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
        const std::size_t counted = scored(lesson, questions.size());
        const Json before = share_of(right_answers[0], people[0] * counted),
                   after = share_of(right_answers[1], people[1] * counted);
        Json gain;  // null if there is nothing to compare, or no room for a gain
        if (before.is_number() && after.is_number() && before.get<double>() < 1)
            gain = (after.get<double>() - before.get<double>()) / (1 - before.get<double>());
        return Json{{"quiz", lesson.title},
                    {"people", {{"before", people[0]}, {"after", people[1]}}},
                    {"right", {{"before", before}, {"after", after}}},
                    {"gain", gain},
                    {"questions", list}};
    });
}

bool names_quiz(const Lesson& lesson, std::string_view text) {
    const Json* quiz = nullptr;
    const Json json = json_or_null(std::string(text));
    return (quiz = find_member(json, "quiz")) != nullptr && is_title(*quiz, lesson.title);
}

Result<std::string> quiz_analysis(LessonRunner& runner, const std::vector<AnsweredForm>& forms) {
    return result_of("", [&] {
        std::string text;
        Matched people;
        for (const AnsweredForm& form : forms) {
            const std::vector<std::size_t> keys = keys_of(runner, form.lesson);
            const std::size_t plain = scored(form.lesson, keys.size());
            for (const bool after : {false, true}) {
                std::vector<const QuizAnswers*> all;
                for (const QuizAnswers& answers : form.answers)
                    if (answers.after == after) all.push_back(&answers);
                if (all.empty()) continue;
                text += table_of(
                    all, after ? keys.size() : plain, keys,
                    fmt::format("form {}, {} the lessons", form.lesson.form, after ? "after" : "before"));
                for (const QuizAnswers* answers : all)
                    if (!answers->person.empty())
                        people[answers->person][after ? 1 : 0] =
                            score_of(*answers, plain, keys) / static_cast<double>(plain);
            }
        }
        return text + gain_text(people);
    });
}

Result<std::string> quiz_csv(LessonRunner& runner, const std::vector<AnsweredForm>& forms) {
    return result_of("", [&] {
        std::string csv = "person,form,when,item,answer,right,seconds\n";
        for (const AnsweredForm& form : forms) {
            const std::vector<std::size_t> keys = keys_of(runner, form.lesson);
            for (const QuizAnswers& answers : form.answers)
                for (std::size_t i = 0; i < keys.size(); ++i) {
                    if (!answers.options[i]) continue;
                    std::string person = answers.person;
                    std::erase_if(person, [](char c) { return c == '"' || c == '\n' || c == '\r'; });
                    // Prevents a spreadsheet from evaluating the text as a formula.
                    if (!person.empty() && std::string_view("=+-@").find(person[0]) != std::string_view::npos)
                        person.insert(0, "'");
                    csv += fmt::format(
                        "\"{}\",{},{},{},{},{},{}\n", person, form.lesson.form,
                        answers.after ? "after" : "before", i + 1,
                        static_cast<char>('A' + *answers.options[i]), is_right(answers, i, keys) ? 1 : 0,
                        answers.seconds.empty() ? "" : fmt::format("{:.1f}", answers.seconds[i]));
                }
        }
        return csv;
    });
}

Result<std::vector<ExportedQuestion>> quiz_questions(LessonRunner& runner, const Lesson& lesson) {
    return result_of(lesson.path, [&] {
        std::vector<ExportedQuestion> questions;
        for (const Posed& posed : questions_of(lesson)) {
            ExportedQuestion question;
            question.title = posed.step->title;
            for (const LessonPart& part : posed.step->parts)
                if (const auto* prose = std::get_if<std::vector<ProseBlock>>(&part))
                    for (const ProseBlock& block : *prose) question.text += plain_text(block) + ' ';
            question.text += posed.question->question;
            std::tie(question.picture, question.alt) = picture_of(runner, lesson, *posed.step, false);
            const std::size_t right = key_of(runner, lesson, posed);
            for (const LessonOption& option : posed.question->options)
                question.options.push_back(
                    {option.text, option.thinks, &option == &posed.question->options[right]});
            questions.push_back(std::move(question));
        }
        return questions;
    });
}

namespace {

using ZipFiles = std::vector<std::pair<std::string, std::string>>;  // name and bytes

/// Encodes pairs of size in bytes and value as little-endian numbers.
std::string little_endian(std::initializer_list<std::pair<std::size_t, int>> numbers) {
    std::string bytes;
    for (const auto& [number, count] : numbers)
        for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
    return bytes;
}

std::string zip_bytes(const ZipFiles& files) {
    // 1 January 1980 instead of today, so that equal input gives equal bytes.
    constexpr std::size_t version = 20, first_day = (1 << 5) + 1;
    std::string zip, directory;
    for (const auto& [name, bytes] : files) {
        const std::string fields =
            little_endian({{version, 2},
                           {0, 2},
                           {0, 2},
                           {0, 2},
                           {first_day, 2},
                           {crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()), 4},
                           {bytes.size(), 4},
                           {bytes.size(), 4},
                           {name.size(), 2},
                           {0, 2}});
        directory.append("PK\x01\x02").append(little_endian({{version, 2}})).append(fields);
        directory.append(little_endian({{0, 2}, {0, 2}, {0, 2}, {0, 4}, {zip.size(), 4}})).append(name);
        zip.append("PK\x03\x04").append(fields).append(name).append(bytes);
    }
    const std::size_t count = files.size(), start = zip.size();
    return zip + directory + "PK\x05\x06" +
           little_endian({{0, 2}, {0, 2}, {count, 2}, {count, 2}, {directory.size(), 4}, {start, 4}, {0, 2}});
}

constexpr std::string_view xml_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// {0} name, {1} title, {2} type of the answer, {3} answer, {4} picture and text, {5} interaction, {6}
/// comparison with the answer, {7} feedback declaration, {8} feedback assignment, {9} feedback text.
constexpr const char* item_form = R"(<assessmentItem xmlns="http://www.imsglobal.org/xsd/imsqti_v2p1"
 identifier="{0}" title="{1}" adaptive="false" timeDependent="false">
<responseDeclaration identifier="RESPONSE" cardinality="single" baseType="{2}">
<correctResponse><value>{3}</value></correctResponse></responseDeclaration>
<outcomeDeclaration identifier="SCORE" cardinality="single" baseType="float">
<defaultValue><value>0</value></defaultValue></outcomeDeclaration>
{7}<itemBody>
{4}{5}</itemBody>
<responseProcessing>
<responseCondition><responseIf>{6}
<setOutcomeValue identifier="SCORE"><baseValue baseType="float">1</baseValue></setOutcomeValue>
</responseIf></responseCondition>
{8}</responseProcessing>
{9}</assessmentItem>
)";
constexpr const char* number_form =
    R"(<equal toleranceMode="absolute" tolerance="{0} {0}">)"
    R"(<variable identifier="RESPONSE"/><correct identifier="RESPONSE"/></equal>)";
constexpr const char* test_form = R"(<assessmentTest xmlns="http://www.imsglobal.org/xsd/imsqti_v2p1"
 identifier="test" title="{0}">
<testPart identifier="part" navigationMode="nonlinear" submissionMode="simultaneous">
<assessmentSection identifier="section" title="{0}" visible="true">
{1}</assessmentSection>
</testPart>
</assessmentTest>
)";
constexpr const char* manifest_form =
    R"(<manifest xmlns="http://www.imsglobal.org/xsd/imscp_v1p1" identifier="glint">
<metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion></metadata>
<organizations/>
<resources>
<resource identifier="r-test" type="imsqti_test_xmlv2p1" href="test.xml"><file href="test.xml"/></resource>
{}</resources>
</manifest>
)";

std::string qti_item(const ExportedQuestion& q, const std::string& name) {
    const bool is_choice = !q.options.empty();
    std::string correct = fmt::format("{}", q.answer), feedback, options;
    for (std::size_t i = 0; i < q.options.size(); ++i) {
        const ExportedQuestion::Option& option = q.options[i];
        const char letter = static_cast<char>('A' + i);
        if (option.is_right) correct = letter;
        options += fmt::format("<simpleChoice identifier=\"{}\">{}</simpleChoice>\n", letter,
                               html_escaped(option.text));
        if (option.feedback.empty()) continue;
        feedback +=
            fmt::format(
                R"(<modalFeedback outcomeIdentifier="FEEDBACK" showHide="show" identifier="{}">{}</modalFeedback>)",
                letter, html_escaped(option.feedback)) +
            "\n";
    }
    const std::string interaction =
        is_choice
            ? fmt::format(
                  R"(<choiceInteraction responseIdentifier="RESPONSE" shuffle="false" maxChoices="1">{}</choiceInteraction>)",
                  options)
            : fmt::format(
                  R"(<p><textEntryInteraction responseIdentifier="RESPONSE" expectedLength="12"/> {}</p>)",
                  html_escaped(q.unit));
    const char* const match =
        R"(<match><variable identifier="RESPONSE"/><correct identifier="RESPONSE"/></match>)";
    const char* const declares =
        R"(<outcomeDeclaration identifier="FEEDBACK" cardinality="single" baseType="identifier"/>)";
    const char* const sets =
        R"(<setOutcomeValue identifier="FEEDBACK"><variable identifier="RESPONSE"/></setOutcomeValue>)";
    std::string text;
    if (q.picture) text = fmt::format("<p><img src=\"{}.png\" alt=\"{}\"/></p>\n", name, html_escaped(q.alt));
    text += "<p>" + html_escaped(q.text) + "</p>\n";
    return std::string(xml_head) +
           fmt::format(fmt::runtime(item_form), name, html_escaped(q.title),
                       is_choice ? "identifier" : "float", correct, text, interaction,
                       is_choice ? match : fmt::format(fmt::runtime(number_form), q.tolerance),
                       feedback.empty() ? "" : declares, feedback.empty() ? "" : sets, feedback);
}

}  // namespace

std::string qti_package(const std::string& title, const std::vector<ExportedQuestion>& questions) {
    ZipFiles files;
    std::string references, resources;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const std::string name = fmt::format("q{}", i + 1);
        files.emplace_back(name + ".xml", qti_item(questions[i], name));
        references += fmt::format("<assessmentItemRef identifier=\"{0}\" href=\"{0}.xml\"/>\n", name);
        const bool has_picture = questions[i].picture.has_value();
        if (has_picture) files.emplace_back(name + ".png", png_bytes(*questions[i].picture, {}));
        resources +=
            fmt::format(
                R"(<resource identifier="r-{0}" type="imsqti_item_xmlv2p1" href="{0}.xml"><file href="{0}.xml"/>{1}</resource>)",
                name, has_picture ? "<file href=\"" + name + ".png\"/>" : "") +
            "\n";
    }
    files.emplace_back("test.xml", std::string(xml_head) +
                                       fmt::format(fmt::runtime(test_form), html_escaped(title), references));
    files.emplace_back("imsmanifest.xml",
                       std::string(xml_head) + fmt::format(fmt::runtime(manifest_form), resources));
    return zip_bytes(files);
}

std::string moodle_xml(const std::string& title, const std::vector<ExportedQuestion>& questions) {
    const auto text = [](const char* element, const std::string& html, const std::string& file = {}) {
        return fmt::format("<{0} format=\"html\"><text>{1}</text>{2}</{0}>\n", element, html_escaped(html),
                           file);
    };
    std::string xml = fmt::format(
        "{}<quiz>\n<question "
        "type=\"category\"><category><text>$course$/Glint/{}</text></category></question>\n",
        xml_head, html_escaped(title));
    for (const ExportedQuestion& q : questions) {
        std::string html = "<p>" + html_escaped(q.text) + "</p>", file;
        if (q.picture) {
            html = fmt::format("<p><img src=\"@@PLUGINFILE@@/picture.png\" alt=\"{}\"></p>{}",
                               html_escaped(q.alt), html);
            file = fmt::format("<file name=\"picture.png\" path=\"/\" encoding=\"base64\">{}</file>",
                               base64(png_bytes(*q.picture, {})));
        }
        if (!q.unit.empty()) html += "<p>(" + html_escaped(q.unit) + ")</p>";
        xml += fmt::format(
            "<question "
            "type=\"{}\"><name><text>{}</text></name>\n{}{}<defaultgrade>1</defaultgrade><hidden>0</"
            "hidden>\n",
            q.options.empty() ? "numerical" : "multichoice", html_escaped(q.title),
            text("questiontext", html, file), text("generalfeedback", html_escaped(q.feedback)));
        if (q.options.empty())
            xml += fmt::format(
                "<answer fraction=\"100\" "
                "format=\"moodle_auto_format\"><text>{}</text>{}<tolerance>{}</tolerance></answer>\n",
                q.answer, text("feedback", ""), q.tolerance);
        else
            xml +=
                "<single>true</single><shuffleanswers>false</shuffleanswers><answernumbering>ABCD</"
                "answernumbering>\n";
        for (const ExportedQuestion::Option& option : q.options)
            xml += fmt::format("<answer fraction=\"{}\" format=\"html\"><text>{}</text>{}</answer>\n",
                               option.is_right ? 100 : 0, html_escaped(html_escaped(option.text)),
                               text("feedback", html_escaped(option.feedback)));
        xml += "</question>\n";
    }
    return xml + "</quiz>\n";
}

std::string exported(const std::string& out, const std::string& title,
                     const std::vector<ExportedQuestion>& questions) {
    return out.ends_with(".zip") ? qti_package(title, questions) : moodle_xml(title, questions);
}

}  // namespace glint
