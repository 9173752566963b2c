// Tests for the installed concept inventory (every key is computed, and every wrong option names a belief),
// its page, and the statistics of a class.
#include "lessons/quiz.h"

#include <algorithm>
#include <map>
#include <set>

#include "lessons/check_lesson.h"
#include "tests/places.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

Lesson inventory(const char* form = "assets/inventory.md") {
    const Result<Lesson> lesson = read_lesson(project_file(form));
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
    for (const char* const form : {"assets/inventory.md", "assets/inventory-b.md"}) {
        const Lesson lesson = inventory(form);
        const Result<std::vector<Checked>> checked = check_lesson(runner, lesson);
        if (const Problem* problem = problem_of(checked)) FAIL(problem->text());
        const auto& items = std::get<std::vector<Checked>>(checked);
        CHECK(items.size() == 24);
        for (const Checked& item : items) {
            INFO(lesson.path << ":" << item.line << ": " << item.says << ": " << item.why);
            CHECK(item.holds);
        }
    }
}

TEST_CASE("the two forms ask the same questions with different numbers or objects", "[lesson][quiz]") {
    const Lesson a = inventory(), b = inventory("assets/inventory-b.md");
    CHECK(a.form == "A");
    CHECK(b.form == "B");
    CHECK(a.plain == 14);
    CHECK(b.plain == 14);
    CHECK(a.title != b.title);  // answers are assigned to a form by its title
    REQUIRE(a.steps.size() == b.steps.size());
    for (std::size_t i = 1; i < a.steps.size(); ++i) {
        CAPTURE(a.steps[i].title);
        CHECK(a.steps[i].set != b.steps[i].set);
        CHECK(!a.steps[i].shows.empty());
        CHECK(!b.steps[i].shows.empty());
    }
}

TEST_CASE("each question of the inventory has 4 options, and each wrong one names a belief",
          "[lesson][quiz]") {
    std::set<std::string> mistakes;
    std::vector<Prediction> all = questions_of(inventory());
    for (const Prediction& p : questions_of(inventory("assets/inventory-b.md"))) all.push_back(p);
    for (const Prediction& p : all) {
        CAPTURE(p.line, p.question);
        CHECK(p.kind == PredictionKind::Choice);
        CHECK(p.options.size() == 4);
        const auto silent = std::count_if(p.options.begin(), p.options.end(),
                                          [](const LessonOption& o) { return o.thinks.empty(); });
        CHECK(silent == 1);  // only the right option
        for (const LessonOption& option : p.options)
            if (!option.mistake.empty()) mistakes.insert(option.mistake);
    }
    CHECK(mistakes.size() >= 10);
}

TEST_CASE("the inventory's page has every question but no answers, the key explains options",
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
    std::size_t hidden_before = 0;
    for (std::size_t at = page.find("class=\"course\""); at != page.npos;
         at = page.find("class=\"course\"", at + 1))
        ++hidden_before;
    CHECK(hidden_before == 10);
    CHECK(page.find("value=\"before\" checked") == std::string::npos);  // nothing is preselected
    CHECK(page.find("<legend>Question 24</legend>") != std::string::npos);
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
    QuizAnswers given{true, {}, "17", std::vector<double>(24, 2.5)};
    for (std::size_t i = 0; i < 24; ++i)
        given.options.push_back(i == 7 ? std::nullopt : std::optional<std::size_t>(i % 4));
    const std::string text = json_line(answers_json(lesson, given));
    CHECK(text.find("\"quiz\":\"" + lesson.title + "\"") != std::string::npos);
    const auto read = std::get<QuizAnswers>(read_answers(lesson, text, "answers.json"));
    CHECK(read == given);
}

