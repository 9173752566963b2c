// Meshes are loaded once and counted once; what is not a mesh, or too large, is not read to its end.
#include "models/mesh/mesh_memory.h"

#include <fmt/core.h>

#include <filesystem>

#include "models/fields/choices.h"
#include "models/mesh_formats/mesh_file.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/gltf_triangle.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/mesh_file_bytes.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;
using test::MemoryLimit;

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t mib = std::uint64_t{1} << 20, gib = std::uint64_t{1} << 30;
constexpr const char* square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

Scene scene_of(const std::vector<MeshSource>& sources) {
    Scene scene;
    for (const MeshSource& source : sources) scene.objects.emplace_back().source = source;
    return scene;
}

/// What is wrong with reading it, where there is room for little.
std::string trouble_of(const std::string& path) {
    const Result<Mesh> mesh = read_mesh(path);
    const Problem* problem = problem_of(mesh);
    return problem != nullptr ? problem->text().substr(path.size()) : "";
}

/// A file that begins with `head` and has a hole behind it.
std::string sparse(const TemporaryDirectory& directory, const std::string& name, const std::string& head,
                   std::uint64_t size) {
    std::string path = directory.file(name, head);
    fs::resize_file(path, size);
    return path;
}

}  // namespace

TEST_CASE("a mesh file is loaded once, whatever paths lead to it", "[memory][mesh_file]") {
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
    CHECK(std::get<MeshFile>(scene.objects[3].source).path == "link.obj");  // named as it was
}

TEST_CASE("a glTF file of several parts is read once, whatever paths lead to it",
          "[memory][mesh_file][gltf]") {
    const TemporaryDirectory directory;
    std::string values = R"("extras": [0)", primitives = R"({"attributes": {"POSITION": 0}})";
    for (int i = 0; i < 20'000; ++i) values += ",[]";  // of which about 2 MiB are made
    std::string parts = primitives;
    for (int i = 1; i < 8; ++i) parts += ", " + primitives;
    std::string text = gltf_triangle::changed(primitives, parts);
    text.insert(1, values + "], ");
    (void)directory.file("parts.gltf", text);
    std::vector<MeshSource> sources;
    for (int i = 0; i < 8; ++i) {
        std::string path = "parts.gltf";
        for (int k = 0; k < i; ++k) path.insert(0, "./");
        sources.emplace_back(MeshFile{path, i});
    }
    Scene scene = scene_of(sources);
    const MemoryLimit limit(6 * mib);
    CHECK(problem_of(load_meshes(scene, "scene.json", directory.path())) == nullptr);
}

TEST_CASE("one file under two extensions is read as each says", "[memory][mesh_file]") {
    const TemporaryDirectory directory;
    (void)directory.file("square.obj", square_obj);
    fs::create_symlink("square.obj", directory.path("square.off"));
    Scene scene = scene_of({MeshFile{"square.obj"}, MeshFile{"square.off"}});
    const auto loaded = load_meshes(scene, "scene.json", directory.path());
    REQUIRE(problem_of(loaded) != nullptr);
    CHECK(problem_of(loaded)->file == directory.path("square.off"));
}

TEST_CASE("equal primitives are one mesh, others are not", "[memory][primitives]") {
    Scene scene = scene_of({PrimitiveMesh{Primitive::Teapot, 8}, PrimitiveMesh{Primitive::Teapot, 8},
                            PrimitiveMesh{Primitive::Teapot, 9}, PrimitiveMesh{Primitive::Knot, 8}});
    REQUIRE(problem_of(load_meshes(scene, "scene.json", "")) == nullptr);
    CHECK(scene.objects[1].mesh == scene.objects[0].mesh);
    CHECK(scene.objects[2].mesh != scene.objects[0].mesh);
    CHECK(scene.objects[3].mesh != scene.objects[0].mesh);
}

TEST_CASE("a mesh counts once while anybody holds it", "[memory]") {
    const std::uint64_t before = memory_left();
    MeshPtr mesh = share_mesh(make_primitive(Primitive::Teapot, 12));
    const std::uint64_t bytes = mesh_bytes(*mesh);
    CHECK(bytes > 64u * 12 * 12 * (sizeof(Triangle) + 3 * sizeof(std::uint32_t)));
    CHECK(memory_left() == before - bytes);
    MeshPtr second = mesh;
    mesh.reset();
    CHECK(memory_left() == before - bytes);
    second.reset();
    CHECK(memory_left() == before);
}

TEST_CASE("no primitive has more triangles than are counted on, nor many fewer", "[memory][primitives]") {
    const std::vector<std::string> names = names_of<Primitive>();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto primitive = static_cast<Primitive>(i);
        for (const int detail : {1, 2, 3, 5, 8, 30}) {
            if (detail > info_of(primitive).max_detail) continue;
            CAPTURE(names[i], detail);
            const std::size_t triangles = make_primitive(primitive, detail).triangles.size();
            const std::uint64_t most = info_of(primitive).max_triangles(static_cast<std::uint64_t>(detail));
            CHECK(most >= triangles);
            CHECK(most <= 2 * triangles + 256);
        }
        // Every largest one can be asked for on a machine of 8 GiB.
        CHECK(bytes_to_make(primitive, info_of(primitive).max_detail) < 6 * gib);
    }
}

