// The switches for mistakes: a click is one undo step, resting on one shows it without touching the scene.
#include "models/scene/mistakes.h"
#include "tests/support/catch.h"
#include "tests/support/ui_why_bench.h"
#include "ui/inspector/mistakes_tab.h"

using namespace glint;
using test::Bench;

namespace {

std::string first_switch() { return "/shading/mistakes/" + std::string(mistake_names().front().name); }

}  // namespace

TEST_CASE("resting on a mistake draws it and leaves the scene alone; a click keeps it, undo takes it back",
          "[ui][window][why]") {
    Bench bench;
    test::ask(bench, WhyTab::Mistakes);
    const Scene start = bench.scene();
    const auto first = mistake_names().front().flag;
    const ImVec2 row = test::rest_on(bench, first_switch());
    CHECK(bench.state.drawn.shading.mistakes.*first);
    CHECK(bench.scene() == start);
    bench.click(row);
    CHECK(bench.scene().shading.mistakes.*first);
    CHECK(mistakes_on(bench.scene().shading.mistakes) == 1);
    test::rest(bench);
    CHECK(bench.state.drawn == bench.scene());
    CHECK(bench.state.editor.history.undo_name() == "Mistakes");
    bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
}

TEST_CASE("a preview that ends asks for the frame that draws the edited scene again", "[ui][window][why]") {
    Bench bench;
    test::ask(bench, WhyTab::Mistakes);
    const auto first = mistake_names().front().flag;
    (void)test::rest_on(bench, first_switch());
    CHECK(bench.state.drawn.shading.mistakes.*first);
    ImGui::GetIO().MousePos = {5, 5};
    CHECK(bench.frame().sleep_s == 0);
    (void)bench.frame();
    CHECK(bench.state.drawn == bench.scene());
    CHECK(bench.frame().sleep_s > 0);
}

TEST_CASE("the status line's mark opens the mistakes", "[ui][window][why]") {
    Bench bench;
    test::ask(bench, WhyTab::Equation);
    bench.scene().shading.mistakes.normals_flipped = true;
    bench.frames(2);
    bench.click(bench.control("/shading/mistakes"));
    CHECK(bench.state.why_column.tab == WhyTab::Mistakes);
}

TEST_CASE("every tab draws with a pixel picked, with the background picked and with none",
          "[ui][window][why]") {
    Bench bench;
    bench.frames(2);
    const Scene start = bench.scene();
    for (const WhyTabInfo& info : why_tabs()) {
        for (const glm::dvec2 share : {glm::dvec2(0.5), glm::dvec2(0.01)}) test::ask(bench, info.tab, share);
        bench.state.viewport.probe.reset();
        bench.frames(2);
    }
    CHECK(bench.scene() == start);
}
