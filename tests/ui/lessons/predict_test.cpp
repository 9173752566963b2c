// *Predict*: the picture is frozen until the user has predicted a pixel's colour.
#include "tests/support/headless_inspector.h"
#include "tests/support/lesson_window.h"
#include "ui/features/lessons/lesson.h"
#include "ui/widgets/numbers/number_input.h"

using namespace glint;
using test::DrawnWindow;

namespace {

/// A window in which the ball's centre is picked and the picture is frozen.
struct PredictWindow : DrawnWindow {
    PredictWindow() : DrawnWindow({1280, 1000}) {
        (void)key(Key::Q);
        CHECK(state.get<PredictState>().stage == PredictStage::Pick);
        const PictureSize size = state.rendered->size;
        click(at_pixel({size.width / 2.0, size.height / 2.0}));
        frames(2);
    }
};

}  // namespace

TEST_CASE("a picked pixel is frozen while the scene changes, then shows its new colour",
          "[ui][window][lesson]") {
    PredictWindow bench;
    REQUIRE(bench.state.get<PredictState>().stage == PredictStage::Change);
    const Scene before = bench.state.rendered_scene;
    const std::array<int, 3> was = bench.state.get<PredictState>().before;
    bench.scene().lights.clear();
    bench.scene().global_ambient = {};
    bench.frames(3);
    CHECK(bench.state.rendered_scene == before);
    // No tab of the column reveals the colour.
    CHECK(test::window_named("Equation") == nullptr);
    CHECK(test::window_named("Shadings") == nullptr);
    const Rect picker = bench.area_of("Colour to predict");
    bench.click(picker.low + ImVec2(30, 30));
    REQUIRE(bench.state.get<PredictState>().mine != Json());
    bench.click(bench.control("Lock the colour in"));
    bench.frames(4);
    CHECK(bench.state.get<PredictState>().stage == PredictStage::Revealed);
    CHECK(bench.state.rendered_scene == bench.scene());
    REQUIRE(bench.state.get<PredictState>().answer);
    CHECK(was[0] > 20);
    CHECK(*bench.state.get<PredictState>().answer == std::array<int, 3>{0, 0, 0});  // no light
    (void)bench.control("You said");
    (void)bench.control("It is");
    CHECK(test::window_named("Equation") != nullptr);
    // After the next edit, the answer is labelled as the old colour.
    bench.scene().global_ambient = {1, 1, 1};
    bench.frames(3);
    CHECK(*bench.state.get<PredictState>().answer == std::array<int, 3>{0, 0, 0});
    (void)bench.control("It was");
}

TEST_CASE("a colour is predicted without a mouse once a pixel is picked", "[ui][window][lesson]") {
    PredictWindow bench;
    REQUIRE(bench.state.get<PredictState>().stage == PredictStage::Change);
    bench.scene().lights.clear();
    bench.frames(2);
    (void)bench.key(Key::Enter);
    CHECK(bench.state.get<PredictState>().stage == PredictStage::Change);  // nothing is predicted yet
    bench.frames(4);
    REQUIRE(ImGui::GetIO().WantTextInput);
    bench.type("7");  // replaces the red value
    (void)bench.key(Key::Enter);
    CHECK(bench.state.get<PredictState>().stage == PredictStage::Change);  // the key only ended text entry
    let_go_of_fields();
    bench.frames(2);
    (void)bench.key(Key::Enter);
    bench.frames(4);
    CHECK(bench.state.get<PredictState>().stage == PredictStage::Revealed);
    CHECK(std::round(255 * elements_of(bench.state.get<PredictState>().mine)[0].get<double>()) == 7);
    REQUIRE(bench.state.get<PredictState>().answer);
    (void)bench.key(Key::Enter);
    CHECK(bench.state.get<PredictState>().stage == PredictStage::Change);
}

