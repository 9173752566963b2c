// A mesh that takes long to make, and edits of the scene in the meantime.
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
using test::HeadlessWindow;

namespace {

const PrimitiveMesh slow_ball{Primitive::Sphere, 8, 0, 6};

Object primitive_object(const char* name, Primitive primitive) {
    Object object;
    object.name = name;
    object.source = PrimitiveMesh{primitive, 4};
    return object;
}

Scene with_meshes_of(const std::vector<MeshSource>& sources) {
    Scene scene;
    for (const MeshSource& source : sources) {
        Object object;
        object.source = source;
        object.mesh = std::make_shared<const Mesh>(make_primitive(Primitive::Sphere, 5));
        scene.objects.push_back(object);
    }
    return scene;
}

/// Replaces the load of all awaited meshes: ends on request, with a result chosen by the test.
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

void begin_orbit(HeadlessWindow& bench) {
    bench.move(bench.at_pixel({20, 200}));
    bench.button(true);
    bench.move(bench.at_pixel({90, 230}));
    REQUIRE(bench.state.viewport.gesture == Gesture::Orbit);
}

void end_during_orbit(HeldLoad& load, HeadlessWindow& bench) {
    begin_orbit(bench);
    load.end();
    bench.frames(2);
}

void escape_orbit(HeadlessWindow& bench) {
    bench.key(Key::Escape);
    bench.button(false);
    bench.frames(3);
}

}  // namespace

TEST_CASE("an object waiting for a mesh keeps its own while the list changes before it", "[ui][loading]") {
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

TEST_CASE("Esc during a drag reverts the drag, but not a mesh that arrived during it", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    const Scene come = with_meshes_of({slow_ball});
    begin_mesh(bench.state, slow_ball, 0);
    HeldLoad load(bench, SceneDocument{come, {}, {}, {}});
    end_during_orbit(load, bench);
    REQUIRE_FALSE(bench.scene().camera == before.camera);
    escape_orbit(bench);
    CHECK(bench.scene().camera == before.camera);
    CHECK(bench.scene().objects[0].source == MeshSource(slow_ball));
    CHECK(bench.scene().objects[0].mesh == come.objects[0].mesh);
    CHECK_FALSE(bench.state.loading.active());
    CHECK(bench.state.editor.history.undo_name() == "Mesh of Ball");
}

TEST_CASE("Esc during a drag keeps an object whose mesh arrived during it", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
    begin_mesh(bench.state, slow_ball, -1);
    HeldLoad load(bench, SceneDocument{with_meshes_of({slow_ball}), {}, {}, {}});
    end_during_orbit(load, bench);
    escape_orbit(bench);
    REQUIRE(bench.scene().objects.size() == 2);
    CHECK(bench.scene().objects[1].source == MeshSource(slow_ball));
}

TEST_CASE("Esc during a drag does not retry a mesh that failed during it", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    begin_mesh(bench.state, slow_ball, 0);
    HeldLoad load(bench, Problem{"ball", "", "is too large", ""});
    end_during_orbit(load, bench);
    escape_orbit(bench);
    CHECK(bench.scene() == before);
    CHECK(bench.state.notifications.list.size() == 1);
}

TEST_CASE("a scene restored because the next cannot be drawn waits for no mesh", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    begin_mesh(bench.state, slow_ball, 0);
    const HeldLoad load(bench, SceneDocument{});
    SceneDocument next = first_scene();
    next.path = "next.json";
    next.scene.objects[0].mesh = std::make_shared<const Mesh>(make_primitive(Primitive::Sphere, 400));
    bench.state.loading.scene_then = bench.scene();
    bench.state.loading.document =
        bench.state.jobs.start<SceneDocument>("next.json", [next](LoadProgress&) { return next; });
    while (!bench.state.loading.document->done()) std::this_thread::yield();
    set_memory_limit(test::cost_of(before, bench.state.rendered->size));
    (void)bench.frame();
    set_memory_limit(0);
    CHECK(bench.state.editor.document.path.empty());
    CHECK(bench.scene() == before);
    CHECK_FALSE(awaits_mesh(bench.state));
}

TEST_CASE("redo waits for a mesh being built and loses no later edits", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
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
    CHECK(why_disabled(bench.state, redo_it) == "A mesh is being built: wait for it, or Esc");
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

TEST_CASE("a mesh chosen in the dialog becomes a step when loaded, none if unreadable", "[ui][loading]") {
    const TemporaryDirectory folder;
    (void)folder.file("good.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    (void)folder.file("bad.obj", "f 1 2 3\n");
    for (const char* const name : {"bad.obj", "good.obj"}) {
        CAPTURE(name);
        HeadlessWindow bench;
        bench.frames(2);
        const Scene before = bench.scene();
        bench.state.mesh_for_object = 0;
        bench.state.files.ask(mesh_purpose, "");
        bench.state.files.folder = folder.path();
        bench.state.files.name = name;  // before its field has focus
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

TEST_CASE("undo while a mesh is built keeps the view, and later edits can be redone", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    begin_mesh(bench.state, slow_ball, 0);
    const HeldLoad load(bench, SceneDocument{});
    bench.scene().camera.eye.x += 2;
    bench.scene().lights[0].intensity = 0.25f;
    bench.frames(2);
    REQUIRE(awaits_mesh(bench.state));
    Scene seen = before, edited = bench.scene();
    seen.camera = edited.camera;
    edited.objects = before.objects;  // except the mesh, which is not ready
    bench.key(Key::Z, true);
    bench.frames(2);
    CHECK_FALSE(awaits_mesh(bench.state));
    CHECK(bench.scene() == seen);
    CHECK(bench.state.editor.views.can_go_back());
    bench.key(Key::Y, true);
    bench.frames(2);
    CHECK(bench.scene() == edited);
}
