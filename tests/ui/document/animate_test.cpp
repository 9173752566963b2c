// Animated scenes, and writing their frames to files.
#include <fmt/format.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <random>

#include "models/fields/scene_fields.h"
#include "renderer/image/image_file.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/document/scene_edit.h"
#include "ui/features/export/animation.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/widgets/numbers/number_input.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

SceneDocument busy_document() {
    SceneDocument document;
    document.scene = test::busy_scene();
    document.scene.objects[0].source = PrimitiveMesh{Primitive::Sphere, 12};
    document.scene.objects[1].source = PrimitiveMesh{Primitive::Cube, 2};
    return document;
}

Scene at(const SceneDocument& document, const Animation& animation, int frame) {
    auto scene = scene_at(document, animation, frame);
    REQUIRE(problem_of(scene) == nullptr);
    return std::get<Scene>(std::move(scene));
}

/// Writes the frames of the window's animation, and waits until this has ended.
void write_frames(HeadlessWindow& bench, const std::string& path) {
    begin_frames(bench.state, path, {40, 30}, 1);
    while (bench.state.get<AnimateState>().job) (void)bench.frame();
}

}  // namespace

TEST_CASE("an animated count takes the nearest allowed value", "[animate]") {
    SceneDocument document = busy_document();
    Animation animation{Motion::PingPong, "/lights/3/area/samples", 1, 64, 40};
    for (int frame = 0; frame < 40; ++frame) {
        const double value = value_at(animation, frame);
        int nearest = 1;
        for (int side = 2; side <= 8; ++side)
            if (std::abs(side * side - value) <= std::abs(nearest - value)) nearest = side * side;
        INFO(frame << ": " << value);
        CHECK(at(document, animation, frame).lights[3].area.samples == nearest);
    }
    animation = {Motion::PingPong, "/objects/0/mesh/detail", 4, 8, 8};  // takes every integer in the range
    for (int frame = 0; frame < 8; ++frame)
        CHECK(std::get<PrimitiveMesh>(at(document, animation, frame).objects[0].source).detail ==
              (frame <= 4 ? 4 + frame : 12 - frame));
}

TEST_CASE("a turntable starts at the scene's view and keeps the eye's distance and height", "[ui][animate]") {
    const SceneDocument document = busy_document();
    const Animation animation{Motion::Turntable, "", 0, 1, 36};
    CHECK(at(document, animation, 0) == document.scene);
    CHECK(at(document, animation, 36) == document.scene);
    const Camera& start = document.scene.camera;
    for (int frame = 1; frame < 36; ++frame) {
        const Camera camera = at(document, animation, frame).camera;
        CHECK(glm::distance(camera.eye, camera.target) == Approx(glm::distance(start.eye, start.target)));
        CHECK(camera.eye.y == Approx(start.eye.y));
    }
    // A quarter turn counter-clockwise, seen from above, takes (x, z) to (z, -x).
    const glm::vec3 quarter = at(document, animation, 9).camera.eye;
    CHECK(quarter.x == Approx(start.eye.z));
    CHECK(quarter.z == Approx(-start.eye.x));
}

TEST_CASE("a light in either space circles the target in world coordinates", "[ui][animate]") {
    SceneDocument document = busy_document();
    Scene& scene = document.scene;
    scene.camera.eye = {1, 2, 9}, scene.camera.target = {1, 2, 3};
    Light spot;
    spot.kind = LightKind::Spot;
    spot.position = {3, 7, 3, 1};  // 2 to the right of the axis, 5 above the target
    spot.spot.direction = {-1, 0, 0};
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {2, 5, 0, 0};
    scene.lights = {spot, in_space(spot, LightSpace::Camera, scene.camera), sun};
    for (const int light : {0, 1}) {
        Animation animation{Motion::Circle, "", 0, 1, 4, light};
        CHECK(at(document, animation, 0) == scene);
        // A quarter turn counter-clockwise, seen from above, takes +x to -z.
        const Light quarter =
            in_space(at(document, animation, 1).lights[std::size_t(light)], LightSpace::World, scene.camera);
        CHECK(glm::distance(glm::vec3(quarter.position), glm::vec3(1, 7, 1)) < 1e-5f);
        CHECK(glm::distance(quarter.spot.direction, glm::vec3(0, 0, 1)) < 1e-5f);
        animation.axis = CircleAxis::View;    // +z: +x to +y, +y to -x
        animation.radius = std::sqrt(116.0);  // twice as far away
        const Light seen =
            in_space(at(document, animation, 1).lights[std::size_t(light)], LightSpace::World, scene.camera);
        CHECK(glm::distance(glm::vec3(seen.position), glm::vec3(1 - 10, 2 + 4, 3)) < 1e-5f);
    }
    const Scene turned = at(document, {Motion::Circle, "", 0, 1, 2, 2}, 1);
    CHECK(glm::distance(turned.lights[2].position, glm::vec4(-2, 5, 0, 0)) < 1e-5f);
}