TEST_CASE("primitives that do not fit together are refused before any is made", "[memory]") {
    const MemoryLimit limit(600 * mib);
    std::vector<MeshSource> sources;
    for (int i = 0; i < 8; ++i) sources.emplace_back(PrimitiveMesh{Primitive::Sphere, 1000 + i});
    Scene scene = scene_of(sources);
    const auto loaded = load_meshes(scene, "balls.json", "");
    REQUIRE(problem_of(loaded) != nullptr);
    CHECK(problem_of(loaded)->text().starts_with("balls.json: /objects/7/mesh: this needs "));
    CHECK(problem_of(loaded)->text().find("of it for the meshes; expected at most 600.0 MiB") !=
          std::string::npos);
    sources.resize(4);
    scene = scene_of(sources);
    CHECK(problem_of(load_meshes(scene, "balls.json", "")) == nullptr);
}

TEST_CASE("of a file of zeros little is read, whatever mesh its name promises", "[memory][mesh_file]") {
    const TemporaryDirectory directory;
    const std::uint64_t size = 16 * gib;
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
               is("x.stl", ": the mesh has no faces") && is("x.om", ": ");
    }));
    starts("y.obj", ":1: a word of 65536 bytes is no");
    starts("y.stl", ": the mesh has no faces");
}

TEST_CASE("a hole in the text of a mesh file ends the reading there", "[memory][mesh_file]") {
    const TemporaryDirectory directory;
    const std::string text = "# " + std::string(70000, '-') + "\nv 0 0 0\n";
    // Sanitizers note for each byte whether it may be read, which takes seconds.
    const std::uint64_t size = test::sanitized ? gib / 4 : 8 * gib;
    CHECK(trouble_of(sparse(directory, "x.obj", text, size)) ==
          ": from byte 131072 on there are only zeros; expected text");
    CHECK(trouble_of(sparse(directory, "x.stl", "solid x\n" + text, size)) ==
          ": from byte 131072 on there are only zeros; expected text");
    const std::string header = "ply\nformat ascii 1.0\ncomment " + std::string(70000, '-') + "\n";
    CHECK(trouble_of(sparse(directory, "x.ply", header, size)) ==
          ": from byte 131072 on there are only zeros; expected text");
}

TEST_CASE("a mesh file that is larger than the memory there is is not read", "[memory][mesh_file]") {
    const TemporaryDirectory directory;
    const MemoryLimit limit(100 * mib);
    const std::string path = sparse(directory, "x.obj", square_obj, 200 * mib);
    CHECK(trouble_of(path) ==
          ": this needs 200.0 MiB of memory, 200.0 MiB of it for the files that are read; expected at most "
          "100.0 "
          "MiB (--memory and GLINT_MEMORY change that)");
}

TEST_CASE("a mesh that grows beyond the memory there is ends its reading", "[memory][mesh_file]") {
    // What follows is wrong, which nobody comes to see.
    const MemoryLimit limit(2 * mib);
    const auto is_refused = [](const std::string& text) {
        const Result<Mesh> mesh = parse_mesh(text + "f 9 9 9\n", "x.obj");
        return problem_of(mesh) != nullptr &&
               problem_of(mesh)->text().find("of it for the meshes; expected at most 2.0 MiB") !=
                   std::string::npos;
    };
    std::string faces = square_obj, vertices;
    for (int i = 0; i < 200000; ++i) faces += "f 1 2 3\n";
    CHECK(is_refused(faces));
    for (int i = 0; i < 400000; ++i) vertices += "v 0 0 0\n";
    CHECK(is_refused(vertices));
}

