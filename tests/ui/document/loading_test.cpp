// Loads that do not block the window.
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
using test::HeadlessWindow;

namespace {

/// A load that ends on request.
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

/// Awaits a file whose opening began before, with its lights removed.
void await_unlit(HeadlessWindow& bench, const std::string& path) {
    Opening opening = opening_of(path, {std::get<Assignment>(parse_assignment("/lights=[]"))});
    REQUIRE(opening.job->wait_for(std::chrono::minutes(1)));
    await_opening(bench.state, std::move(opening));
}

constexpr const char* square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

}  // namespace

TEST_CASE("while a file is loaded the present scene stays and can be edited", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
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
    // Edits made in the meantime are discarded only after a question.
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
    HeadlessWindow bench;
    bench.frames(2);
    await_unlit(bench, path);
    CHECK_FALSE(bench.scene().lights.empty());
    bench.wait_for_loads();
    CHECK(bench.scene().lights.empty());
    CHECK(bench.state.editor.document.path == path);
    CHECK_FALSE(bench.state.editor.unsaved());
}

TEST_CASE("assignments to an awaited file survive the question and the save dialog", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("given.json", scene_text(first_scene().scene));
    HeadlessWindow bench;
    bench.frames(2);
    await_unlit(bench, path);
    bench.scene().shading.mode = ShadingMode::Flat;
    bench.wait_for_loads();
    REQUIRE(bench.state.pending.asking);
    bench.key(Key::Enter);  // save: under which name?
    bench.frames(3);
    REQUIRE(bench.state.files.open);
    bench.state.files.ask(save_purpose, folder.path("scene.json"));
    bench.frames(2);
    bench.key(Key::Enter);
    bench.wait_for_loads();
    CHECK(std::filesystem::exists(folder.path("scene.json")));
    CHECK(bench.state.editor.document.path == path);
    CHECK(bench.scene().lights.empty());
}

TEST_CASE("a file and a mesh for which no thread can start are reported once", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("given.json", scene_text(first_scene().scene));
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    {
        const test::NoThreads none;
        begin_open(bench.state, path);
        begin_mesh(bench.state, PrimitiveMesh{Primitive::Sphere, 1500}, 0);
        bench.frames(10);
        CHECK_FALSE(bench.state.loading.active());
    }
    CHECK(bench.notes_with("given.json: the system allows no further thread") == 1);
    CHECK(bench.notes_with("sphere: the system allows no further thread") == 1);
    CHECK(bench.scene() == before);
    begin_open(bench.state, path);
    bench.wait_for_loads();
    CHECK(bench.state.editor.document.path == path);
}

TEST_CASE("waiting for a job ends after the given time or when it is done", "[ui][loading]") {
    Gate gate;
    const JobPtr<SceneDocument> job = gate.job(first_scene());
    CHECK_FALSE(job->wait_for(std::chrono::milliseconds(20)));
    gate.open.set_value();
    CHECK(job->wait_for(std::chrono::minutes(1)));
    CHECK(job->done());
}

TEST_CASE("a loaded file waits for the answer to a question about the present scene", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string asked_for = folder.file("asked.json", scene_text(first_scene().scene));
    HeadlessWindow bench;
    bench.frames(2);
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

TEST_CASE("the loading panel is drawn over the picture and covers no row of buttons", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
    Gate gate;
    bench.state.loading.document = bench.state.jobs.add(gate.job(first_scene()));
    bench.frames(30);  // half a second
    const ImGuiWindow* panel = test::window_named("##loading");
    REQUIRE(panel != nullptr);
    const Rect picture = lay_out(ImGui::GetIO().DisplaySize, bench.state.layout, 1).centre;
    CHECK(panel->Pos.y >= picture.low.y);
    CHECK(panel->Pos.x >= picture.low.x);
    CHECK(panel->Pos.x + panel->Size.x <= picture.high.x);
    gate.open.set_value();
    bench.wait_for_loads();
}

TEST_CASE("loading a mesh without normals reports the averaging and shows Crease", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("square.obj", square_obj);
    HeadlessWindow bench;
    UiInput drop;
    drop.dropped = {path};
    (void)bench.frame(drop);
    bench.wait_for_loads();
    bench.frames(2);
    const auto said = [&bench] { return bench.notes_with("has no normals") > 0; };
    CHECK(said());
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Object, 0});
    const Rect crease = bench.area_of("/objects/0/normals/crease_deg");  // visible without scrolling
    CHECK(crease.low.y < bench.area_of("/objects/0/material/ambient").low.y);
    // A mesh with normals gives no message.
    bench.state.notifications.list.clear();
    drop.dropped = {folder.file("with.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n")};
    (void)bench.frame(drop);
    bench.wait_for_loads();
    bench.frames(2);
    REQUIRE(bench.scene().objects[0].mesh->given_normals == GivenNormals::File);
    CHECK_FALSE(said());
}

