// Selecting an item shows its panel; renaming in the tree; the undo list; the drawn field of view.
#include <chrono>
#include <filesystem>
#include <thread>

#include "renderer/image/image_file.h"
#include "tests/places.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"

using namespace glint;
using namespace glint::test;

namespace {

bool shows_field(const HeadlessWindow& bench, std::string_view name) {
    return std::any_of(bench.controls().begin(), bench.controls().end(), [&](const NamedControl& control) {
        return control.in_sight && (control.name == name || control.key == name);
    });
}

}  // namespace

TEST_CASE("selecting a light shows its panel in a narrow window too", "[ui][window][shell]") {
    HeadlessWindow bench({1024, 768});
    bench.frames(3);
    bench.click(bench.at_pixel({300, 330}));  // opens the WHY column
    bench.frames(2);
    REQUIRE(bench.state.left_shows_inspector);
    bench.click(bench.at_pixel(bench.handle_pixel(1)));
    bench.frames(2);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 1});
    CHECK(shows_field(bench, "/lights/1/intensity"));
    bench.click(bench.at_pixel({300, 330}));
    bench.frames(2);
    REQUIRE(bench.state.left_shows_inspector);
    bench.click(bench.at_pixel(bench.handle_pixel(1)));  // the light is already selected
    bench.frames(2);
    CHECK(shows_field(bench, "/lights/1/intensity"));
}

TEST_CASE("a double-click in the list edits the item's name in place", "[ui][window][shell]") {
    HeadlessWindow bench;
    bench.frames(3);
    for (const char* const pointer : {"/lights/1/enabled", "/objects/0/visible"}) {
        CAPTURE(pointer);
        const ImVec2 row = bench.control(pointer) - ImVec2(120, 0);
        bench.click(row);
        bench.click(row);
        bench.frames(4);
        REQUIRE(ImGui::GetIO().WantTextInput);
        const Rect field = bench.area_of("Name in the list");
        CHECK(std::abs(HeadlessWindow::middle_of(field).y - row.y) < 3);
        bench.type("Sunny");
        bench.click(bench.at_pixel({30, 30}));  // leaves the field
        bench.frames(3);
        CHECK_FALSE(ImGui::GetIO().WantTextInput);
    }
    CHECK(bench.scene().lights[1].name == "Sunny");
    CHECK(bench.scene().objects[0].name == "Sunny");
}

TEST_CASE("a click in the undo list goes back or forward to that step", "[ui][window][shell]") {
    HeadlessWindow bench;
    bench.frames(3);
    const float first = bench.scene().lights[0].intensity;
    for (const float value : {2.0f, 3.0f, 4.0f}) {
        bench.scene().lights[0].intensity = value;
        bench.frames(1);
        bench.scene().display.exposure = value;
        bench.frames(1);
    }
    const auto go_to = [&](const char* step) {
        bench.click_on("Edit");
        bench.move(bench.control("Undo list"));
        bench.frames(20);
        bench.click(bench.control(step));
        bench.frames(3);
    };
    go_to("Step 0: As opened");
    CHECK(bench.scene().lights[0].intensity == first);
    go_to("Step 5: Brightness of Sun");
    CHECK(bench.scene().lights[0].intensity == 4);
    CHECK(bench.scene().display.exposure == 3);
}

TEST_CASE("a narrow picture shows and edits the field of view that is drawn", "[ui][window][camera]") {
    Camera camera;
    camera.projection = Perspective{.fov_y_deg = 28};
    HeadlessWindow bench({1024, 768});
    bench.scene().camera.projection = camera.projection;
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.frames(4);
    const PictureSize size = bench.state.full_size;
    REQUIRE(is_widened(size));
    bench.click_on("/camera/projection/fov_y_deg");
    bench.type("50");
    (void)bench.key(Key::Enter);
    bench.frames(3);
    const Projection drawn = fitted(bench.scene().camera.projection, size);
    CHECK(std::get<Perspective>(drawn).fov_y_deg == Approx(50).margin(0.01));
}

TEST_CASE("pictures of examples are saved in the user's pictures folder by default", "[ui][window][export]") {
    HeadlessWindow bench;
    bench.state.shipped_scenes = project_file("assets/scenes");
    bench.frames(2);
    bench.state.editor.document.path = project_file("assets/scenes/still-life.json");
    CHECK(std::filesystem::path(offered_name(bench.state, ".png")).parent_path() == pictures_folder());
    CHECK(std::filesystem::path(offered_name(bench.state, ".png")).filename() == "still-life.png");
    bench.state.editor.document.path = "/somewhere/mine.json";
    CHECK(offered_name(bench.state, ".png") == "/somewhere/mine.png");
}

TEST_CASE("an opened picture from another program can be compared to the scene", "[ui][window][diagnosis]") {
    DrawnWindow bench;
    const TemporaryDirectory folder;
    ask_to_open(bench.state, folder.file("mine.png", png_bytes(*bench.state.rendered, "")));
    bench.wait_for_loads();
    bench.frames(2);
    bench.click(bench.control("Compare with the open scene"));
    for (int i = 0; i < 200 && !bench.state.get<MyPictureState>().shown; ++i) {
        bench.frames(1);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    CHECK(bench.state.get<MyPictureState>().shown);
    CHECK(bench.state.notifications.list.empty());
}
