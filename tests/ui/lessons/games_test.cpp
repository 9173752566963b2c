// The quiz in the window, and *Match the target*.
#include <algorithm>
#include <set>
#include <thread>

#include "lessons/quiz.h"
#include "models/fields/scene_fields.h"
#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "tests/places.h"
#include "tests/support/lesson_window.h"
#include "tests/support/program.h"
#include "ui/document/document_actions.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// The numbers in which two scenes differ.
std::set<std::string> differing_numbers(const Scene& a, const Scene& b) {
    const std::vector<SceneNumber> of_a = numbers_of(a), of_b = numbers_of(b);
    REQUIRE(of_a.size() == of_b.size());
    std::set<std::string> differ;
    for (std::size_t i = 0; i < of_a.size(); ++i)
        if (of_a[i].value != of_b[i].value) differ.insert(of_a[i].pointer);
    return differ;
}

void open_game(HeadlessWindow& bench, std::uint64_t seed) {
    bench.frames(2);
    begin_match(bench.state, seed);
    bench.frames(3);
}

}  // namespace

TEST_CASE("a target differs from its start only in the named numbers, for every seed", "[ui][match]") {
    Renderer renderer(1);
    for (std::uint64_t seed = 1; seed <= 21; ++seed) {
        CAPTURE(seed);
        const MatchTask task = match_task(seed);
        const std::set<std::string> differ = differing_numbers(task.start, task.target);
        CHECK_FALSE(differ.empty());
        for (const std::string& number : differ)
            CHECK(std::find(task.numbers.begin(), task.numbers.end(), number) != task.numbers.end());
        CHECK(same_description(match_task(seed).target, task.target));
        // Setting the numbers one by one solves the task, and it is not solved at the start.
        Scene scene = task.start;
        for (const std::string& number : task.numbers)
            CHECK_FALSE(set_number(scene, number, number_at(task.target, number)->value));
        CHECK(scene == task.target);
        const Picture target = renderer.render(task.target, match_size);
        const Picture start = renderer.render(task.start, match_size);
        CHECK(apart_of(start, target) > 2 * match_tolerance);
    }
    CHECK_FALSE(match_task(1).target == match_task(8).target);
}

TEST_CASE("the difference shrinks as a number nears its target, from any view", "[ui][window][match]") {
    HeadlessWindow bench({1280, 1000});
    open_game(bench, 2);  // only the exponent differs
    const MatchState& match = bench.state.get<MatchState>();
    REQUIRE(match.on);
    CHECK(match.now == match.first);
    const float wanted = match.task.target.objects[0].material.shininess;
    float& shininess = bench.scene().objects[0].material.shininess;
    const double first = match.now;
    shininess = (shininess + wanted) / 2;
    bench.frames(2);
    CHECK(match.now < first);
    CHECK_FALSE(match.solved);
    const double half = match.now;
    bench.scene().camera.eye.x += 1;
    bench.frames(2);
    CHECK(match.now == half);
    bench.scene().objects[0].material.shininess = wanted;
    bench.frames(2);
    CHECK(match.now == 0);
    CHECK(match.solved);
}

TEST_CASE("a light within a few degrees is close enough, one ten degrees off is not", "[ui][match]") {
    const MatchTask task = match_task(1);
    Renderer renderer(1);
    const Picture target = renderer.render(task.target, match_size);
    const auto apart_at = [&](float degrees) {
        Scene scene = task.target;
        const float angle = degrees * 3.14159265f / 180;
        const glm::vec4 p = scene.lights[0].position;
        scene.lights[0].position.x = p.x * std::cos(angle) + p.z * std::sin(angle);
        scene.lights[0].position.z = p.z * std::cos(angle) - p.x * std::sin(angle);
        return apart_of(renderer.render(scene, match_size), target);
    };
    CAPTURE(apart_at(2), apart_at(3), apart_at(5), apart_at(10));
    CHECK(apart_at(2) < match_tolerance);
    CHECK(apart_at(10) > match_tolerance);
}

