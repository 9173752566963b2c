// Undo, redo, and what the steps are called.
#include "tests/catch.h"
#include "ui/history.h"

using namespace glint;

namespace {

Scene two_lights() {
    Scene scene;
    scene.lights.resize(2);
    scene.lights[0].name = "Sun";
    scene.lights[1].name = "Bulb";
    scene.objects.resize(1);
    scene.objects[0].name = "Teapot";
    return scene;
}

template <class Change> std::string name_of(Change change) {
    Scene after = two_lights();
    change(after);
    return step_name(two_lights(), after);
}

}  // namespace

TEST_CASE("undo and redo walk back and forth over equal scenes", "[ui]") {
    History history;
    std::vector<Scene> scenes{two_lights()};
    history.reset(scenes[0]);
    CHECK_FALSE(history.can_undo());
    for (int i = 0; i < 10; ++i) {
        Scene next = scenes.back();
        next.lights[1].position.x += 1;
        CHECK(history.commit(next));
        scenes.push_back(next);
    }
    CHECK_FALSE(history.commit(scenes.back()));  // nothing changed
    for (std::size_t i = scenes.size() - 1; i > 0; --i) CHECK(history.undo() == scenes[i - 1]);
    CHECK_FALSE(history.can_undo());
    for (std::size_t i = 1; i < scenes.size(); ++i) CHECK(history.redo() == scenes[i]);
    CHECK_FALSE(history.can_redo());
}

TEST_CASE("an edit after undo drops what was undone", "[ui]") {
    History history;
    Scene scene = two_lights();
    history.reset(scene);
    scene.lights[0].intensity = 2;
    history.commit(scene);
    history.undo();
    scene.lights[0].intensity = 3;
    history.commit(scene);
    CHECK_FALSE(history.can_redo());
    CHECK(history.undo() == two_lights());
}

TEST_CASE("joined steps of one name are one step", "[ui]") {
    History history;
    Scene scene = two_lights();
    history.reset(scene);
    for (int i = 0; i < 5; ++i) {
        scene.camera.eye.z += 1;
        history.commit(scene, true);
    }
    CHECK(history.undo() == two_lights());
    CHECK_FALSE(history.can_undo());
}

TEST_CASE("the history of a large scene forgets its oldest steps, not its newest", "[ui]") {
    History history;
    Scene scene;
    scene.lights.resize(4096);
    history.reset(scene);
    for (int i = 1; i <= 200; ++i) {
        scene.lights[0].intensity = static_cast<float>(i);
        history.commit(scene);
    }
    int steps = 0;
    for (float expected = 199; history.can_undo(); --expected, ++steps)
        CHECK(history.undo().lights[0].intensity == expected);
    CHECK(steps > 20);
    CHECK(steps < 100);
}

TEST_CASE("steps are named by what changed", "[ui]") {
    CHECK(step_name(two_lights(), two_lights()).empty());
    CHECK(name_of([](Scene& s) { s.lights[1].position.x = 7; }) == "Move Bulb");
    CHECK(name_of([](Scene& s) { s.lights[0].position.w = 0; }) == "Turn Sun");
    CHECK(name_of([](Scene& s) { s.lights[1].enabled = false; }) == "Switch Bulb off");
    CHECK(name_of([](Scene& s) { s.lights[1].diffuse.x = 0.5f; }) == "Colour of Bulb");
    CHECK(name_of([](Scene& s) { s.lights.erase(s.lights.begin()); }) == "Delete Sun");
    CHECK(name_of([](Scene& s) { s.lights.emplace_back().name = "Lamp"; }) == "Add Lamp");
    CHECK(name_of([](Scene& s) { s.lights[1].name = "Lamp"; }) == "Rename Bulb");
    CHECK(name_of([](Scene& s) { s.objects[0].material.shininess = 5; }) == "Material of Teapot");
    CHECK(name_of([](Scene& s) { s.objects[0].transform.translate.x = 5; }) == "Move Teapot");
    CHECK(name_of([](Scene& s) { s.camera.eye.x = 5; }) == "Camera");
    CHECK(name_of([](Scene& s) { s.shading.mode = ShadingMode::Flat; }) == "Shading mode");
    CHECK(name_of([](Scene& s) { s.shading.terms.ambient = false; }) == "Terms");
    CHECK(name_of([](Scene& s) { s.display.exposure = 2, s.camera.eye.x = 5; }) == "Edit scene");
}
