// While the picture shows a scene other than the edited one (B, or a frozen one), picking explains the shown
// scene, and no drag in the picture or the column changes the edited one.
#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/program.h"
#include "ui/features/export/export_picture.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/views/views.h"
#include "ui/picture/draw_picture.h"

using namespace glint;
using test::DrawnWindow;

namespace {

/// B is stored with two lights; then the edited scene's first light is deleted and the other brightened.
struct StoredWindow : DrawnWindow {
    StoredWindow() : DrawnWindow({1280, 1000}) {
        (void)key(Key::B, true);
        b = scene();
        REQUIRE(b.lights.size() == 2);
        scene().lights.erase(scene().lights.begin());
        scene().lights[0].intensity = 3;
        frames(2);
        edited = scene();
        state.get<InspectorState>().tab = InspectorTab::Equation;
    }
    ImVec2 at_share(double x, double y) {
        const PictureSize size = state.rendered->size;
        const glm::ivec2 pixel = nearest_pixel(size, {x * size.width, y * size.height});
        return at_pixel(glm::dvec2(pixel) + 0.5);
    }
    /// Checks that the explanation is the one a separate renderer gives for B's pixel.
    void check_explains_b() {
        REQUIRE(state.on_screen.explanation.has_value());
        const Explanation& e = *state.on_screen.explanation;
        Renderer alone(1);
        (void)alone.render(b, state.rendered->size);
        const Explanation expected = alone.explain(e.x, e.y);
        CHECK(e.hit);
        CHECK(e.sum == expected.sum);
        CHECK(e.at.lights.size() == 2);
        CHECK(explained_scene(state) == b);
    }
    /// Checks that dragging and clicking each number in the column changes nothing.
    void check_column_edits_nothing() {
        frames(2);
        const Rect column = test::right_column(*this);
        std::vector<ImVec2> places;
        for (const NamedControl& control : controls())
            if (control.in_sight && column.holds(middle_of(control.at)) && control.key.starts_with("/"))
                places.push_back(middle_of(control.at));
        CHECK(places.size() > 5);
        for (const ImVec2 at : places) {
            drag(at, {at.x + 60, at.y});
            click(at);
            frames(1);
        }
        CHECK(scene() == edited);
    }

    Scene b, edited;
};

}  // namespace

TEST_CASE("while B is shown, clicks explain B, whose numbers are read-only", "[ui][window][compare]") {
    StoredWindow bench;
    bench.click(bench.at_share(0.5, 0.5));
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation->at.lights.size() == 1);
    bench.key(Key::B);
    bench.frames(2);
    bench.check_explains_b();
    bench.click(bench.at_share(0.45, 0.45));
    bench.frames(2);
    bench.check_explains_b();
    CHECK(why_disabled(bench.state, command(CommandId::SelectMainLight)) ==
          "The picture is not showing the scene you are editing");
    CHECK(bench.state.on_screen.explanation->x == bench.state.on_screen.pixel.x);
    bench.check_column_edits_nothing();
    CHECK_FALSE(is_explained(bench.state));
    CHECK(editable_scene(bench.state) == nullptr);
    bench.key(Key::B);
    bench.frames(2);
    CHECK(bench.state.on_screen.explanation->at.lights.size() == 1);
    CHECK(is_explained(bench.state));
    CHECK(editable_scene(bench.state) == &bench.scene());
    CHECK(bench.scene() == bench.edited);
}

TEST_CASE("no light of B can be grabbed, and the edited lights are not drawn over it",
          "[ui][window][compare]") {
    StoredWindow bench;
    const ImVec2 bulb = bench.at_pixel(bench.handle_pixel(0));
    bench.move(bulb);
    REQUIRE(bench.state.viewport.hovered_grip.kind == GripKind::Light);
    bench.key(Key::B);
    bench.frames(2);
    bench.drag(bulb, {bulb.x + 80, bulb.y + 40});
    CHECK(bench.scene().lights == bench.edited.lights);
    bench.key(Key::H);  // normally makes a light follow the cursor
    CHECK(bench.state.viewport.gesture == Gesture::None);
}

