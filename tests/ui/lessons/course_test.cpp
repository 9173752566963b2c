// Cancelling the opening of a lesson.
#include "ui/features/lessons/course.h"

#include <chrono>
#include <thread>

#include "models/progress.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

/// A lesson with `steps` steps about a scene with `lights` lights.
std::string lesson_about_lights(const TemporaryDirectory& folder, int steps, int lights,
                                const std::string& step = "Look.\n") {
    std::string scene = R"({"glint": 1, "lights": [{})";
    for (int i = 1; i < lights; ++i) scene += ", {}";
    (void)folder.file("lights.json", scene + "]}");
    std::string text = "# Lights\n\n```lesson\ntopic: Own\nscene: lights.json\nsize: 32x32\n```\n\n";
    for (int i = 0; i < steps; ++i) text += "## Step\n\n" + step + "\n";
    return folder.file("l.md", text);
}

}  // namespace

TEST_CASE("opening a lesson can be cancelled between its stations", "[ui][lesson]") {
    const TemporaryDirectory folder;
    constexpr int lights = 100;
    // Each step reads its scene again, so opening the lesson takes seconds.
    const std::string step = "```scene\nset: /display/exposure=2\n```\n";
    const std::string path = lesson_about_lights(folder, 450, lights, step);
    LoadProgress progress;
    std::thread hand([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        progress.cancelled = true;
    });
    const ProgressScope scope(progress);
    const auto opened = open_course(path);
    hand.join();
    REQUIRE(problem_of(opened) != nullptr);
    CHECK(problem_of(opened)->text() == path + ": " + cancelled_words);
}
