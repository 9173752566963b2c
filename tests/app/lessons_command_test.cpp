// Tests of glint lessons, glint exercise and glint quiz as a user runs them.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

std::string lesson_text(const std::string& scene, const std::string& check) {
    return "# Mine\n\n```lesson\ntopic: Own\nscene: " + scene +
           "\nsize: 32x32\n```\n\n```claim\nsays: One.\ne = explain --pixel 16,16\ncheck: " + check +
           "\n```\n";
}

const char* const ball_scene = R"({"glint": 1, "objects": [{"name": "Ball"}]})";

void check_refused(const std::vector<std::string>& arguments, const std::string& part) {
    const Ended ended = run_glint(arguments);
    CAPTURE(arguments, ended.err);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.err.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("glint lessons lists the installed lessons as text and as JSON", "[cli][lesson]") {
    const Ended text = run_glint({"lessons"}), json = run_glint({"lessons", "--format", "json"});
    REQUIRE(text.status == 0);
    REQUIRE(json.status == 0);
    const auto lessons = nlohmann::json::parse(json.out)["lessons"];
    CHECK(lessons.size() >= 24);
    for (const auto& lesson : lessons) {
        const std::string name = lesson["name"], title = lesson["title"];
        CAPTURE(name);
        CHECK(text.out.find(name) != std::string::npos);
        CHECK(text.out.find(title) != std::string::npos);
        CHECK(lesson["claims"] > 0);
    }
    for (const char* const word : {"05-lambert", "lambert", "05", "5"}) {
        const Ended one = run_glint({"lessons", word, "--format", "json"});
        CAPTURE(word);
        CHECK(nlohmann::json::parse(one.out)["lessons"].at(0)["name"] == "05-lambert");
    }
    const Ended first = run_glint({"lessons", "0", "--format", "json"});
    CHECK(nlohmann::json::parse(first.out)["lessons"].at(0)["name"] == "00-one-point");
}

TEST_CASE("glint lessons --check returns status 1 if a claim in the given folder fails", "[cli][lesson]") {
    const TemporaryDirectory directory;
    (void)directory.file("ball.json", ball_scene);
    const std::string good = directory.file("01-good.md", lesson_text("ball.json", "e.hit"));
    const std::string bad = directory.file("02-bad.md", lesson_text("ball.json", "e.sum[0] = 7"));
    const Ended one = run_glint({"lessons", "--check", good});
    CHECK(one.status == 0);
    CHECK(one.out == "1 of 1 hold\n");
    const Ended both = run_glint({"lessons", "--check", directory.path()});
    CHECK(both.status == 1);
    CHECK(both.err.empty());
    CHECK(both.out.find(bad + ":9: claim: One.\n    e.sum[0] = 7 is false: 0.0") == 0);
    CHECK(both.out.find("1 of 2 hold\n") != std::string::npos);
    const auto json = nlohmann::json::parse(
        run_glint({"lessons", "--check", directory.path(), "--format", "json"}).out)["checked"];
    REQUIRE(json.size() == 2);
    CHECK((json[0]["holds"] == true && json[1]["holds"] == false && json[1]["line"] == 9));
}

TEST_CASE("a lesson's run gives the same numbers as the command with the same options", "[cli][lesson]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file("ball.json", ball_scene);
    const std::string line =
        GENERATE(as<std::string>(), "explain --pixel 15,11 --set /lights/0/intensity=0.7 --size 32x24",
                 "profile --from 3,11 --to 29,12 --size 40x24",
                 "lobe --object 0 --angle 41 --set /objects/0/material/shininess=9",
                 "microfacets --roughness 0.4 --angle 50 --view 20 --rays 90 --facets 60");
    CAPTURE(line);
    std::istringstream text(line);
    std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
    if (words[0] != "microfacets") words.insert(words.end(), {scene, "--format", "json"});
    const Ended command = run_glint(words);
    REQUIRE(command.status == 0);
    std::string checks;
    const auto numbers = nlohmann::json::parse(command.out).flatten();
    for (const auto& [pointer, value] : numbers.items()) {
        std::string path = std::regex_replace(pointer, std::regex("/([0-9]+)"), "[$1]");
        std::replace(path.begin(), path.end(), '/', '.');
        if (value.is_number() &&
            !std::regex_search(path, std::regex("\\[(..+|[2-9])\\]")))  // keeps the block short
            checks += "check: r" + path + " = " + value.dump() + " within 1e-9\n";
    }
    std::string lesson = lesson_text("ball.json", "e.hit\n" + checks);
    lesson.insert(lesson.find("e = "), "r = " + line + "\n");
    const Ended check = run_glint({"lessons", "--check", directory.file("01-runs.md", lesson)});
    CHECK(check.out == "1 of 1 hold\n");
    CHECK(check.err.empty());
}

TEST_CASE("an error in a lesson is reported in one line on standard error", "[cli][lesson][bad-input]") {
    const TemporaryDirectory directory;
    (void)directory.file("ball.json", ball_scene);
    const std::string path = directory.file("l.md", lesson_text("ball.json", "e.hits = "));
    const Ended ended = run_glint({"lessons", "--check", path});
    CHECK(ended.status == 1);
    CHECK(ended.out.empty());
    CHECK(ended.err == "glint: error: " + path + ":12: \"e.hits =\" ends too early; expected a value\n");
    const std::string other = directory.file("m.md", lesson_text("none.json", "e.hit"));
    const std::string missing = run_glint({"lessons", "--check", other}).err;
    CHECK(missing.starts_with("glint: error: " + other + ": its scene "));
    CHECK(missing.find("none.json: cannot read: no such file or directory; expected a scene") !=
          std::string::npos);
}

TEST_CASE("glint lessons writes pages, and glint exercise writes sheets in every format", "[cli][lesson]") {
    const TemporaryDirectory directory;
    const std::string page = directory.path("l.html"), tex = directory.path("e.tex"),
                      html = directory.path("e.html");
    CHECK(run_glint({"lessons", "lambert", "-o", page, "--key"}).status == 0);
    CHECK(bytes_of(page).find("<!DOCTYPE html>") == 0);
    CHECK(run_glint({"lessons", "lambert", "-o", "-"}).out.find("<!DOCTYPE html>") == 0);
    const std::string keys = directory.path("k.tex"), zip = directory.path("e.zip"),
                      xml = directory.path("e.xml");
    CHECK(
        run_glint({"exercise", "lambert", "--seed", "7", "--count", "3", "-o", tex, "--key", keys}).status ==
        0);
    CHECK(bytes_of(keys).find("Sheet 9") != std::string::npos);
    CHECK(bytes_of(tex).find("accept") == std::string::npos);
    CHECK(run_glint({"exercise", "lambert", "-o", zip}).status == 0);
    CHECK(bytes_of(zip).starts_with("PK"));
    CHECK(run_glint({"exercise", "lambert", "-o", xml}).status == 0);
    CHECK(bytes_of(xml).find("<question type=\"numerical\">") != std::string::npos);
    CHECK(run_glint({"lessons", "lambert", "-o", "-", "--slides"}).out.find("class=\"slide\"") !=
          std::string::npos);
    CHECK(run_glint({"lessons", "lambert", "-o", "-", "--instructor"}).out.find("What students believe") !=
          std::string::npos);
    CHECK(run_glint({"exercise", "lambert", "--seed", "7", "--count", "3", "-o", html}).status == 0);
    for (const char* const sheet : {"Sheet 7", "Sheet 8", "Sheet 9"}) {
        CHECK(bytes_of(tex).find(sheet) != std::string::npos);
        CHECK(bytes_of(html).find(sheet) != std::string::npos);
    }
    CHECK(bytes_of(tex).find("\\begin{document}") != std::string::npos);
    CHECK(bytes_of(tex).find("\\end{document}\n") != std::string::npos);
}

TEST_CASE("glint lessons and glint exercise report incorrect usage", "[cli][lesson][bad-input]") {
    check_refused({"lessons", "lambret"},
                  "lambret: neither a file nor a lesson; expected a lesson, such as 05-lambert, or a file");
    check_refused({"lessons", "-o", "x.html"}, "-o: writes a single lesson");
    check_refused({"lessons", "5", "-o", "x.pdf"}, "expected a name that ends in .html, or -");
    check_refused({"lessons", "5", "--key"}, "--key: requires -o");
    check_refused({"lessons", "5", "--slides"}, "--slides: requires -o");
    check_refused({"lessons", "5", "--key", "--instructor", "-o", "x.html"},
                  "--instructor: cannot be combined with --key");
    check_refused({"exercise", "5", "-o", "x.html", "--key", "x.html"}, "--key: is the same file as -o");
    check_refused({"lessons", "5", "--check", "-o", "x.html"}, "--check: cannot be combined with -o");
    check_refused({"lessons", "5", "--format", "json", "-o", "x.html"},
                  "--format: cannot be json with -o, which writes a page");
    const TemporaryDirectory directory;
    (void)directory.file("ball.json", ball_scene);
    for (const char* const name : {"one.md", "two.md"})
        (void)directory.file(name, lesson_text("ball.json", "e.hit"));
    check_refused({"exercise", directory.path(), "-o", directory.path("x.html")},
                  directory.path() + ": names 2 lessons; expected only one");
    check_refused({"lessons", directory.path(), "-o", directory.path("x.html")}, ": names 2 lessons");
    const TemporaryDirectory empty;
    check_refused({"exercise", empty.path(), "-o", directory.path("x.html")},
                  empty.path() + ": contains no lessons; expected a folder with lessons");
    check_refused({"exercise", "5", "-o", "x.html", "--seed", "4294967296"},
                  "--seed: 4294967296 is out of range; expected 0 to 2147483647");
    check_refused({"exercise", "5", "-o", "x.html", "--seed", "2147483647", "--count", "3"},
                  "--count: there are fewer sheets from seed 2147483647 on; expected 1 to 1");
    check_refused({"exercise"}, "NAME: is missing");
    check_refused({"exercise", "5"}, "-o: is missing");
    check_refused({"exercise", "5", "-o", "x.pdf"}, "expected a name that ends in .html, .tex, .xml or .zip");
    check_refused({"exercise", "5", "-o", "x.html", "--count", "0"}, "--count: 0 is out of range");
}

TEST_CASE("glint quiz writes the concept inventory and counts a class's answers", "[cli][quiz]") {
    const TemporaryDirectory directory;
    const std::string page = directory.path("quiz.html");
    CHECK(run_glint({"quiz", "-o", page}).status == 0);
    CHECK(bytes_of(page).find("<!DOCTYPE html>") == 0);
    CHECK(bytes_of(page).find("class=\"right\"") == std::string::npos);
    CHECK(run_glint({"quiz", "-o", "-", "--key"}).out.find("class=\"right\"") != std::string::npos);
    std::string answers =
        R"({"quiz": "What do you believe about lighting?", "when": "before", "answers": [0)";
    for (int i = 1; i < 24; ++i) answers += ",0";
    const std::string a = directory.file("a.json", answers + "]}"), b = directory.file("b.json", "[]");
    const Ended counted = run_glint({"quiz", a, a});
    REQUIRE(counted.status == 0);
    const auto json = nlohmann::json::parse(counted.out);
    CHECK(json["people"]["before"] == 2);
    CHECK(json["questions"].size() == 24);
    CHECK(json["questions"][0]["options"][0]["before"] == 2);
    const Ended wrong = run_glint({"quiz", a, b});
    CHECK(wrong.status == 1);
    CHECK(wrong.err.find(b + ": these are not answers to \"What do you believe about lighting?\"") !=
          std::string::npos);
    check_refused({"quiz"}, "-o: is missing");
    check_refused({"quiz", a, "-o", page}, "-o: cannot be combined with ANSWERS");
    check_refused({"quiz", a, "--key"}, "--key: cannot be combined with ANSWERS");
    CHECK(run_glint({"quiz", "-"})
              .err.find("-: these are not answers to \"What do you believe about lighting?\"") !=
          std::string::npos);
    check_refused({"quiz", "-o", "x.png"}, "expected a name that ends in .html, .xml or .zip, or -");
    check_refused({"quiz", "--csv"}, "--csv: requires ANSWERS");
    check_refused({"quiz", "--analyse", "--csv", a}, "--csv: cannot be combined with --analyse");
    CHECK(run_glint({"quiz", "--analyse", a}).out.starts_with("form A, before the lessons, people: 1\n"));
    CHECK(run_glint({"quiz", "--csv", a})
              .out.starts_with("person,form,when,item,answer,right,seconds\n\"\",A,before,1,A,"));
    const std::string xml = directory.path("q.xml");
    CHECK(run_glint({"quiz", "--form", "b", "-o", xml}).status == 0);
    CHECK(bytes_of(xml).find("(form B)") != std::string::npos);
}

TEST_CASE("a folder without lessons is an error, not a success", "[cli][lesson][bad-input]") {
    const TemporaryDirectory empty;
    const std::string line = empty.path() + ": contains no lessons; expected a folder with lessons";
    check_refused({"lessons", empty.path()}, line);
    check_refused({"lessons", empty.path(), "--check"}, line);
    check_refused({"lessons", "5", empty.path(), "--format", "json"}, line);
}

TEST_CASE("without installed lessons, the error names the expected folder", "[cli][lesson][bad-input]") {
    const TemporaryDirectory elsewhere;
    const std::string program = elsewhere.path("glint");
    std::filesystem::copy_file(glint_program, program);
    for (const auto& [command, part] :
         {std::pair{"lessons", "no lessons are installed; expected assets/lessons "},
          {"quiz -o -", "no inventory is installed; expected assets/inventory.md "}}) {
        const Ended ended = run_glint({"--version"}, {}, "; '" + program + "' " + command + " 2>&1");
        CAPTURE(ended.out);
        CHECK(ended.status == 1);
        CHECK(ended.out.find("glint: error: " + std::string(part)) != std::string::npos);
    }
}

TEST_CASE("glint exercise prints the two answers if the formula is wrong", "[cli][lesson][exercise]") {
    const TemporaryDirectory directory;
    (void)directory.file("ball.json", ball_scene);
    const std::string lesson = directory.file(
        "l.md", lesson_text("ball.json", "e.hit") +
                    "\n```exercise\nvary: a = 2\nquestion: {a}?\nanswer: a\ntolerance: 1\nclosed: 4\n```\n");
    const std::string out = directory.path("x.tex");
    const std::string key = directory.path("key.tex");
    CHECK(run_glint({"exercise", lesson, "-o", out, "--key", key}).status == 0);
    CHECK(bytes_of(key).find("4.0 by the formula, but 2.0 by the engine") != std::string::npos);
}

// Tests of glint mistakes as a user runs it.
TEST_CASE("glint mistakes lists the catalogue as text and as JSON", "[cli][mistakes]") {
    const Ended text = run_glint({"mistakes"}), json = run_glint({"mistakes", "--format", "json"});
    REQUIRE(text.status == 0);
    REQUIRE(json.status == 0);
    const auto all = nlohmann::json::parse(json.out)["mistakes"];
    CHECK(all.size() == 79);
    std::string scene = R"({"glint": 1, "shading": {"mistakes": {)";
    for (const auto& mistake : all) {
        const std::string name = mistake["name"];
        CAPTURE(name);
        CHECK(text.out.find("\n  " + name + "\n    " + std::string(mistake["does"])) != std::string::npos);
        for (const std::string source : mistake["sources"])  // a comma is part of a title, not a separator
            CHECK(text.out.find(source) != std::string::npos);
        scene += (scene.back() == '{' ? "\"" : ", \"") + name + "\": true";
    }
    CHECK(run_glint({"info", "-"}, scene + "}}}").status == 0);
}

namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns {a, b} for "--set 'a' --set 'b'".
std::vector<std::string> settings_in(const std::string& line) {
    std::vector<std::string> words;
    const std::regex form("--set '([^']*)'");
    for (std::sregex_iterator at(line.begin(), line.end(), form), end; at != end; ++at)
        words.insert(words.end(), {"--set", (*at)[1].str()});
    return words;
}

}  // namespace

