// How a lesson is opened: what its stations may hold, and how it is cancelled.
#include "ui/lessons/course.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "models/progress.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

/// A lesson of so many steps about a scene of lights.
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

TEST_CASE("a lesson opens only where there is memory for the scenes of all its stations",
          "[ui][lesson][memory]") {
    const TemporaryDirectory folder;
    constexpr int lights = 400;
    // Two scenes a station; beside them there is the file that is read.
    const test::MemoryLimit limit(20 * lights * sizeof(Light));
    const std::uint64_t left = memory_left();
    {
        const auto few = open_course(lesson_about_lights(folder, 2, lights));
        REQUIRE(problem_of(few) == nullptr);
        CHECK(left - memory_left() >= 4 * lights * sizeof(Light));
    }
    CHECK(memory_left() == left);
    CHECK_THROWS_AS(open_course(lesson_about_lights(folder, 40, lights)), Refused);
    CHECK(memory_left() == left);
}

TEST_CASE("a lesson that is being opened can be cancelled between its stations", "[ui][lesson]") {
    const TemporaryDirectory folder;
    constexpr int lights = 100;
    // Each step reads its scene anew, so that all of them take seconds.
    const std::string step = "```scene\nset: /display/exposure=2\n```\n";
    const std::string path = lesson_about_lights(folder, 450, lights, step);
    const std::uint64_t left = memory_left();
    LoadProgress progress;
    std::atomic<bool> ended = false;
    std::thread hand([&] {  // cancels once some stations are there
        while (!ended && left - std::min(left, memory_left()) < 20 * lights * sizeof(Light))
            std::this_thread::yield();
        progress.cancelled = true;
    });
    const ProgressScope scope(progress);
    const auto opened = open_course(path);
    ended = true;
    hand.join();
    REQUIRE(problem_of(opened) != nullptr);
    CHECK(problem_of(opened)->text() == path + ": " + cancelled_words);
}
