// Tests for the scenes and values with which tasks and exercises are checked.
#include "lessons/check_lesson.h"

#include <algorithm>
#include <set>

#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

constexpr const char* darken = "set: /lights/0/intensity=0.5\n";

/// The last check's result for these steps, with a ball under a light of intensity 1.
Checked last_checked(const std::string& steps) {
    const TemporaryDirectory directory;
    (void)directory.file("ball.json", R"({"glint": 1, "global_ambient": [0, 0, 0],
        "lights": [{"type": "directional", "position": [0, 0, 1]}], "objects": [{"name": "Ball",
        "material": {"diffuse": [0.5, 0.5, 0.5], "specular": [0, 0, 0]}}]})");
    const std::string path = directory.file(
        "01-ball.md", "# A ball\n\n```lesson\ntopic: Light\nscene: ball.json\nsize: 32x32\n```\n\n" + steps);
    LessonRunner runner(1);
    const auto checked = check_lesson(runner, std::get<Lesson>(read_lesson(path)));
    return std::get<std::vector<Checked>>(checked).back();
}

/// A task to dim the light by half.
const std::string task =
    "```try\ndrag: it\ne = explain --pixel 16,16\ndone: e.sum[0] < 0.3\n"
    "solution: /lights/0/intensity=0.5\n```\n\n";
const std::string reveal = std::string("```reveal\n") + darken + "```\n\n";

}  // namespace

TEST_CASE("a task starts with the reveal's scene, a step or question with the step's scene", "[lesson]") {
    const Checked alone = last_checked(task);
    INFO(alone.why);
    CHECK(alone.holds);
    const Checked solved = last_checked(reveal + task);
    CHECK_FALSE(solved.holds);
    CHECK(solved.why.find("done before anything is dragged") != std::string::npos);
    CHECK(last_checked(reveal + "## Two\n\n" + task).holds);
    const std::string question = "```predict number\nquestion: ?\nanswer: 1\ntolerance: 1\n```\n\n";
    CHECK(last_checked(reveal + question + task).holds);
}

TEST_CASE("a formula is checked at every value, or at the ends if there are many values",
          "[lesson][exercise]") {
    const auto checked = [](const std::string& vary, const std::string& closed) {
        return last_checked("```exercise\n" + vary + "question: {a}\nanswer: a\ntolerance: 1e-4\nclosed: a" +
                            closed + "\n```\n");
    };
    const std::string few = "vary: a = 1 to 2 step 0.01\n",
                      many = "vary: a = 1 to 1000 step 1\nvary: b = 1 to 1000 step 1\n";
    CHECK(checked(few, "").holds);
    CHECK(
        checked(few, " + max(a - 1.989, 0)").why.starts_with("1.99: the engine says 1.99, the formula 1.99"));
    CHECK(checked(few, " + max(0.001 - abs(a - 1.57), 0)").why.starts_with("1.57: the engine says 1.57"));
    CHECK(checked(many, "").holds);
    CHECK(checked(many, " + max(a + b - 1999, 0)").why.starts_with("1000: the engine says 1000"));
    CHECK(checked(many, " + max(3 - a - b, 0)").why.starts_with("1: the engine says 1"));
}

TEST_CASE("an exercise is tried with all combinations of values, up to a given number",
          "[lesson][exercise]") {
    const Exercise exercise{{{"a", {1, 2, 3}}, {"b", {4, 5, 6}}}, {}, 1};
    const auto all = values_to_try(exercise, 9);
    CHECK(all.size() == 9);
    CHECK(std::set(all.begin(), all.end()).size() == 9);
    const auto some = values_to_try(exercise, 8);
    CHECK(some.size() == 8);
    const std::set tried(some.begin(), some.end());
    for (const std::vector<double>& corner : std::vector<std::vector<double>>{{1, 4}, {1, 6}, {3, 4}, {3, 6}})
        CHECK(tried.contains(corner));
    Exercise long_one;
    for (int i = 0; i < 40; ++i) long_one.variables.push_back({"x" + std::to_string(i), {0, 1}});
    CHECK(values_to_try(long_one, 16).size() == 16);
}

TEST_CASE("an exercise with a tolerance that is not positive fails the check", "[lesson][exercise]") {
    for (const char* const tolerance : {"0", "-1", "0 / 0"}) {
        const Checked checked =
            last_checked(std::string("```exercise\nvary: a = 1, 2\nquestion: {a}\nanswer: a\ntolerance: ") +
                         tolerance + "\n```\n");
        INFO(checked.why);
        CHECK_FALSE(checked.holds);
    }
}

