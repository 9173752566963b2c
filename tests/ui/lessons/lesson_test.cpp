// A lesson in the window: opening and closing it, its progress, the lecturer's view.
#include "ui/features/lessons/lesson.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/lesson_window.h"
#include "tests/support/program.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/features/lessons/course.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

const std::string lambert = test::shipped_lesson("05-lambert");

/// A window in a lesson.
struct LessonWindow : HeadlessWindow {
    /// The window stores its progress in `folder`, if there is one.
    explicit LessonWindow(const std::string& path, const std::string& folder = "", ImVec2 size = {1280, 1000})
        : HeadlessWindow(size) {
        if (!folder.empty()) begin_persistence(state, folder);
        frames(2);
        test::drop(*this, path);
    }
    LessonState& lesson() { return state.get<LessonState>(); }
    void turn(Key page) {
        (void)key(page);
        frames(3);
    }
    [[nodiscard]] bool asks_for(PredictionKind kind) {
        return open_question(lesson()) && test::asked(*this).asks->kind == kind;
    }
    /// Pages through the lesson to a question of that kind.
    void turn_to(PredictionKind kind) {
        while (!asks_for(kind)) turn(Key::PageDown);
    }
    /// Whether the page has an animation.
    [[nodiscard]] bool plays() {
        const Reveal* reveal = lesson().station().reveal;
        return reveal != nullptr && !reveal->play.empty();
    }
    void type_into(const char* field, const std::string& text) {
        click(control(field));
        test::type(*this, text);
    }
    void answer(const std::string& text) {
        type_into("Your answer", text);
        click(control("Lock it in"));
        frames(3);
    }
};

/// A window with Lambert's lesson at its second station, whose answer is a number.
struct LambertWindow : LessonWindow {
    explicit LambertWindow(ImVec2 size = {1280, 1000}) : LessonWindow(lambert, "", size) {
        turn(Key::PageDown);
    }
};

bool says(const HeadlessWindow& bench, const std::string& part) { return bench.notes_with(part) > 0; }

/// A user's lesson, with that block in its only step.
std::string lesson_with(const std::string& block) { return test::own_lesson("## One\n\n" + block); }

}  // namespace

TEST_CASE("an answer is shown next to the correct one, and its number is marked", "[ui][window][lesson]") {
    LambertWindow bench;
    CHECK_FALSE(bench.state.on_screen.explanation);
    bench.answer("0.7");
    REQUIRE(bench.lesson().given()[0].locked);
    CHECK(bench.lesson().given()[0].value == Json(0.7));
    CHECK_FALSE(is_right(bench.lesson().station().questions[0], bench.lesson().given()[0]));
    // The plate at 60 degrees gets half the light. The marked number is the cosine, in the right column.
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.explanation->object == "60 degrees");
    CHECK(bench.state.on_screen.explanation->sum.x == Approx(0.5));
    const Rect yours = bench.area_of("You said"), right = bench.area_of("It is");
    CHECK(yours.high.x <= right.low.x);
    CHECK(yours.low.y == right.low.y);
    const Rect column = test::right_column(bench);
    const ImVec2 mark = bench.control("Marked number");
    CHECK(column.holds(mark));
    // The mark disappears after a while, and a click restores it.
    bench.state.get<InspectorState>().marked.reset();
    bench.state.get<InspectorState>().tab = InspectorTab::Mistakes;
    bench.frames(1);
    bench.click_on("Show it in the equation");
    CHECK(bench.state.get<InspectorState>().tab == InspectorTab::Equation);
    CHECK(column.holds(bench.control("Marked number")));
}

TEST_CASE("an answer may be a calculation and is correct if within the tolerance", "[ui][window][lesson]") {
    LambertWindow bench;
    bench.answer("cos(60*deg)+0.02");
    CHECK(is_right(bench.lesson().station().questions[0], bench.lesson().given()[0]));
}

TEST_CASE("an invalid number keeps the focus so that it can be corrected", "[ui][window][lesson]") {
    LambertWindow bench;
    constexpr int return_key = 90;
    ImGui::GetIO().KeyMap[ImGuiKey_Enter] = return_key;
    const auto enter = [&] {
        ImGui::GetIO().KeysDown[return_key] = true;
        (void)bench.frame();
        ImGui::GetIO().KeysDown[return_key] = false;
        bench.frames(3);
    };
    bench.type_into("Your answer", "half of 1");
    enter();
    REQUIRE(open_question(bench.lesson()));
    CHECK(ImGui::GetIO().WantTextInput);
    test::type(bench, ".5");  // appended to the answer
    CHECK(bench.lesson().typed == "half of 1.5");
    enter();
    CHECK(ImGui::GetIO().WantTextInput);
}