TEST_CASE("a hint names the differing term and how it differs", "[ui][match]") {
    Renderer renderer(1);
    const MatchTask task = match_task(1);
    Scene scene = task.target;
    CHECK(match_hint(renderer, scene, task.target) == "Nothing differs.");
    scene.objects[0].material.shininess *= 4;
    CHECK(match_hint(renderer, scene, task.target) ==
          "The specular term is furthest off: its highlight is too small.");
    scene = task.target;
    scene.objects[0].material.diffuse *= 0.6f;
    CHECK(match_hint(renderer, scene, task.target) ==
          "The diffuse term is furthest off: its light is too dark.");
    scene = task.target;
    scene.global_ambient *= 3.0f;
    CHECK(match_hint(renderer, scene, task.target) == "The ambient term is furthest off: it is too bright.");
    scene = task.target;
    scene.lights[0].position.x = -scene.lights[0].position.x;
    CHECK(match_hint(renderer, scene, task.target).find("in the wrong place") != std::string::npos);
    scene.lights.clear();
    CHECK(match_hint(renderer, scene, task.target) ==
          "The diffuse term is furthest off: its light is missing.");
    scene = task.target;
    scene.shading.terms.diffuse = false;
    CHECK(match_hint(renderer, scene, task.target) ==
          "The shading differs from the target's: Begin again restores it.");
}

TEST_CASE("changes to a game saved under a name are not discarded without asking", "[ui][window][match]") {
    const TemporaryDirectory folder;
    const std::string path = folder.path("game.json");
    HeadlessWindow bench({1280, 1000});
    open_game(bench, 2);
    bench.scene().objects[0].material.shininess = 3;
    bench.frames(2);
    CHECK_FALSE(bench.state.editor.unsaved());
    REQUIRE_FALSE(save_file(bench.state.editor, path, bench.scene()));
    bench.scene().objects[0].material.shininess = 4;
    bench.frames(2);
    CHECK(bench.state.editor.unsaved());
    bench.click_on("Another");
    CHECK(bench.state.pending.asking);
    CHECK(bench.state.get<MatchState>().seed == 2);
    bench.state.pending = {};
    bench.frames(2);
    run_command(bench.state, test::command_named("Match the target"));
    CHECK(bench.state.pending.asking);
    CHECK(bench.state.get<MatchState>().seed == 2);
    finish_pending(bench.state);
    CHECK(bench.state.get<MatchState>().seed == 3);
}

TEST_CASE("the target of a game is not remembered for the next window", "[ui][window][match]") {
    DrawnWindow bench({1280, 1000});
    const Json before = features_to_remember(bench.state);
    open_game(bench, 2);
    bench.click_on("Target next to it");
    CHECK(features_to_remember(bench.state) == before);
}

TEST_CASE("starting a game ends what was shown before, Escape ends an animation", "[ui][window][match]") {
    DrawnWindow bench;
    const auto play = [&] {
        if (!bench.state.get<AnimateState>().open)
            run_command(bench.state, test::command_named("Animate: turntable, light, number…"));
        bench.frames(2);
        bench.state.get<AnimateState>().animation.motion = Motion::Turntable;
        bench.click_on("Play");
        REQUIRE(bench.state.get<AnimateState>().playing);
    };
    play();
    (void)bench.key(Key::Escape);
    bench.frames(2);
    CHECK_FALSE(bench.state.get<AnimateState>().open);
    CHECK_FALSE(bench.state.get<AnimateState>().playing);
    CHECK_FALSE(bench.state.get<AnimateState>().frame);
    play();
    begin_match(bench.state, 3);
    bench.frames(3);
    CHECK_FALSE(bench.state.get<AnimateState>().playing);
    CHECK(bench.state.rendered_scene == bench.scene());
}

TEST_CASE("the game's buttons work: hint, target, begin again, another, leave", "[ui][window][match]") {
    HeadlessWindow bench({1280, 1000});
    open_game(bench, 2);
    bench.click(bench.control("A hint"));
    bench.frames(1);
    CHECK(bench.state.get<MatchState>().hint.find("specular term") != std::string::npos);
    bench.click_on("Target next to it");
    CHECK(bench.state.get<CompareState>().choice.on);
    CHECK(*bench.state.get<CompareState>().choice.stored == bench.state.get<MatchState>().task.target);
    bench.scene().objects[0].material.shininess = 3;
    bench.frames(2);
    bench.click_on("Begin again");
    CHECK(bench.scene() == bench.state.get<MatchState>().task.start);
    bench.scene().objects[0].material.shininess = 3;
    bench.frames(2);
    bench.click_on("Another");
    CHECK(bench.state.get<MatchState>().seed == 3);
    CHECK_FALSE(bench.state.pending.asking);  // a game's changes need no saving
    bench.click_on("Leave");
    CHECK_FALSE(bench.state.get<MatchState>().on);
    CHECK_FALSE(bench.state.get<CompareState>().choice.on);
}

