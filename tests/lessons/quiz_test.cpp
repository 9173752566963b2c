// Tests of the installed concept inventory: every key is computed, and every wrong option has a belief; its
// page; the statistics of a class.
#include "lessons/quiz.h"

#include <algorithm>
#include <set>

#include "lessons/check_lesson.h"
#include "tests/places.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

Lesson inventory() {
    const Result<Lesson> lesson = read_lesson(project_file("assets/inventory.md"));
    if (const Problem* problem = problem_of(lesson)) FAIL(problem->text());
    return std::get<Lesson>(lesson);
}

std::vector<Prediction> questions_of(const Lesson& lesson) {
    std::vector<Prediction> questions;
    for (const LessonStep& step : lesson.steps)
        for (const LessonPart& part : step.parts)
            if (const auto* p = std::get_if<Prediction>(&part)) questions.push_back(*p);
    return questions;
}

Json statistics(const std::vector<QuizAnswers>& all) {
    LessonRunner runner(1);
    const Result<Json> counted = quiz_statistics(runner, inventory(), all);
    if (const Problem* problem = problem_of(counted)) FAIL(problem->text());
    return std::get<Json>(counted);
}

double number(const Json& json, const char* a, const char* b) { return json.at(a).at(b).get<double>(); }

}  // namespace

TEST_CASE("the engine confirms the inventory's keys and the options that name a mistake", "[lesson][quiz]") {
    LessonRunner runner(1);
    const Lesson lesson = inventory();
    const Result<std::vector<Checked>> checked = check_lesson(runner, lesson);
    if (const Problem* problem = problem_of(checked)) FAIL(problem->text());
    const auto& items = std::get<std::vector<Checked>>(checked);
    CHECK(items.size() == 24);
    for (const Checked& item : items) {
        INFO(lesson.path << ":" << item.line << ": " << item.says << ": " << item.why);
        CHECK(item.holds);
    }
}

TEST_CASE("each question of the inventory has four options, each wrong one with a belief", "[lesson][quiz]") {
    std::set<std::string> mistakes;
    for (const Prediction& p : questions_of(inventory())) {
        CAPTURE(p.line, p.question);
        CHECK(p.kind == PredictionKind::Choice);
        CHECK(p.options.size() == 4);
        const auto silent = std::count_if(p.options.begin(), p.options.end(),
                                          [](const LessonOption& o) { return o.thinks.empty(); });
        CHECK(silent == 1);  // the right one
        for (const LessonOption& option : p.options)
            if (!option.mistake.empty()) mistakes.insert(option.mistake);
    }
    CHECK(mistakes.size() >= 10);
}

TEST_CASE("the inventory's page has every question and no key; the key explains the options",
          "[lesson][quiz][release]") {
    LessonRunner runner(1);
    const Lesson lesson = inventory();
    const auto page = std::get<std::string>(quiz_html(runner, lesson, false));
    const auto key = std::get<std::string>(quiz_html(runner, lesson, true));
    std::size_t radios = 0;
    for (std::size_t at = page.find("type=\"radio\" name=\"q"); at != page.npos;
         at = page.find("type=\"radio\" name=\"q", at + 1))
        ++radios;
    CHECK(radios == 4 * 24);
    CHECK(page.find("JSON.stringify") != std::string::npos);
    CHECK(page.find("class=\"right\"") == std::string::npos);
    CHECK(key.find("class=\"right\"") != std::string::npos);
    CHECK(page.find("cutoff_as_full_angle") == std::string::npos);
    CHECK(key.find("cutoff_as_full_angle") != std::string::npos);
}