TEST_CASE("Ctrl+K finds an action while an answer is being typed", "[ui][window][lesson]") {
    LambertWindow bench;
    bench.type_into("Your answer", "0.5");
    (void)bench.key(Key::K, true);
    bench.frames(2);
    REQUIRE(bench.state.palette.open);
    test::type(bench, "projector");
    bench.frames(2);
    CHECK(bench.state.palette.text == "projector");
    CHECK(bench.lesson().typed == "0.5");
}

TEST_CASE("a letter and Enter answer a choice, and the palette opens during a question",
          "[ui][window][lesson]") {
    LessonWindow bench(lambert);
    LessonState& lesson = bench.lesson();
    bench.turn_to(PredictionKind::Choice);
    const Scene held = bench.scene();
    (void)bench.key(Key::Z, true);
    CHECK(says(bench, "First answer the lesson's question (Ctrl+Z)"));
    bench.state.notifications.list.clear();
    (void)bench.key(Key::K, true);
    bench.frames(2);
    REQUIRE(bench.state.palette.open);
    CHECK_FALSE(says(bench, "First answer"));
    test::type(bench, "exposure");
    bench.frames(2);
    (void)bench.key(Key::Enter);
    bench.frames(2);
    CHECK(says(bench, "First answer the lesson's question"));
    CHECK(bench.scene() == held);
    (void)bench.key(Key::Escape);
    bench.frames(2);
    (void)bench.key(Key::Enter);  // nothing is chosen yet
    REQUIRE(bench.asks_for(PredictionKind::Choice));
    (void)bench.key(Key::B);
    CHECK(lesson.chosen == Json(1));
    CHECK_FALSE(bench.state.get<CompareState>().choice.shows_stored);
    (void)bench.key(Key::C);
    CHECK(lesson.chosen == Json(2));
    const std::size_t open = *open_question(lesson);
    (void)bench.key(Key::Enter);
    CHECK(lesson.given()[open].value == Json(2));
    CHECK(lesson.given()[open].locked);
}

namespace {

/// A window in a lesson whose task moves a light, with fields for its position.
struct LightWindow : DrawnWindow {
    LightWindow() : DrawnWindow({1280, 1000}) {
        REQUIRE(problem_of(write_file(folder.path("ball.json"),
                                      R"({"glint": 1, "lights": [{"position": [1, 2, 3]}]})")) == nullptr);
        test::drop(*this,
                   folder.file("w.md", lesson_with("```try\ndrag: the light\ncontrol: /lights/0/position\n"
                                                   "e = explain --pixel 16,16\n"
                                                   "done: e.pixel[0] > 99\n"
                                                   "solution: /lights/0/position=[0,0,9]\n```\n")));
        REQUIRE(state.get<LessonState>().course);
    }
    void type_into_x(const char* letters) {
        state.notifications.list.clear();
        click_on("/lights/0/position/0");
        for (; *letters != 0; ++letters) type(std::string(1, *letters).c_str());
        click({2, 998});
        frames(3);
    }
    TemporaryDirectory folder;
};

}  // namespace

TEST_CASE("a lesson's light fields accept what the panel accepts and omit w", "[ui][window][lesson]") {
    LightWindow bench;
    for (const NamedControl& control : bench.controls()) CHECK(control.key != "/lights/0/position/3");
    bench.type_into_x("25");
    CHECK(bench.scene().lights[0].position == glm::vec4(25, 2, 3, 1));
    bench.type_into_x("1e7");
    CHECK(bench.state.notifications.list.empty());
    CHECK(bench.scene().lights[0].position == glm::vec4(1e7f, 2, 3, 1));
    bench.type_into_x("1e8");
    CHECK(bench.scene().lights[0].position == glm::vec4(1e7f, 2, 3, 1));
    CHECK(bench.state.notifications.list.size() == 1);
    CHECK(says(bench, "1e+08 is out of range"));
}

TEST_CASE("the answer can be shown without predicting, and this is recorded", "[ui][window][lesson]") {
    LambertWindow bench;
    bench.click_on("Show it anyway");
    CHECK(bench.lesson().given()[0].skipped);
    CHECK(bench.state.on_screen.explanation);
    CHECK(score_of(*bench.lesson().course, bench.lesson().progress).locked == 0);
}