namespace {

/// Opens the quiz of a window that stores its settings in `folder`.
void open_quiz_in(HeadlessWindow& bench, const std::string& folder) {
    begin_persistence(bench.state, folder);
    bench.state.get<LessonState>().inventory = project_file("assets/inventory.md");
    bench.frames(2);
    test::command_named("Quiz: what do you believe about lighting?").run(bench.state);
    do {
        (void)bench.frame();
        std::this_thread::yield();
    } while (!bench.state.get<QuizState>().pages);
    bench.frames(2);
}

}  // namespace

TEST_CASE("keys answer the quiz, and the next window continues it until it is saved",
          "[ui][window][quiz][long]") {
    using Taken = std::vector<std::optional<std::size_t>>;
    const TemporaryDirectory folder;
    {
        HeadlessWindow bench({1280, 1000});
        open_quiz_in(bench, folder.path("state"));
        (void)bench.key(Key::B);
        (void)bench.key(Key::Enter);
        (void)bench.key(Key::E);  // ignored: there are only four options
        (void)bench.key(Key::PageDown);
        (void)bench.key(Key::D);
        (void)bench.key(Key::PageUp);
        (void)bench.key(Key::PageUp);
        (void)bench.key(Key::PageUp);
        CHECK(bench.state.get<QuizState>().at == 0);
        (void)bench.key(Key::A);
    }
    {
        HeadlessWindow bench({1280, 1000});
        open_quiz_in(bench, folder.path("state"));
        QuizState& quiz = bench.state.get<QuizState>();
        CHECK(quiz.at == 1);  // the first question without an answer
        CHECK(Taken(quiz.taken.begin(), quiz.taken.begin() + 4) == Taken{0, {}, 3, {}});
        quiz.after = true;
        (void)bench.key(Key::C);
        answers_purpose.use(bench.state, folder.path("answers.json"));
        bench.frames(2);
    }
    HeadlessWindow bench({1280, 1000});
    open_quiz_in(bench, folder.path("state"));
    CHECK(bench.state.get<QuizState>().taken == Taken(24));
    CHECK_FALSE(bench.state.get<QuizState>().after);
    bench.click(bench.control(bench.state.get<QuizState>().pages->pages[0].options[2]));
    CHECK(bench.state.get<QuizState>().taken[0] == 2u);
    bench.click(bench.control("Next question"));
    bench.click(bench.control("Begin again"));
    CHECK(bench.state.get<QuizState>().at == 0);
    CHECK(bench.state.get<QuizState>().taken == Taken(24));
    bench.frames(2);
    bench.click(bench.control("Restore them"));
    CHECK(bench.state.get<QuizState>().taken[0] == 2u);
}

TEST_CASE("clicks answer the quiz, and glint quiz counts its file", "[ui][window][quiz][long]") {
    const std::string inventory = project_file("assets/inventory.md");
    HeadlessWindow bench({1280, 1000});
    bench.state.get<LessonState>().inventory = inventory;
    bench.frames(2);
    test::command_named("Quiz: what do you believe about lighting?").run(bench.state);
    QuizState& quiz = bench.state.get<QuizState>();
    do {
        (void)bench.frame();
        std::this_thread::yield();
    } while (!quiz.pages);
    bench.frames(2);
    REQUIRE(quiz.pages->pages.size() == 24);
    quiz.after = true;
    for (std::size_t i = 0; i < 24; ++i) {
        CAPTURE(i);
        REQUIRE(quiz.at == i);
        const QuizPage& page = quiz.pages->pages[i];
        REQUIRE(page.options.size() == 4);
        if (i != 5) bench.click(bench.control(page.options[i % 4]));  // one question is skipped
        bench.click_on("Next question");
    }
    bench.click(bench.control("Your number or code"));
    bench.type("17");
    bench.frames(2);
    const TemporaryDirectory folder;
    answers_purpose.use(bench.state, folder.path("answers.json"));
    const auto text = std::get<std::string>(read_file(folder.path("answers.json"), 10000));
    const auto lesson = std::get<Lesson>(read_lesson(inventory));
    const auto read = std::get<QuizAnswers>(read_answers(lesson, text, "answers.json"));
    CHECK(read.after);
    CHECK(read.options == quiz.taken);
    CHECK(read.person == "17");
    CHECK(read.seconds.size() == 24);
    CHECK(read.options[0] == 0u);
    CHECK_FALSE(read.options[5]);
    CHECK(read.options[7] == 3u);
    const Ended ended = run_glint({"quiz", folder.path("answers.json")});
    CHECK(ended.status == 0);
    CHECK(ended.out.find("\"after\": 1") != std::string::npos);
}
