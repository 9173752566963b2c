// Loading files without blocking the window.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <thread>

#include "models/io/file.h"
#include "models/memory_limit.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/picture/draw_picture.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// A load that finishes on request.
struct Gate {
    std::promise<void> open;
    std::shared_future<void> opened = open.get_future().share();

    JobPtr<SceneDocument> job(const SceneDocument& document) {
        return std::make_shared<LoadJob>("slow.json",
                                         [opened = opened, document](LoadProgress&) -> Result<SceneDocument> {
                                             opened.wait();
                                             return document;
                                         });
    }
};

/// Awaits a file that started loading before the window opened, with an assignment that removes its lights.
void await_unlit(HeadlessWindow& bench, const std::string& path) {
    Opening opening = opening_of(path, {std::get<Assignment>(parse_assignment("/lights=[]"))});
    REQUIRE(opening.job->wait_for(std::chrono::minutes(1)));
    await_opening(bench.state, std::move(opening));
}

constexpr const char* square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

}  // namespace

TEST_CASE("while a file loads, the current scene stays and can be edited", "[ui][loading]") {
    DrawnWindow bench;
    Gate gate;
    SceneDocument other = first_scene();
    other.path = "slow.json";
    other.scene.lights.clear();
    bench.state.loading.document = bench.state.jobs.add(gate.job(other));
    bench.state.loading.scene_then = bench.scene();
    bench.frames(3);
    bench.key(Key::Digit1);
    bench.frames(3);
    CHECK(bench.state.editor.history.undo_name().starts_with("Shading mode: "));
    CHECK(bench.frame().sleep_s < 0.1);
    gate.open.set_value();
    bench.wait_for_loads();
    // Edits made in the meantime are not discarded without asking.
    REQUIRE(bench.state.pending.asking);
    CHECK(bench.scene().shading.mode == ShadingMode::Flat);
    finish_pending(bench.state);
    bench.wait_for_loads();
    CHECK(bench.scene().lights.empty());
    CHECK(bench.state.editor.document.path == "slow.json");
}

TEST_CASE("a file that began loading before the window existed keeps its assignments", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("given.json", scene_text(first_scene().scene));
    DrawnWindow bench;
    await_unlit(bench, path);
    CHECK_FALSE(bench.scene().lights.empty());
    bench.wait_for_loads();
    CHECK(bench.scene().lights.empty());
    CHECK(bench.state.editor.document.path == path);
    CHECK_FALSE(bench.state.editor.unsaved());
}

TEST_CASE("a loaded file waits until a question about the current scene is answered", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string asked_for = folder.file("asked.json", scene_text(first_scene().scene));
    DrawnWindow bench;
    Gate gate;
    SceneDocument other = first_scene();
    other.path = "slow.json";
    bench.state.loading.document = bench.state.jobs.add(gate.job(other));
    bench.key(Key::Digit1);
    bench.frames(2);
    bench.state.loading.scene_then = bench.scene();
    ask_to_open(bench.state, asked_for);
    REQUIRE(bench.state.pending.asking);
    gate.open.set_value();
    while (!bench.state.loading.document->done()) std::this_thread::yield();
    bench.frames(2);
    CHECK(bench.state.editor.document.path.empty());
    finish_pending(bench.state);
    bench.wait_for_loads();
    CHECK(bench.state.editor.document.path == asked_for);
}

TEST_CASE("loading a mesh without normals reports averaging and shows the crease angle", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("square.obj", square_obj);
    HeadlessWindow bench;
    bench.open(path);
    bench.frames(2);
    const auto said = [&bench] { return bench.notes_with("has no normals") > 0; };
    CHECK(said());
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Object, 0});
    const Rect crease = bench.area_of("/objects/0/normals/crease_deg");  // visible without scrolling
    CHECK(crease.low.y < bench.area_of("/objects/0/material/reflection").low.y);
    // A mesh with normals causes no message.
    bench.state.notifications.list.clear();
    bench.open(folder.file("with.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"));
    bench.frames(2);
    REQUIRE(bench.scene().objects[0].mesh->given_normals == GivenNormals::File);
    CHECK_FALSE(said());
}

TEST_CASE("the error for a file of unknown type lists the types that the window can open", "[ui][loading]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    bench.frames(1);
    bench.open(folder.file("mine.jpg", "x"));
    REQUIRE(bench.state.notifications.list.size() == 1);
    const std::string& text = bench.state.notifications.list[0].text;
    for (const char* const kind : {".json", ".stl", ".md", ".pfm", ".exr"})
        CHECK(text.find(kind) != std::string::npos);
}