TEST_CASE("each list of a mesh that grows is asked for before it does", "[memory][mesh_file]") {
    // What follows is wrong, which nobody comes to see.
    const auto is_refused = [](const std::string& name, const std::string& bytes, std::uint64_t room) {
        const MemoryLimit limit(room);
        const Result<Mesh> mesh = parse_mesh(bytes, name);
        const std::string text = problem_of(mesh) != nullptr ? problem_of(mesh)->text() : "";
        CAPTURE(name, text);
        CHECK(text.find("for the meshes; expected at most") != std::string::npos);
    };
    const auto times = [](int count, const std::string& text) {
        std::string all;
        for (int i = 0; i < count; ++i) all += text;
        return all;
    };
    std::string ahead = "f";
    for (int i = 1; i <= 50'000; ++i) ahead += fmt::format(" {}", i);
    is_refused("normals.obj", square_obj + times(200'000, "vn 0 0 1\n") + "x\n", 2 * mib);
    is_refused("corners.obj", square_obj + ("f" + times(200'000, " 1 2 3") + " x\n"), 2 * mib);
    is_refused("ahead.obj", ahead + " x\n", mib);
    is_refused("named.obj", square_obj + ("f" + times(50'000, " 1//1 2//1 3//1") + " x\n"), mib + mib / 2);
    is_refused("colors.obj", times(100'000, "v 0 0 0 1 1 1\n") + "x\n", 2 * mib);
    is_refused("corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n600001" + times(200'000, " 0 1 2") + " x\n",
               2 * mib);
    is_refused("normals.off", "NOFF\n100001 1 0\n" + times(100'000, "0 0 0 0 0 1\n") + "x\n", 2 * mib);
    is_refused("colors.off", "COFF\n100001 1 0\n" + times(100'000, "0 0 0 1 1 1\n") + "x\n", 2 * mib);
    const std::string places = "property float x\nproperty float y\nproperty float z\n";
    const auto ply = [&](const std::string& more) {
        return "ply\nformat ascii 1.0\nelement vertex 100001\n" + places + more + "end_header\n" +
               times(100'000, "0 0 0 0 0 1\n") + "x\n";
    };
    is_refused("normals.ply", ply("property float nx\nproperty float ny\nproperty float nz\n"), 2 * mib);
    is_refused("colors.ply", ply("property float red\nproperty float green\nproperty float blue\n"), 2 * mib);
    is_refused("corners.ply",
               "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + places +
                   "element face 1\nproperty list uint uchar vertex_indices\nend_header\n" +
                   test::Bytes(std::string(12, '\0')).u32({1'000'000}).str() + std::string(800'000, '\0'),
               2 * mib);
    const auto om = [&](const test::Bytes& after, std::uint32_t vertices) {
        return test::Bytes("OMP\x42").u32({vertices, 0, 0}).u16({0x1600}).str() +
               std::string(12 * std::size_t{vertices}, '\0') + after.str();
    };
    is_refused("places.om", om(test::Bytes(), 200'000), 2 * mib);
    is_refused("colors.om",
               om(test::Bytes(test::Bytes().u16({0x1080}).str() + std::string(300'000, '\0')), 100'000),
               2 * mib);
    test::Bytes stl(std::string(80, '\0'));
    stl.u32({10'001});
    for (int i = 0; i <= 10'000; ++i) {
        const auto x = static_cast<float>(i);
        stl.f32({0, 0, 1, x, 0, 0, x, 1, 0, x, 0, i < 10'000 ? 1 : 1e38f}).u16({0});
    }
    is_refused("places.stl", stl.str(), mib);
}

TEST_CASE("of corners that name vertices ahead only those are kept that may be the first out of range",
          "[memory][mesh_file][obj]") {
    std::string faces, vertices;
    for (int i = 0; i < 20'000; ++i) faces += "f 9 8 7\n";
    for (int i = 0; i < 9; ++i) vertices += fmt::format("v {} {} 0\n", i, i * i);
    const MemoryLimit limit(mib);
    CHECK(problem_of(parse_mesh(faces + vertices, "x.obj")) == nullptr);
    const auto line_of = [&](const std::string& text) {
        const Result<Mesh> mesh = parse_mesh(text + vertices, "x.obj");
        return problem_of(mesh) != nullptr ? problem_of(mesh)->text() : "";
    };
    CHECK(line_of("f 9 8 7\nf 1 12 3\nf 14 11 10\n").starts_with("x.obj:2: vertex index 12 is out of range"));
    CHECK(line_of("f 9 8 7\nf 1 2 3\nf 1 14 2\nf 20 1 2\n")
              .starts_with("x.obj:3: vertex index 14 is out of range"));
}

TEST_CASE("the triangles of a mesh are asked for before they are made", "[memory][mesh_file]") {
    std::string fan = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 4000; ++i) fan += "f 1 2 3\n";  // a list of which is made where no face is looked at
    const MemoryLimit limit(100 << 10);
    const Result<Mesh> mesh = parse_mesh(fan, "x.obj");
    REQUIRE(problem_of(mesh) != nullptr);
    CHECK(problem_of(mesh)->text().find("of it for the meshes; expected at most") != std::string::npos);
}

TEST_CASE("a picture or a scene that is none is not read to its end", "[memory]") {
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

TEST_CASE("a picture that does not fit in memory is refused by its header", "[memory]") {
    const TemporaryDirectory directory;
    Picture picture{{2000, 2000}, std::vector<std::uint8_t>(std::size_t{4} * 2000 * 2000, 7), {}};
    const std::string path = directory.file("p.png", png_bytes(picture, ""));
    const MemoryLimit limit(10 * mib);
    const auto read = read_png(path);
    REQUIRE(problem_of(read) != nullptr);
    CHECK(problem_of(read)->text().find("15.3 MiB of it for the pixels and samples of the picture") !=
          std::string::npos);
}