TEST_CASE("only answers in the page's format are accepted", "[lesson][quiz][bad-input]") {
    const Lesson lesson = inventory();
    std::string list = "0";
    for (int i = 1; i < 24; ++i) list += i % 2 == 0 ? ",3" : ",null";
    const auto read = [&](const std::string& text) { return read_answers(lesson, text, "a.json"); };
    const auto good = read(R"({"when": "after", "answers": [)" + list + "]}");
    REQUIRE(problem_of(good) == nullptr);
    CHECK(std::get<QuizAnswers>(good).after);
    CHECK(std::get<QuizAnswers>(good).options[0] == std::size_t{0});
    CHECK_FALSE(std::get<QuizAnswers>(good).options[1].has_value());
    for (const std::string& bad :
         {std::string("no"), std::string("{}"), R"({"when": "later", "answers": [)" + list + "]}",
          std::string(R"({"when": "after", "answers": [0]})"),
          R"({"when": "after", "answers": [4)" + list.substr(1) + "]}",
          R"({"when": "after", "answers": [-1)" + list.substr(1) + "]}",
          R"({"when": "after", "answers": [0.5)" + list.substr(1) + "]}"}) {
        CAPTURE(bad);
        REQUIRE(problem_of(read(bad)) != nullptr);
        CHECK(problem_of(read(bad))->file == "a.json");
    }
}

TEST_CASE("answers written by the window are read back unchanged", "[lesson][quiz]") {
    const Lesson lesson = inventory();
    QuizAnswers given{true, {}};
    for (std::size_t i = 0; i < 24; ++i)
        given.options.push_back(i == 7 ? std::nullopt : std::optional<std::size_t>(i % 4));
    const std::string text = json_line(answers_json(lesson, given));
    CHECK(text.find("\"quiz\":\"" + lesson.title + "\"") != std::string::npos);
    const auto read = std::get<QuizAnswers>(read_answers(lesson, text, "answers.json"));
    CHECK(read.after);
    CHECK(read.options == given.options);
}

TEST_CASE("a class's statistics count options and give the gain", "[lesson][quiz]") {
    // The statistics of an empty class contain the right options.
    const Json none = statistics({});
    std::vector<std::optional<std::size_t>> all_right, half_right;
    for (const Json& question : elements_of(*find_member(none, "questions"))) {
        const auto& options = elements_of(*find_member(question, "options"));
        const auto right = std::find_if(options.begin(), options.end(),
                                        [](const Json& o) { return find_member(o, "right")->get<bool>(); });
        REQUIRE(right != options.end());
        const auto at = static_cast<std::size_t>(right - options.begin());
        all_right.emplace_back(at);
        half_right.emplace_back(half_right.size() % 2 == 0 ? at : (at + 1) % options.size());
    }
    CHECK(*find_member(none, "gain") == Json());
    const Json counted = statistics({{false, half_right}, {true, half_right}, {true, all_right}});
    CHECK(number(counted, "people", "before") == 1);
    CHECK(number(counted, "people", "after") == 2);
    CHECK(number(counted, "right", "before") == Approx(0.5));
    CHECK(number(counted, "right", "after") == Approx(0.75));
    CHECK(find_member(counted, "gain")->get<double>() == Approx(0.5));
    const Json& second = elements_of(*find_member(counted, "questions")).at(1);
    CHECK(find_member(second, "right_before")->get<double>() == 0);
    CHECK(find_member(second, "right_after")->get<double>() == Approx(0.5));
}

TEST_CASE("answers to another quiz and damaged answers are rejected with their line",
          "[lesson][quiz][bad-input]") {
    const Lesson lesson = inventory();
    std::string list = "0";
    for (int i = 1; i < 24; ++i) list += ",0";
    const auto problem_with = [&](const std::string& text) {
        const Result<QuizAnswers> read = read_answers(lesson, text, "a.json");
        return problem_of(read) == nullptr ? "" : problem_of(read)->text();
    };
    const std::string rest = R"(, "when": "after", "answers": [)" + list + "]}";
    CHECK(problem_with(R"({"quiz": ")" + lesson.title + '"' + rest).empty());
    CHECK(problem_with(R"({"quiz": "Sound")" + rest) ==
          "a.json: /quiz: answers to \"Sound\"; expected \"" + lesson.title + "\"");
    CHECK(problem_with(R"({"quiz": 1)" + rest).starts_with("a.json: /quiz: "));
    CHECK(problem_with("{\n\"when\": \"after\",\n\"answers\": [0,\n}") ==
          "a.json:4: unexpected \"}\"; expected a value");
    CHECK(problem_with("{\n\"when\": \"after\",\n\"when\": \"before\"}").starts_with("a.json:3: "));
}
