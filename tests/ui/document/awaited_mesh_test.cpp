// A mesh that takes a long time to build, and edits to the scene in the meantime.
#include <future>
#include <thread>

#include "models/memory_limit.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "ui/document/document_actions.h"
#include "ui/document/loading.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

const PrimitiveMesh slow_ball{Primitive::Sphere, 8, 0, 6};

Object primitive_object(const char* name, Primitive primitive) {
    Object object;
    object.name = name;
    object.source = PrimitiveMesh{primitive, 4};
    return object;
}

/// Replaces the loading of all awaited meshes with a load that ends on request, with the given result.
class HeldLoad {
  public:
    HeldLoad(HeadlessWindow& bench, const Result<SceneDocument>& result) : bench_(bench) {
        bench.state.loading.meshes = bench.state.jobs.start<SceneDocument>(
            "slow", [opened = open_.get_future().share(), result](LoadProgress&) {
                opened.wait();
                return result;
            });
        (void)bench.frame();
    }
    ~HeldLoad() {
        if (!is_open_) open_.set_value();
    }
    HeldLoad(const HeldLoad&) = delete;
    HeldLoad& operator=(const HeldLoad&) = delete;

    void end() {
        open_.set_value();
        is_open_ = true;
        while (!bench_.state.loading.meshes->done()) std::this_thread::yield();
    }

  private:
    HeadlessWindow& bench_;
    std::promise<void> open_;
    bool is_open_ = false;
};

}  // namespace

TEST_CASE("a loading mesh still reaches its object if earlier objects are added or deleted",
          "[ui][loading]") {
    const TemporaryDirectory folder;
    const bool deletes = GENERATE(true, false);
    CAPTURE(deletes);
    HeadlessWindow bench;
    Scene& scene = bench.scene();
    scene.objects = {primitive_object("Aaa", Primitive::Teapot), primitive_object("Bbb", Primitive::Cube),
                     primitive_object("Ccc", Primitive::Sphere)};
    bench.frames(2);
    const std::vector<Object> before = scene.objects;
    begin_mesh(bench.state, slow_ball, 2);
    const HeldLoad load(bench, SceneDocument{});
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.key(deletes ? Key::Delete : Key::D, !deletes);
    const std::size_t b = deletes ? 0 : 2;
    REQUIRE(scene.objects[b].name == "Bbb");
    const auto saved_as_made = [&] {
        REQUIRE(save_as(bench.state, folder.path("saved.json")));
        const auto saved =
            std::get<Scene>(parse_scene(bytes_of(folder.path("saved.json")), "saved.json")).objects;
        CHECK(saved[b].source == before[1].source);
        CHECK(saved[b + 1].source == before[2].source);
    };
    for (const int subdivide : {7, 6}) {  // changed again before it was ready
        begin_mesh(bench.state, PrimitiveMesh{Primitive::Cube, 4, 0, subdivide}, static_cast<int>(b));
        saved_as_made();
        bench.frames(2);
        CHECK(scene.objects[b].mesh == before[1].mesh);
        CHECK(scene.objects[b + 1].mesh == before[2].mesh);
        saved_as_made();
    }
    bench.key(Key::Escape);
    CHECK(scene.objects[b] == before[1]);
    CHECK(scene.objects[b + 1] == before[2]);
}

TEST_CASE("redo waits for a mesh being built and loses no later edits", "[ui][loading]") {
    DrawnWindow bench;
    bench.scene().shading.mode = ShadingMode::Flat;
    bench.frames(2);
    bench.key(Key::Z, true);
    bench.frames(2);
    const Scene before = bench.scene();
    const WindowCommand& redo_it = command(CommandId::Redo);
    begin_mesh(bench.state, slow_ball, 0);
    const HeldLoad load(bench, SceneDocument{});
    bench.scene().lights[0].intensity = 0.25f;
    bench.frames(2);
    const Scene edited = bench.scene();
    CHECK(why_disabled(bench.state, redo_it) == "A mesh is being built: wait for it, or press Esc");
    bench.key(Key::Y, true);
    bench.frames(2);
    CHECK(bench.scene() == edited);
    bench.scene().lights[0].intensity = before.lights[0].intensity;
    bench.key(Key::Escape);
    bench.frames(2);
    CHECK(why_disabled(bench.state, redo_it).empty());
    bench.key(Key::Y, true);
    bench.frames(2);
    CHECK(bench.scene().shading.mode == ShadingMode::Flat);
}

TEST_CASE("choosing a mesh is one undo step once it loads, and no step if it is unreadable",
          "[ui][loading]") {
    const TemporaryDirectory folder;
    (void)folder.file("good.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    (void)folder.file("bad.obj", "f 1 2 3\n");
    for (const char* const name : {"bad.obj", "good.obj"}) {
        CAPTURE(name);
        DrawnWindow bench;
        const Scene before = bench.scene();
        bench.state.mesh_for_object = 0;
        bench.state.files.ask(mesh_purpose, "");
        bench.state.files.folder = folder.path();
        bench.state.files.name = name;  // set before the name field has focus
        bench.frames(2);
        bench.key(Key::Enter);
        REQUIRE_FALSE(bench.state.files.open);
        CHECK(bench.scene().objects[0].source == MeshSource(MeshFile{folder.path(name)}));
        CHECK_FALSE(bench.state.editor.history.can_undo());
        bench.wait_for_loads();
        bench.frames(3);
        if (name == std::string("good.obj")) {
            CHECK(bench.state.editor.history.undo_name() == "Mesh of Ball");
            bench.key(Key::Z, true);
        } else {
            CHECK(bench.state.notifications.list.size() == 1);
        }
        bench.frames(2);
        CHECK(bench.scene() == before);
        CHECK_FALSE(bench.state.editor.history.can_undo());
    }
}

TEST_CASE("a problem with the mesh of a new object names the mesh, not the object's index", "[ui][loading]") {
    DrawnWindow bench;
    const test::MemoryLimit limit(64 << 20);
    begin_mesh(bench.state, PrimitiveMesh{Primitive::Sphere, 2000}, -1);
    bench.wait_for_loads();
    bench.frames(3);
    REQUIRE(bench.state.notifications.list.size() == 1);
    CHECK(bench.state.notifications.list[0].text.starts_with("sphere: this needs"));
}
