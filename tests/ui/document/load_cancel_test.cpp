// Every part of a load can be cancelled. An uncancelled load would reject each input here with another
// message, so the message shows that the part in question was cancelled.
#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/primitives/primitives.h"
#include "models/progress.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_file_bytes.h"
#include "tests/support/program.h"
#include "ui/document/loading.h"

using namespace glint;

namespace {

/// The message of a load of these bytes that was cancelled before it began.
std::string cancelled_words_of(const std::string& name, const std::string& bytes) {
    LoadProgress progress;
    progress.cancelled = true;
    const ProgressScope scope(progress);
    const Result<Mesh> result = parse_mesh(bytes, name);
    return problem_of(result) == nullptr ? "read" : problem_of(result)->what;
}

std::string times(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

/// `count` arrowheads, which are not convex, on the same five positions.
std::string arrowheads(int count) {
    return "v 0 0 0\nv 4 -2 0\nv 1 0 0\nv 4 2 0\nv 3 3 3\n" + times("f 1 2 3 4\n", count);
}

}  // namespace

TEST_CASE("parsing can be cancelled in every part of every format", "[loading][cancel]") {
    const std::string ply_head = "ply\nformat ascii 1.0\n",
                      xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string binary_head =
        "ply\nformat binary_little_endian 1.0\nelement vertex 99999\n" + xyz + face;
    struct Row {
        std::string name, bytes;
    };
    const std::vector<Row> table{
        {"vertices.obj", times("v 0 0 0\n", 20000)},
        {"comments.obj", times("# nothing\n", 20000)},
        {"one_face.obj", "v 0 0 0\nf" + times(" 1", 100000) + " 2\n"},
        {"header.ply", ply_head + times("comment nothing\n", 20000)},
        {"elements.ply", ply_head +
                             [] {
                                 std::string names;
                                 for (int i = 0; i < 20000; ++i) names += fmt::format("element e{} 0\n", i);
                                 return names;
                             }()},
        {"vertices.ply", ply_head + "element vertex 99999\n" + xyz + face + times("0 0 0\n", 30000)},
        {"binary.ply", binary_head + std::string(12 * 30000, '\0')},
        {"vertices.off", "OFF 99999 1 0\n" + times("0 0 0\n", 30000)},
        {"ascii.stl",
         "solid\n" + times("facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                           "endloop\nendfacet\n",
                           2000)},
        {"binary.stl", std::string(80, ' ') + std::string("\xd0\x07\0\0", 4) + std::string(50 * 2000, '\0')},
    };
    for (const Row& row : table) {
        INFO(row.name);
        CHECK(cancelled_words_of(row.name, row.bytes) == cancelled_words);
        CHECK(test::error_of(row.name, row.bytes).find(cancelled_words) == std::string::npos);
    }
    // A scene too: this one has an unknown key.
    LoadProgress progress;
    progress.cancelled = true;
    const ProgressScope scope(progress);
    const Result<Scene> scene = parse_scene("{\"x\": [" + times("0, ", 50000) + "0]}", "s.json");
    REQUIRE(problem_of(scene) != nullptr);
    CHECK(problem_of(scene)->what == cancelled_words);
}

TEST_CASE("cutting polygons and making primitives report faces and can be cancelled", "[loading][cancel]") {
    Mesh mesh = test::read_text("m.obj", arrowheads(20000));
    LoadProgress progress;
    {
        const ProgressScope scope(progress);
        finish_mesh(mesh);
        CHECK(progress.stage == LoadStage::Building);
        CHECK(progress.done > 10000);
        CHECK(progress.total == 20000);
        CHECK(progress_words(progress).find("of 20000 faces") != std::string::npos);
    }
    progress.cancelled = true;
    const ProgressScope scope(progress);
    CHECK_THROWS_AS(finish_mesh(mesh), LoadCancelled);
    CHECK_THROWS_AS(make_primitive(Primitive::Plane, 2000), LoadCancelled);
    Scene scene;
    Object object;
    object.source = PrimitiveMesh{Primitive::Cube, 1};  // after cancelling no further small one is made
    scene.objects.push_back(object);
    const Result<Warnings> loaded = load_meshes(scene, "s.json", "");
    REQUIRE(problem_of(loaded) != nullptr);
    CHECK(problem_of(loaded)->what == cancelled_words);
}

TEST_CASE("a load that is cancelled while polygons are cut returns no mesh", "[loading][cancel]") {
    // About 20 corners per face, each on a spiral that no fan covers: cutting takes most of the time.
    std::string obj;
    for (int i = 0; i < 300; ++i)
        obj += i % 2 == 0 ? fmt::format("v {} 0 0\n", i / 2)
                          : fmt::format("v {} {} 0\n", 150 - 0.5 * (i % 3), 5 + i % 7);
    std::string face = "f";
    for (int i = 1; i <= 300; ++i) face += fmt::format(" {}", i);
    const TemporaryDirectory directory;
    const std::string path = directory.file("m.obj", obj + times(face + "\n", 3000));
    LoadJob job("m.obj", [path](LoadProgress&) { return open_document(path); });
    while (job.progress().stage != LoadStage::Building && !job.done()) std::this_thread::yield();
    job.cancel();
    while (!job.done()) std::this_thread::yield();
    const Result<SceneDocument> result = job.take();
    REQUIRE(problem_of(result) != nullptr);
    CHECK(problem_of(result)->what == cancelled_words);
}