TEST_CASE("docs/diagnose.md shows every mistake as it is currently drawn", "[cli][mistakes][docs][release]") {
    const std::string docs = project_file("docs/");
    const std::string page = text_of(docs + "diagnose.md");
    const std::string pictures = docs + "pictures/museum/";
    const TemporaryDirectory directory;
    const auto all = nlohmann::json::parse(run_glint({"mistakes", "--format", "json"}).out)["mistakes"];
    for (const auto& mistake : all) {
        const std::string name = mistake["name"];
        CAPTURE(name);
        const std::size_t begin = page.find("\n### " + name + "\n");
        REQUIRE(begin != std::string::npos);
        const std::string entry = page.substr(begin, page.find("\n### ", begin + 1) - begin);
        CHECK(entry.find(std::string(mistake["does"]) + " **" + std::string(mistake["looks"]) + "**") !=
              std::string::npos);
        for (const std::string alike : mistake["look_alikes"])
            CHECK(entry.find("[`" + alike + "`]") != std::string::npos);
        const std::string drawn = directory.path(name + ".png");
        std::vector<std::string> line{"render", docs + "museum.json", "--size", "288x216", "-o", drawn};
        const auto settings = settings_in(entry.substr(0, entry.find("Looks like")));
        CHECK(settings.back() == "/shading/mistakes/" + name + "=true");
        line.insert(line.end(), settings.begin(), settings.end());
        REQUIRE(run_glint(line).status == 0);
        std::string shown = pictures;
        shown.append(name).append(".png");
        CHECK(nlohmann::json::parse(run_glint({"compare", shown, drawn}).out)["max_error"] == 0);
    }
}

TEST_CASE("a NaN pixel can be explained as JSON, and is black in the picture", "[cli][mistakes]") {
    const char* const ball =
        R"({"glint": 1, "lights": [{"type": "directional", "position": [0.6, 0, 0.8, 0]}],
        "objects": [{"mesh": {"primitive": "sphere"}, "material": {"shininess": 0}}],
        "shading": {"mistakes": {"power_zero_is_nan": true}}})";
    int black = 0;
    for (int x = 30; x < 48; x += 1) {
        const Ended ended = run_glint(
            {"explain", "-", "--pixel", std::to_string(x) + ",32", "--size", "64x64", "--format", "json"},
            ball);
        REQUIRE(ended.status == 0);
        const auto e = nlohmann::json::parse(ended.out);
        if (!e["sum"].is_array() || !e["sum"][0].is_null()) continue;
        CHECK(e["byte"] == nlohmann::json({0, 0, 0}));
        ++black;
    }
    CHECK(black > 0);
}
