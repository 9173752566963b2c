// Sets of lights: previewed, applied, saved and imported.
#include <glm/geometric.hpp>

#include "tests/places.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "ui/commands/command.h"
#include "ui/fields/panels.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using namespace glint::test;

namespace {

void open_menu(HeadlessWindow& bench) {
    bench.frames(2);
    bench.click(bench.control("Light setups"));
    bench.frames(3);
}

}  // namespace

TEST_CASE("hovering over a light setup previews it, and a click applies it", "[ui][window][lights]") {
    HeadlessWindow bench;
    open_menu(bench);
    const Scene before = bench.scene();
    bench.move(bench.control("Three-point"));
    bench.frames(3);
    CHECK(bench.scene() == before);
    REQUIRE(bench.state.rendered_scene.lights.size() == 3);
    bench.move({5, 5});
    bench.frames(3);
    CHECK(bench.state.rendered_scene.lights == before.lights);
    bench.click(bench.control("Three-point"));
    bench.frames(3);
    const std::vector<Light>& lights = bench.scene().lights;
    REQUIRE(lights.size() == 3);
    // Seen from the eye: the key light is on the left and above, the fill on the right, the rim behind.
    const ScreenMap map = screen_map(bench.scene().camera, bench.state.rendered->size);
    const auto in_view = [&](const glm::vec4& at) {
        return glm::dvec3(map.view_from_world * glm::dvec4(at));
    };
    const glm::dvec3 target = in_view(glm::vec4(bench.scene().camera.target, 1));
    CHECK(in_view(lights[0].position).x < target.x);
    CHECK(in_view(lights[0].position).y > target.y);
    CHECK(in_view(lights[1].position).x > target.x);
    CHECK(in_view(lights[2].position).z < target.z);
    CHECK(lights[0].intensity > lights[1].intensity);
    (void)bench.key(Key::Z, true);
    bench.frames(2);
    CHECK(bench.scene().lights == before.lights);
}

TEST_CASE("the noon sun is overhead, and the headlight is at the eye in every view", "[ui][window][lights]") {
    HeadlessWindow bench;
    bench.frames(2);
    const auto apply = [&](const char* name) {
        for (const PaletteEntry& entry : palette_entries(bench.state))
            if (entry.name == name) return entry.run(bench.state);
        FAIL("no entry " << name);
    };
    apply("Light setup: Noon");
    REQUIRE(bench.scene().lights.size() == 1);
    CHECK(glm::distance(bench.scene().lights[0].position, glm::vec4(0, 1, 0, 0)) < 1e-6f);
    apply("Light setup: Headlight");
    CHECK(bench.scene().lights[0].space == LightSpace::Camera);
    CHECK(bench.scene().lights[0].position == glm::vec4(0, 0, 0, 1));
}

TEST_CASE("a user's light setups are saved with the settings and survive a reset", "[ui][window][lights]") {
    Json kept;
    std::vector<Light> saved;
    {
        HeadlessWindow bench;
        bench.frames(2);
        bench.scene().lights[0].intensity = 0.625f;
        saved = bench.scene().lights;
        open_menu(bench);
        bench.click(bench.control("Name of the preset"));
        bench.frames(2);
        bench.type("Evening");
        bench.click(bench.control("Save lights as preset"));
        bench.frames(2);
        kept = features_to_remember(bench.state);
    }
    HeadlessWindow bench;
    bench.frames(2);
    recall_features(bench.state, kept);
    recall_features(bench.state, Json::object());
    bench.scene().lights.clear();
    open_menu(bench);
    bench.click(bench.control("Evening"));
    bench.frames(2);
    CHECK(bench.scene().lights == saved);
    recall_features(bench.state, {{"light_setups", {{{"name", 3}}, {{"name", "x"}, {"lights", "y"}}, 5}}});
    open_menu(bench);
    CHECK(std::none_of(bench.controls().begin(), bench.controls().end(),
                       [](const NamedControl& control) { return control.name == "Evening"; }));
}

TEST_CASE("lights are imported from another scene", "[ui][window][lights]") {
    HeadlessWindow bench;
    open_menu(bench);
    bench.click(bench.control("Import lights"));
    bench.frames(2);
    REQUIRE(bench.state.files.open);
    const FilePurpose& purpose = *bench.state.files.purpose;
    bench.state.files.open = false;
    const std::string path = project_file("assets/scenes/bulb.json");
    const auto opened = open_document(path);
    REQUIRE(problem_of(opened) == nullptr);
    const std::vector<Light> expected = std::get<SceneDocument>(opened).scene.lights;
    const std::vector<Object> objects = bench.scene().objects;
    purpose.use(bench.state, path);
    for (int i = 0; i < 2000 && !(bench.scene().lights == expected); ++i) {
        bench.frames(1);
        std::this_thread::yield();
    }
    CHECK(bench.scene().lights == expected);
    CHECK(bench.scene().objects == objects);
}
