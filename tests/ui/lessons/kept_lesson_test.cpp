// What a lesson must not lose or mix up: work that was saved under a name, progress, tasks.
#include <chrono>
#include <thread>

#include "models/io/file.h"
#include "models/progress.h"
#include "tests/support/catch.h"
#include "tests/support/lesson_window.h"
#include "tests/support/program.h"
#include "ui/document/document_actions.h"
#include "ui/features/lessons/course.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

const char* const two_steps = "## One\n\nLook.\n\n## Two\n\nLook again.\n";

/// A window in a lesson whose scene was saved under a name and has changed since.
struct OwnWorkWindow : DrawnWindow {
    OwnWorkWindow() : DrawnWindow({1280, 1000}) {
        test::drop(*this, folder.file("l.md", test::own_lesson("Look.\n")));
        REQUIRE(state.get<LessonState>().course);
    }
    void save_and_change() {
        REQUIRE_FALSE(save_file(state.editor, path, scene()));
        scene().global_ambient = glm::vec3(0.75f);
        frames(2);
    }
    void check_asks_first() {
        frames(2);
        REQUIRE(state.pending.asking);
        CHECK(scene().global_ambient == glm::vec3(0.75f));
        CHECK(state.editor.document.path == path);
        finish_pending(state);  // Don't save
        frames(2);
        CHECK(scene() == state.get<LessonState>().station().revealed);
        CHECK(state.editor.document.path.empty());
    }
    test::LessonFolder folder;
    std::string path = folder.path("mine.json");
};

}  // namespace

TEST_CASE("a lesson asks before it replaces work that was saved under a name", "[ui][window][lesson]") {
    OwnWorkWindow bench;
    SECTION("going back to its scene") {
        bench.save_and_change();
        bench.click(bench.control("Back to the lesson's scene"));
        bench.check_asks_first();
    }
    SECTION("beginning again") {
        bench.save_and_change();
        bench.click(bench.control("Begin again"));
        bench.check_asks_first();
    }
    SECTION("ending a lecture") {
        bench.click(bench.control("Lecturer"));
        bench.save_and_change();
        bench.click_on("Lecturer");
        CHECK(bench.state.get<LessonState>().lecturer);
        bench.check_asks_first();
        CHECK_FALSE(bench.state.get<LessonState>().lecturer);
    }
}

TEST_CASE("a lesson restores its scene without asking if the current one was not saved",
          "[ui][window][lesson]") {
    OwnWorkWindow bench;
    bench.scene().global_ambient = glm::vec3(0.75f);
    bench.frames(2);
    bench.click(bench.control("Begin again"));
    CHECK_FALSE(bench.state.pending.asking);
    CHECK(bench.scene() == bench.state.get<LessonState>().station().revealed);
}

TEST_CASE("an unreadable or full progress file stays unchanged and is reported", "[ui][window][lesson]") {
    constexpr std::size_t longest = std::size_t{1} << 20;
    const std::string head = "{\"x\": \"", tail = "\"}";
    const auto of_size = [&](std::size_t size) {
        return head + std::string(size - head.size() - tail.size(), 'x') + tail;
    };
    for (const std::string& kept :
         {std::string("{\"05-lambert\": {\"at\": 3},}"), of_size(longest + 1), of_size(longest - 20)}) {
        const test::LessonFolder folder;
        const std::string file = folder.file("lessons.json", kept);
        test::RememberingWindow bench(folder.path());
        test::drop(bench, folder.file("l.md", test::own_lesson(two_steps)));
        (void)bench.key(Key::PageDown);
        bench.frames(2);
        REQUIRE(bench.state.get<LessonState>().progress.station == 1);
        CHECK(bytes_of(file) == kept);
        CHECK(bench.notes_with("Your answers and progress cannot be remembered: ") > 0);
    }
}

TEST_CASE("tasks evaluated on one lesson's scene do not count for the next lesson", "[ui][window][lesson]") {
    const test::LessonFolder folder;
    const auto with_task = [&](const char* name, const char* done) {
        return folder.file(
            name, test::own_lesson("```try\ndrag: the light\ndone: " + std::string(done) + "\n```\n"));
    };
    const std::string undone = with_task("b.md", "1 = 2");
    DrawnWindow bench({1280, 1000});
    const auto next = std::get<std::shared_ptr<const Course>>(open_course(undone));
    test::drop(bench, with_task("a.md", "1 = 1"));
    LessonState& lesson = bench.state.get<LessonState>();
    REQUIRE(lesson.course);
    test::wait_for_tasks(bench);
    CHECK(lesson.progress.tasks[0][0]);
    bench.scene().global_ambient = glm::vec3(0.75f);
    do (void)bench.frame();
    while (!lesson.watching);
    take_scene(bench.state, next->document);
    begin_lesson(bench.state, next);
    test::wait_for_tasks(bench);
    CHECK_FALSE(lesson.progress.tasks[0][0]);
    CHECK(lesson.watched->course == next);
}

TEST_CASE("a lesson that opens at a question accepts typing as the answer", "[ui][window][lesson]") {
    const test::LessonFolder folder;
    const std::string path = folder.file(
        "own.md",
        test::own_lesson("```predict number\nquestion: How much?\nanswer: 0.5\ntolerance: 0.1\n```\n"));
    const auto opened = open_course(path);
    REQUIRE(problem_of(opened) == nullptr);
    HeadlessWindow bench({1280, 1000});
    take_document(bench.state.editor, std::get<std::shared_ptr<const Course>>(opened)->document);
    begin_lesson(bench.state, std::get<std::shared_ptr<const Course>>(opened));  // before the first frame
    bench.frames(4);
    bench.type("7");
    CHECK(bench.state.get<LessonState>().typed == "7");
}

// Cancelling the opening of a lesson.
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