TEST_CASE("undo does not lead out of a lesson", "[ui][window][lesson]") {
    HeadlessWindow bench;
    bench.scene().lights[0].intensity = 0.5f;
    bench.frames(2);
    REQUIRE(bench.state.editor.history.can_undo());
    test::drop(bench, lambert);
    if (bench.state.pending.asking) finish_pending(bench.state);  // Don't save
    bench.wait_for_loads();
    bench.frames(3);
    REQUIRE(bench.state.get<LessonState>().course);
    CHECK_FALSE(bench.state.editor.history.can_undo());
}

TEST_CASE("restoring the lesson's scene is one step that can be undone", "[ui][window][lesson]") {
    LambertWindow bench;
    bench.answer("0.5");
    const Scene lesson = bench.scene();
    bench.scene().lights[0].intensity = 0.25f;
    bench.frames(2);
    CHECK(bench.state.editor.unsaved());
    bench.click(bench.control("Back to the lesson's scene"));
    CHECK(bench.scene() == lesson);
    CHECK_FALSE(bench.state.editor.unsaved());
    bench.key(Key::Z, true);
    CHECK(bench.scene().lights[0].intensity == 0.25f);
}

TEST_CASE("the next page's scene has no file, leaving the user's scene asks first", "[ui][window][lesson]") {
    const TemporaryDirectory folder;
    const std::string path = folder.path("mine.json");
    LambertWindow bench;
    bench.answer("0.5");
    REQUIRE_FALSE(save_file(bench.state.editor, path, bench.scene()));
    const std::string saved = bytes_of(path);
    CHECK(bench.frame().title == "mine.json – Glint");
    bench.scene().lights[0].intensity = 0.25f;
    bench.frames(2);
    const std::size_t station = bench.lesson().progress.station;
    bench.key(Key::PageDown);
    bench.frames(2);
    REQUIRE(bench.state.pending.asking);
    CHECK(bench.lesson().progress.station == station);
    CHECK(bench.scene().lights[0].intensity == 0.25f);
    finish_pending(bench.state);  // Don't save
    bench.frames(2);
    CHECK(bench.lesson().progress.station == station + 1);
    CHECK(bench.scene() == bench.lesson().station().asked);
    bench.key(Key::S, true);
    bench.frames(2);
    CHECK(bench.state.files.open);  // to ask for a name
    CHECK(bytes_of(path) == saved);
}

TEST_CASE("a typed answer that was not locked in does not answer the next question", "[ui][window][lesson]") {
    const test::LessonFolder folder;
    const std::string asks = "```predict number\nquestion: How much?\nanswer: 0.5\ntolerance: 0.1\n```\n\n";
    LessonWindow bench(folder.file("two.md", lesson_with(asks + "## Two\n\n" + asks)));
    bench.type_into("Your answer", "7");
    CHECK(bench.lesson().typed == "7");
    bench.turn(Key::PageDown);
    REQUIRE(test::asked(bench).asks->kind == PredictionKind::Number);
    CHECK(bench.lesson().typed.empty());
    CHECK_FALSE(can_lock(bench.lesson()));
}

TEST_CASE("PgDn and PgUp turn pages while a number is typed, and restore their scenes",
          "[ui][window][lesson]") {
    LambertWindow bench;
    bench.type_into("Your answer", "0.");
    bench.key(Key::F9);
    CHECK(bench.state.layout.projector);
    bench.key(Key::F9);
    bench.click(bench.control("Your answer"));
    bench.key(Key::PageDown);
    bench.frames(2);
    CHECK(bench.lesson().progress.station == 2);
    CHECK(bench.scene() == bench.lesson().station().asked);
    bench.key(Key::PageUp);
    bench.key(Key::PageUp);
    bench.frames(2);
    CHECK(bench.lesson().progress.station == 0);
    CHECK_FALSE(bench.lesson().given().size() > 0);
    bench.key(Key::PageUp);
    CHECK(bench.lesson().progress.station == 0);
    CHECK(says(bench, "the start of the lesson"));
}