TEST_CASE("a file of an unknown kind is answered with the kinds that a window opens", "[ui][loading]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    bench.frames(1);
    UiInput input;
    input.dropped = {folder.file("mine.jpg", "x")};
    (void)bench.frame(input);
    bench.wait_for_loads();
    REQUIRE(bench.state.notifications.list.size() == 1);
    const std::string& text = bench.state.notifications.list[0].text;
    for (const char* const kind : {".json", ".stl", ".md", ".pfm", ".exr"})
        CHECK(text.find(kind) != std::string::npos);
}

TEST_CASE("Escape cancels a load and drops its result", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
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

TEST_CASE("a new mesh arrives as one step, and until then the object shows its old one", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("square.obj", square_obj);
    HeadlessWindow bench;
    bench.frames(2);
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

TEST_CASE("deleting an object before its new mesh is ready reports what undo restores", "[ui][loading]") {
    const PrimitiveMesh slow{Primitive::Sphere, 2800};
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    const auto told = [&] {
        const auto& list = bench.state.notifications.list;
        for (const Notification& note : list) UNSCOPED_INFO(note.text);
        return std::ssize(list);
    };
    for (const bool waits : {false, true}) {
        if (waits) begin_mesh(bench.state, slow, 0);
        if (waits) (void)bench.frame();
        REQUIRE(awaits_mesh(bench.state) == waits);
        bench.key(Key::Delete);
        bench.frames(3);
        CHECK(told() == (waits ? 1 : 0));
        bench.state.notifications.list.clear();
        INFO(bench.state.editor.history.undo_name());
        bench.key(Key::Z, true);
        bench.frames(2);
        CHECK(bench.scene() == before);
    }
    begin_mesh(bench.state, slow, 0);
    (void)bench.frame();
    REQUIRE(awaits_mesh(bench.state));
    take_document(bench.state.editor, SceneDocument{});
    bench.frames(2);
    CHECK(told() == 0);
}

TEST_CASE("undo while a mesh is built reverts its edit and no earlier step", "[ui][loading]") {
    const PrimitiveMesh slow{Primitive::Sphere, 2800};
    HeadlessWindow bench;
    bench.frames(2);
    bench.scene().global_ambient = glm::vec3(0.5f);
    bench.frames(2);
    const Scene before = bench.scene();
    begin_mesh(bench.state, slow, 0);
    (void)bench.frame();
    REQUIRE(awaits_mesh(bench.state));
    bench.key(Key::Z, true);
    bench.frames(2);
    bench.wait_for_loads();
    CHECK(bench.scene() == before);
    CHECK(bench.state.notifications.list.empty());
    bench.key(Key::Z, true);
    bench.frames(2);
    CHECK(bench.scene().global_ambient != before.global_ambient);
}

TEST_CASE("saving at the question about a scene whose mesh is being built keeps the scene", "[ui][loading]") {
    const TemporaryDirectory folder;
    const PrimitiveMesh slow{Primitive::Sphere, 2800};
    HeadlessWindow bench;
    bench.frames(2);
    REQUIRE(save_as(bench.state, folder.path("scene.json")));
    begin_mesh(bench.state, slow, 0);
    (void)bench.frame();
    bench.key(Key::N, true);
    bench.frames(2);
    REQUIRE(bench.state.pending.asking);
    bench.key(Key::Enter);
    REQUIRE(awaits_mesh(bench.state));
    bench.frames(2);
    CHECK(bench.scene().objects[0].source == MeshSource(slow));
    CHECK(bench.state.editor.document.path == folder.path("scene.json"));
    CHECK(bench.state.editor.unsaved());
    bench.wait_for_loads();
    bench.key(Key::N, true);
    bench.frames(2);
    bench.key(Key::Enter);
    bench.frames(2);
    CHECK(bench.state.editor.document.path.empty());
    const auto saved = parse_scene(bytes_of(folder.path("scene.json")), "scene.json");
    CHECK(std::get<Scene>(saved).objects[0].source == MeshSource(slow));
}

TEST_CASE("an object from a file is added when its mesh is loaded", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("square.obj", square_obj);
    HeadlessWindow bench;
    bench.frames(2);
    begin_mesh(bench.state, MeshFile{path}, -1);
    bench.wait_for_loads();
    REQUIRE(bench.scene().objects.size() == 2);
    CHECK(bench.scene().objects[1].mesh->face_count() == 1);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Object, 1});
    bench.frames(2);
    CHECK(bench.state.editor.history.undo_name() == "Add Square");
}