TEST_CASE("Escape cancels a load and discards its result", "[ui][loading]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    Gate gate;
    bench.state.loading.document = bench.state.jobs.add(gate.job({}));
    bench.frames(2);
    bench.key(Key::Escape);
    CHECK_FALSE(bench.state.loading.active());
    gate.open.set_value();
    bench.frames(3);
    CHECK(bench.scene() == before);
    CHECK(bench.state.notifications.list.empty());
}

TEST_CASE("an object shows its old mesh while a new one loads, which is one undo step", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("square.obj", square_obj);
    DrawnWindow bench;
    const MeshPtr old_mesh = bench.scene().objects[0].mesh;
    begin_mesh(bench.state, MeshFile{path}, 0);
    (void)bench.frame();
    REQUIRE(bench.scene().objects[0].mesh != nullptr);
    bench.wait_for_loads();
    CHECK(bench.scene().objects[0].mesh->face_count() == 1);
    CHECK(bench.state.renderer->stats().triangles == 2);
    CHECK(bench.state.editor.history.undo_name() == "Mesh of Ball");
    bench.key(Key::Z, true);
    bench.frames(2);
    CHECK(bench.scene().objects[0].mesh == old_mesh);
    CHECK_FALSE(bench.state.editor.unsaved());
}

TEST_CASE("an object from a file is added when its mesh is loaded", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("square.obj", square_obj);
    DrawnWindow bench;
    begin_mesh(bench.state, MeshFile{path}, -1);
    bench.wait_for_loads();
    REQUIRE(bench.scene().objects.size() == 2);
    CHECK(bench.scene().objects[1].mesh->face_count() == 1);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Object, 1});
    bench.frames(2);
    CHECK(bench.state.editor.history.undo_name() == "Add Square");
}

TEST_CASE("saving a scene whose mesh file is missing warns that it will not open", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string mesh = folder.file("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string path =
        folder.file("own.json", R"({"glint": 1, "objects": [{"mesh": {"file": "one.obj"}}]})");
    DrawnWindow bench;
    bench.open(path);
    bench.frames(2);
    const auto saved = [&] {
        bench.state.notifications.list.clear();
        CHECK(save(bench.state));
        return bench.state.notifications.list;
    };
    REQUIRE(saved().size() == 1);
    std::filesystem::remove(mesh);
    const auto told = saved();
    REQUIRE(told.size() == 1);
    CHECK(told[0].tone == Tone::Warning);
    CHECK(told[0].text.ends_with("The scene cannot be opened again until \"one.obj\" exists: no such file"));
    std::filesystem::create_directory(mesh);
    const auto found = saved();
    REQUIRE(found.size() == 1);
    CHECK(found[0].text.ends_with(
        "The scene cannot be opened again until \"one.obj\" exists: it is a directory"));
}

TEST_CASE("an unreadable mesh leaves the object unchanged and reports why", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("none.obj", "f 1 2 3\n");
    DrawnWindow bench;
    const Scene before = bench.scene();
    begin_mesh(bench.state, MeshFile{path}, 0);
    bench.wait_for_loads();
    CHECK(bench.scene() == before);
    REQUIRE(bench.state.notifications.list.size() == 1);
    CHECK(bench.state.notifications.list[0].text.find("none.obj") != std::string::npos);
    CHECK_FALSE(bench.state.editor.history.can_undo());
}

TEST_CASE("a mesh of a million triangles is built in the background, the last request wins",
          "[ui][loading]") {
    DrawnWindow bench;
    REQUIRE_FALSE(is_quick(PrimitiveMesh{Primitive::Sphere, 1000}));
    REQUIRE(is_quick(PrimitiveMesh{Primitive::Sphere, 400}));
    for (const int detail : {700, 640, 600}) {
        begin_mesh(bench.state, PrimitiveMesh{Primitive::Sphere, detail}, 0);
        (void)bench.frame();
        CHECK(bench.scene().objects[0].mesh != nullptr);
    }
    bench.wait_for_loads();
    CHECK(bench.scene().objects[0].mesh->face_count() == 600 * 300);
    bench.frames(2);
    bench.key(Key::Z, true);
    CHECK_FALSE(bench.state.editor.history.can_undo());
}