TEST_CASE("nothing in a frozen picture can be grabbed, and its pixel keeps its numbers",
          "[ui][window][lecture]") {
    StoredWindow bench;
    bench.scene() = bench.b;
    bench.frames(2);
    bench.click(bench.at_share(0.5, 0.5));
    bench.frames(2);
    bench.key(Key::F8);
    bench.scene() = bench.edited;
    bench.frames(2);
    bench.check_explains_b();
    bench.check_column_edits_nothing();
    for (double y = 0.1; y < 0.95; y += 0.1)
        for (double x = 0.1; x < 0.95; x += 0.1) {
            const ImVec2 from = bench.at_share(x, y);
            bench.drag(from, {from.x + 30, from.y + 20});
        }
    CHECK(bench.scene() == bench.edited);
    const ImVec2 middle = bench.at_share(0.5, 0.5);
    bench.drag(middle, {middle.x + 30, middle.y}, 1);
    ImGui::GetIO().MouseWheel = 2;
    bench.frames(1);
    CHECK(bench.scene() == bench.edited);
}

TEST_CASE("clicking a frozen picture shows a message about the freeze", "[ui][window][lecture]") {
    StoredWindow bench;
    bench.key(Key::F8);
    bench.state.notifications.list.clear();
    bench.click(bench.at_share(0.5, 0.5));
    REQUIRE(bench.state.notifications.list.size() == 1);
    CHECK(bench.state.notifications.list[0].text == "The picture is frozen: F8 unfreezes it");
}

TEST_CASE("exported pictures and copied commands are those of the shown scene", "[ui][window]") {
    const TemporaryDirectory folder;
    StoredWindow bench;
    std::string clipboard;
    test::use_clipboard(clipboard);
    const auto exported = [&] {
        const std::string path = folder.path("shown.pfm");
        begin_export(bench.state, {bench.state.rendered->size, 1}, path);
        while (bench.state.get<ExportState>().job) bench.frames(1);
        bench.frames(2);
        return std::get<Picture>(read_pfm(path)).linear;
    };
    const auto drawn = [&](const Scene& scene) {
        Renderer renderer(1);
        return renderer.render(scene, bench.state.rendered->size, true).linear;
    };
    const auto check_shows = [&](const Scene& scene) {
        const std::vector<float> mine = exported(), right = drawn(scene);
        REQUIRE(mine.size() == right.size());
        CHECK((mine == right));  // in parentheses, so that thousands of numbers are not printed
        copy_render_command(bench.state, {bench.state.rendered->size, 1}, "a.png");
    };
    REQUIRE_FALSE(save_file(bench.state.editor, folder.path("own.json"), bench.scene()));
    check_shows(bench.edited);
    CHECK(clipboard.find("/lights") == std::string::npos);
    bench.key(Key::B);
    bench.frames(2);
    check_shows(bench.b);
    CHECK(clipboard.find("/lights") != std::string::npos);  // the file has a different list of lights
    bench.key(Key::F8);
    bench.key(Key::B);
    bench.frames(2);
    check_shows(bench.b);
    CHECK(clipboard.find("/lights") != std::string::npos);  // the file has a different list of lights
}

TEST_CASE("the main light shown is that of the part under the cursor", "[ui][window][compare]") {
    DrawnWindow bench;
    bench.compare({variant_of(ShadingMode::Flat), variant_of(ShadingMode::Phong)});
    const PictureSize size = bench.state.rendered->size;
    Scene flat = bench.scene();
    flat.shading.mode = ShadingMode::Flat;
    Renderer alone(1);
    (void)alone.render(flat, size);
    int told = 0, other = 0;
    for (int y = size.height / 4; y < 3 * size.height / 4; y += 12)
        for (int x = size.width / 4; x < size.width / 2 - 10; x += 12) {
            bench.move(bench.at_pixel({x + 0.5, y + 0.5}));
            const auto main = main_light(alone.explain(x, y));
            const auto& shown = bench.state.viewport.main_light;
            if (!main || !shown) continue;
            ++told;
            CHECK(shown->light == main->light);
            CHECK(shown->share == main->share);
            const auto smooth = main_light(bench.state.renderer->explain(x, y));
            other += smooth && smooth->share != main->share ? 1 : 0;
        }
    CHECK(told > 20);
    CHECK(other > 10);
}

