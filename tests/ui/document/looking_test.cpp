// View changes and picking never count as unsaved changes, and views have their own history.
#include <filesystem>

#include "models/io/file.h"
#include "tests/support/headless_window.h"
#include "ui/document/document_actions.h"

using namespace glint;
using namespace glint::test;

namespace {

/// Orbits by dragging over the background.
void orbit_by_hand(HeadlessWindow& bench, float pixels) {
    const ImVec2 corner = bench.at_pixel({40, 40});
    bench.drag(corner, {corner.x + pixels, corner.y});
    bench.frames(2);
}

void brighten(HeadlessWindow& bench, float intensity) {
    bench.scene().lights[0].intensity = intensity;
    bench.frames(2);
}

void key_alt(HeadlessWindow& bench, Key key) {
    UiInput input;
    input.presses.push_back({key, false, false, true});
    (void)bench.frame(input);
    bench.frames(2);
}

}  // namespace

TEST_CASE("orbiting and picking cause no unsaved changes and no undo steps", "[ui]") {
    DrawnWindow bench;
    const Camera before = bench.scene().camera;
    orbit_by_hand(bench, 90);
    CHECK(bench.scene().camera != before);
    bench.click(bench.at_pixel({200, 200}));
    bench.frames(2);
    CHECK_FALSE(bench.state.editor.unsaved());
    CHECK_FALSE(bench.state.editor.history.can_undo());
    bench.key(Key::Q, true);
    CHECK_FALSE(bench.state.pending.asking);
}

TEST_CASE("undo between two edits to a light reverts the light and keeps the view", "[ui]") {
    DrawnWindow bench;
    brighten(bench, 2);
    orbit_by_hand(bench, 60);
    brighten(bench, 3);
    orbit_by_hand(bench, 60);
    const Camera seen_from = bench.scene().camera;
    bench.key(Key::Z, true);
    bench.frames(2);
    CHECK(bench.scene().lights[0].intensity == 2);
    CHECK(bench.scene().camera == seen_from);
    bench.key(Key::Z, true);
    bench.frames(2);
    CHECK(bench.scene().lights[0].intensity == 1);
    CHECK(bench.scene().camera == seen_from);
    CHECK_FALSE(bench.state.editor.unsaved());
}

TEST_CASE("views have their own back and forward commands, independent of undo", "[ui]") {
    DrawnWindow bench;
    const Camera first = bench.scene().camera;
    orbit_by_hand(bench, 60);
    const Camera second = bench.scene().camera;
    orbit_by_hand(bench, 60);
    const Camera third = bench.scene().camera;
    key_alt(bench, Key::Left);
    CHECK(bench.scene().camera == second);
    key_alt(bench, Key::Left);
    CHECK(bench.scene().camera == first);
    CHECK_FALSE(why_disabled(bench.state, command_named("Previous view")).empty());
    key_alt(bench, Key::Right);
    CHECK(bench.scene().camera == second);
    orbit_by_hand(bench, -30);
    CHECK_FALSE(why_disabled(bench.state, command_named("Next view")).empty());
    key_alt(bench, Key::Left);
    CHECK(bench.scene().camera == second);
    CHECK(third != second);
}

TEST_CASE("ten wheel steps make one entry in the view history", "[ui]") {
    DrawnWindow bench;
    const Camera before = bench.scene().camera;
    bench.move(bench.at_pixel({300, 200}));
    for (int i = 0; i < 10; ++i) {
        ImGui::GetIO().MouseWheel = 1;
        bench.frames(2);
    }
    CHECK(bench.scene().camera != before);
    key_alt(bench, Key::Left);
    CHECK(bench.scene().camera == before);
}

TEST_CASE("typing a number in the camera's panel is an edit that can be saved and undone", "[ui]") {
    HeadlessWindow bench;
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.frames(2);
    const Camera before = bench.scene().camera;
    bench.state.editor.edits_camera = true;  // as in columns.cpp
    bench.scene().camera.eye.z += 1;
    bench.frames(2);
    CHECK(bench.state.editor.unsaved());
    orbit_by_hand(bench, 60);
    CHECK(bench.state.editor.unsaved());
    bench.key(Key::Z, true);
    bench.frames(2);
    CHECK(bench.scene().camera == before);
    CHECK_FALSE(bench.state.editor.unsaved());
}

TEST_CASE("dragging a number in the camera's panel is an edit", "[ui]") {
    HeadlessWindow bench;
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    bench.frames(3);
    const ImVec2 field = bench.control("/camera/projection/fov_y_deg");
    bench.drag(field, {field.x + 30, field.y});
    bench.frames(2);
    CHECK(bench.state.editor.unsaved());
    CHECK(bench.state.editor.history.undo_name() == "Camera");
}

TEST_CASE("saving an example requires a new name and never overwrites it", "[ui]") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "glint-shipped-test";
    std::filesystem::create_directories(folder);
    const std::string path = (folder / "example.json").string();
    DrawnWindow bench;
    REQUIRE_FALSE(save_file(bench.state.editor, path, bench.scene()));
    const std::string text = std::get<std::string>(read_file(path, 1 << 20));
    bench.state.shipped_scenes = folder.string();
    brighten(bench, 2);
    bench.key(Key::S, true);
    bench.frames(2);
    CHECK(bench.state.files.open);
    CHECK(bench.state.files.purpose == &save_purpose);
    CHECK(std::get<std::string>(read_file(path, 1 << 20)) == text);
    CHECK(bench.state.files.folder != folder.string());
    bench.key(Key::Escape);
    bench.state.shipped_scenes.clear();
    bench.frames(2);
    bench.key(Key::S, true);
    CHECK(std::get<std::string>(read_file(path, 1 << 20)) != text);
    std::filesystem::remove_all(folder);
}
