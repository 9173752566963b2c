// The complete window without a display: mouse and key input changes the scene.
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/picture/draw_picture.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// A ball with a bulb in front of it, in the middle of the picture's upper half.
HeadlessWindow& with_bulb(HeadlessWindow& bench) {
    bench.scene().lights.resize(1);
    bench.scene().lights[0].name = "Bulb";
    bench.scene().lights[0].kind = LightKind::Point;
    bench.scene().lights[0].position = {0.3f, 1.3f, 0.9f, 1};
    take_document(bench.state.editor, bench.state.editor.document);
    bench.frames(2);
    return bench;
}

/// Presses the button on the bulb's handle and returns the handle's pixel.
glm::dvec2 with_grabbed_bulb(HeadlessWindow& bench) {
    with_bulb(bench);
    const glm::dvec2 handle = bench.handle_pixel(0);
    bench.move(bench.at_pixel(handle));
    bench.button(true);
    return handle;
}

}  // namespace

TEST_CASE("the first frame shows the scene at the picture's actual size", "[ui][window]") {
    HeadlessWindow bench;
    const UiRequests wants = bench.frame();
    REQUIRE(bench.state.rendered != nullptr);
    const Layout layout = lay_out({1280, 800}, bench.state.layout, 1);
    const ImVec2 area = picture_area(layout.centre, 1).size();
    CHECK(bench.state.rendered->size == PictureSize{int(area.x), int(area.y), true});
    CHECK(area.x == layout.centre.size().x - 20);
    CHECK(wants.title == "New scene – Glint");
    CHECK_FALSE(wants.quit);
}

TEST_CASE("nothing is redrawn while nothing changes", "[ui][window]") {
    HeadlessWindow bench;
    bench.frames(3);
    const auto serial = bench.state.picture_serial;
    bench.move({600, 400});
    bench.frames(5);
    CHECK(bench.state.picture_serial == serial);
    bench.scene().lights[0].intensity = 2;
    bench.frames(3);
    CHECK(bench.state.picture_serial == serial + 1);
}

TEST_CASE("the shown scene is the frozen, else the animated, previewed or stored one", "[ui][window]") {
    DrawnWindow bench;
    const auto with_ambient = [&](float ambient) {
        Scene scene = bench.scene();
        scene.global_ambient.x = ambient;
        return scene;
    };
    const auto ambient_shown = [&] {
        OnScreen shown;
        decide_shown(shown, bench.state);
        return shown.drawn() != nullptr ? shown.drawn()->scene.global_ambient.x : -1;
    };
    CHECK(ambient_shown() == -1);
    CompareChoice& compare = bench.state.get<CompareState>().choice;
    compare.stored = std::make_shared<const Scene>(with_ambient(4));
    CHECK(ambient_shown() == -1);  // stored, but not shown
    compare.shows_stored = true;
    CHECK(ambient_shown() == 4);
    bench.state.get<InspectorState>().instead = with_ambient(3);
    CHECK(ambient_shown() == 3);
    bench.state.get<AnimateState>().frame = with_ambient(2);
    CHECK(ambient_shown() == 2);
    bench.state.get<LectureState>().frozen = with_ambient(1);
    CHECK(ambient_shown() == 1);
}

TEST_CASE("nothing is redrawn while B is on the screen", "[ui][window]") {
    DrawnWindow bench;
    bench.key(Key::B, true);
    bench.scene().lights[0].intensity = 0.25f;
    bench.key(Key::B);
    bench.frames(3);
    bench.state.notifications.list.clear();
    bench.frames(2);
    CHECK(bench.state.rendered_scene.lights[0].intensity != 0.25f);
    CHECK(bench.frame().sleep_s > 0);
}

TEST_CASE("each press of Escape ends one thing, the innermost first", "[ui][window]") {
    HeadlessWindow bench;
    bench.click(bench.at_pixel({400, 300}));
    bench.frames(2);
    UiState& state = bench.state;
    const Scene before = bench.scene();
    bench.key(Key::P);
    state.layout.hides_all = state.get<PenState>().on = state.get<WedgeState>().open = state.shows_shortcuts =
        true;
    bench.frames(1);
    state.asks_overwrite = true;
    const auto open_now = [&] {
        return std::vector<bool>{state.asks_overwrite,
                                 state.shows_shortcuts,
                                 state.get<WedgeState>().open,
                                 state.get<PenState>().on,
                                 state.layout.hides_all,
                                 state.get<ScopeState>().armed,
                                 state.viewport.probe.has_value()};
    };
    std::vector<bool> left(7, true);
    REQUIRE(open_now() == left);
    for (std::size_t i = 0; i < left.size(); ++i) {
        bench.key(Key::Escape);
        bench.frames(2);
        left[i] = false;
        CHECK(open_now() == left);
    }
    CHECK(bench.scene() == before);
}