TEST_CASE("a predicted colour is that of the edited scene alone, without the comparison",
          "[ui][window][lesson]") {
    StoredWindow bench;
    bench.compare({{}, {Variant::Kind::Stored, 0}});
    bench.click(bench.at_share(0.55, 0.5));
    bench.frames(2);
    bench.key(Key::Q);
    bench.frames(3);
    CHECK_FALSE(bench.state.get<CompareState>().choice.on);
    REQUIRE(bench.state.get<PredictState>().stage == PredictStage::Change);
    Renderer alone(1);
    (void)alone.render(bench.edited, bench.state.rendered->size);
    CHECK(bench.state.get<PredictState>().before ==
          alone.explain(bench.state.on_screen.pixel.x, bench.state.on_screen.pixel.y).byte);
}

TEST_CASE("kept grid cells are explained and exported as shown, even during drags", "[ui][window][grid]") {
    DrawnWindow bench({1280, 1000});
    test::ask(bench, InspectorTab::Grid);
    bench.state.get<TermGridState>().solo = GridCell{1, 1};
    bench.frames(3);
    const auto alone = [&] { return with_cells(bench.scene(), {GridCell{1, 1}}); };
    const auto check_asked = [&] {
        Renderer renderer(1);
        (void)renderer.render(alone(), bench.state.rendered->size);
        REQUIRE(bench.state.on_screen.explanation);
        CHECK(bench.state.on_screen.explanation->sum ==
              renderer.explain(bench.state.on_screen.pixel.x, bench.state.on_screen.pixel.y).sum);
    };
    CHECK(bench.state.rendered_scene == alone());
    check_asked();
    bench.click(bench.at_pixel(glm::dvec2(bench.state.on_screen.pixel) + glm::dvec2(-40.5, 20.5)));
    bench.frames(2);
    check_asked();
    CHECK(shown_scene(bench.state) == alone());
    const ImVec2 bulb = bench.at_pixel(bench.handle_pixel(1));
    bench.move(bulb);
    bench.button(true);
    for (int i = 1; i <= 6; ++i) {
        const glm::vec4 before = bench.scene().lights[1].position;
        bench.move({bulb.x + 6 * float(i), bulb.y});
        CHECK(bench.state.rendered_scene.lights[0].diffuse ==
              glm::vec3(0));  // never the entire scene, even for one frame
        if (i > 2) CHECK(bench.scene().lights[1].position != before);
    }
    bench.button(false);
    bench.state.viewport.probe.reset();
    bench.frames(2);
    CHECK_FALSE(bench.state.on_screen.explanation.has_value());
}

TEST_CASE("a part is explained as shown: B, frozen or animated, with its own setting",
          "[ui][window][compare]") {
    StoredWindow bench;
    bench.compare({variant_of(ShadingMode::Flat), variant_of(ShadingMode::Phong)});
    const auto check_explains = [&](Scene scene, ShadingMode mode) {
        scene.shading.mode = mode;
        Renderer alone(1);
        (void)alone.render(scene, bench.state.rendered->size);
        REQUIRE(bench.state.on_screen.explanation.has_value());
        const glm::ivec2 at = bench.state.on_screen.pixel;
        CHECK(bench.state.on_screen.explanation->mode == mode);
        CHECK(bench.state.on_screen.explanation->sum == alone.explain(at.x, at.y).sum);
        const Picture& shown = *bench.state.displayed;
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(bench.state.on_screen.explanation->byte[c] == shown.rgba[4 * shown.pixel(at.x, at.y) + c]);
    };
    bench.key(Key::B);
    bench.frames(2);
    bench.click(bench.at_share(0.45, 0.5));
    bench.frames(2);
    check_explains(bench.b, ShadingMode::Flat);
    CHECK(explained_scene(bench.state).shading.mode == ShadingMode::Flat);
    bench.click(bench.at_share(0.55, 0.5));
    bench.frames(2);
    check_explains(bench.b, ShadingMode::Phong);
    bench.key(Key::B);
    bench.click(bench.at_share(0.45, 0.5));
    bench.frames(2);
    check_explains(bench.edited, ShadingMode::Flat);
    Scene played = bench.edited;
    played.lights[0].intensity = 1;
    bench.state.get<AnimateState>().frame = played;
    bench.frames(1);
    check_explains(played, ShadingMode::Flat);
    bench.frames(1);
    bench.key(Key::F8);
    bench.scene().lights.clear();
    bench.frames(2);
    check_explains(bench.edited, ShadingMode::Flat);
    bench.key(Key::C);
    bench.frames(2);
    check_explains(bench.edited, bench.edited.shading.mode);
    bench.key(Key::C);
    bench.frames(2);
    check_explains(bench.edited, ShadingMode::Flat);
    bench.state.viewport.probe.reset();
    bench.frames(2);
    CHECK_FALSE(bench.state.on_screen.explanation.has_value());
}