TEST_CASE("numbers that could answer a question are found in text, names and bounds are not", "[lesson]") {
    using Numbers = std::vector<double>;
    CHECK(numbers_in("from 2.5 to −3 units", false) == Numbers{2.5, -3});
    CHECK(numbers_in("a quarter, 1/8 or 20 %", false) == Numbers{0.25, 0.125, 20, 0.2});
    CHECK(numbers_in("tilted by 60 degrees or 45°, half of 7", false) == Numbers{7});
    CHECK(numbers_in("tilted by 60 degrees or 45°, half of 7", true) == Numbers{60, 45});
    CHECK(numbers_in("n = (0, 1, 0), levels (0–255), x25 and k_d where n·l = 0", false).empty());
}

namespace {

const std::string how_bright =
    "```predict number\nquestion: How bright is it?\na = explain --pixel 16,16\nanswer: a.sum[0]\n"
    "tolerance: 0.02\n";

}  // namespace

TEST_CASE("an answer in the text before its question is reported, one after it is not", "[lesson]") {
    const std::string hidden = "```scene\npicture: /lights/0/enabled=false\n```\n\n";
    CHECK(last_checked(hidden + how_bright + "```\n\nIt is 0.5.\n").holds);
    CHECK(last_checked(hidden + "It is 0.5.\n\n" + how_bright + "```\n")
              .why.starts_with("the text says 0.5, and the answer is"));
    CHECK_FALSE(last_checked("## Half of it: 1/2\n\n" + hidden + how_bright + "```\n").holds);
}

TEST_CASE("an answer that a picture shows before its question is reported", "[lesson]") {
    CHECK(last_checked(how_bright + "```\n").why.starts_with("the pictures show the answer"));
    // A later step shows the same things in the same light.
    CHECK(last_checked("## Later\n\nLook.\n\n## Now\n\n```scene\npicture: /lights/0/enabled=false\n```\n\n" +
                       how_bright + "```\n")
              .why.starts_with("the pictures show the answer"));
    const std::string dark = "```scene\npicture: /lights/0/enabled=false\n```\n\n";
    const std::string colour =
        "```predict colour\nquestion: Which?\na = explain --pixel 16,16\nanswer: a.displayed\ntolerance: "
        "0.02\n```\n";
    CHECK(last_checked(dark + colour).holds);
    CHECK(last_checked(colour).why == "the picture shows the colour at 16,16");
    const std::string curve =
        "```predict sketch\nquestion: Draw.\nalong: 16,16 30,16\np = profile --from 16,16 --to 30,16\n"
        "answer: p.intensity\ntolerance: 0.05\n```\n";
    CHECK(last_checked(dark + curve).holds);
    // A dimmer picture shows the same curve.
    CHECK(last_checked("```scene\npicture: /lights/0/intensity=0.5\n```\n\n" + curve)
              .why.starts_with("the picture shows the curve"));
    const std::string click =
        "```predict click\nquestion: Where?\nanswer: [16, 16]\ntolerance: 3\n```\n\n```reveal\nset: "
        "/lights/0/intensity=0.5\n```\n";
    CHECK(last_checked(click).holds);
    const std::string same = click.substr(0, click.find("set:")) + "pick: 16,16\n```\n";
    CHECK(last_checked(same).why ==
          "the picture shows the position (16, 16): it changes by only 0 levels there");
}

TEST_CASE("a typical wrong answer must count as wrong, and not as a different wrong answer", "[lesson]") {
    const std::string dark = "```scene\npicture: /lights/0/enabled=false\n```\n\n";
    CHECK(last_checked(dark + how_bright + "wrong: 1\nthinks: All light comes back.\n```\n").holds);
    CHECK(last_checked(dark + how_bright + "wrong: 0.51\nthinks: Nearly.\n```\n")
              .why.starts_with("wrong: 0.51 counts"));
    CHECK(last_checked(dark + how_bright + "wrong: 1\nthinks: All.\nwrong: 1.01\nthinks: More.\n```\n")
              .why.starts_with("wrong: 1.01"));
}

TEST_CASE("a misconception attached to the right option fails the check", "[lesson]") {
    const auto checked = [](const std::string& thinks) {
        return last_checked("```predict choice\nquestion: ?\noption: yes\nif: true\n" + thinks +
                            "option: no\nif: false\nthinks: Never.\n```\n");
    };
    CHECK(checked("").holds);
    CHECK(checked("thinks: Always.\n").why == "\"yes\" is right, but has a misconception (thinks:)");
}
