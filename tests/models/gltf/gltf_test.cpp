// Files written with numpy and json according to the specification (write_gltf.py), compared with results
// worked out by hand.
#include "models/gltf/gltf.h"

#include <fmt/format.h>

#include <cstdlib>
#include <glm/geometric.hpp>

#include "models/gltf/gltf_document.h"
#include "models/memory_limit.h"
#include "models/scene_file/scene_file.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/gltf_triangle.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

/// The file that the script writes. Debian's own Python comes first because it has numpy.
std::string written(const TemporaryDirectory& folder, const std::string& how) {
    const std::string command =
        fmt::format("PATH=/usr/bin:$PATH python3 {} '{}' {}", project_file("tests/models/gltf/write_gltf.py"),
                    folder.path(), how);
    REQUIRE(std::system(command.c_str()) == 0);
    return folder.path(how.find("glb") != std::string::npos ? "box.glb" : "box.gltf");
}

SceneDocument opened(const std::string& path, const std::vector<Assignment>& assignments = {}) {
    Result<SceneDocument> result = open_document(path, assignments);
    if (const Problem* problem = problem_of(result)) FAIL(problem->text());
    return std::get<SceneDocument>(std::move(result));
}

void check_near(const glm::vec3& a, const glm::vec3& b) {
    CAPTURE(a.x, a.y, a.z);
    CHECK(glm::distance(a, b) < 1e-5f);
}

}  // namespace

TEST_CASE("a glTF box gives the same mesh with every layout of its data", "[gltf]") {
    for (const char* how : {"glb", "bytes", "glb ints", "external", "glb interleaved", "small"}) {
        CAPTURE(how);
        const TemporaryDirectory folder;
        const SceneDocument document = opened(written(folder, how));
        CHECK(document.warnings.empty());
        REQUIRE(document.scene.objects.size() == 1);
        const Mesh& mesh = *document.scene.objects[0].mesh;
        CHECK(mesh.positions.size() == 8);  // shared by the sides, whose normals differ
        const MeshInfo info = mesh_info(mesh);
        CHECK(info.triangles == 12);
        CHECK(info.boundary_edges == 0);
        CHECK(info.inconsistent_edges == 0);
        CHECK(used_source(mesh, NormalSource::Auto) == NormalSource::File);
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c)
                check_near(mesh.normals[mesh.given_normal_of(c)], facet_normal(mesh, f));
    }
}

TEST_CASE("the transform read from a glTF matrix reproduces it, even in gimbal lock", "[gltf]") {
    const float y = GENERATE(-90.0f, -89.0f, 0.0f, 35.0f, 90.0f);
    const float x = GENERATE(-170.0f, 0.0f, 20.0f, 95.0f), z = GENERATE(-60.0f, 0.0f, 140.0f);
    const glm::dmat4 m = world_from_object({{1, 2, 3}, {x, y, z}, {2, 0.5f, -3}});
    bool sheared = false;
    const std::optional<Transform> found = transform_of(m, sheared);
    REQUIRE(found);
    CHECK_FALSE(sheared);
    const glm::dmat4 again = world_from_object(*found);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) CHECK(again[c][r] == Approx(m[c][r]).margin(1e-5));
}

TEST_CASE("glTF without a camera is framed like a mesh file", "[gltf][frame_camera]") {
    const TemporaryDirectory folder;
    // A quarter turn about x makes the file's triangle horizontal: its (0, 1, 0) becomes (0, 0, 1).
    const std::string lying = gltf_triangle::changed(
        R"({"mesh": 0})", R"({"mesh": 0, "rotation": [0.70710678, 0, 0, 0.70710678]})");
    const SceneDocument gltf = opened(folder.file("floor.gltf", lying));
    const SceneDocument obj = opened(folder.file("floor.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n"));
    check_near(gltf.scene.camera.eye, obj.scene.camera.eye);
    check_near(gltf.scene.camera.target, obj.scene.camera.target);
    CHECK(gltf.scene.camera.eye.y > 0.3f);  // from above, because the triangle is level
}