TEST_CASE("the selected light is the one that circles", "[ui][window][animate]") {
    HeadlessWindow bench;
    for (const int light : {1, 0}) {
        bench.state.editor.selection = {Selection::Kind::Light, light};
        begin_animation(bench.state, Motion::Circle);
        CHECK(bench.state.get<AnimateState>().animation.light == light);
    }
}

TEST_CASE("an animation without a light does not play", "[ui][window][animate]") {
    HeadlessWindow bench;
    bench.scene().lights.clear();
    begin_animation(bench.state, Motion::Circle);
    switch_playing(bench.state);
    bench.frames(2);
    CHECK_FALSE(bench.state.get<AnimateState>().playing);
    CHECK(bench.state.get<AnimateState>().refused == "The scene has no lights");
}

TEST_CASE("ffmpeg encodes all frames as a video, or its absence is reported", "[ui][window][animate]") {
    const TemporaryDirectory folder;
    const char* const path = std::getenv("PATH");
    const std::string path_before = path != nullptr ? path : "";
    setenv("PATH", folder.path("").c_str(), 1);
    DrawnWindow bench;
    AnimateState& animate = bench.state.get<AnimateState>();
    animate.animation.frames = 3;
    begin_frames(bench.state, folder.path("turn.mp4"), {40, 30}, 1);
    CHECK_FALSE(animate.job);
    CHECK(bench.notes_with("MP4 needs the program ffmpeg") == 1);
    begin_animation(bench.state, Motion::Turntable);
    animate.file = AnimationFile::Mp4;
    bench.frames(3);
    bench.click_on("Export animation");
    CHECK_FALSE(bench.state.files.open);
    // A fake ffmpeg, which writes its input to the file named by its last argument.
    const auto install = [&](const char* script) {
        std::filesystem::permissions(folder.file("ffmpeg", script), std::filesystem::perms::owner_all);
    };
    install("#!/bin/sh\nfor last; do :; done\n/bin/cat >\"$last\"\n");
    write_frames(bench, folder.path("turn.mp4"));
    CHECK(bench.notes_with("Wrote turn.mp4 with 3 frames") == 1);
    const std::string read = bytes_of(folder.path("turn.mp4"));
    std::size_t pictures = 0;
    for (std::size_t i = read.find("\x89PNG"); i != std::string::npos; i = read.find("\x89PNG", i + 1))
        ++pictures;
    CHECK(pictures == 3);
    install("#!/bin/sh\nexit 1\n");
    write_frames(bench, folder.path("other.mp4"));
    CHECK(bench.notes_with("ffmpeg could not write the video") == 1);
    CHECK(folder.names() == std::vector<std::string>{"ffmpeg", "turn.mp4"});
    setenv("PATH", path_before.c_str(), 1);
}

TEST_CASE("an exported animation has the size of the view", "[ui][window][animate]") {
    const TemporaryDirectory folder;
    DrawnWindow bench;
    AnimateState& animate = bench.state.get<AnimateState>();
    begin_animation(bench.state, Motion::Turntable);
    animate.animation.frames = 1;
    bench.state.get<ExportState>().options.samples = 1;
    frames_purpose.use(bench.state, folder.path("turn.png"));
    REQUIRE(animate.job);
    animate.job->wait();
    const Result<Picture> written = read_png(folder.path("turn-0001.png"));
    REQUIRE(problem_of(written) == nullptr);
    const PictureSize size = std::get<Picture>(written).size, view = bench.state.full_size;
    CHECK(size == PictureSize{view.width, view.height});
}

