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

constexpr std::uint64_t mib = std::uint64_t{1} << 20, gib = std::uint64_t{1} << 30;
constexpr const char* square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

Scene scene_of(const std::vector<MeshSource>& sources) {
    Scene scene;
    for (const MeshSource& source : sources) scene.objects.emplace_back().source = source;
    return scene;
}

/// The problem with reading the file, without its path.
std::string trouble_of(const std::string& path) {
    const Result<Mesh> mesh = read_mesh(path);
    const Problem* problem = problem_of(mesh);
    return problem != nullptr ? problem->text().substr(path.size()) : "";
}

/// A file with the beginning `head`, followed by a hole.
std::string sparse(const TemporaryDirectory& directory, const std::string& name, const std::string& head,
                   std::uint64_t size) {
    std::string path = directory.file(name, head);
    fs::resize_file(path, size);
    return path;
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

TEST_CASE("one file under two extensions is read in both formats", "[mesh_file]") {
    const TemporaryDirectory directory;
    (void)directory.file("square.obj", square_obj);
    fs::create_symlink("square.obj", directory.path("square.off"));
    Scene scene = scene_of({MeshFile{"square.obj"}, MeshFile{"square.off"}});
    const auto loaded = load_meshes(scene, "scene.json", directory.path());
    REQUIRE(problem_of(loaded) != nullptr);
    CHECK(problem_of(loaded)->file == directory.path("square.off"));
}

TEST_CASE("equal primitives are one mesh, others are not", "[primitives]") {
    Scene scene = scene_of({PrimitiveMesh{Primitive::Teapot, 8}, PrimitiveMesh{Primitive::Teapot, 8},
                            PrimitiveMesh{Primitive::Teapot, 9}, PrimitiveMesh{Primitive::Knot, 8}});
    REQUIRE(problem_of(load_meshes(scene, "scene.json", "")) == nullptr);
    CHECK(scene.objects[1].mesh == scene.objects[0].mesh);
    CHECK(scene.objects[2].mesh != scene.objects[0].mesh);
    CHECK(scene.objects[3].mesh != scene.objects[0].mesh);
}

TEST_CASE("a file of zeros is rejected early under every mesh extension", "[mesh_file]") {
    const TemporaryDirectory directory;
    const std::uint64_t size = 2 * gib;
    const auto starts = [&directory](const char* name, const char* text) {
        const std::string trouble = trouble_of(sparse(directory, name, "", size));
        CAPTURE(name, trouble);
        CHECK(trouble.starts_with(text));
    };
    if (test::sanitized) return;
    CHECK(test::in_process_with_room(512 * mib, [&] {
        const auto is = [&](const char* name, const char* text) {
            return trouble_of(sparse(directory, name, "", size)).starts_with(text);
        };
        return is("x.obj", ":1: a word of 65536 bytes is no") && is("x.ply", ":1: ") && is("x.off", ":1: ") &&
               is("x.stl", ": the mesh has no faces");
    }));
    starts("y.obj", ":1: a word of 65536 bytes is no");
    starts("y.stl", ": the mesh has no faces");
}

TEST_CASE("a mesh file of more than 2 GiB is refused", "[mesh_file]") {
    const TemporaryDirectory directory;
    for (const char* const name : {"x.obj", "x.glb"})
        CHECK(trouble_of(sparse(directory, name, square_obj, 2 * gib + 1)) ==
              ": is too long; expected at most 2147483648 bytes");
}

TEST_CASE("a hole in the text of a mesh file stops the reading", "[mesh_file]") {
    const TemporaryDirectory directory;
    const std::string text = "# " + std::string(70000, '-') + "\nv 0 0 0\n";
    // Sanitizers track for each byte whether it may be read, which takes seconds.
    const std::uint64_t size = test::sanitized ? gib / 4 : 2 * gib;
    CHECK(trouble_of(sparse(directory, "x.obj", text, size)) ==
          ": from byte 131072 on there are only zeros; expected text");
    CHECK(trouble_of(sparse(directory, "x.stl", "solid x\n" + text, size)) ==
          ": from byte 131072 on there are only zeros; expected text");
    const std::string header = "ply\nformat ascii 1.0\ncomment " + std::string(70000, '-') + "\n";
    CHECK(trouble_of(sparse(directory, "x.ply", header, size)) ==
          ": from byte 131072 on there are only zeros; expected text");
}

TEST_CASE("only corners that may be the first out of range are kept while reading an OBJ",
          "[mesh_file][obj]") {
    std::string faces, vertices;
    for (int i = 0; i < 20'000; ++i) faces += "f 9 8 7\n";
    for (int i = 0; i < 9; ++i) vertices += fmt::format("v {} {} 0\n", i, i * i);
    CHECK(problem_of(parse_mesh(faces + vertices, "x.obj")) == nullptr);
    const auto line_of = [&](const std::string& text) {
        const Result<Mesh> mesh = parse_mesh(text + vertices, "x.obj");
        return problem_of(mesh) != nullptr ? problem_of(mesh)->text() : "";
    };
    CHECK(line_of("f 9 8 7\nf 1 12 3\nf 14 11 10\n").starts_with("x.obj:2: vertex index 12 is out of range"));
    CHECK(line_of("f 9 8 7\nf 1 2 3\nf 1 14 2\nf 20 1 2\n")
              .starts_with("x.obj:3: vertex index 14 is out of range"));
}

TEST_CASE("a file that is not a picture or a scene is rejected early", "[memory]") {
    const TemporaryDirectory directory;
    const std::string png = sparse(directory, "x.png", "", 2 * gib),
                      json = sparse(directory, "x.json", "{", gib);
    const auto says = [](const auto& result, const std::string& words) {
        return problem_of(result) != nullptr && problem_of(result)->text().find(words) != std::string::npos;
    };
    const auto all = [&] {
        return says(open_document(png), "is not a PNG picture") &&
               says(read_png(png), "cannot be read as a PNG") && says(open_document(json), "is too long");
    };
    CHECK(all());
    if (!test::sanitized) CHECK(test::in_process_with_room(256 * mib, all));
}
