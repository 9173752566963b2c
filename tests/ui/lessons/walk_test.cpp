// Every lesson that comes with the program is worked through with mouse and keys from beginning to end.
#include <algorithm>
#include <filesystem>

#include "models/io/file.h"
#include "tests/places.h"
#include "tests/support/lesson_window.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Checks that during a question no input changes the scene, and the picture reveals nothing.
void check_held(HeadlessWindow& bench) {
    const Station& station = bench.state.get<LessonState>().station();
    REQUIRE(bench.scene() == station.asked);
    for (const Key key : {Key::Digit1, Key::D, Key::L, Key::P, Key::C, Key::I}) bench.key(key);
    const ImVec2 middle = bench.at_pixel({double(bench.state.rendered->size.width) / 2, 120});
    bench.drag(middle, middle + ImVec2(90, 40));
    bench.frames(1);
    CHECK(bench.scene() == station.asked);
    CHECK(bench.state.rendered_scene == station.asked);
    CHECK_FALSE(bench.state.on_screen.explanation);
    CHECK_FALSE(bench.state.get<ScopeState>().open);
    CHECK_FALSE(bench.state.get<CompareState>().choice.on);
    CHECK(bench.state.get<DebugViewState>().set == DebugViewSet{});
}

void answer_all(HeadlessWindow& bench) {
    LessonState& lesson = bench.state.get<LessonState>();
    while (const auto open = open_question(lesson)) {
        CAPTURE(test::asked(bench).asks->question);
        check_held(bench);
        // check_held() has already clicked in the picture, and pressed C and D, which choose an option. All
        // other kinds of answers are still open.
        const PredictionKind kind = test::asked(bench).asks->kind;
        if (kind != PredictionKind::Click && kind != PredictionKind::Choice) CHECK_FALSE(can_lock(lesson));
        test::give_answer(bench);
        REQUIRE(can_lock(lesson));
        CHECK(bench.scene() == lesson.station().asked);
        bench.click(bench.control("Lock it in"));
        bench.frames(3);
        REQUIRE(lesson.given()[*open].locked);
        if (open_question(lesson)) CHECK(bench.scene() == lesson.station().asked);
    }
}

void check_revealed(HeadlessWindow& bench) {
    const Station& station = bench.state.get<LessonState>().station();
    if (!bench.state.get<AnimateState>().playing) CHECK(bench.state.rendered_scene == station.revealed);
    bench.state.get<AnimateState>().playing = false;
    bench.frames(2);
    CHECK(bench.scene() == station.revealed);
    if (station.reveal == nullptr) return;
    CHECK(bench.state.get<ScopeState>().open == station.reveal->along.has_value());
    if (!station.reveal->pick) return;
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.get<InspectorState>().tab != InspectorTab::MyPicture);
}

/// The number of tasks in a lesson's text.
int tasks_in(const std::string& path) {
    const std::string text = std::get<std::string>(read_file(path, 1 << 20));
    const std::string_view fence = "\n```try\n";
    int count = 0;
    for (std::size_t at = text.find(fence); at != text.npos; at = text.find(fence, at + 1)) ++count;
    return count;
}

/// Completes the tasks as the lesson describes.
void do_tasks(HeadlessWindow& bench) {
    LessonState& lesson = bench.state.get<LessonState>();
    const Station& station = lesson.station();
    std::size_t number = 0;
    for (const StationPart& part : station.after) {
        if (part.task == nullptr) continue;
        CAPTURE(part.task->drag);
        test::wait_for_tasks(bench);
        CHECK_FALSE(lesson.progress.tasks[lesson.progress.station][number]);
        (void)bench.control("Task open");
        SceneDocument document = lesson.course->document;
        document.scene = bench.scene();
        bench.scene() = std::get<Scene>(scene_variant(document, part.task->solution));
        bench.state.editor.edits_camera = true;
        test::wait_for_tasks(bench);
        CHECK(lesson.progress.tasks[lesson.progress.station][number]);
        CHECK(has_strayed(bench.state));
        bench.click(bench.control("Back to the lesson's scene"));
        CHECK(bench.scene() == station.revealed);
        ++number;
    }
}

}  // namespace

TEST_CASE("every lesson can be worked through: freeze, predict, reveal, task, next",
          "[ui][window][lesson][long]") {
    std::vector<std::string> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(project_folder) / "assets/lessons"))
        if (entry.path().extension() == ".md") files.push_back(entry.path().string());
    REQUIRE(files.size() >= 24);
    std::sort(files.begin(), files.end());
    HeadlessWindow bench({1280, 1500});
    bench.frames(2);
    LessonState& lesson = bench.state.get<LessonState>();
    int answered = 0, done = 0, written = 0;
    for (const std::string& file : files) {
        CAPTURE(file);
        test::drop(bench, file);
        REQUIRE(lesson.course);
        CHECK(lesson.course->lesson.path == file);
        const std::size_t count = lesson.course->stations.size();
        for (std::size_t i = 0; i < count; ++i) {
            CAPTURE(i);
            REQUIRE(lesson.progress.station == i);
            answer_all(bench);
            check_revealed(bench);
            do_tasks(bench);
            bench.key(Key::PageDown);
            bench.frames(3);
        }
        const CourseScore score = score_of(*lesson.course, lesson.progress);
        CHECK(score.locked == score.questions);
        CHECK(score.done == score.tasks);
        answered += score.questions;
        done += score.tasks;
        written += tasks_in(file);
        CHECK_FALSE(bench.state.editor.unsaved());
    }
    CHECK(answered >= 100);
    CHECK(written >= 26);
    CHECK(done == written);
}
