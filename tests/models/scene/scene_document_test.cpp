// Reading and writing scenes: finding meshes, pictures with an embedded scene, saving elsewhere.
#include <zlib.h>

#include <cstdint>
#include <filesystem>

#include "models/io/file.h"
#include "models/io/png_info.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;
namespace fs = std::filesystem;

namespace {

/// A directory with triangle.obj and deep/broken.obj.
struct Place {
    TemporaryDirectory directory;
    fs::path path = directory.path();
    Place() {
        fs::create_directories(path / "deep");
        write("triangle.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
        write("deep/broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    }
    [[nodiscard]] std::string operator/(const std::string& name) const { return directory.path(name); }
    void write(const std::string& name, const std::string& bytes) const {
        REQUIRE(problem_of(write_file(*this / name, bytes)) == nullptr);
    }
};

SceneDocument opened(const std::string& path, const std::vector<Assignment>& assignments = {}) {
    Result<SceneDocument> result = open_document(path, assignments);
    INFO((problem_of(result) != nullptr ? problem_of(result)->text() : ""));
    REQUIRE(problem_of(result) == nullptr);
    return std::get<SceneDocument>(std::move(result));
}

std::string problem_at(const std::string& path, const std::vector<Assignment>& assignments = {}) {
    const Result<SceneDocument> result = open_document(path, assignments);
    return problem_of(result) != nullptr ? problem_of(result)->text() : "no problem";
}

constexpr const char* two_triangles = R"({"glint": 1, "objects": [
    {"mesh": {"file": "../triangle.obj"}}, {"mesh": {"file": "../triangle.obj"}}, {}, {}]})";

std::string picture_with(const std::string& scene_json) {
    return png_bytes({{1, 1}, {10, 20, 30, 255}, {}}, scene_json);
}

}  // namespace

TEST_CASE("mesh paths are relative to the scene file, and each mesh is loaded once", "[scene_document]") {
    const Place place;
    place.write("deep/scene.json", two_triangles);
    const SceneDocument document = opened(place / "deep/scene.json");
    const std::vector<Object>& objects = document.scene.objects;
    REQUIRE(objects.size() == 4);
    CHECK(objects[0].mesh->face_count() == 1);
    CHECK(objects[0].mesh == objects[1].mesh);
    CHECK(objects[2].mesh == objects[3].mesh);
    CHECK(objects[2].mesh->face_count() == 48 * 24);
    CHECK(document.path == place / "deep/scene.json");
    CHECK(document.mesh_dir == place / "deep");
}

TEST_CASE("an unreadable mesh is reported at its pointer, a malformed one at its line", "[scene_document]") {
    const Place place;
    const auto problem = [&](const std::string& file) {
        place.write("s.json",
                    std::string(R"({"glint": 1, "objects": [{}, {"mesh": {"file": ")") + file + "\"}}]}");
        return problem_at(place / "s.json");
    };
    const std::string at = place / "s.json" + ": /objects/1/mesh/file: ";
    CHECK(problem("no.obj") == at + "cannot read \"no.obj\": no such file; expected a mesh file");
    CHECK(problem("deep") == at + "cannot read \"deep\": it is a directory; expected a mesh file");
    CHECK(problem("/dev/zero") ==
          at + "cannot read \"/dev/zero\": it is a device or a pipe; expected a mesh file");
    CHECK(problem("s.json") ==
          at + "\"s.json\" has a different extension; expected .obj, .ply, .off, .stl, .gltf or .glb");
    CHECK(problem("deep/broken.obj").find(place / "deep/broken.obj:4: ") == 0);
}

TEST_CASE("a missing mesh named by --set is reported as a problem with --set", "[scene_document]") {
    const Place place;
    place.write("s.json", R"({"glint": 1, "objects": [{}]})");
    CHECK(problem_at(place / "s.json", {{"/objects/0/mesh", R"({"file": "no.off"})"}}) ==
          "--set: /objects/0/mesh/file: cannot read \"no.off\": no such file; expected a mesh file");
}

TEST_CASE("a missing mesh part is reported at its pointer or as a problem with --set", "[scene_document]") {
    const Place place;
    place.write("deep/s.json", two_triangles);
    CHECK(problem_at(place / "deep/s.json", {{"/objects/1/mesh/part", "1"}}) ==
          "--set: /objects/1/mesh/part: the file has no part 1: it contains only one mesh; expected 0");
    place.write("t.json", R"({"glint": 1, "objects": [{"mesh": {"file": "one.gltf", "part": 3}}]})");
    place.write("one.gltf", R"({"asset": {"version": "2.0"}})");
    CHECK(problem_at(place / "t.json") ==
          place / "t.json: /objects/0/mesh/part: the file has no part 3; expected a file with a mesh");
}

