// Tests for features that other programs would draw incorrectly: each finding is tested on the smallest mesh
// file that has it.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/primitives/primitives.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/mesh_file_bytes.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;
using test::read_text;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The finding of that name, or an empty one.
MeshFinding finding(const Mesh& mesh, std::string_view name) {
    const MeshInfo info = mesh_info(mesh);
    const auto found = std::find_if(info.findings.begin(), info.findings.end(),
                                    [&](const MeshFinding& f) { return f.name == name; });
    return found == info.findings.end() ? MeshFinding{} : *found;
}
MeshFinding finding(const std::string& obj, std::string_view name) {
    return finding(read_text("m.obj", obj), name);
}

}  // namespace

TEST_CASE("normals that point against their face are counted by face", "[mesh_info]") {
    const MeshFinding found = finding(square + "vn 0 0 1\nvn 0 0 -1\nf 1//1 2//1 3//1\nf 1//1 3//2 4//1\n",
                                      "normals_against_faces");
    CHECK(found.count == 1);
    CHECK(found.what == "1 of 2 faces have normals that point the opposite way");
    REQUIRE(found.places.size() == 1);
    CHECK(found.places[0].x == Approx(1 / 3.0));
    CHECK(finding(square + "vn 0 0 1\nf 1//1 2//1 3//1\n", "normals_against_faces").count == 0);
}

TEST_CASE("oppositely wound neighbours are counted by edge", "[mesh_info]") {
    const MeshFinding found = finding(square + "f 1 2 3\nf 1 4 3\n", "opposite_winding");
    CHECK(found.count == 1);
    CHECK(found.what == "1 edge joins faces that are wound in opposite directions");
    CHECK(found.places == std::vector<glm::vec3>{{0.5f, 0.5f, 0}});
    CHECK(finding(square + "f 1 2 3\nf 1 3 4\n", "opposite_winding").count == 0);
}

TEST_CASE("vertices at the same position as another vertex are counted", "[mesh_info]") {
    const MeshFinding found = finding(square + "v 0 0 0\nf 1 2 3\nf 5 3 4\n", "unwelded_vertices");
    CHECK(found.count == 1);
    CHECK(found.places == std::vector<glm::vec3>{{0, 0, 0}});
    CHECK(finding(square + "v 0 0 0\nf 1 2 3\nf 5 3 4\n", "open_edges").count ==
          4);  // the diagonal is not open
}

TEST_CASE("zero, invalid and non-unit normals are counted separately", "[mesh_info]") {
    const std::string obj = square + "vn 0 0 0\nvn nan 0 1\nvn 0 0 2\nvn 0 0 1.005\nf 1//1 2//2 3//3 4//4\n";
    CHECK(finding(obj, "zero_normals").what == "2 of 4 normals are zero or missing");
    CHECK(finding(obj, "invalid_normals").what == "1 of 4 normals are not finite");
    CHECK(finding(obj, "non_unit_normals").places == std::vector<glm::vec3>{{1, 1, 0}});
}

TEST_CASE("degenerate and duplicate faces, open and non-manifold edges are findings", "[mesh_info]") {
    const std::string obj = square + "v 0 0 1\nf 1 2 3\nf 2 3 1\nf 1 3 4\nf 1 1 2\nf 1 3 5\n";
    CHECK(finding(obj, "degenerate_faces").count == 1);
    CHECK(finding(obj, "duplicate_faces").count == 1);
    CHECK(finding(obj, "non_manifold_edges").count == 2);
    CHECK(finding(obj, "open_edges").count == 4);
}

TEST_CASE("different indices for normals and for positions are a finding", "[mesh_info]") {
    const MeshFinding found = finding(square + "vn 0 0 1\nf 1//1 2//1 3//1\n", "own_normal_indices");
    CHECK(found.what == "positions and normals have different indices: 3 pairs of 4 positions and 1 normals");
    CHECK(finding("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1//1 2//2 3//3\n",
                  "own_normal_indices")
              .count == 0);
}

TEST_CASE("a mesh's size and distance from the origin hint at its units", "[mesh_info]") {
    CHECK(finding("v 0 0 0\nv 3000 0 0\nv 0 4000 0\nf 1 2 3\n", "size").what ==
          "the shape is 5e+03 units in size");
    CHECK(finding("v 0 0 9\nv 1 0 9\nv 0 1 9\nf 1 2 3\n", "far_from_origin").count == 1);
    CHECK(finding(square + "f 1 2 3\n", "size").count == 0);
    CHECK(finding(square + "f 1 2 3\n", "far_from_origin").count == 0);
}

TEST_CASE("a closed primitive has no findings", "[mesh_info]") {
    CHECK(mesh_info(make_primitive(Primitive::Torus, 24)).findings.empty());
}

// The sources of meshes: each is loaded once, and a file that is not a mesh, or too large, is rejected early.
namespace {

namespace fs = std::filesystem;

constexpr const char* square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

Scene scene_of(const std::vector<MeshSource>& sources) {
    Scene scene;
    for (const MeshSource& source : sources) scene.objects.emplace_back().source = source;
    return scene;
}

}  // namespace

TEST_CASE("a mesh file is loaded once, whichever paths name it", "[mesh_file]") {
    const TemporaryDirectory directory;
    (void)directory.file("square.obj", square_obj);
    fs::create_symlink("square.obj", directory.path("link.obj"));
    fs::create_hard_link(directory.path("square.obj"), directory.path("same.obj"));
    (void)directory.file("copy.obj", square_obj);
    Scene scene = scene_of({MeshFile{"square.obj"}, MeshFile{"./square.obj"}, MeshFile{"././square.obj"},
                            MeshFile{"link.obj"}, MeshFile{"same.obj"},
                            MeshFile{directory.path("square.obj")}, MeshFile{"copy.obj"}});
    REQUIRE(problem_of(load_meshes(scene, "scene.json", directory.path())) == nullptr);
    for (std::size_t i = 1; i < 6; ++i) CHECK(scene.objects[i].mesh == scene.objects[0].mesh);
    CHECK(scene.objects[6].mesh != scene.objects[0].mesh);
    CHECK(std::get<MeshFile>(scene.objects[3].source).path == "link.obj");  // each object keeps its own path
}

TEST_CASE("equal primitives share one mesh, others do not", "[primitives]") {
    Scene scene = scene_of({PrimitiveMesh{Primitive::Teapot, 8}, PrimitiveMesh{Primitive::Teapot, 8},
                            PrimitiveMesh{Primitive::Teapot, 9}, PrimitiveMesh{Primitive::Knot, 8}});
    REQUIRE(problem_of(load_meshes(scene, "scene.json", "")) == nullptr);
    CHECK(scene.objects[1].mesh == scene.objects[0].mesh);
    CHECK(scene.objects[2].mesh != scene.objects[0].mesh);
    CHECK(scene.objects[3].mesh != scene.objects[0].mesh);
}