TEST_CASE("a number moves linearly to the other end of its range and back", "[ui][animate]") {
    const SceneDocument document = busy_document();
    const Animation animation{Motion::PingPong, "/objects/0/material/shininess", 10, 50, 8};
    const float expected[] = {10, 20, 30, 40, 50, 40, 30, 20, 10};
    for (int frame = 0; frame < 9; ++frame)
        CHECK(at(document, animation, frame).objects[0].material.shininess == expected[frame]);
    CHECK(at(document, animation, -1).objects[0].material.shininess == 20);
    const Animation detail{Motion::PingPong, "/objects/0/mesh/detail", 3, 4, 8};
    CHECK(std::get<PrimitiveMesh>(at(document, detail, 1).objects[0].source).detail == 3);
    const Animation wrong{Motion::PingPong, "/objects/0/material/roughness", 0, 2, 8};
    const auto refused = scene_at(document, wrong, 4);
    REQUIRE(problem_of(refused) != nullptr);
    CHECK(problem_of(refused)->text().find("roughness") != std::string::npos);
}

TEST_CASE("every number in a scene can be chosen by its key", "[ui][animate]") {
    const SceneDocument document = busy_document();
    const auto numbers = numbers_of(document.scene);
    CHECK(numbers.size() > 100);
    for (const SceneNumber& number : numbers) {
        const Animation still{Motion::PingPong, number.pointer, number.value, number.value, 2};
        INFO(number.pointer);
        CHECK(same_description(at(document, still, 0), document.scene));
    }
}

TEST_CASE("frames are written into one file with the extension .gif or .webp", "[ui][animate]") {
    const TemporaryDirectory folder;
    DrawnWindow bench;
    bench.state.get<AnimateState>().animation.frames = 2;
    bench.state.get<AnimateState>().frames_a_second = 50;
    for (const char* name : {"TURN.GIF", "turn.webp"}) {
        write_frames(bench, folder.path(name));
        CHECK(bench.state.notifications.list.back().text == fmt::format("Wrote {} with 2 frames", name));
    }
    CHECK(folder.names() == std::vector<std::string>{"TURN.GIF", "turn.webp"});
    CHECK(bytes_of(folder.path("turn.webp")).substr(8, 4) == "WEBP");
    const std::string two_hundredths("\x21\xF9\x04\x04\x02\x00", 6);  // GIF89a, 23: Graphic Control Extension
    CHECK(bytes_of(folder.path("TURN.GIF")).find(two_hundredths) != std::string::npos);
}

TEST_CASE("frames are written as numbered pictures with their scenes embedded", "[ui][animate]") {
    const TemporaryDirectory folder;
    DrawnWindow bench;
    bench.state.get<AnimateState>().animation = {Motion::PingPong, "/lights/0/intensity", 0, 1, 4};
    write_frames(bench, folder.path("turn.png"));
    CHECK(folder.names() ==
          std::vector<std::string>{"turn-0001.png", "turn-0002.png", "turn-0003.png", "turn-0004.png"});
    const auto third = open_document(folder.path("turn-0003.png"));
    REQUIRE(problem_of(third) == nullptr);
    CHECK(std::get<SceneDocument>(third).scene.lights[0].intensity == 1);
    write_frames(bench, folder.path("turn.gif"));
    CHECK(bytes_of(folder.path("turn.gif")).substr(0, 6) == "GIF89a");
    CHECK(bench.state.notifications.list.back().text == "Wrote turn.gif with 4 frames");
    bench.scene().shading.terms.specular = false;
    bench.key(Key::I);
    write_frames(bench, folder.path("turn.gif"));
    CHECK(bench.state.notifications.list.back().text ==
          "Wrote turn.gif with 4 frames: Off: specular. Not in the file: View: Normals");
}

