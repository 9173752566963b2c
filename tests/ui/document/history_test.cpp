// Undo, redo, and the names of steps.
#include "models/memory_limit.h"
#include "models/mesh/primitives/primitives.h"
#include "models/scene/scene.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "ui/document/document_actions.h"
#include "ui/document/editor.h"

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

template <class Change> std::string undo_text(Change change) {
    Scene after = two_lights();
    change(after);
    return step_name(two_lights(), after);
}

}  // namespace

TEST_CASE("undo and redo restore the exact scenes", "[ui]") {
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

TEST_CASE("typing into a field is one undo step, which ends if the scene is saved", "[ui][window]") {
    const TemporaryDirectory folder;
    test::DrawnWindow bench;
    const auto type_into = [&](const char* field, const char* text) {
        bench.click(bench.control(field));
        bench.type(text);
    };
    Scene start = bench.scene();
    type_into("/lights/0/intensity", "2");
    type_into("/lights/0/diffuse/0", "0.5");
    const Scene two = bench.scene();
    CHECK(two.lights[0].intensity == 2);
    CHECK(two.lights[0].diffuse.x == 0.5f);
    CHECK(save_as(bench.state, folder.path("two.json")));
    bench.type("5");
    bench.click({5, 5});
    bench.frames(2);
    CHECK(bench.scene().lights[0].diffuse.x == 0.55f);
    bench.key(Key::Z, true);
    CHECK(bench.scene() == two);  // as saved
    bench.key(Key::Z, true);
    CHECK(bench.scene().lights[0].diffuse == start.lights[0].diffuse);
    CHECK(bench.scene().lights[0].intensity == 2);
    bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
}

TEST_CASE("an edit after undo discards the undone steps", "[ui]") {
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

TEST_CASE("an edit to a different item is a separate step, however soon it follows", "[ui]") {
    Editor editor;
    editor.document.scene = two_lights();
    editor.history.reset(editor.scene());
    std::vector<Scene> scenes{editor.scene()};
    const auto edit = [&](auto change) {
        change(editor.scene());
        remember_step(editor, false);
        scenes.push_back(editor.scene());
    };
    edit([](Scene& s) { s.lights[0].intensity = 2; });
    edit([](Scene& s) { s.lights[0].position.x = 3; });
    edit([](Scene& s) { s.lights[1].intensity = 2; });
    edit([](Scene& s) { s.shading.mode = ShadingMode::Flat; });
    edit([](Scene& s) { s.shading.mode = ShadingMode::Gouraud; });
    for (std::size_t i = scenes.size() - 1; i > 0; --i) {
        REQUIRE(undo(editor));
        CHECK(editor.scene() == scenes[i - 1]);
    }
    CHECK_FALSE(undo(editor));
}

TEST_CASE("view changes between two edits are not undo steps, and undo keeps the view", "[ui]") {
    History history;
    Scene scene = two_lights();
    history.reset(scene);
    const auto look = [&](float z) {
        scene.camera.eye.z = z;
        history.look(scene.camera);
        CHECK_FALSE(history.commit(scene));
    };
    look(7);
    scene.lights[0].intensity = 2;
    history.commit(scene);
    look(9);
    scene.lights[0].intensity = 3;
    history.commit(scene);
    CHECK(history.undo().lights[0].intensity == 2);
    CHECK(history.present().camera.eye.z == 9);
    CHECK(history.undo().lights[0].intensity == 1);
    CHECK(history.present().camera.eye.z == 9);
    history.look(two_lights().camera);
    CHECK(history.redo().lights[0].intensity == 2);
    CHECK(history.present().camera == two_lights().camera);
    CHECK(history.edited_camera() == two_lights().camera);
}

TEST_CASE("undo reverts an edit to the camera from any view", "[ui]") {
    History history;
    Scene scene = two_lights();
    history.reset(scene);
    scene.camera.eye.z = 7;
    history.commit(scene);  // typed, not a change of view
    CHECK(history.undo_name() == "Camera");
    CHECK(history.edited_camera().eye.z == 7);
    Camera elsewhere = scene.camera;
    elsewhere.eye.x = 3;
    history.look(elsewhere);
    CHECK(history.edited_camera().eye.z == 7);
    CHECK(history.undo().camera == two_lights().camera);
    CHECK(history.edited_camera() == two_lights().camera);
    CHECK(history.redo().camera.eye.z == 7);
}

TEST_CASE("undo deselects an item that it removes", "[ui]") {
    Editor editor;
    SceneDocument document;
    document.scene = two_lights();
    take_document(editor, document);
    editor.scene().lights.emplace_back().name = "Lamp";
    editor.selection = {Selection::Kind::Light, 2};
    remember_step(editor, false);
    REQUIRE(undo(editor));
    CHECK(editor.selection == Selection{Selection::Kind::Light, 1});  // the nearest existing one
    editor.scene().lights.clear();
    remember_step(editor, false);
    REQUIRE(undo(editor));
    editor.selection = {Selection::Kind::Light, 1};
    REQUIRE(redo(editor));
    CHECK(editor.selection.kind != Selection::Kind::Light);
}

TEST_CASE("undoing a copy selects the original, and deleting again selects the next item", "[ui]") {
    Editor editor;
    SceneDocument document;
    document.scene = two_lights();
    document.scene.lights.emplace_back().name = "Lamp";
    take_document(editor, document);
    editor.selection = {Selection::Kind::Light, 1};
    duplicate(editor.scene(), editor.selection);
    remember_step(editor, false);
    CHECK(editor.selection.index == 2);
    REQUIRE(undo(editor));
    CHECK(editor.selection == Selection{Selection::Kind::Light, 1});
    remove(editor.scene(), editor.selection);
    remember_step(editor, false);
    REQUIRE(undo(editor));
    CHECK(editor.selection == Selection{Selection::Kind::Light, 1});  // the restored light
    REQUIRE(redo(editor));
    CHECK(editor.selection == Selection{Selection::Kind::Light, 1});
}

TEST_CASE("undo selects a restored item if its deletion left its neighbour selected", "[ui]") {
    Editor editor;
    SceneDocument document;
    document.scene = two_lights();
    for (const char* const name : {"Lamp", "Torch"}) document.scene.lights.emplace_back().name = name;
    take_document(editor, document);
    for (int deleted = 0; deleted < 4; ++deleted) {
        editor.selection = {Selection::Kind::Light, deleted};
        remove(editor.scene(), editor.selection);
        remember_step(editor, false);
        REQUIRE(undo(editor));
        CHECK(editor.selection == Selection{Selection::Kind::Light, deleted});
    }
    editor.selection = {Selection::Kind::Light, 1};
    remove(editor.scene(), editor.selection);
    remember_step(editor, false);
    editor.selection = {Selection::Kind::Light, 2};  // selected by the user, so undo keeps it
    REQUIRE(undo(editor));
    CHECK(editor.selection == Selection{Selection::Kind::Light, 3});
}

TEST_CASE("a reloaded mesh is not an edit and has no step name", "[ui]") {
    Scene scene = two_lights();
    scene.objects[0].mesh = std::make_shared<const Mesh>();
    Scene again = scene;
    again.objects[0].mesh = std::make_shared<const Mesh>();  // as after rereading a file
    CHECK(step_name(scene, again).empty());
    History history;
    history.reset(scene);
    history.commit(again);
    CHECK_FALSE(history.can_undo());
    again.lights[1].position.x = 7;
    CHECK(step_name(scene, again) == "Move Bulb");
}

TEST_CASE("undo and redo report the step after a view change", "[ui][window]") {
    test::DrawnWindow bench;
    bench.scene().lights[1].position.x += 1;
    bench.frames(2);
    bench.scene().camera.eye.x += 1;
    bench.frames(2);
    bench.key(Key::Z, true);
    bench.frames(1);
    CHECK(bench.notes_with("Undone: Move Bulb") == 1);
    bench.key(Key::Z, true, true);
    bench.frames(1);
    CHECK(bench.notes_with("Redone: Move Bulb") == 1);
    CHECK(bench.notes_with("Undone") == 0);
}

TEST_CASE("the history keeps 500 steps and drops older ones", "[ui]") {
    History history;
    Scene scene = two_lights();
    history.reset(scene);
    for (int i = 1; i <= 600; ++i) {
        scene.lights[0].intensity = static_cast<float>(i);
        history.commit(scene);
    }
    int steps = 0;
    for (; history.can_undo(); ++steps) (void)history.undo();
    CHECK(steps == 500);
    CHECK(history.present().lights[0].intensity == 100);
}

TEST_CASE("the history drops old steps when their meshes need too much memory", "[ui]") {
    const test::MemoryLimit limit(8 << 20);
    History history;
    Scene scene = two_lights();
    history.reset(scene);
    for (int detail = 40; detail < 60; ++detail) {
        scene.objects[0].source = PrimitiveMesh{Primitive::Sphere, detail};
        scene.objects[0].mesh = std::make_shared<const Mesh>(make_primitive(Primitive::Sphere, detail));
        history.commit(scene);
    }
    int steps = 0;
    for (; history.can_undo(); ++steps) (void)history.undo();
    CHECK(steps > 0);
    CHECK(steps < 19);
}

TEST_CASE("undo steps are named after what they changed", "[ui]") {
    CHECK(step_name(two_lights(), two_lights()).empty());
    CHECK(undo_text([](Scene& s) { s.lights[1].position.x = 7; }) == "Move Bulb");
    CHECK(undo_text([](Scene& s) { s.lights[0].position.w = 0; }) == "Turn Sun");
    CHECK(undo_text([](Scene& s) { s.lights[1].enabled = false; }) == "Switch Bulb off");
    CHECK(undo_text([](Scene& s) { s.lights[1].diffuse.x = 0.5f; }) == "Colour of Bulb");
    CHECK(undo_text([](Scene& s) { s.lights.erase(s.lights.begin()); }) == "Delete Sun");
    CHECK(undo_text([](Scene& s) { s.lights.emplace_back().name = "Lamp"; }) == "Add Lamp");
    CHECK(undo_text([](Scene& s) { s.lights[1].name = "Lamp"; }) == "Rename Bulb");
    CHECK(undo_text([](Scene& s) { s.objects[0].name = "Pot"; }) == "Rename Teapot");
    CHECK(undo_text([](Scene& s) { s.objects[0].material.shininess = 5; }) == "Material of Teapot");
    CHECK(undo_text([](Scene& s) { s.objects[0].transform.translate.x = 5; }) == "Move Teapot");
    CHECK(undo_text([](Scene& s) { s.camera.eye.x = 5; }) == "Camera");
    CHECK(undo_text([](Scene& s) { s.shading.mode = ShadingMode::Flat; }) == "Shading mode: Phong → Flat");
    CHECK(undo_text([](Scene& s) { s.shading.reflection = Reflection::BlinnPhong; }) ==
          "Reflection: Phong → Blinn–Phong");
    CHECK(undo_text([](Scene& s) { s.shading.terms.ambient = false; }) == "Terms");
    CHECK(undo_text([](Scene& s) { s.display.exposure = 2, s.camera.eye.x = 5; }) == "Edit scene");
}
