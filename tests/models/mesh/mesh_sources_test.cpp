// The sources of meshes: each is loaded once, and a file that is not a mesh, or too large, is rejected early.

#include <fmt/core.h>

#include <filesystem>

#include "models/mesh/formats/mesh_file.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;

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
    CHECK(std::get<MeshFile>(scene.objects[3].source).path == "link.obj");  // its path is kept
}

TEST_CASE("equal primitives share one mesh; others do not", "[primitives]") {
    Scene scene = scene_of({PrimitiveMesh{Primitive::Teapot, 8}, PrimitiveMesh{Primitive::Teapot, 8},
                            PrimitiveMesh{Primitive::Teapot, 9}, PrimitiveMesh{Primitive::Knot, 8}});
    REQUIRE(problem_of(load_meshes(scene, "scene.json", "")) == nullptr);
    CHECK(scene.objects[1].mesh == scene.objects[0].mesh);
    CHECK(scene.objects[2].mesh != scene.objects[0].mesh);
    CHECK(scene.objects[3].mesh != scene.objects[0].mesh);
}
