// Files that the last release wrote, kept in tests/frozen, open in the current program. After a release,
// GLINT_FREEZE=1 in the environment replaces them with files from the current program.
#include <cstdlib>
#include <filesystem>

#include "models/io/file.h"
#include "tests/places.h"
#include "tests/support/person.h"
#include "tests/support/scenes.h"
#include "ui/picture/orbit.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using test::Person;

namespace {

const std::string lambert = project_file("assets/lessons/05-lambert.md");

/// A window that keeps its settings, progress and answers in `folder`.
void begin_in(Person& person, const std::string& folder) {
    begin_persistence(person.state, folder);
    person.state.get<LessonState>().folder = project_file("assets/lessons");
    person.state.get<LessonState>().inventory = project_file("assets/inventory.md");
    person.frames(2);
}

void open_quiz(Person& person) {
    test::command_named("Quiz: what do you believe about lighting?").run(person.state);
    person.waits_until([&] { return person.state.get<QuizState>().pages.has_value(); });
}

void freeze_files(const std::string& folder) {
    std::filesystem::create_directories(folder);
    REQUIRE(problem_of(write_file(folder + "/scene.json", scene_text(test::busy_scene()))) == nullptr);
    Person person;
    begin_in(person, folder);
    person.state.dark = false;
    person.state.layout.left_width = 300;
    person.state.kept_views.resize(2);
    person.state.kept_views[1].eye = {1, 2, 3};
    person.state.get<CompareState>().choice.gain = 16;
    person.drops(lambert);
    person.press(Key::PageDown);
    person.clicks("Your answer");
    person.type("0.5");
    person.clicks("Lock it in");
    leave_lesson(person.state);
    person.state.persistence.preferences.recent = {"/home/student/scene.json"};
    open_quiz(person);
    person.press(Key::B);
    end_persistence(person.state);
}

}  // namespace

TEST_CASE("files from the last release open in the current program", "[ui][window]") {
    const std::string frozen = project_file("tests/frozen");
    if (std::getenv("GLINT_FREEZE") != nullptr) freeze_files(frozen);
    const TemporaryDirectory folder;
    std::filesystem::copy(frozen, folder.path());
    Person person;
    begin_in(person, folder.path());
    CHECK_FALSE(person.state.dark);
    CHECK(person.state.layout.left_width == 300);
    REQUIRE(person.state.kept_views.size() == 2);
    CHECK(person.state.kept_views[1].eye == glm::vec3(1, 2, 3));
    CHECK(person.state.get<CompareState>().choice.gain == 16);

    person.drops(folder.path("scene.json"));
    CHECK(person.state.notifications.list.empty());
    CHECK(same_description(person.scene(), test::busy_scene()));
    person.drops(lambert);
    const LessonState& lesson = person.state.get<LessonState>();
    REQUIRE(lesson.progress.station == 1);
    CHECK(lesson.given()[0].locked);
    CHECK(is_right(lesson.station().questions[0], lesson.given()[0]));
    open_quiz(person);
    CHECK(person.state.get<QuizState>().taken.at(0) == 1u);
    CHECK_FALSE(person.state.get<QuizState>().taken.at(1));
}