TEST_CASE("a number that has no effect is not offered for animation", "[ui][window][animate]") {
    HeadlessWindow bench;
    bench.scene().lights.assign(1, Light{});
    bench.scene().lights[0].name = "Bulb";
    bench.state.get<AnimateState>().search = "bulb cutoff";
    begin_animation(bench.state, Motion::PingPong);
    const auto offers_cutoff = [&] {
        bench.frames(4);
        return std::any_of(bench.controls().begin(), bench.controls().end(),
                           [](const NamedControl& control) { return control.name == "Bulb: cone cutoff"; });
    };
    CHECK_FALSE(offers_cutoff());
    bench.scene().lights[0].kind = LightKind::Spot;
    CHECK(offers_cutoff());
}

TEST_CASE("the animation can be chosen and played without a mouse", "[ui][window][animate]") {
    DrawnWindow bench;
    (void)bench.key(Key::T, true);
    bench.frames(3);
    REQUIRE(bench.state.get<AnimateState>().open);
    (void)bench.key(Key::Tab);
    bench.frames(4);
    REQUIRE(ImGui::GetIO().WantTextInput);
    bench.type("12");  // seconds
    CHECK(bench.state.get<AnimateState>().animation.frames == 12 * 25);
    let_go_of_fields();
    bench.frames(2);
    (void)bench.key(Key::Enter);
    CHECK(bench.state.get<AnimateState>().playing);
    (void)bench.key(Key::Enter);
    CHECK_FALSE(bench.state.get<AnimateState>().playing);
    // With focus elsewhere, Tab moves focus to the selected item's panel, and Enter does not start playing.
    bench.click(bench.at_pixel({5, 5}));
    bench.frames(2);
    (void)bench.key(Key::Enter);
    CHECK_FALSE(bench.state.get<AnimateState>().playing);
    (void)bench.key(Key::Tab);
    bench.frames(4);
    CHECK_FALSE(bench.state.get<AnimateState>().has_keyboard);
}

TEST_CASE("numbered frames are overwritten only after confirmation", "[ui][window][animate]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    for (const char* other : {"turn-12.png", "turn-00001.png", "turn-0000.png", "turn-000a.png",
                              "turn-0001.gif", "turns-0001.png", "turn.png"})
        (void)folder.file(other, "precious");
    CHECK_FALSE(may_replace(folder.path("turn.png"), frames_purpose));
    CHECK_FALSE(may_replace(folder.path("turn.gif"), frames_purpose));
    (void)folder.file("turn-0007.png", "precious");
    CHECK(may_replace(folder.path("turn.png"), frames_purpose));
    CHECK_FALSE(may_replace(folder.path("turn.gif"), frames_purpose));
    CHECK(may_replace(folder.path("turn.png"), save_picture_purpose));
    bench.state.files.ask(frames_purpose, folder.path("turn.png"));
    bench.frames(2);
    bench.key(Key::Enter);
    bench.frames(2);
    CHECK(bench.state.files.asks_overwrite);
    CHECK(bench.state.files.open);
    CHECK_FALSE(bench.state.get<AnimateState>().job);
    CHECK(bytes_of(folder.path("turn-0007.png")) == "precious");
}

TEST_CASE("an animation with slow meshes does not play, a message suggests exporting it", "[ui][animate]") {
    DrawnWindow bench;
    AnimateState& animate = bench.state.get<AnimateState>();
    const std::string detail = "/objects/0/mesh/detail";
    const auto plays = [&](const std::string& pointer, double from, double to) {
        animate.animation = {Motion::PingPong, pointer, from, to, 6};
        animate.number.clear();
        animate.open = animate.playing = true;
        animate.began = ImGui::GetTime();
        bench.state.notifications.list.clear();
        bench.frames(2);
        return animate.playing;
    };
    CHECK(plays(detail, 8, 12));
    REQUIRE(animate.frame);
    CHECK(animate.frame->objects[0].mesh);
    for (const auto& [from, to] : {std::pair(8, 1500), {1500, 8}}) {
        CHECK_FALSE(plays(detail, from, to));
        CHECK_FALSE(animate.frame);
        REQUIRE(bench.state.notifications.list.size() == 1);
        CHECK(bench.state.notifications.list[0].text.find("Export animation…") != std::string::npos);
        CHECK(animate.refused.empty());  // the frames can still be written
    }
    CHECK_FALSE(plays("/objects/0/mesh/decimate", 0, 100));
    CHECK(plays("/objects/0/transform/scale/0", 1, 1500));
}

