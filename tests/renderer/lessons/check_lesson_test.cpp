// What a task is tried on.
#include "renderer/lessons/check_lesson.h"

#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

constexpr const char* darken = "set: /lights/0/intensity=0.5\n";

/// Returns the last thing that these steps check, of a ball under a light of intensity 1.
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

/// The light is to be dimmed to a half.
const std::string task =
    "```try\ndrag: it\ne = explain --pixel 16,16\ndone: e.sum[0] < 0.3\n"
    "solution: /lights/0/intensity=0.5\n```\n\n";
const std::string reveal = std::string("```reveal\n") + darken + "```\n\n";

}  // namespace

TEST_CASE(
    "a task begins with what the reveal above it leaves, and a new step or question with the step's scene",
    "[lesson]") {
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