TEST_CASE("glTF nodes, cameras, lights and materials are converted as specified", "[gltf]") {
    const TemporaryDirectory folder;
    const SceneDocument document = opened(written(folder, "glb"));
    const Scene& s = document.scene;
    const Object& box = s.objects.at(0);
    CHECK(box.name == "box");
    // A quarter turn about y maps x to -z: the box, 1 along x, is at (2, 0, -1).
    const glm::dmat4 m = world_from_object(box.transform);
    check_near(glm::vec3(m * glm::dvec4(0, 0, 0, 1)), {2, 0, -1});
    check_near(glm::vec3(m * glm::dvec4(1, 0, 0, 0)), {0, 0, -2});
    check_near(glm::vec3(m * glm::dvec4(0, 0, 1, 0)), {2, 0, 0});
    check_near(box.material.diffuse, {0.36f, 0.18f, 0.72f});  // 3/4 is non-metal, which reflects 0.04
    check_near(box.material.f0, {0.155f, 0.0925f, 0.28f});    // 0.03 + base/4
    CHECK(box.material.roughness == 0.375f);
    check_near(box.material.emission, {0, 0.125f, 0});
    CHECK(s.shading.reflection == Reflection::CookTorrance);
    CHECK(s.display.transfer == Transfer::Srgb);
    CHECK(s.shading.cull == Cull::Back);  // its material is single-sided

    check_near(s.camera.eye, {0, 1, 10});
    check_near(s.camera.target, {0, 1, -1});  // at the distance of the box
    const auto& view = std::get<Perspective>(s.camera.projection);
    CHECK(view.fov_y_deg == Approx(60));
    CHECK(view.near == 0.5f);
    CHECK(view.far == 50);

    REQUIRE(s.lights.size() == 3);
    CHECK(s.global_ambient == glm::vec3(0));
    CHECK(s.lights[0].name == "headlamp");
    CHECK(s.lights[0].space == LightSpace::Camera);
    check_near(glm::vec3(s.lights[0].position), {0, 0.5f, 0});
    CHECK(s.lights[0].intensity == Approx(40));
    CHECK(s.lights[0].falloff == Falloff{0, 0, 1});
    check_near(s.lights[0].diffuse, {1, 0.5f, 0});
    CHECK(s.lights[1].kind == LightKind::Directional);
    check_near(glm::vec3(s.lights[1].position), {0, 0, 1});
    CHECK(s.lights[2].kind == LightKind::Spot);
    check_near(s.lights[2].spot.direction, {0, -1, 0});
    CHECK(s.lights[2].spot.cutoff_deg == Approx(30).margin(1e-3));
    CHECK(s.lights[2].spot.exponent == 0);
}

TEST_CASE("glTF strips and fans wind their triangles as specified", "[gltf]") {
    const TemporaryDirectory folder;
    const SceneDocument document = opened(written(folder, "strip"));
    REQUIRE(document.scene.objects.size() == 2);
    for (const Object& object : document.scene.objects) {
        CHECK(object.normals.source == NormalSource::Facet);  // the file has no normals
        CHECK(object.mesh->triangles.size() == 2);
        for (std::size_t f = 0; f < 2; ++f) check_near(facet_normal(*object.mesh, f), {0, 0, 1});
    }
    CHECK(document.warnings == Warnings{"1 primitive of points or lines is left out"});
}

TEST_CASE("importing glTF warns once per kind of feature that a scene does not have", "[gltf]") {
    const TemporaryDirectory folder;
    const SceneDocument document = opened(written(folder, "glb left"));
    CHECK(document.warnings == Warnings{"1 material has textures, which are not read",
                                        "1 material is transparent, but is drawn as opaque",
                                        "2 animations are left out", "1 additional camera is left out"});
}

TEST_CASE("a glTF scene is changed, saved and opened again like any other", "[gltf]") {
    const TemporaryDirectory folder;
    const std::string path = written(folder, "strip");
    const SceneDocument document =
        opened(path, {{"/objects/1/mesh/subdivide", "1"}, {"/objects/0/name", "left"}});
    CHECK(document.scene.objects[0].name == "left");
    CHECK(document.scene.objects[1].mesh->triangles.size() == 8);
    const Result<SceneDocument> saved = save_document(document, folder.path("saved.json"));
    REQUIRE(problem_of(saved) == nullptr);
    const SceneDocument again = opened(folder.path("saved.json"));
    CHECK(same_description(again.scene, document.scene));
    CHECK(again.scene.objects[0].mesh->positions == document.scene.objects[0].mesh->positions);
    CHECK(scene_text(again.scene).find(R"({"file": "box.gltf", "part": 1, "subdivide": 1})") !=
          std::string::npos);

    const Result<GltfFile> file = GltfFile::read(path);
    REQUIRE(problem_of(file) == nullptr);
    const Result<Mesh> none = std::get<GltfFile>(file).mesh(7);
    REQUIRE(problem_of(none) != nullptr);
    CHECK(problem_of(none)->text() == "/part: the file has no part 7; expected 0 to 2");
}