TEST_CASE("a scene stored while a mesh is built has the visible mesh and reopens", "[ui][loading][window]") {
    const TemporaryDirectory folder;
    const std::string path = folder.path("own.json");
    HeadlessWindow bench;
    bench.frames(2);
    begin_persistence(bench.state, folder.path("state"));
    REQUIRE_FALSE(save_file(bench.state.editor, path, bench.scene()));
    const Scene before = bench.scene();
    bench.scene().lights[0].intensity = 0.25f;
    bench.frames(2);
    const Scene seen = bench.scene();
    Gate gate;
    bench.state.loading.meshes = bench.state.jobs.add(gate.job(bench.state.editor.document));
    begin_mesh(bench.state, PrimitiveMesh{Primitive::Sphere, 1000}, 0);
    for (const bool is_noted : {false, true}) {  // it has no mesh yet; then the old one
        CAPTURE(is_noted);
        if (is_noted) bench.frames(2);
        REQUIRE(awaits_mesh(bench.state));
        bench.state.editor.saved = before;
        REQUIRE(keep_unsaved_work(bench.state));
        const auto copy = open_autosave(bench.state.persistence.autosave->path);
        REQUIRE(problem_of(copy) == nullptr);
        CHECK(same_description(std::get<SceneDocument>(copy).scene, seen));
        CHECK(save(bench.state));
        CHECK(same_description(std::get<SceneDocument>(open_document(path)).scene, seen));
        CHECK(bench.state.editor.unsaved());
        run_command(bench.state, CommandId::StoreB);
        CHECK(*bench.state.get<CompareState>().choice.stored == seen);
        (void)shortest_command(bench.state, [&](const SceneDocument& document, const Scene&) {
            CHECK(document.scene == seen);
            return std::string();
        });
        CHECK(document_as_made(bench.state).scene == seen);
    }
    CHECK(bench.notes_with("Saved own.json, with the mesh as it was: the new one is being built") == 1);
    CHECK(bench.notes_with("Stored as B") == 1);
    freeze(bench.state);
    CHECK(*bench.state.get<LectureState>().frozen == seen);
    bench.state.get<LectureState>().frozen.reset();
    gate.open.set_value();
    bench.wait_for_loads();
    CHECK(bench.scene().objects[0].mesh->face_count() == 1000 * 500);
    CHECK(as_made(bench.state, bench.scene()) == bench.scene());
}

TEST_CASE("saving a scene whose mesh file is missing warns that it will not open", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string mesh = folder.file("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string path =
        folder.file("own.json", R"({"glint": 1, "objects": [{"mesh": {"file": "one.obj"}}]})");
    HeadlessWindow bench;
    bench.frames(2);
    UiInput input;
    input.dropped = {path};
    (void)bench.frame(input);
    bench.wait_for_loads();
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
    CHECK(told[0].text.ends_with("The scene opens again when \"one.obj\" exists: no such file"));
    std::filesystem::create_directory(mesh);
    const auto found = saved();
    REQUIRE(found.size() == 1);
    CHECK(found[0].text.ends_with("The scene opens again when \"one.obj\" exists: it is a directory"));
}

TEST_CASE("an unreadable mesh leaves the object unchanged and reports why", "[ui][loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("none.obj", "f 1 2 3\n");
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    begin_mesh(bench.state, MeshFile{path}, 0);
    bench.wait_for_loads();
    CHECK(bench.scene() == before);
    REQUIRE(bench.state.notifications.list.size() == 1);
    CHECK(bench.state.notifications.list[0].text.find("none.obj") != std::string::npos);
    CHECK_FALSE(bench.state.editor.history.can_undo());
}

TEST_CASE("a detail of a million triangles is made in the background; the last request wins",
          "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
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

TEST_CASE("a load reports the bytes read and ends when cancelled", "[loading]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("square.obj", square_obj);
    LoadProgress progress;
    {
        const ProgressScope scope(progress);
        CHECK(problem_of(read_file(path, 1000)) == nullptr);
    }
    CHECK(progress.done == std::string(square_obj).size());
    CHECK(progress.total == progress.done);
    CHECK(progress_share(progress) == 1);
    progress.cancelled = true;
    const ProgressScope scope(progress);
    const auto read = read_file(path, 1000);
    REQUIRE(problem_of(read) != nullptr);
    CHECK(problem_of(read)->what == cancelled_words);
}
