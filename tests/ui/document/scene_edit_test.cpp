// Adding and copying lights and objects.

#include "ui/document/scene_edit.h"

#include "models/mesh/primitives/primitives.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"

using namespace glint;

TEST_CASE("lights can be added up to a scene's limit", "[ui][edit]") {
    Scene scene;
    scene.lights.resize(max_lights - 1);
    Selection selection;
    CHECK(add_light(scene, selection, LightKind::Point));
    const Selection last{Selection::Kind::Light, static_cast<int>(max_lights) - 1};
    CHECK(selection == last);
    CHECK_FALSE(add_light(scene, selection, LightKind::Point));
    CHECK(selection == last);
    CHECK(scene.lights.size() == max_lights);
}

TEST_CASE("pressing a key that would exceed a scene's limit reports it and adds nothing", "[ui][edit]") {
    test::HeadlessWindow bench;
    bench.scene().lights.resize(max_lights, bench.scene().lights[0]);
    bench.state.editor.selection = {Selection::Kind::Light, 0};
    bench.frames(2);
    for (const char* const name : {"Add a light", "Duplicate"}) {
        const std::string why = why_disabled(bench.state, test::command_named(name));
        CHECK(why == is_full);
    }
    bench.key(Key::L, false, true);
    bench.key(Key::D, true);
    CHECK(bench.notes_with(is_full) == 1);  // the second message has the same text
    CHECK(bench.scene().lights.size() == max_lights);
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    CHECK(why_disabled(bench.state, test::command_named("Duplicate")).empty());
}

TEST_CASE("only a pointer into a light or an object selects it", "[ui][edit]") {
    using Kind = Selection::Kind;
    CHECK(selection_in("/lights/3") == Selection{Kind::Light, 3});
    CHECK(selection_in("/lights/12/position/1") == Selection{Kind::Light, 12});
    CHECK(selection_in("/objects/0/transform/0/scale") == Selection{Kind::Object, 0});
    for (const char* none : {"", "/camera/eye/0", "/lights", "/lights/", "/lights/-", "/lights/-1",
                             "/lights/1x", "/lights/99999999999", "/objects/x/0", "lights/0"})
        CHECK(selection_in(none) == std::nullopt);
}

TEST_CASE("a copied lamp is placed a tenth of the scene's diagonal to the right", "[ui][edit]") {
    Scene scene;
    Object cube;
    cube.mesh = std::make_shared<const Mesh>(make_primitive(Primitive::Cube, 1));
    scene.objects = {cube};  // a diagonal of 2 sqrt(3)
    scene.lights.emplace_back().position = {1, 2, 3, 1};
    Selection selection{Selection::Kind::Light, 0};
    duplicate(scene, selection);
    CHECK(scene.lights.at(1).position.x == Approx(1.3464));
}

TEST_CASE("a copy comes after its original and is selected", "[ui][edit]") {
    Scene scene;
    for (const char* name : {"A", "B", "C"}) scene.lights.emplace_back().name = name;
    Selection selection{Selection::Kind::Light, 1};
    duplicate(scene, selection);
    CHECK(selection.index == 2);
    REQUIRE(scene.lights.size() == 4);
    CHECK(scene.lights[1].name == "B");
    CHECK(scene.lights[2].name == "B 2");
    CHECK(scene.lights[3].name == "C");
}

TEST_CASE("a new object is placed to the right of all others", "[ui][edit]") {
    // The cube extends from 4 to 6.
    Result<Scene> parsed = parse_scene(R"({"glint": 1, "objects": [{"mesh": {"primitive": "cube"},
        "transform": {"translate": [5, 0, 0], "scale": [2, 2, 2]}}]})",
                                       "s.json");
    REQUIRE_FALSE(problem_of(parsed));
    Scene scene = std::get<Scene>(std::move(parsed));
    REQUIRE(problem_of(load_meshes(scene, "", "")) == nullptr);
    Selection selection;
    REQUIRE(add_object(scene, selection, scene.objects[0].source));
    CHECK(selection == Selection{Selection::Kind::Object, 1});
    CHECK(scene.objects[1].transform.translate.x > 6);
}

TEST_CASE("a copy of an item with the longest allowed name gets a valid name", "[ui][edit]") {
    Scene scene;
    std::string name;
    for (std::size_t i = 0; i < max_name_characters; ++i) name += "é";
    scene.lights.emplace_back().name = name;
    for (int copies = 0; copies < 12; ++copies) {
        Selection selection{Selection::Kind::Light, copies};
        duplicate(scene, selection);
        CHECK(scene.lights.back().name.ends_with("é " + std::to_string(copies + 2)));
    }
    const Result<Scene> read = parse_scene(scene_text(scene), "s.json");
    REQUIRE(problem_of(read) == nullptr);
    CHECK(same_description(std::get<Scene>(read), scene));
}