TEST_CASE("a lesson asks before discarding edits, and answering No changes nothing", "[ui][window][lesson]") {
    DrawnWindow bench;
    bench.scene().lights[0].intensity = 0.3f;
    bench.frames(2);
    const Scene edited = bench.scene();
    test::drop(bench, lambert);
    CHECK(bench.state.pending.asking);
    CHECK_FALSE(bench.state.get<LessonState>().course);
    bench.key(Key::Escape);
    bench.frames(2);
    CHECK(bench.scene() == edited);
    CHECK_FALSE(bench.state.get<LessonState>().course);
    test::drop(bench, lambert);
    finish_pending(bench.state);
    bench.wait_for_loads();
    CHECK(bench.state.get<LessonState>().course);
    // The lesson's scene has no file, so it is saved under a new name.
    CHECK(bench.state.editor.document.path.empty());
}

TEST_CASE("a lesson's error is reported with its line number, and the open scene stays",
          "[ui][window][lesson]") {
    const test::LessonFolder folder;
    DrawnWindow bench;
    const Scene before = bench.scene();
    test::drop(bench, folder.file("wrong.md", lesson_with("```predict number\nquestion: How?\nanswer: f.x\n"
                                                          "tolerance: 1\n```\n")));
    CHECK(says(bench, "wrong.md:13:"));
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.get<LessonState>().course);
    // An error that is found only when the lesson runs.
    test::drop(bench, folder.file("late.md", lesson_with("```scene\nset: /lights/9/intensity=1\n```\n")));
    CHECK(says(bench, "late.md:11:"));
    CHECK(bench.scene() == before);
    // A correct lesson opens from any folder.
    test::drop(bench, folder.file("right.md", lesson_with("Look.\n")));
    REQUIRE(bench.state.get<LessonState>().course);
    CHECK(bench.scene().objects[0].name == "Ball");
}

TEST_CASE("progress stores every answer, and a lesson resumes where it was left off",
          "[ui][window][lesson]") {
    const TemporaryDirectory folder;
    {
        LessonWindow bench(lambert, folder.path());
        bench.turn(Key::PageDown);
        bench.answer("0.4");
    }
    HeadlessWindow bench({1280, 1000});
    bench.state.get<LessonState>().folder =
        std::filesystem::path(test::shipped_lesson("x")).parent_path().string();
    begin_persistence(bench.state, folder.path());
    bench.frames(2);
    // The lesson's folder is not the program's, so its key is the full path.
    const auto text = read_file(folder.path("lessons.json"), 100000);
    CHECK(std::get<std::string>(text).find("lessons/05-lambert.md") != std::string::npos);
    bench.state.get<LessonState>().folder.clear();
    test::drop(bench, lambert);
    CHECK(bench.state.get<LessonState>().progress.station == 1);
    CHECK(bench.state.get<LessonState>().given()[0].value == Json(0.4));
    CHECK(bench.scene() == bench.state.get<LessonState>().station().revealed);
    open_lessons(bench.state);
    bench.frames(2);
    const std::vector<LessonEntry>& beside = bench.state.get<LessonListState>().beside;
    const auto entry = std::find_if(beside.begin(), beside.end(),
                                    [](const LessonEntry& lesson) { return number_of(lesson) == "05"; });
    REQUIRE(entry != beside.end());
    REQUIRE(entry->record);
    CHECK(entry->record->score.locked == 1);
    CHECK(entry->record->at == 1);
}

TEST_CASE("arrow keys and Enter open a lesson from a cyclic list", "[ui][window][lesson]") {
    HeadlessWindow bench;
    bench.state.get<LessonState>().folder =
        std::filesystem::path(test::shipped_lesson("x")).parent_path().string();
    open_lessons(bench.state);
    bench.frames(2);
    bench.key(Key::Enter);  // nothing is chosen yet
    CHECK(bench.state.get<LessonListState>().open);
    const LessonEntry last = bench.state.get<LessonListState>().own.back();
    bench.key(Key::Down);
    CHECK(bench.state.get<LessonListState>().chosen == 0);
    bench.key(Key::Up);
    CHECK(bench.state.get<LessonListState>().chosen ==
          static_cast<int>(bench.state.get<LessonListState>().own.size()) - 1);
    bench.frames(2);
    (void)bench.control(last.title);  // is visible
    bench.key(Key::Enter);
    bench.wait_for_loads();
    CHECK_FALSE(bench.state.get<LessonListState>().open);
    REQUIRE(bench.state.get<LessonState>().course);
    CHECK(bench.state.get<LessonState>().course->lesson.path == last.path);
}