TEST_CASE("opening a mesh frames it and adds one light in the world and one at the camera",
          "[scene_document]") {
    const Place place;
    const SceneDocument document = opened(place / "triangle.obj");
    REQUIRE(document.scene.objects.size() == 1);
    CHECK(document.scene.objects[0].name == "triangle");
    CHECK(std::get<MeshFile>(document.scene.objects[0].source).path == "triangle.obj");
    CHECK(document.scene.objects[0].mesh->face_count() == 1);
    REQUIRE(document.scene.lights.size() == 2);
    CHECK(document.scene.lights[0].space == LightSpace::World);
    CHECK(document.scene.lights[1].space == LightSpace::Camera);
    CHECK(document.scene.camera.target == glm::vec3(1, 1, 0));
    CHECK(same_description(std::get<Scene>(parse_scene(scene_text(document.scene), "s")), document.scene));

    const SceneDocument assigned = opened(
        place / "triangle.obj", {{"/display/exposure", "2"}, {"/objects/0/transform/scale", "[2, 2, 2]"}});
    CHECK(assigned.scene.display.exposure == 2);
    CHECK(assigned.scene.objects[0].mesh->face_count() == 1);
    CHECK(problem_at(place / "triangle.obj", {{"/display/exposure", "0"}}) ==
          "--set: /display/exposure: 0 is out of range; expected more than 0, up to 1e7");
}

TEST_CASE("a picture with an embedded scene opens as that scene", "[scene_document]") {
    const Place place;
    place.write("deep/a.png", picture_with(two_triangles));
    CHECK(opened(place / "deep/a.png").scene.objects[0].mesh->face_count() == 1);
    place.write("plain.png", picture_with(""));
    CHECK(problem_at(place / "plain.png") ==
          place / "plain.png: the picture contains no scene; expected a PNG that Glint wrote");
    place.write("no.png", "nothing");
    CHECK(problem_at(place / "no.png") ==
          place / "no.png: is not a PNG picture; expected one that Glint wrote");
}

TEST_CASE("a file of an unknown kind is refused with a list of the known kinds", "[scene_document]") {
    const Place place;
    const std::string expected =
        "; expected a scene (.json, .png, .gltf, .glb) or a mesh (.obj, .ply, .off, .stl)";
    for (const char* name : {"a.txt", "name"}) {  // checked first as missing files, then as existing ones
        CHECK(problem_at(place / name) ==
              place / name + ": cannot read: no such file or directory" + expected);
        REQUIRE(problem_of(write_file(place / name, "x")) == nullptr);
    }
    std::filesystem::create_symlink(place / "loop", place / "loop");
    CHECK(problem_at(place / "loop") == place / "loop: cannot read: a loop of symbolic links" + expected);
    CHECK(problem_at(place / "a.txt") == place / "a.txt: has a different extension" + expected);
    CHECK(problem_at(place / "name") == place / "name: has no extension" + expected);
    CHECK(problem_at(place / "deep") == place / "deep: is a directory" + expected);
    CHECK(problem_at("/dev/null") == "/dev/null: has no extension" + expected);
    CHECK(problem_at(place / "no.json").find("no such file") != std::string::npos);
    CHECK(problem_at(place / "no.obj").find("no such file") != std::string::npos);
    CHECK(problem_at("").find("has no extension") != std::string::npos);
}

TEST_CASE("a scene saved through a link into another directory opens by both paths", "[scene_document]") {
    const Place place;
    fs::create_directories(place.path / "far/off");
    fs::create_directories(place.path / "same");
    place.write("deep/scene.json", two_triangles);
    const SceneDocument document = opened(place / "deep/scene.json");
    fs::create_symlink("../far/off/real.json", place.path / "deep/link.json");
    place.write("far/off/real.json", two_triangles);
    REQUIRE(problem_of(save_document(document, place / "deep/link.json")) == nullptr);
    fs::create_symlink("../far/off/real.png", place.path / "deep/link.png");
    place.write("far/off/real.png",
                picture_with(carried_scene_text(document.scene, document.mesh_dir, place / "deep/link.png")));
    for (const char* const file :
         {"deep/link.json", "far/off/real.json", "deep/link.png", "far/off/real.png"}) {
        CAPTURE(file);
        CHECK(opened(place / file).scene.objects[0].mesh->face_count() == 1);
    }
    fs::create_symlink("there.json", place.path / "same/link.json");
    REQUIRE(problem_of(save_document(document, place / "same/link.json")) == nullptr);
    CHECK(std::get<MeshFile>(opened(place / "same/there.json").scene.objects[0].source).path ==
          "../triangle.obj");
}

TEST_CASE("a scene saved in another directory still finds its meshes", "[scene_document]") {
    const Place place;
    place.write("deep/scene.json", two_triangles);
    const SceneDocument document = opened(place / "deep/scene.json");
    const auto path_in = [](const SceneDocument& d) {
        return std::get<MeshFile>(d.scene.objects[0].source).path;
    };
    for (const auto& [name, expected] : std::vector<std::pair<std::string, std::string>>{
             {"deep/same.json", "../triangle.obj"}, {"up.json", "triangle.obj"}}) {
        const Result<SceneDocument> saved = save_document(document, place / name);
        REQUIRE(problem_of(saved) == nullptr);
        CHECK(path_in(std::get<SceneDocument>(saved)) == expected);
        CHECK(same_description(opened(place / name).scene, std::get<SceneDocument>(saved).scene));
    }
    CHECK(problem_of(save_document(document, place / "triangle.obj")) != nullptr);
    CHECK(problem_of(save_document(document, place / "no/scene.json")) != nullptr);
    SceneDocument broken = document;
    broken.scene.display.exposure = -1;
    CHECK(problem_of(save_document(broken, place / "up.json")) != nullptr);
    broken = document;
    broken.scene.objects[0].name.assign(1, '\xff');
    CHECK(problem_of(save_document(broken, place / "up.json")) != nullptr);
    CHECK(opened(place / "up.json").scene.display.exposure == 1);
}