TEST_CASE("dragging a light's handle keeps it under the cursor and is one undo step", "[ui][window]") {
    HeadlessWindow bench;
    with_bulb(bench);
    const Scene before = bench.scene();
    const glm::dvec2 handle = bench.handle_pixel(0), to = handle + glm::dvec2(70, 90);
    bench.drag(bench.at_pixel(handle), bench.at_pixel(to));
    CHECK(glm::length(bench.handle_pixel(0) - to) < 0.5);
    CHECK(bench.state.editor.history.undo_name() == "Move Bulb");
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 0});
    CHECK(bench.state.editor.unsaved());
    bench.key(Key::Z, true);
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.editor.history.can_undo());
    CHECK_FALSE(bench.state.editor.unsaved());
    bench.key(Key::Y, true);
    CHECK(glm::length(bench.handle_pixel(0) - to) < 0.5);
}

TEST_CASE("every frame of a drag shows the latest cursor position", "[ui][window]") {
    HeadlessWindow bench;
    const glm::dvec2 handle = with_grabbed_bulb(bench);
    for (int i = 1; i < 12; ++i) {
        const glm::dvec2 hand = handle + glm::dvec2(9 * i, 5 * i);
        bench.move(bench.at_pixel(hand));
        CHECK(glm::length(bench.handle_pixel(0) - hand) < 0.5);
        CHECK(bench.state.rendered_scene == bench.scene());
        CHECK(bench.state.renderer->stats().redone == std::array{false, false, false, false, true});
    }
    bench.button(false);
}

TEST_CASE("axis keys and Shift change the direction in which a drag moves a light", "[ui][window]") {
    HeadlessWindow bench;
    const glm::dvec2 handle = with_grabbed_bulb(bench);
    const glm::vec4 start = bench.scene().lights[0].position;
    UiInput holding_x;
    holding_x.axis_held[0] = true;
    for (int i = 1; i < 5; ++i) {
        ImGui::GetIO().MousePos = bench.at_pixel(handle + glm::dvec2(12 * i, 9 * i));
        (void)bench.frame(holding_x);
    }
    const glm::vec4 along_x = bench.scene().lights[0].position;
    CHECK(along_x.x > start.x + 0.05f);
    CHECK(along_x.y == Approx(start.y));
    CHECK(along_x.z == Approx(start.z));
    bench.button(false);
    ImGui::GetIO().KeyShift = true;
    const glm::dvec2 now = bench.handle_pixel(0);
    bench.drag(bench.at_pixel(now), bench.at_pixel(now + glm::dvec2(0, -40)));
    ImGui::GetIO().KeyShift = false;
    CHECK(glm::length(bench.handle_pixel(0) - now) < 0.5);
    CHECK(bench.scene().lights[0].position.z < along_x.z - 0.1f);
}

TEST_CASE("a click explains a pixel, and drags update the numbers", "[ui][window]") {
    HeadlessWindow bench;
    with_bulb(bench);
    const PictureSize size = bench.state.rendered->size;
    const glm::dvec2 pixel = glm::dvec2(glm::ivec2(size.width / 2, size.height * 2 / 5)) + 0.5;
    bench.click(bench.at_pixel(pixel));
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.explanation->x == int(pixel.x));
    CHECK(bench.state.on_screen.explanation->y == int(pixel.y));
    CHECK(bench.state.on_screen.explanation->hit);
    CHECK_FALSE(bench.state.editor.unsaved());
    const glm::vec3 sum = bench.state.on_screen.explanation->sum;
    bench.scene().lights[0].intensity = 0.5f;
    (void)bench.frame();
    CHECK(bench.state.on_screen.explanation->sum.x < sum.x);
    const std::size_t at = 4 * bench.state.rendered->pixel(bench.state.on_screen.explanation->x,
                                                           bench.state.on_screen.explanation->y);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(bench.state.on_screen.explanation->byte[i] == bench.state.rendered->rgba[at + i]);
}

