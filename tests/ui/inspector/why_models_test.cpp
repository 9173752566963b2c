// The four shadings of one pixel side by side.
#include "tests/support/catch.h"
#include "tests/support/ui_why_bench.h"
#include "ui/fields/choices.h"
#include "ui/inspector/models_tab.h"

using namespace glint;
using test::Bench;

TEST_CASE("the models' values are those of the pixel drawn under each mode", "[ui][window][why]") {
    Bench bench;
    test::ask(bench, WhyTab::Models, {0.42, 0.38});
    const auto all = under_each_mode(bench.state, *bench.state.why);
    Renderer renderer(1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        Scene scene = bench.scene();
        scene.shading.mode = static_cast<ShadingMode>(i);
        (void)renderer.render(scene, bench.state.picture->size);
        const Explanation drawn = renderer.explain(bench.state.why->x, bench.state.why->y);
        CHECK(all[i].sum == drawn.sum);
        CHECK(all[i].byte == drawn.byte);
        CHECK(all[i].corners.size() == drawn.corners.size());
    }
    CHECK(all[2].corners.size() == 3);
    CHECK(all[0].sum != all[3].sum);
}

TEST_CASE("pointing at a model shows the picture under it, a click takes it, undo goes back",
          "[ui][window][why]") {
    Bench bench;
    test::ask(bench, WhyTab::Models);
    const Scene start = bench.scene();
    const auto values = under_each_mode(bench.state, *bench.state.why);
    const ImVec2 at = test::rest_on(bench, "Gouraud");
    CHECK(bench.state.drawn.shading.mode == ShadingMode::Gouraud);
    CHECK(bench.scene() == start);
    CHECK(under_each_mode(bench.state, *bench.state.why)[0].sum == values[0].sum);
    bench.click(at);
    CHECK(bench.scene().shading.mode == ShadingMode::Gouraud);
    test::rest(bench);
    bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
}

TEST_CASE("while a scene with other objects is on the screen the models wait", "[ui][window][why]") {
    Bench bench;
    test::ask(bench, WhyTab::Models);
    Scene other = bench.scene();
    other.objects.push_back(other.objects.front());
    other.objects.back().transform.translate = {0, 0, 1.5f};
    for (int i = 0; i < 3; ++i) {
        bench.state.why_column.instead = other;
        bench.frames(1);
    }
    CHECK(bench.state.drawn.objects.size() == 2);
    bench.frames(2);
    CHECK(bench.state.drawn == bench.scene());
}