TEST_CASE("parts are counted through all meshes, including those without primitives", "[gltf]") {
    // Triangle i has the corners i, i + 1 and i + 2 of (0,0,0) (1,0,0) (0,1,0) (2,0,0) (0,3,0).
    const std::string text = R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 1}, {"mesh": 4}],
      "scenes": [{"nodes": [1, 0]}],
      "meshes": [{}, {"primitives": [{"attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 1}}]},
                 {"name": "empty"}, {"primitives": []}, {"primitives": [{"attributes": {"POSITION": 2}}]}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                    {"bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": 3, "type": "VEC3"},
                    {"bufferView": 0, "byteOffset": 24, "componentType": 5126, "count": 3, "type": "VEC3"}],
      "bufferViews": [{"buffer": 0, "byteLength": 60}], "buffers": [{"byteLength": 60, "uri":
      "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAQAAAAAAAAAAAAAAAAAAAQEAAAAAA"}]})";
    const Result<GltfFile> file = GltfFile::parse(text, "t.gltf");
    REQUIRE(problem_of(file) == nullptr);
    const std::vector<glm::vec3> first{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (int part = 0; part < 3; ++part) {
        const Result<Mesh> mesh = std::get<GltfFile>(file).mesh(part);
        REQUIRE(problem_of(mesh) == nullptr);
        CHECK(std::get<Mesh>(mesh).positions.front() == first[static_cast<std::size_t>(part)]);
    }
    for (const int part : {-1, 3}) {
        const Result<Mesh> mesh = std::get<GltfFile>(file).mesh(part);
        REQUIRE(problem_of(mesh) != nullptr);
        CHECK(problem_of(mesh)->text() ==
              fmt::format("/part: the file has no part {}; expected 0 to 2", part));
    }
    const TemporaryDirectory folder;
    const SceneDocument document = opened(folder.file("t.gltf", text));
    REQUIRE(document.scene.objects.size() == 3);
    const std::vector<int> parts{2, 0, 1};  // in the order of the nodes
    for (std::size_t o = 0; o < 3; ++o)
        CHECK(std::get<MeshFile>(document.scene.objects[o].source).part == parts[o]);
}

TEST_CASE("primitives that share vertices give the same meshes as with their own vertices", "[gltf]") {
    // Corners (0,0,0) (1,0,0) (0,1,0), which are also the normals. The first triangle uses their order, the
    // second has indices that reverse it.
    const auto text = [](int positions, int normals) {
        return fmt::format(R"({{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
      "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "NORMAL": 1}}}},
         {{"attributes": {{"POSITION": {}, "NORMAL": {}}}, "indices": 4}},
         {{"attributes": {{"POSITION": 0}}}}, {{"attributes": {{"POSITION": 0}}}}]}}],
      "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
                    {{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
                    {{"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC3"}},
                    {{"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC3"}},
                    {{"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}}],
      "bufferViews": [{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteOffset": 36, "byteLength": 3}},
                      {{"buffer": 1, "byteLength": 36}}],
      "buffers": [{{"byteLength": 39, "uri":
      "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAgEA"}},
                  {{"byteLength": 36, "uri":
      "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}]}})",
                           positions, normals);
    };
    const auto shared = GltfFile::parse(text(0, 1), "t.gltf"), own = GltfFile::parse(text(2, 3), "t.gltf");
    REQUIRE(problem_of(shared) == nullptr);
    REQUIRE(problem_of(own) == nullptr);
    for (const int part : {1, 2, 0, 1, 3}) {
        const auto a = std::get<GltfFile>(shared).mesh(part), b = std::get<GltfFile>(own).mesh(part);
        REQUIRE(problem_of(a) == nullptr);
        REQUIRE(problem_of(b) == nullptr);
        CHECK(std::get<Mesh>(a).positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        CHECK(std::get<Mesh>(a).positions == std::get<Mesh>(b).positions);
        CHECK(std::get<Mesh>(a).normals == std::get<Mesh>(b).normals);
        CHECK(std::get<Mesh>(a).normals.size() == (part >= 2 ? 0 : 3));
        CHECK(std::get<Mesh>(a).corner_position ==
              (part == 1 ? std::vector<std::uint32_t>{2, 1, 0} : std::vector<std::uint32_t>{0, 1, 2}));
    }
}

TEST_CASE("lights in candela are scaled to a display's brightness by a single factor", "[gltf]") {
    const TemporaryDirectory folder;
    std::string text = bytes_of(written(folder, "external"));
    const auto times = [&](const std::string& what, const std::string& with) {
        const std::size_t at = text.find(what);
        REQUIRE(at != text.npos);
        text.replace(at, what.size(), with);
    };
    times(fmt::format("\"intensity\": {}", 8 * 3.141592653589793), "\"intensity\": 54351");
    const SceneDocument document = opened(folder.file("bright.gltf", text));
    REQUIRE(document.warnings.size() == 1);
    // From (0, 5, 0) to the centre of the box at (2, 0, -1): 54351 / (30 pi).
    CHECK(document.warnings[0].starts_with("lights are 577 times brighter"));
    CHECK(document.scene.lights[2].intensity == Approx(30).epsilon(1e-4));
    CHECK(document.scene.lights[1].intensity == Approx(1 / 576.68).epsilon(1e-3));
}