TEST_CASE("a pixel's old colour is the edited scene's, not a comparison part's", "[ui][window][lesson]") {
    DrawnWindow bench({1280, 1000});
    bench.compare({variant_of(Reflection::None), {}});
    const PictureSize size = bench.state.rendered->size;
    bench.click(bench.at_pixel({size.width * 0.47, size.height / 2.0}));
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    const Explanation& asked = *bench.state.on_screen.explanation;
    const auto edited = bench.state.renderer->explain(asked.x, asked.y).byte;
    REQUIRE_FALSE(asked.byte == edited);
    bench.key(Key::Q);
    CHECK(bench.state.get<PredictState>().before == edited);
}

TEST_CASE("Esc, the prediction's own key and another scene cancel a prediction", "[ui][window][lesson]") {
    PredictWindow bench;
    bench.scene().lights.clear();
    bench.frames(2);
    bench.key(Key::Escape);
    bench.frames(2);
    CHECK(bench.state.get<PredictState>().stage == PredictStage::Off);
    CHECK_FALSE(bench.state.get<LectureState>().frozen);
    CHECK(bench.state.rendered_scene == bench.scene());
    bench.key(Key::Q);
    CHECK(bench.state.get<PredictState>().stage == PredictStage::Change);  // the pixel is still picked
    bench.key(Key::Q);
    CHECK_FALSE(bench.state.get<LectureState>().frozen);
    bench.key(Key::Q);
    test::drop(bench, test::shipped_lesson("05-lambert"));
    bench.state.pending.asking = false;
    bench.frames(2);
}

TEST_CASE("a prediction shows the picture of the scene, not of a preview", "[ui][window][lesson]") {
    test::HeadlessWindow bench;
    test::ask(bench, InspectorTab::Equation);
    const Scene edited = bench.scene();
    (void)test::rest_on(bench, "s  specular");
    REQUIRE_FALSE(bench.state.rendered_scene == edited);
    bench.key(Key::Q);
    REQUIRE(bench.state.get<PredictState>().stage == PredictStage::Change);
    CHECK(*bench.state.get<LectureState>().frozen == edited);
    bench.frames(2);
    CHECK(bench.state.rendered_scene == edited);
}

TEST_CASE("a prediction can start during a freeze or an animation", "[ui][window][lesson]") {
    DrawnWindow bench;
    bench.state.get<AnimateState>().animation.motion = Motion::Turntable;
    bench.state.get<AnimateState>().playing = true;
    bench.frames(3);
    REQUIRE(bench.state.get<AnimateState>().frame);
    switch_prediction(bench.state);
    bench.frames(2);
    CHECK_FALSE(bench.state.get<AnimateState>().frame);
    REQUIRE(bench.state.get<PredictState>().stage == PredictStage::Pick);
    bench.click(bench.at_pixel({200, 300}));
    bench.frames(3);
    CHECK(bench.state.get<PredictState>().stage == PredictStage::Change);
}

TEST_CASE("the revealed pixel is the picked one, even if others are viewed or picked",
          "[ui][window][lesson]") {
    PredictWindow bench;
    REQUIRE(bench.state.get<PredictState>().stage == PredictStage::Change);
    const std::array<int, 3> was = bench.state.get<PredictState>().before;
    bench.key(Key::B, true);
    const int looked_at = GENERATE(0, 1, 2);
    CAPTURE(looked_at);
    if (looked_at == 0) ask_about(bench.state.viewport, glm::dvec2(0.02, 0.02));  // background
    if (looked_at == 1) {
        bench.scene().lights.clear();
        bench.scene().global_ambient = {};
        bench.frames(2);
        bench.key(Key::B);
    }
    if (looked_at == 2) bench.key(Key::C);
    bench.frames(2);
    bench.click(bench.control("Lock the colour in"));
    bench.frames(4);
    REQUIRE(bench.state.get<PredictState>().answer);
    CHECK(*bench.state.get<PredictState>().answer == (looked_at == 1 ? std::array<int, 3>{0, 0, 0} : was));
}