TEST_CASE("a failure to store answers is reported once", "[ui][window][lesson]") {
    const TemporaryDirectory folder;
    LessonWindow bench(lambert, folder.file("state", "a file in its place"));
    CHECK_FALSE(says(bench, "cannot be remembered"));
    bench.turn(Key::PageDown);
    CHECK(says(bench, "Your answers and progress cannot be remembered: "));
    bench.state.notifications.list.clear();
    bench.click(bench.control("Show it anyway"));
    bench.frames(3);
    CHECK_FALSE(says(bench, "cannot be remembered"));
}

TEST_CASE("a picture dropped during a question does not cover the question", "[ui][window][lesson]") {
    const TemporaryDirectory folder;
    LambertWindow bench;
    const Picture picture = *bench.state.rendered;
    test::drop(bench, folder.file("mine.png", png_bytes(picture, "")));
    bench.frames(20);
    CHECK_FALSE(bench.state.get<MyPictureState>().shown);
    CHECK_FALSE(bench.state.get<MyPictureState>().reading);
    CHECK(says(bench, "Answer the lesson's question first"));
}

TEST_CASE("a lecturer's questions cannot be answered by mistake, PgDn shows the answer",
          "[ui][window][lesson]") {
    LambertWindow bench;
    bench.click_on("Lecturer");
    CHECK(open_question(bench.lesson()));
    CHECK_FALSE(bench.state.on_screen.explanation);
    const auto& controls = bench.controls();
    CHECK(std::none_of(controls.begin(), controls.end(), [](const NamedControl& c) {
        return c.name == "Your answer" || c.name == "Lock it in" || c.name == "It is";
    }));
    bench.turn(Key::PageDown);
    CHECK(bench.lesson().progress.station == 1);
    CHECK(bench.state.on_screen.explanation);
    (void)bench.control("It is");
    bench.key(Key::PageDown);
    CHECK(bench.lesson().progress.station == 2);
    bench.frames(3);
    bench.click(bench.control("Lecturer"));  // the student is on the lecturer's page and has no answers yet
    CHECK(bench.lesson().progress.station == 2);
    bench.key(Key::PageUp);
    CHECK(open_question(bench.lesson()));
}

TEST_CASE("a lesson stays visible on a projector, in a narrow window or without columns",
          "[ui][window][lesson]") {
    LambertWindow bench({1024, 900});
    (void)bench.control("Your answer");
    bench.key(Key::F9);
    bench.frames(2);
    (void)bench.control("Your answer");
    bench.key(Key::F9);
    bench.answer("0.5");
    bench.click_on("Why");
    CHECK(test::window_named("Equation") != nullptr);
    bench.click_on("Lesson");
    (void)bench.control("It is");
    bench.key(Key::F11);
    bench.frames(2);
    CHECK(window_layout(bench.state).has_caption);
    CHECK(lesson_caption(bench.state) == "Tilted by 60 degrees");
}

TEST_CASE("a scene that would reveal the answer is shown only after the question", "[ui][window][lesson]") {
    const TemporaryDirectory folder;
    (void)folder.file("ball.json",
                      R"({"glint": 1, "lights": [{"type": "point"}], "objects": [{"name": "Ball"}]})");
    DrawnWindow bench;
    test::drop(bench, folder.file("01.md", lesson_with("```scene\nset: /lights/0/intensity=0.5\n"
                                                       "picture: /lights/0/intensity=2\n```\n\n"
                                                       "```predict number\nquestion: How?\n"
                                                       "e = explain --pixel 16,16\nanswer: e.sum[0]\n"
                                                       "tolerance: 1\n```\n")));
    REQUIRE(open_question(bench.state.get<LessonState>()));
    CHECK(bench.state.rendered_scene.lights[0].intensity == 2);
    bench.click_on("Show it anyway");
    CHECK(bench.state.rendered_scene.lights[0].intensity == 0.5f);
}

TEST_CASE("a user's lesson is listed under recent files and reopens from there", "[ui][window][lesson]") {
    const test::LessonFolder folder;
    const std::string mine = folder.file("mine.md", lesson_with("Look.\n"));
    test::RememberingWindow bench(folder.path("state"));
    test::drop(bench, mine);
    REQUIRE(bench.state.get<LessonState>().course);
    REQUIRE(bench.state.persistence.preferences.recent == std::vector<std::string>{mine});
    bench.click_on("Leave");
    CHECK_FALSE(bench.state.get<LessonState>().course);
    bench.click_on("File");
    bench.click_on("Open recent");
    bench.click(bench.control(mine.c_str()));
    bench.wait_for_loads();
    REQUIRE(bench.state.get<LessonState>().course);
    CHECK(bench.state.get<LessonState>().course->lesson.path == mine);
}

