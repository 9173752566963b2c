// The switches for mistakes: a click is one undo step, and hovering previews without changing the scene.
#include <algorithm>
#include <string>

#include "models/scene/mistakes.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/mistake_row.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// The topmost mistake in the list.
const MistakeName& first_mistake() {
    const auto names = mistake_names();
    return *std::find_if(names.begin(), names.end(),
                         [](const MistakeName& m) { return m.seen_as == all_seen_as[0]; });
}
std::string first_switch() { return "/shading/mistakes/" + std::string(first_mistake().name); }

}  // namespace

TEST_CASE("titles of mistakes spell sRGB and Phong correctly", "[ui][why]") {
    const auto title = [](std::string_view name) {
        for (const MistakeName& mistake : mistake_names())
            if (mistake.name == name) return title_of(mistake);
        return std::string();
    };
    CHECK(title("lit_in_srgb") == "Lit in sRGB");
    CHECK(title("half_angle_with_phong_shininess") == "Half angle with Phong shininess");
    CHECK(title("power_zero_is_nan") == "Power zero is NaN");
    CHECK(title("normals_as_points") == "Normals as points");
}

TEST_CASE("hovering over a mistake previews it, a click toggles it as one undo step", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Mistakes);
    const Scene start = bench.scene();
    const auto first = first_mistake().flag;
    const ImVec2 row = test::rest_on(bench, first_switch());
    CHECK(bench.state.rendered_scene.shading.mistakes.*first);
    CHECK(bench.scene() == start);
    bench.click(row);
    CHECK(bench.scene().shading.mistakes.*first);
    CHECK(mistakes_on(bench.scene().shading.mistakes) == 1);
    test::rest(bench);
    CHECK(bench.state.rendered_scene == bench.scene());
    CHECK(bench.state.editor.history.undo_name() == "Mistakes");
    bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
}

TEST_CASE("no mistake is named over a frozen picture or after a preview has ended",
          "[ui][window][why][lecture]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Mistakes);
    (void)test::rest_on(bench, first_switch());
    CHECK_FALSE(bench.state.get<InspectorState>().preview_name.empty());
    test::rest(bench);
    bench.key(Key::F8);
    (void)test::rest_on(bench, first_switch());
    CHECK(bench.state.get<InspectorState>().preview_name.empty());
    REQUIRE(bench.state.on_screen.explained_other);
    bench.key(Key::F8);
    bench.frames(3);
    CHECK_FALSE(bench.state.on_screen.explained_other);
    CHECK_FALSE(bench.state.get<InspectorState>().preview_name.empty());
    REQUIRE(bench.state.on_screen.explanation);
    const glm::vec3 sum = bench.state.on_screen.explanation->sum;
    test::rest(bench);
    CHECK(bench.state.on_screen.explanation->sum == sum);  // the explanation was that of the edited scene
}

TEST_CASE("clicking the status line scrolls the list of mistakes to the active one", "[ui][window][why]") {
    for (const MistakeName& mistake : mistake_names()) {
        const std::string row = "/shading/mistakes/" + std::string(mistake.name);
        CAPTURE(row);
        HeadlessWindow bench;
        test::ask(bench, InspectorTab::Equation);
        bench.scene().shading.mistakes.*mistake.flag = true;
        bench.frames(2);
        bench.click(bench.control("/shading/mistakes"));
        CHECK(bench.state.get<InspectorState>().tab == InspectorTab::Mistakes);
        bench.frames(3);
        const Rect shown = bench.area_of(row, test::right_column(bench));  // fails if hidden
        CHECK(shown.high.y <= test::right_column(bench).high.y);
    }
}

TEST_CASE("at most the first two mistakes are named", "[ui][why]") {
    Mistakes mistakes;
    CHECK(mistakes_text(mistakes).empty());
    mistakes.reflect_sign = true;
    CHECK(mistakes_text(mistakes) == "Mistake: Reflect sign");
    mistakes.power_zero_is_nan = true;
    CHECK(mistakes_text(mistakes) == "2 mistakes: Reflect sign, Power zero is NaN");
    mistakes.view_reversed = mistakes.missing_pi = true;
    CHECK(mistakes_text(mistakes).starts_with("4 mistakes: "));
    CHECK(mistakes_text(mistakes).ends_with(", …"));
}

TEST_CASE("every tab can be drawn with an object, the background or nothing picked", "[ui][window][why]") {
    HeadlessWindow bench;
    bench.frames(2);
    const Scene start = bench.scene();
    for (const InspectorTabInfo& info : inspector_tabs()) {
        for (const glm::dvec2 share : {glm::dvec2(0.5), glm::dvec2(0.01)}) test::ask(bench, info.tab, share);
        bench.state.viewport.probe.reset();
        bench.frames(2);
    }
    CHECK(bench.scene() == start);
}
