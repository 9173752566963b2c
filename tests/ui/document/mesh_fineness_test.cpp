// A mesh made finer and coarser by hand, and a scene of glTF in the window.
#include <fmt/format.h>

#include <cmath>

#include "models/gltf/gltf.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Drags a slider by a share of its width.
void slide(HeadlessWindow& bench, std::string_view key, float share) {
    const Rect area = bench.area_of(key);
    const ImVec2 from = HeadlessWindow::middle_of(area);
    bench.drag(from, {from.x + share * (area.high.x - area.low.x), from.y});
    bench.wait_for_loads();
}

}  // namespace

TEST_CASE("an object's panel makes its mesh coarser and finer, each as one step", "[ui][loading]") {
    HeadlessWindow bench;
    bench.frames(2);
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    const auto triangles = [&bench] { return bench.scene().objects[0].mesh->triangles.size(); };
    const std::size_t given = triangles();
    const std::size_t faces = bench.scene().objects[0].mesh->face_count();
    REQUIRE(given > 500);

    slide(bench, "/objects/0/mesh/decimate", -0.3f);  // of a slider by powers
    const int wanted = fineness_of(bench.scene().objects[0].source).decimate;
    CHECK(wanted > 4);
    CHECK(static_cast<std::size_t>(wanted) < given);
    CHECK(triangles() <= static_cast<std::size_t>(wanted));
    CHECK(bench.scene().objects[0].mesh->given_triangles == given);
    CHECK(bench.state.editor.history.undo_name() == "Mesh of Ball");

    slide(bench, "/objects/0/mesh/decimate", 0.6f);  // to its end: all again
    CHECK(fineness_of(bench.scene().objects[0].source).decimate == 0);
    CHECK(triangles() == given);

    slide(bench, "/objects/0/mesh/subdivide", 0.13f);  // an eighth of it
    CHECK(fineness_of(bench.scene().objects[0].source).subdivide == 1);
    CHECK(bench.scene().objects[0].mesh->face_count() >= 4 * faces - 2 * given);
    CHECK(bench.scene().objects[0].mesh->face_count() > 3 * faces);

    // What would be too large leaves the mesh and says why.
    const MeshPtr before = bench.scene().objects[0].mesh;
    slide(bench, "/objects/0/mesh/subdivide", 1);
    CHECK(bench.scene().objects[0].mesh == before);
    REQUIRE_FALSE(bench.state.notifications.list.empty());
    CHECK(bench.state.notifications.list.back().text.find("at most 8388608") != std::string::npos);
}

TEST_CASE("what decimating has to say stands in the panel, not over the picture", "[ui][loading]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    bench.frames(2);
    // A disc whose rim cannot go: 24 corners on a circle round its middle.
    std::string disc = "v 0 0 0\n";
    for (int i = 0; i < 24; ++i)
        disc += fmt::format("v {} {} 0\n", std::cos(i * 0.2618), std::sin(i * 0.2618));
    for (int i = 0; i < 24; ++i) disc += fmt::format("f 1 {} {}\n", i + 2, (i + 1) % 24 + 2);
    begin_open(bench.state, folder.file("disc.obj", disc));
    bench.wait_for_loads();
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    bench.state.notifications.list.clear();
    slide(bench, "/objects/0/mesh/decimate", -0.9f);
    REQUIRE(bench.scene().objects[0].mesh->given_triangles == 24);
    CHECK_FALSE(bench.scene().objects[0].mesh->warnings.empty());
    CHECK(bench.state.notifications.list.empty());
}

TEST_CASE("a glTF file opens in the window as a scene", "[ui][loading]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    bench.frames(2);
    const auto written = glb_of(bench.scene(), "first");
    const std::string path = folder.file("first.glb", std::get<GltfWritten>(written).bytes);
    const std::size_t objects = bench.scene().objects.size();
    begin_open(bench.state, path);
    bench.wait_for_loads();
    CHECK(bench.state.editor.document.path == path);
    CHECK(bench.scene().shading.reflection == Reflection::CookTorrance);
    CHECK(bench.scene().objects.size() == objects);
    CHECK_FALSE(bench.state.editor.unsaved());
}