TEST_CASE("a class's statistics count the chosen options and report the gain", "[lesson][quiz]") {
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

TEST_CASE("answers to another quiz are rejected, damaged ones are reported by line number",
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

namespace {

/// A class of four who answered form A; two of them also answered form B. The first person knows everything,
/// the last knows nothing.
std::vector<AnsweredForm> answered() {
    std::vector<AnsweredForm> forms{{inventory(), {}}, {inventory("assets/inventory-b.md"), {}}};
    LessonRunner runner(1);
    for (AnsweredForm& form : forms) {
        const Json counted = std::get<Json>(quiz_statistics(runner, form.lesson, {}));
        for (int person = 0; person < (form.lesson.form == "A" ? 4 : 2); ++person) {
            QuizAnswers answers{
                form.lesson.form == "B", {}, std::string(1, static_cast<char>('a' + person)), {}};
            std::size_t item = 0;
            for (const Json& question : elements_of(*find_member(counted, "questions"))) {
                const auto& options = elements_of(*find_member(question, "options"));
                std::size_t right = 0;
                while (!find_member(options[right], "right")->get<bool>()) ++right;
                // Before the lessons, person p knows the first 14 - 4 p items, or none if p = 3; afterwards,
                // everybody knows the first 14.
                const std::size_t knows = answers.after ? 14
                                          : person == 3 ? 0
                                                        : 14 - 4 * static_cast<std::size_t>(person);
                answers.options.emplace_back(item < knows ? right : (right + 1) % 4);
                ++item;
            }
            form.answers.push_back(answers);
        }
    }
    return forms;
}

}  // namespace

TEST_CASE("the analysis prints difficulty, discrimination, reliability and gain", "[lesson][quiz]") {
    LessonRunner runner(1);
    const auto text = std::get<std::string>(quiz_analysis(runner, answered()));
    CHECK(text.starts_with("form A, before the lessons, people: 4\n"));
    // Scores 14, 10, 6, 0 of 14. Item 1: three of four answer it correctly. Its correlation with the score on
    // the other items, 13, 9, 5, 0: the covariance of (1, 1, 1, 0) with these scores is 1.6875, the
    // deviations are 0.4330 and 4.8153.
    CHECK(text.find("   1        0.75            0.81\n") != std::string::npos);
    // Item 14: only the first person answers it correctly. The covariance of (1, 0, 0, 0) and (13, 10, 6, 0)
    // is 1.4375, the deviations are 0.4330 and 4.8670.
    CHECK(text.find("  14        0.25            0.68\n") != std::string::npos);
    // KR-20: 14/13 (1 - sum of p (1 - p) / 26.75); p (1 - p) is 0.1875 for ten items, 0.25 for four.
    CHECK(text.find("reliability (KR-20) 0.96\n") != std::string::npos);
    CHECK(text.find("form B, after the lessons, people: 2\n") != std::string::npos);
    // Of the people a and b, only b could improve: from 10 of 14 to 14.
    CHECK(text.find("gain: 1.00 (standard error 0.00), people: 1") != std::string::npos);
}

TEST_CASE("everyone's results are written as a table of comma-separated values", "[lesson][quiz]") {
    LessonRunner runner(1);
    std::vector<AnsweredForm> forms = answered();
    forms[0].answers[3].options[1].reset();
    forms[1].answers[1].seconds.assign(24, 3.25);
    forms[1].answers[1].person = "x\",\n";
    const auto csv = std::get<std::string>(quiz_csv(runner, forms));
    CHECK(csv.starts_with("person,form,when,item,answer,right,seconds\n\"a\",A,before,1,C,1,\n"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 6 * 24 - 1);
    CHECK(csv.find("\"d\",A,before,2,") == std::string::npos);
    CHECK(csv.find("\"x,\",B,after,24,") != std::string::npos);
    CHECK(csv.find(",0,3.2\n") != std::string::npos);
}

namespace {

/// Checks that tags are properly nested and all entities are predefined. Does not validate against the QTI
/// 2.1 schema, which may not be distributed with the program.
void check_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    CHECK(xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"));
    for (std::size_t at = xml.find('<', 1); at != xml.npos; at = xml.find('<', at + 1)) {
        const std::size_t end = xml.find('>', at);
        REQUIRE(end != xml.npos);
        const std::string tag = xml.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
        if (tag.starts_with("/")) {
            REQUIRE(!open.empty());
            CHECK(open.back() == tag.substr(1));
            open.pop_back();
        } else if (!tag.ends_with("/")) {
            open.push_back(name);
        }
        at = end;
    }
    CHECK(open.empty());
    // An ampersand begins one of XML's predefined entities.
    for (std::size_t at = xml.find('&'); at != xml.npos; at = xml.find('&', at + 1)) {
        const std::string entity = xml.substr(at, xml.find(';', at) - at);
        CHECK((entity == "&amp" || entity == "&lt" || entity == "&gt" || entity == "&quot"));
    }
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// Checks that the parts occur in this order.
void check_order(const std::string& text, const std::vector<std::string>& parts) {
    std::size_t at = 0;
    for (const std::string& part : parts) {
        CAPTURE(part);
        at = text.find(part, at);
        REQUIRE(at != text.npos);
    }
}

std::uint32_t number_at(const std::string& bytes, std::size_t at, std::size_t size) {
    std::uint32_t number = 0;
    for (std::size_t i = size; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

/// The files of a zip, read through its directory.
std::map<std::string, std::string> unzipped(const std::string& zip) {
    std::map<std::string, std::string> files;
    const std::size_t end = zip.rfind("PK\x05\x06");
    REQUIRE(end != zip.npos);
    std::size_t at = number_at(zip, end + 16, 4);
    for (std::uint32_t i = 0; i < number_at(zip, end + 10, 2); ++i) {
        REQUIRE(zip.compare(at, 4, "PK\x01\x02") == 0);
        const std::size_t size = number_at(zip, at + 24, 4), name = number_at(zip, at + 28, 2),
                          local = number_at(zip, at + 42, 4);
        REQUIRE(zip.compare(local, 4, "PK\x03\x04") == 0);
        CHECK(number_at(zip, local + 14, 4) == number_at(zip, at + 16, 4));
        files[zip.substr(at + 46, name)] = zip.substr(local + 30 + number_at(zip, local + 26, 2), size);
        at += 46 + name;
    }
    return files;
}

std::vector<ExportedQuestion> two_questions() {
    ExportedQuestion choice, number;
    choice.title = "Red & green";
    choice.text = "Is 1 < 2?";
    choice.picture = Picture{{1, 1}, {1, 2, 3, 255}, {}, 1};
    choice.alt = "A \"dot\"";
    choice.options = {{"yes", "", true}, {"no", "Size & number.", false}};
    number.title = "How much?";
    number.text = "2 · 0.3?";
    number.answer = 0.6;
    number.tolerance = 0.01;
    number.unit = "m";
    number.feedback = "2 · 0.3";
    return {choice, number};
}

}  // namespace

TEST_CASE("the QTI package has a manifest, a test, and valid items with their pictures", "[lesson][quiz]") {
    const std::map<std::string, std::string> files = unzipped(qti_package("A <quiz>", two_questions()));
    REQUIRE(files.size() == 5);
    for (const auto& [name, bytes] : files)
        if (name.ends_with(".xml")) check_well_formed(bytes);
    CHECK(files.at("q1.png").starts_with("\x89PNG"));
    check_order(files.at("q1.xml"),
                {"<assessmentItem xmlns=\"http://www.imsglobal.org/xsd/imsqti_v2p1\"",
                 "identifier=\"q1\" title=\"Red &amp; green\"",
                 "adaptive=\"false\" timeDependent=\"false\"",
                 "<responseDeclaration",
                 "baseType=\"identifier\"",
                 "<correctResponse><value>A</value>",
                 "<outcomeDeclaration identifier=\"SCORE\"",
                 "<outcomeDeclaration identifier=\"FEEDBACK\"",
                 "<itemBody>",
                 "<img src=\"q1.png\" alt=\"A &quot;dot&quot;\"/>",
                 "Is 1 &lt; 2?",
                 "<choiceInteraction",
                 "maxChoices=\"1\"",
                 "<simpleChoice identifier=\"A\">yes",
                 "<simpleChoice identifier=\"B\">no",
                 "</itemBody>",
                 "<responseProcessing>",
                 "<match>",
                 "</responseProcessing>",
                 "<modalFeedback outcomeIdentifier=\"FEEDBACK\" showHide=\"show\" identifier=\"B\">",
                 "Size &amp; number."});
    check_order(files.at("q2.xml"), {"baseType=\"float\"", "<value>0.6</value>",
                                     "<textEntryInteraction responseIdentifier=\"RESPONSE\"", " m</p>",
                                     "<equal toleranceMode=\"absolute\" tolerance=\"0.01 0.01\">"});
    CHECK(files.at("q2.xml").find("FEEDBACK") == std::string::npos);
    check_order(files.at("test.xml"), {"<assessmentTest", "title=\"A &lt;quiz&gt;\"", "<testPart",
                                       "<assessmentSection", "href=\"q1.xml\"", "href=\"q2.xml\""});
    check_order(
        files.at("imsmanifest.xml"),
        {"<metadata>", "<organizations/>", "type=\"imsqti_test_xmlv2p1\" href=\"test.xml\"",
         "type=\"imsqti_item_xmlv2p1\" href=\"q1.xml\"><file href=\"q1.xml\"/><file href=\"q1.png\"/>"});
}

TEST_CASE("Moodle XML has a category, and each question with its answers and feedback", "[lesson][quiz]") {
    const std::string xml = moodle_xml("A <quiz>", two_questions());
    check_well_formed(xml);
    check_order(xml,
                {"<quiz>", "<question type=\"category\">", "$course$/Glint/A &lt;quiz&gt;",
                 "<question type=\"multichoice\">", "<name><text>Red &amp; green</text>",
                 "@@PLUGINFILE@@/picture.png", "Is 1 &amp;lt; 2?",
                 "<file name=\"picture.png\" path=\"/\" encoding=\"base64\">iVBOR", "<single>true</single>",
                 "<answer fraction=\"100\" format=\"html\"><text>yes</text>",
                 "<answer fraction=\"0\" format=\"html\"><text>no</text>", "Size &amp;amp; number.",
                 "<question type=\"numerical\">", "<generalfeedback format=\"html\"><text>2 · 0.3</text>",
                 "<answer fraction=\"100\" format=\"moodle_auto_format\"><text>0.6</text>",
                 "<tolerance>0.01</tolerance>"});
    CHECK(count_of(xml, "<question type") == 3);
}

TEST_CASE("the quiz exports every question with one right option and a described picture", "[lesson][quiz]") {
    LessonRunner runner(1);
    const auto questions = std::get<std::vector<ExportedQuestion>>(quiz_questions(runner, inventory()));
    REQUIRE(questions.size() == 24);
    for (const ExportedQuestion& q : questions) {
        CAPTURE(q.title);
        CHECK(std::count_if(q.options.begin(), q.options.end(), [](const auto& o) { return o.is_right; }) ==
              1);
        CHECK(std::count_if(q.options.begin(), q.options.end(),
                            [](const auto& o) { return o.feedback.empty(); }) == 1);
        CHECK(q.picture);
        CHECK(!q.title.empty());
        CHECK(!q.alt.empty());
    }
    check_well_formed(moodle_xml("Quiz", questions));
}