TEST_CASE("an animated number whose light was deleted does not animate another light", "[ui][animate]") {
    HeadlessWindow bench;
    bench.scene().lights.push_back(bench.scene().lights[1]);
    bench.scene().lights[2].name = "Lamp";
    bench.state.get<AnimateState>().animation = {Motion::PingPong, "/lights/1/intensity", 0, 1, 4};
    bench.state.get<AnimateState>().open = bench.state.get<AnimateState>().playing = true;
    bench.frames(3);
    CHECK(bench.state.get<AnimateState>().playing);
    bench.scene().lights.erase(bench.scene().lights.begin() + 1);
    bench.frames(3);
    CHECK_FALSE(bench.state.get<AnimateState>().playing);
    CHECK(bench.state.get<AnimateState>().animation.pointer.empty());
    REQUIRE_FALSE(bench.state.notifications.list.empty());
    CHECK(bench.state.notifications.list.back().text == "Animate: “Bulb: intensity” no longer exists");
    CHECK(bench.state.rendered_scene == bench.scene());
}

TEST_CASE("Escape first cancels writing the frames, and only then closes the panel", "[ui][animate]") {
    const TemporaryDirectory folder;
    DrawnWindow bench;
    bench.state.get<AnimateState>().animation.frames = 2000;
    begin_frames(bench.state, folder.path("turn.png"), {640, 480}, 8);
    bench.frames(2);
    REQUIRE(bench.state.get<AnimateState>().job);
    bench.key(Key::T, true);  // the panel stays open while frames are written
    CHECK(bench.state.get<AnimateState>().open);
    bench.key(Key::Escape);
    CHECK(bench.state.get<AnimateState>().open);
    while (bench.state.get<AnimateState>().job) bench.frame();
    CHECK(bench.notes_with("writing was cancelled") == 1);
    CHECK(folder.names().size() < 2000);
    bench.key(Key::Escape);
    CHECK_FALSE(bench.state.get<AnimateState>().open);
}

TEST_CASE("exporting frames opens a file dialog only after a number is chosen", "[ui][window][animate]") {
    DrawnWindow bench;
    begin_animation(bench.state, Motion::PingPong);
    bench.frames(3);
    bench.click_on("Export animation");
    CHECK_FALSE(bench.state.files.open);
    CHECK(bench.state.get<AnimateState>().refused.find("No number is chosen") == 0);
    bench.state.get<AnimateState>().open = false;
    ask_for_frames(bench.state);  // as the command in Ctrl+K does
    CHECK_FALSE(bench.state.files.open);
    CHECK(bench.state.get<AnimateState>().open);
    begin_animation(bench.state, Motion::Turntable);
    ask_for_frames(bench.state);
    CHECK(bench.state.files.open);
}

// References to lights or objects by index, after earlier ones are added or deleted.
namespace {

/// Opens three lights, all called "Light", with intensities 1, 2 and 3, and selects the first one.
void take_three(HeadlessWindow& bench) {
    bench.frames(1);
    Scene& scene = bench.scene();
    scene.lights.assign(3, scene.lights[0]);
    for (std::size_t i = 0; i < 3; ++i) {
        scene.lights[i].name = "Light";
        scene.lights[i].intensity = 1 + static_cast<float>(i);
    }
    bench.frames(2);
    bench.state.editor.selection = {Selection::Kind::Light, 0};
}

/// Deletes the selected item while `number` is animated.
void delete_while_it_goes(HeadlessWindow& bench, const char* number, const Selection& selection) {
    bench.state.get<AnimateState>().animation.motion = Motion::PingPong;
    bench.state.get<AnimateState>().animation.pointer = number;
    bench.state.editor.selection = selection;
    bench.frames(2);
    run_command(bench.state, test::command_named("Delete"));
    bench.frames(2);
}

}  // namespace