TEST_CASE("after any wheel motion the view can be saved and the scene framed again", "[ui][window]") {
    DrawnWindow bench({1400, 900});
    const auto turn = [&](ImVec2 at, float way, int times) {
        bench.move(at);
        for (int i = 0; i < times; ++i) {
            ImGui::GetIO().MouseWheel = way;
            (void)bench.frame();
        }
    };
    const Camera start = bench.scene().camera;
    const auto view_direction = [&] {
        const Camera& camera = bench.scene().camera;
        return glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    };
    const glm::dvec3 ahead = view_direction();
    for (const ImVec2 at : {ImVec2(600, 300), ImVec2(420, 700)}) {
        turn({600, 400}, -1, 120);
        turn(at, 1, 500);
        const auto read = parse_scene(scene_text(bench.scene()), "wheel.json");
        if (const Problem* problem = problem_of(read)) FAIL(problem->text());
        CHECK(bench.state.notifications.list.empty());
        // Moving closer does not turn the view, except for float rounding far away.
        CHECK(glm::length(view_direction() - ahead) < 0.01);
        (void)bench.key(Key::F, false, true);
        bench.frames(2);
        REQUIRE(bench.state.rendered != nullptr);
        const auto& explained = bench.state.rendered->rgba;
        CHECK(std::any_of(explained.begin(), explained.end(),
                          [](std::uint8_t byte) { return byte > 100 && byte < 255; }));
        CHECK(glm::length(bench.scene().camera.eye) < 100);
    }
    CHECK(bench.scene().camera.up == start.up);
}

TEST_CASE("an edit that no scene file accepts is reverted and reported", "[ui][window]") {
    HeadlessWindow bench;
    SceneDocument document = first_scene();
    document.scene.lights[1].position = {1e7f, 1e7f, 1e7f, 1};
    take_document(bench.state.editor, document);
    bench.frames(2);
    const auto is_told = [&](const std::string& what) {
        const auto& list = bench.state.notifications.list;
        return std::any_of(list.begin(), list.end(),
                           [&](const Notification& n) { return n.text.find(what) != std::string::npos; });
    };
    const Scene before = bench.scene();
    bench.state.editor.selection = {Selection::Kind::Light, 1};
    bench.scene().lights[1].position.x = std::numeric_limits<float>::infinity();
    bench.frames(2);
    CHECK(bench.scene() == before);
    CHECK(is_told(
        "Not possible: /lights/1/position/0: inf is out of range; expected a number between -1e7 and 1e7"));
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 1});
    CHECK_FALSE(bench.state.editor.history.can_undo());
    // A copy would be placed outside the range.
    (void)bench.key(Key::D, true);
    bench.frames(2);
    for (const Light& light : bench.scene().lights) CHECK(std::isfinite(light.position.x));
    const auto read = parse_scene(scene_text(bench.scene()), "copy.json");
    CHECK(problem_of(read) == nullptr);
    // A rule that involves several numbers.
    const Scene now = bench.scene();
    bench.scene().camera.target = bench.scene().camera.eye;
    bench.frames(2);
    CHECK(bench.scene() == now);
    CHECK(is_told("/camera: eye and target are the same point"));
    // An unrelated edit is not affected.
    bench.scene().lights[0].intensity = 2;
    bench.frames(2);
    CHECK(bench.scene().lights[0].intensity == 2);
}

TEST_CASE("closing the window prompts only if there are unsaved changes", "[ui][window]") {
    DrawnWindow bench;
    bench.scene().lights[0].intensity = 3;
    UiInput close;
    close.close_asked = true;
    const UiRequests asked = bench.frame(close);
    CHECK_FALSE(asked.quit);
    CHECK(asked.title == "● New scene – Glint");
    CHECK(bench.state.pending.asking);
    bench.frames(2);
    bench.key(Key::Escape);
    CHECK_FALSE(bench.state.pending.asking);
    bench.frames(2);
    bench.key(Key::Z, true);
    CHECK(bench.frame(close).quit);
}

TEST_CASE("closing during a drag prompts when the drag ends, the drag is one undo step", "[ui][window]") {
    const bool drops = GENERATE(false, true);
    HeadlessWindow bench;
    const glm::dvec2 handle = with_grabbed_bulb(bench);
    const Scene before = bench.scene();
    bench.move(bench.at_pixel(handle + glm::dvec2(30, 40)));
    UiInput request;
    request.close_asked = !drops;
    if (drops) request.dropped = {"/nowhere/at/all.json"};
    CHECK_FALSE(bench.frame(request).quit);
    bench.frames(2);
    CHECK_FALSE(bench.state.pending.asking);
    const bool escapes = GENERATE(false, true);
    if (escapes) bench.key(Key::Escape);
    bench.move(bench.at_pixel(handle + glm::dvec2(70, 90)));
    bench.button(false);
    UiRequests last = bench.frame();
    if (escapes) {  // nothing left to save
        CHECK(bench.scene() == before);
        CHECK_FALSE(bench.state.editor.history.can_undo());
        CHECK_FALSE(bench.state.pending.asking);
        return;
    }
    CHECK_FALSE(last.quit);
    CHECK(bench.state.pending.asking);
    bench.key(Key::Escape);
    bench.frames(2);
    bench.key(Key::Z, true);
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.editor.history.can_undo());
}