TEST_CASE("nothing in an animated scene can be grabbed, a press ends a lesson's animation", "[ui][window]") {
    for (const bool in_panel : {false, true}) {
        DrawnWindow bench({1280, 1000});
        AnimateState& animate = bench.state.get<AnimateState>();
        animate.animation = {Motion::Turntable, "", 0, 0, 48};
        animate.open = in_panel;
        animate.playing = true;
        bench.frames(3);
        REQUIRE(animate.frame);
        const Scene before = bench.scene();
        const ImVec2 bulb = bench.at_pixel(bench.handle_pixel(1));
        bench.move(bulb);
        CHECK_FALSE(bench.state.viewport.hovered_grip);
        bench.drag(bulb, {bulb.x + 80, bulb.y + 30});
        CHECK(bench.scene().lights == before.lights);
        CHECK(animate.playing == in_panel);
        animate.playing = false;
        bench.scene().camera = before.camera;
        bench.frames(3);
        bench.drag(bulb, {bulb.x + 80, bulb.y + 30});
        CHECK_FALSE(bench.scene().lights == before.lights);
    }
}

TEST_CASE("a highlight can be grabbed only where it is visible, not where a view hides it", "[ui][window]") {
    DrawnWindow bench;
    const PictureSize size = bench.state.rendered->size;
    const auto is_highlight = [&](glm::ivec2 pixel) {
        bench.move(bench.at_pixel(pixel));
        return bench.state.viewport.hovered_grip.kind == GripKind::Highlight;
    };
    std::vector<glm::ivec2> seen_at;
    for (int y = size.height / 4; y < 3 * size.height / 4; y += 5)
        for (int x = size.width / 4; x < size.width / 2 - 10; x += 5)
            if (is_highlight({x, y})) seen_at.emplace_back(x, y);
    const std::ptrdiff_t seen = std::ssize(seen_at);
    CHECK(seen > 3);
    const auto found = [&] { return std::count_if(seen_at.begin(), seen_at.end(), is_highlight); };
    bench.state.get<InspectorState>().tab = InspectorTab::Grid;
    bench.state.get<TermGridState>().solo = GridCell{0, 1};
    bench.frames(3);
    CHECK(found() == 0);
    bench.state.get<TermGridState>().solo.reset();
    bench.frames(3);
    CHECK(found() == seen);
    bench.compare({variant_of(Reflection::Lambert), {}});
    CHECK(found() == 0);
    set_parts(bench.state.get<CompareState>().choice, {variant_of(ShadingMode::Gouraud), {}});
    bench.frames(2);
    CHECK(found() == seen);
    bench.key(Key::C);
    bench.state.get<DebugViewState>().set.choice.view = DebugView::Normal;
    bench.frames(2);
    CHECK(found() == 0);
}

TEST_CASE("while B is shown, n·l is that of a light in B, and the cells are B's", "[ui][window][compare]") {
    StoredWindow bench;
    bench.key(Key::B);
    DebugViewChoice& choice = bench.state.get<DebugViewState>().set.choice;
    choice = {.view = DebugView::NDotL, .light = 1};  // the edited scene has one light
    bench.state.get<InspectorState>().tab = InspectorTab::Grid;
    bench.frames(3);
    CHECK(choice.light == 1);
    CHECK(bench.state.get<TermGridState>().drawn_of == bench.b);
    bench.state.get<TermGridState>().solo = GridCell{1, 1};
    bench.frames(3);
    const auto cell_of = [](const Scene& scene) { return with_cells(scene, {{1, 1}}); };
    CHECK(bench.state.rendered_scene == cell_of(bench.b));
    bench.key(Key::B);
    bench.frames(3);
    CHECK(choice.light == 1);
    CHECK(bench.state.get<TermGridState>().drawn_of == bench.edited);
    CHECK(bench.state.rendered_scene == bench.edited);  // the edited scene has no such cell
}