TEST_CASE("an animation of a deleted light is reported and does not play", "[ui][window][lesson]") {
    LessonWindow bench(test::shipped_lesson("03-falloff"));
    while (!bench.plays()) bench.turn(Key::PageDown);
    REQUIRE(bench.lesson().station().reveal->play == "/lights/0/position/0");
    bench.click(bench.control("Show it anyway"));
    bench.frames(3);
    bench.scene().lights.clear();
    bench.frames(2);
    REQUIRE_FALSE(bench.state.get<AnimateState>().playing);
    bench.click(bench.control("Play it"));
    bench.frames(3);
    CHECK_FALSE(bench.state.get<AnimateState>().playing);
    CHECK(says(bench, "“/lights/0/position/0” no longer exists"));
}

TEST_CASE("each page plays its own animation after any other animation or edit", "[ui][window][lesson]") {
    LessonWindow bench(test::shipped_lesson("03-falloff"));
    const auto turn = [&](Key page) {
        bench.turn(page);
        if (!open_question(bench.lesson())) return;
        reveal_unanswered(bench.state);
        bench.frames(3);
    };
    while (!bench.plays()) turn(Key::PageDown);
    CHECK(bench.state.get<AnimateState>().playing);
    bench.state.notifications.list.clear();
    turn(Key::PageDown);
    CHECK_FALSE(says(bench, "any more"));
    (void)bench.key(Key::L, false, true);
    bench.frames(2);
    bench.state.notifications.list.clear();
    turn(Key::PageUp);
    bench.frames(2);
    CHECK(bench.state.get<AnimateState>().playing);
    CHECK(bench.state.get<AnimateState>().animation.pointer == bench.lesson().station().reveal->play);
    CHECK_FALSE(says(bench, "any more"));
}

TEST_CASE("opening another scene ends the lesson, as does its Leave button", "[ui][window][lesson]") {
    LambertWindow bench;
    REQUIRE(bench.scene().objects.size() == 7);
    bench.click_on("Leave");
    CHECK_FALSE(bench.state.get<LessonState>().course);
    CHECK(bench.scene().objects.size() == 1);  // the scene from before the lesson
    test::drop(bench, lambert);
    REQUIRE(bench.state.get<LessonState>().course);
    bench.key(Key::N, true);
    bench.frames(2);
    CHECK_FALSE(bench.state.get<LessonState>().course);
}

TEST_CASE("a curve and a position can be typed instead of drawn", "[ui][window][lesson]") {
    LessonWindow bench(test::shipped_lesson("07-shininess"));
    bench.turn_to(PredictionKind::Sketch);
    bench.type_into("Type it", "1 0.5 0");
    bench.frames(2);
    LessonState& lesson = bench.lesson();
    REQUIRE(can_lock(lesson));
    const Json::array_t& curve = elements_of(lesson.chosen);
    CHECK(curve.size() == 71);
    CHECK(curve[0].get<double>() == Approx(1));
    CHECK(curve[35].get<double>() == Approx(0.5));
    CHECK(curve[70].get<double>() == Approx(0));
    test::drop(bench, test::shipped_lesson("06-mirror-vector"));
    bench.turn_to(PredictionKind::Click);
    bench.type_into("Type it", "187, 76");
    bench.frames(2);
    CHECK(lesson.chosen == Json(Json::array_t{187.0, 76.0}));
    bench.click_on("Lock it in");
    CHECK(is_right(lesson.station().questions[0], lesson.given()[0]));
}

TEST_CASE("a reason is kept with the answer, and a typical wrong answer is explained",
          "[ui][window][lesson]") {
    const TemporaryDirectory folder;
    {
        LessonWindow bench(lambert, folder.path());
        bench.turn(Key::PageDown);
        bench.type_into("Your reason", "it is tilted");
        bench.answer("0.87");
        const LessonState& lesson = bench.lesson();
        CHECK(lesson.given()[0].why == "it is tilted");
        const StationQuestion& question = lesson.station().questions[0];
        CHECK(thought_behind(*question.asks, question.right, lesson.given()[0].value)
                  .starts_with("The cosine is that of the angle to the surface"));
    }
    LessonWindow bench(lambert, folder.path());
    CHECK(bench.lesson().given()[0].why == "it is tilted");
}