TEST_CASE("an unreadable file gives the command line's error, and the scene stays", "[ui][window]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    bench.open("/nowhere/at/all.json");
    REQUIRE(bench.state.notifications.list.size() == 1);
    const auto opened = open_document("/nowhere/at/all.json");
    REQUIRE(problem_of(opened) != nullptr);
    CHECK(bench.state.notifications.list[0].text == problem_of(opened)->text());
    CHECK(bench.scene() == before);
}

TEST_CASE("a probe survives a change of the picture's size", "[ui][window]") {
    HeadlessWindow bench;
    with_bulb(bench);
    const PictureSize before = bench.state.rendered->size;
    bench.click(bench.at_pixel({100, 300}));
    bench.key(Key::F11);
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    const PictureSize after = bench.state.rendered->size;
    // Both pictures keep the width of the view: the window's 1280 x 800 is narrower than 16:9 too.
    CHECK(double(bench.state.on_screen.explanation->x) / after.width ==
          Approx(100.0 / before.width).margin(0.01));
    CHECK((bench.state.on_screen.explanation->y - after.height / 2.0) / after.width ==
          Approx((300 - before.height / 2.0) / before.width).margin(0.01));
}

TEST_CASE("scenes and pictures saved by the window open in it again", "[ui][window]") {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "glint_window_save_test";
    fs::remove_all(folder);
    fs::create_directories(folder);
    HeadlessWindow bench;
    with_bulb(bench);
    bench.drag(bench.at_pixel(bench.handle_pixel(0)), bench.at_pixel({500, 100}));
    const Scene made = bench.scene();
    bench.key(Key::S, true);  // the scene has no name yet
    REQUIRE(bench.state.files.open);
    bench.state.files.folder = folder.string();
    bench.state.files.name = "made";
    bench.frames(2);
    bench.key(Key::Enter);
    CHECK_FALSE(bench.state.editor.unsaved());
    CHECK(bench.state.editor.title() == "made.json");
    bench.frames(2);
    bench.key(Key::F12);
    REQUIRE(bench.state.files.open);
    bench.state.files.name = "made.png";
    bench.frames(2);
    bench.key(Key::Enter);
    while (bench.state.get<ExportState>().job) bench.frame();
    bench.frames(2);
    for (const char* name : {"made.json", "made.png"}) {
        bench.key(Key::N, true);
        CHECK_FALSE(same_description(bench.scene(), made));
        bench.open((folder / name).string());
        CHECK(same_description(bench.scene(), made));
        CHECK_FALSE(bench.state.editor.unsaved());
        CHECK_FALSE(bench.state.editor.history.can_undo());
    }
    fs::remove_all(folder);
}

TEST_CASE("a frame without a request lets the window sleep", "[ui][window]") {
    HeadlessWindow bench;
    bench.frames(3);
    CHECK(std::isinf(bench.frame().sleep_s));
    bench.move(bench.control("Undo"));  // its tooltip is due
    CHECK(bench.frame().sleep_s < 1);
    for (int i = 0; i < 60; ++i) (void)bench.frame();
    CHECK(std::isinf(bench.frame().sleep_s));
}

TEST_CASE("a selection in a scene with more items does not affect keys in this one", "[ui][window]") {
    // As after a click on one of B's lights, if B has more lights than the current scene.
    HeadlessWindow bench({1280, 800});
    const std::size_t lights = bench.scene().lights.size(), objects = bench.scene().objects.size();
    const std::string last_light = bench.scene().lights.back().name;
    bench.state.editor.selection = {Selection::Kind::Light, static_cast<int>(lights) + 5};
    (void)bench.key(Key::D, true);
    REQUIRE(bench.scene().lights.size() == lights + 1);
    CHECK(bench.scene().lights.back().name.starts_with(last_light));
    bench.state.editor.selection = {Selection::Kind::Object, static_cast<int>(objects) + 5};
    (void)bench.key(Key::Delete);
    CHECK(bench.scene().objects.size() == objects - 1);
}