TEST_CASE("an item is found in a changed list by its unchanged neighbours unless deleted", "[ui]") {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        std::vector<int> before(1 + random() % 8);
        for (std::size_t i = 0; i < before.size(); ++i) before[i] = static_cast<int>(i);
        std::vector<int> after = before;
        const auto place = static_cast<std::ptrdiff_t>(random() % before.size());
        const int count = static_cast<int>(1 + random() % 3);  // number of neighbours added or deleted
        if (random() % 2 == 0)
            after.insert(after.begin() + place, static_cast<std::size_t>(count), 99);
        else
            after.erase(after.begin() + place,
                        after.begin() + std::min(place + count, std::ptrdiff_t(after.size())));
        for (int i = 0; i < static_cast<int>(before.size()); ++i) {
            const auto found = std::find(after.begin(), after.end(), i);
            CHECK(place_in(before, after, i) ==
                  (found == after.end() ? -1 : static_cast<int>(found - after.begin())));
        }
    }
    CHECK(place_in(std::vector{1, 2, 3}, std::vector{7, 8, 9}, 1) == 1);  // all edited in place
}

TEST_CASE("a light's debug view follows the light when earlier ones are deleted or added", "[ui][window]") {
    HeadlessWindow bench;
    take_three(bench);
    bench.state.get<DebugViewState>().set.choice.light = 1;
    bench.state.get<TermGridState>().solo = GridCell{1, 2};
    bench.state.get<TermGridState>().muted = {{-1, 1}, {0, 0}, {2, 1}};
    bench.state.get<AnimateState>().animation.motion = Motion::PingPong;
    bench.state.get<AnimateState>().animation.pointer = "/lights/1/intensity";
    bench.frames(2);
    const auto check_second = [&](int place) {
        CHECK(bench.state.get<DebugViewState>().set.choice.light == place);
        CHECK(bench.state.get<TermGridState>().solo == GridCell{place, 2});
        CHECK(bench.state.get<AnimateState>().animation.pointer ==
              "/lights/" + std::to_string(place) + "/intensity");
        CHECK(bench.scene().lights[static_cast<std::size_t>(place)].intensity == 2);
        for (const Notification& note : bench.state.notifications.list) CHECK(note.tone == Tone::Done);
    };
    run_command(bench.state, test::command_named("Delete"));
    bench.frames(2);
    check_second(0);
    CHECK(bench.state.get<TermGridState>().muted == std::vector<GridCell>{{-1, 1}, {1, 1}});
    bench.state.editor.selection = {Selection::Kind::Light, 1};
    run_command(bench.state, test::command_named("Undo"));
    bench.frames(2);
    check_second(1);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 2});  // the same light
    bench.state.editor.selection = {Selection::Kind::Light, 0};
    run_command(bench.state, test::command_named("Duplicate"));
    bench.frames(2);
    check_second(2);
}

TEST_CASE("an animated number stays with its light, even among lights with the same name",
          "[ui][window][animate]") {
    HeadlessWindow bench;
    take_three(bench);
    delete_while_it_goes(bench, "/lights/1/intensity", {Selection::Kind::Light, 1});
    CHECK(bench.state.get<AnimateState>().animation.pointer.empty());
    CHECK(bench.state.notifications.list.back().text == "Animate: “Light: intensity” no longer exists");
}

TEST_CASE("an animated number stays with its object if an earlier one is deleted", "[ui][window][animate]") {
    HeadlessWindow bench;
    bench.frames(1);
    Scene& scene = bench.scene();
    scene.objects.resize(2, scene.objects[0]);
    scene.objects[1].transform.translate.x = 3;
    delete_while_it_goes(bench, "/objects/1/transform/translate/0", {Selection::Kind::Object, 0});
    CHECK(bench.state.get<AnimateState>().animation.pointer == "/objects/0/transform/translate/0");
    CHECK(bench.state.notifications.list.empty());
}
