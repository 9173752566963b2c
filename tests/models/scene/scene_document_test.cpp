// Scenes from files and into files: meshes found, pictures that carry their scene, saving elsewhere.
#include <zlib.h>

#include <cstdint>
#include <filesystem>

#include "models/io/file.h"
#include "models/io/png_text.h"
#include "models/memory_limit.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
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

TEST_CASE("a mesh that cannot be read is a problem at its pointer, one inside it at its line",
          "[scene_document]") {
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
          at + "\"s.json\" has another extension; expected .obj, .ply, .off, .stl, .om, .gltf or .glb");
    CHECK(problem("deep/broken.obj").find(place / "deep/broken.obj:4: ") == 0);
}

TEST_CASE("a mesh that --set names and that is not there is the fault of --set", "[scene_document]") {
    const Place place;
    place.write("s.json", R"({"glint": 1, "objects": [{}]})");
    CHECK(problem_at(place / "s.json", {{"/objects/0/mesh", R"({"file": "no.off"})"}}) ==
          "--set: /objects/0/mesh/file: cannot read \"no.off\": no such file; expected a mesh file");
}

TEST_CASE("a mesh that --set makes too large is the fault of --set", "[scene_document]") {
    const Place place;
    const std::string scene = place / "s.json";
    place.write("s.json", R"({"glint": 1, "objects": [{"mesh": {"primitive": "sphere", "detail": 8}}]})");
    set_memory_limit(memory_limit() - memory_left() + (1 << 20));
    const std::string set = problem_at(scene, {{"/objects/0/mesh/detail", "300"}}),
                      whole = problem_at(
                          scene, {{"/objects/0", R"({"mesh": {"primitive": "knot", "detail": 300}})"}});
    set_memory_limit(0);
    CHECK(set.starts_with("--set: /objects/0/mesh: this needs "));
    CHECK(whole.starts_with("--set: /objects/0/mesh: this needs "));
}

TEST_CASE("a part that a mesh's file has not is a problem at the part, and of --set where that names it",
          "[scene_document]") {
    const Place place;
    place.write("deep/s.json", two_triangles);
    CHECK(problem_at(place / "deep/s.json", {{"/objects/1/mesh/part", "1"}}) ==
          "--set: /objects/1/mesh/part: the file holds one mesh, and not a part 1; expected 0");
    place.write("t.json", R"({"glint": 1, "objects": [{"mesh": {"file": "one.gltf", "part": 3}}]})");
    place.write("one.gltf", R"({"asset": {"version": "2.0"}})");
    CHECK(problem_at(place / "t.json") ==
          place / "t.json: /objects/0/mesh/part: the file has no part 3; expected a file with a mesh");
}

TEST_CASE("a scene that has loaded nothing stays as it was", "[scene_document]") {
    Scene scene;
    scene.objects.resize(2);
    scene.objects[1].source = MeshFile{"no.obj"};
    CHECK(problem_of(load_meshes(scene, "s.json", "")) != nullptr);
    CHECK(scene.objects[0].mesh == nullptr);
}

TEST_CASE("a mesh opens framed, with a light in the world and one at the camera", "[scene_document]") {
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
          "--set: /display/exposure: 0 is out of range; expected more than 0, up to 1e30");
}

TEST_CASE("a picture that carries its scene opens as that scene", "[scene_document]") {
    const Place place;
    place.write("deep/a.png", picture_with(two_triangles));
    CHECK(opened(place / "deep/a.png").scene.objects[0].mesh->face_count() == 1);
    place.write("plain.png", picture_with(""));
    CHECK(problem_at(place / "plain.png") ==
          place / "plain.png: the picture carries no scene; expected a PNG that Glint wrote");
    place.write("no.png", "nothing");
    CHECK(problem_at(place / "no.png") ==
          place / "no.png: is not a PNG picture; expected one that Glint wrote");
}

TEST_CASE("whether a picture carries a scene is told without reading it all", "[scene_document]") {
    const Place place;
    place.write("a.png", picture_with(two_triangles));
    place.write("plain.png", picture_with(""));
    place.write("no.png", "nothing");
    const std::string whole = picture_with(two_triangles);
    place.write("cut.png", whole.substr(0, 30));
    CHECK(has_png_text(place / "a.png", png_scene_keyword));
    CHECK_FALSE(has_png_text(place / "a.png", "glint-scen"));
    for (const char* name : {"plain.png", "no.png", "cut.png", "nowhere.png", "."})
        CHECK_FALSE(has_png_text(place / name, png_scene_keyword));
}

TEST_CASE("a picture that is damaged anywhere is a problem and never a crash", "[scene_document]") {
    const std::string whole = picture_with(R"({"glint": 1})");
    const auto text_in = [](const std::string& bytes) {
        return png_text(bytes, png_scene_keyword, 100, "p.png");
    };
    CHECK(std::get<std::string>(text_in(whole)) == R"({"glint": 1})");
    for (std::size_t i = 0; i < whole.size(); ++i) {
        (void)text_in(whole.substr(0, i));
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x5A);
        const Result<std::string> text = text_in(damaged);  // found before the damage, or not at all
        CHECK((problem_of(text) != nullptr || std::get<std::string>(text) == R"({"glint": 1})"));
    }
    CHECK(problem_of(png_text(whole, png_scene_keyword, 11, "p.png")) != nullptr);  // one byte too long
}

namespace {

/// A chunk of a PNG: its length, type and bytes, and the sum of those.
std::string chunk_of(const std::string& type_and_bytes) {
    const auto number = [](std::size_t n) {
        return std::string{static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8),
                           static_cast<char>(n)};
    };
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(type_and_bytes.data()),
                           static_cast<uInt>(type_and_bytes.size()));
    return number(type_and_bytes.size() - 4) + type_and_bytes + number(sum);
}

}  // namespace

TEST_CASE("a size that a picture claims to be fitted to and is none is told of and ignored",
          "[scene_document]") {
    const Place place;
    const std::string picture = picture_with(R"({"glint": 1, "objects": [{}]})");
    const std::size_t end = picture.size() - 12;  // the last chunk is empty
    for (const auto& [words, is_size] : {std::pair<std::string, bool>{"640x716", true},
                                         {"-1x5", false},
                                         {"0x0", false},
                                         {"640", false},
                                         {"640x716x", false},
                                         {"1x16385", false}}) {
        CAPTURE(words);
        const std::string field =
            chunk_of("iTXt" + std::string(png_field_keyword) + std::string(5, '\0') + words);
        const std::string file = place / "field.png";
        REQUIRE(problem_of(write_file(file, picture.substr(0, end) + field + picture.substr(end))) ==
                nullptr);
        const Result<SceneDocument> opened = open_document(file);
        REQUIRE(problem_of(opened) == nullptr);
        const auto& document = std::get<SceneDocument>(opened);
        CHECK(document.fitted_to.has_value() == is_size);
        CHECK(document.warnings ==
              (is_size ? Warnings{}
                       : Warnings{file + ": its chunk glint-field is not a size, and is ignored"}));
    }
}

TEST_CASE("text is taken up to the bytes asked for and no more, compressed or not", "[scene_document]") {
    std::string deflated(64, ' ');
    uLongf length = deflated.size();
    const std::string text = "twelve bytes";
    REQUIRE(compress(reinterpret_cast<Bytef*>(deflated.data()), &length,
                     reinterpret_cast<const Bytef*>(text.data()), text.size()) == Z_OK);
    deflated.resize(length);
    for (const bool compressed : {false, true}) {
        CAPTURE(compressed);
        // Keyword, flag and method of compression, language, translated keyword, text.
        const std::string chunk = "iTXt" + std::string(png_scene_keyword) + '\0' +
                                  (compressed ? '\1' : '\0') + std::string(3, '\0') +
                                  (compressed ? deflated : text);
        const std::string png = "\x89PNG\r\n\x1a\n" + chunk_of(chunk);
        CHECK(std::get<std::string>(png_text(png, png_scene_keyword, 12, "p.png")) == text);
        CHECK(problem_of(png_text(png, png_scene_keyword, 11, "p.png")) != nullptr);
    }
}

TEST_CASE("the scene that a picture has packed is unpacked only where there is memory for it",
          "[scene_document][memory]") {
    const std::string text(std::size_t{8} << 20, ' ');
    std::string deflated(std::size_t{1} << 16, ' ');
    uLongf length = deflated.size();
    REQUIRE(compress(reinterpret_cast<Bytef*>(deflated.data()), &length,
                     reinterpret_cast<const Bytef*>(text.data()), text.size()) == Z_OK);
    deflated.resize(length);
    const std::string chunk =
        "iTXt" + std::string(png_scene_keyword) + '\0' + '\1' + std::string(3, '\0') + deflated;
    const std::string png = "\x89PNG\r\n\x1a\n" + chunk_of(chunk);
    {
        const test::MemoryLimit limit(4 * text.size());
        const auto unpacked = png_text(png, png_scene_keyword, text.size(), "p.png");
        REQUIRE(problem_of(unpacked) == nullptr);
        CHECK((std::get<std::string>(unpacked) == text));
    }
    const test::MemoryLimit limit(text.size());
    CHECK_THROWS_AS((void)png_text(png, png_scene_keyword, text.size(), "p.png"), Refused);
}

TEST_CASE("a file of another kind is a problem that lists the kinds", "[scene_document]") {
    const Place place;
    const std::string expected =
        "; expected a scene (.json, .png, .gltf, .glb) or a mesh (.obj, .ply, .off, .stl, .om)";
    for (const char* name : {"a.txt", "name"}) {  // missing first, then there
        CHECK(problem_at(place / name) ==
              place / name + ": cannot read: no such file or directory" + expected);
        REQUIRE(problem_of(write_file(place / name, "x")) == nullptr);
    }
    std::filesystem::create_symlink(place / "loop", place / "loop");
    CHECK(problem_at(place / "loop") == place / "loop: cannot read: a loop of symbolic links" + expected);
    CHECK(problem_at(place / "a.txt") == place / "a.txt: has another extension" + expected);
    CHECK(problem_at(place / "name") == place / "name: has no extension" + expected);
    CHECK(problem_at(place / "deep") == place / "deep: is a directory" + expected);
    CHECK(problem_at("/dev/null") == "/dev/null: has no extension" + expected);
    CHECK(problem_at(place / "no.json").find("no such file") != std::string::npos);
    CHECK(problem_at(place / "no.obj").find("no such file") != std::string::npos);
    CHECK(problem_at("").find("has no extension") != std::string::npos);
}

TEST_CASE("a scene written through a link into another directory opens there and by the link",
          "[scene_document]") {
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
