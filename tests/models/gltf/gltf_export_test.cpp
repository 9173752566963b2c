// Exported files, read back by Glint and by assimp.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <random>

#include "models/gltf/gltf.h"
#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"

using namespace glint;

namespace {

/// A scene with everything that glTF can express: metal and roughness, lights with quadratic falloff, and one
/// of them on the camera.
constexpr const char* sayable = R"({"glint": 1, "global_ambient": [0, 0, 0],
 "camera": {"eye": [1, 2, 6], "target": [0, 0, 0], "projection": {"type": "perspective",
   "fov_y_deg": 40, "near": 0.5, "far": 40}},
 "lights": [
  {"name": "Sun", "type": "directional", "position": [1, 2, 1], "diffuse": [0.9, 0.8, 0.7],
   "specular": [0.9, 0.8, 0.7], "intensity": 0.6},
  {"name": "Headlight", "space": "camera", "position": [0.5, 0.5, 0], "intensity": 12,
   "falloff": {"constant": 0, "linear": 0, "quadratic": 1}},
  {"name": "Lamp", "type": "spot", "position": [-1, 4, 0], "intensity": 9, "falloff": {"constant": 0,
   "quadratic": 0.5},
   "spot": {"direction": [0.2, -1, 0], "cutoff_deg": 30, "exponent": 0}}],
 "objects": [
  {"name": "Pot", "mesh": {"primitive": "teapot", "detail": 6},
   "transform": {"rotate_deg": [10, 30, -20], "scale": [1, 1.5, 0.7]},
   "material": {"diffuse": [0.6, 0.3, 0.1], "specular": [1, 1, 1], "roughness": 0.3,
   "f0": [0.04, 0.04, 0.04]}},
  {"name": "Gold", "mesh": {"primitive": "torus", "detail": 24},
   "transform": {"translate": [0, -0.6, 0], "scale": [-2, 2, 2]},
   "material": {"diffuse": [0, 0, 0], "specular": [1, 1, 1], "roughness": 0.45, "f0": [1, 0.8, 0.3]}},
  {"name": "Half", "mesh": {"primitive": "cube", "detail": 2}, "transform": {"translate": [2, 0.5, 0],
   "rotate_deg": [0, 90, 45], "scale": [0.5, 0.5, 0.5]},
   "material": {"diffuse": [0.24, 0.384, 0.048], "specular": [1, 1, 1], "roughness": 0.6,
   "f0": [0.27, 0.42, 0.07]}}],
 "shading": {"mode": "phong", "reflection": "cook-torrance"},
 "display": {"transfer": "srgb", "background": [0.01, 0.01, 0.013]}})";

std::vector<std::uint8_t> drawn(const Scene& scene) {
    Renderer renderer;
    return renderer.render(scene, {320, 180}).rgba;
}

}  // namespace

TEST_CASE("a scene that glTF can express gives the same picture when read back", "[cli][gltf]") {
    const TemporaryDirectory folder;
    const std::string scene = folder.file("scene.json", sayable), glb = folder.path("scene.glb");
    const Ended ended = run_glint({"export", scene, "-o", glb});
    CHECK(ended.err.empty());
    REQUIRE(ended.status == 0);
    const auto given = std::get<SceneDocument>(open_document(scene));
    const Result<SceneDocument> opened = open_document(glb);
    if (const Problem* problem = problem_of(opened)) FAIL(problem->text());
    const auto& again = std::get<SceneDocument>(opened);
    CHECK(again.warnings.empty());
    REQUIRE(again.scene.lights.size() == 3);
    for (const Light& light : again.scene.lights)
        CHECK((light.space == LightSpace::Camera) == (light.name == "Headlight"));
    const auto a = drawn(given.scene), b = drawn(again.scene);
    REQUIRE(a.size() == b.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) different += std::abs(a[i] - b[i]) > 1 ? 1 : 0;
    CHECK(different < a.size() / 500);  // a float's last bit moves an outline in a few pixels
    CHECK(std::count_if(a.begin(), a.end(), [](std::uint8_t x) { return x > 100; }) > 5000);
}

TEST_CASE("a spot's soft edge is kept exactly, an exponent becomes one, with a warning", "[cli][gltf]") {
    const TemporaryDirectory folder;
    struct Case {
        const char *exponent, *inner_deg;
        double inner_again;  // in degrees; 180: none
    };
    // Halfway between the cosines of the two angles, cos^12 and glTF's square are both 1/4: cos inner = 2 *
    // 4^(-1/12) - cos 30 degrees = 0.9157.
    for (const Case& c : {Case{"0", "10", 10}, {"0", "180", 180}, {"12", "180", 23.70}, {"12", "10", 10}}) {
        CAPTURE(c.exponent, c.inner_deg);
        const std::string glb = folder.path("spot.glb");
        const Ended ended = run_glint({"export", folder.file("scene.json", sayable), "-o", glb, "--set",
                                       std::string("/lights/2/spot/exponent=") + c.exponent, "--set",
                                       std::string("/lights/2/spot/inner_deg=") + c.inner_deg});
        REQUIRE(ended.status == 0);
        CHECK(ended.err.empty() == (c.exponent[0] == '0'));
        const auto again = std::get<SceneDocument>(open_document(glb));
        REQUIRE(again.scene.lights.size() == 3);
        for (const Light& light : again.scene.lights)
            if (light.kind == LightKind::Spot) {
                CHECK(light.spot.exponent == 0);
                CHECK(light.spot.inner_deg == Approx(c.inner_again).epsilon(1e-3));
                CHECK(light.spot.cutoff_deg == Approx(30));
            }
    }
}

TEST_CASE("exporting glTF warns once per kind of feature that it cannot express", "[cli][gltf]") {
    const TemporaryDirectory folder;
    const std::string glb = folder.path("out.glb");
    const Ended ended = run_glint({"export", project_file("assets/scenes/default.json"), "-o", glb});
    REQUIRE(ended.status == 0);
    CHECK(ended.err.find("the reflection model is written as metal and roughness") != std::string::npos);
    CHECK(ended.err.find("the ambient light is left out") != std::string::npos);
    CHECK(problem_of(open_document(glb)) == nullptr);
    const Ended wrong = run_glint({"export", project_file("assets/scenes/default.json"), "-o", "x.obj"});
    CHECK(wrong.status == 2);
    CHECK(wrong.err == "glint: error: -o: x.obj has a different extension; expected .glb\n");
}

TEST_CASE("every setting that glTF cannot express is named in a warning", "[cli][gltf]") {
    const TemporaryDirectory folder;
    const std::string file = folder.file("scene.json", sayable), glb = folder.path("out.glb");
    const SceneDocument given = std::get<SceneDocument>(open_document(file));
    std::vector<std::string> quiet, different;
    for (const std::string set :
         {"/about=\"\"", "/shading/mode=\"flat\"", "/shading/mode=\"facet\"", "/shading/mode=\"gouraud\"",
          "/shading/local_viewer=false", "/shading/interpolation=\"screen\"", "/shading/cull=\"front\"",
          "/shading/rules=\"opengl2\"", "/shading/terms/diffuse=false", "/shading/terms/specular=false",
          "/shading/terms/emission=false", "/shading/power_table=2", "/shading/mistakes/missing_pi=true",
          "/shading/mistakes/normals_flipped=true", "/npr/cool_to_warm=true", "/npr/silhouettes=true",
          "/npr/creases=true", "/global_ambient=[0.2,0.2,0.2]", "/display/transfer=\"none\""}) {
        const Ended ended = run_glint({"export", file, "-o", glb, "--set", set});
        INFO(set << ": " << ended.err);
        REQUIRE(ended.status == 0);
        const Scene before = std::get<Scene>(
            scene_variant(given, {{set.substr(0, set.find('=')), set.substr(set.find('=') + 1)}}));
        const auto a = drawn(before), b = drawn(std::get<SceneDocument>(open_document(glb)).scene);
        std::size_t other = 0;
        for (std::size_t i = 0; i < a.size(); ++i) other += std::abs(a[i] - b[i]) > 1 ? 1 : 0;
        const bool reads_back = other < a.size() / 500;
        if (!reads_back) different.push_back(set);
        if (ended.err.empty()) quiet.push_back(set);
        CHECK((reads_back || !ended.err.empty()));
    }
    CHECK(different.size() > 8);
    CHECK(quiet.front() == "/about=\"\"");
}

TEST_CASE("assimp reads the glTF files that Glint exports", "[cli][gltf]") {
    const TemporaryDirectory folder;
    const std::string scene = folder.file("scene.json", sayable), glb = folder.path("scene.glb");
    REQUIRE(run_glint({"export", scene, "-o", glb}).status == 0);
    const std::string said = folder.path("said");
    REQUIRE(std::system(("assimp info '" + glb + "' > '" + said + "' 2>&1").c_str()) == 0);
    const std::string text = bytes_of(said);
    CHECK(text.find("Meshes:             3") != std::string::npos);
    CHECK(text.find("Cameras:            1") != std::string::npos);
    CHECK(text.find("Lights:             3") != std::string::npos);
    const auto triangles = [](const Scene& s) {
        std::size_t sum = 0;
        for (const Object& o : s.objects) sum += o.mesh->triangles.size();
        return std::to_string(sum);
    };
    CHECK(text.find("Faces:              " +
                    triangles(std::get<SceneDocument>(open_document(scene)).scene)) != std::string::npos);
}

// A scene at the limits of glTF can be read back, or one line names the offending value.
namespace {

/// A scene with everything that glTF can express without a warning.
constexpr const char* plain = R"({"glint": 1, "global_ambient": [0, 0, 0],
 "camera": {"eye": [0, 0, 6], "target": [0, 0, 0]},
 "lights": [{"type": "point", "position": [0, 3, 3], "intensity": 9,
   "falloff": {"constant": 0, "quadratic": 1}}],
 "objects": [{"name": "Cube", "mesh": {"primitive": "cube", "detail": 1},
   "material": {"diffuse": [0.5, 0.5, 0.5], "specular": [1, 1, 1], "f0": [0.04, 0.04, 0.04]}}],
 "shading": {"mode": "phong", "reflection": "cook-torrance"}, "display": {"transfer": "srgb"}})";

struct Exported {
    Ended ended;
    bool is_written = false;
    Scene scene;  // read back
};
Exported exported(const std::vector<std::string>& settings) {
    const TemporaryDirectory folder;
    const std::string glb = folder.path("out.glb");
    std::vector<std::string> line{"export", folder.file("scene.json", plain), "-o", glb};
    for (const std::string& setting : settings) line.insert(line.end(), {"--set", setting});
    Exported out{run_glint(line), std::filesystem::exists(glb), {}};
    if (const std::size_t at = out.ended.err.find(folder.path() + "/"); at != std::string::npos)
        out.ended.err.erase(at, folder.path().size() + 1);
    if (!out.is_written) return out;
    Result<SceneDocument> opened = open_document(glb);
    if (const Problem* problem = problem_of(opened)) FAIL(problem->text());
    out.scene = std::get<SceneDocument>(std::move(opened)).scene;
    return out;
}

constexpr const char* frustum_of = R"(/camera/projection={{"type": "frustum", "left": {}, "right": {},)"
                                   R"( "bottom": {}, "top": {}, "near": 1, "far": 100}})";

}  // namespace

TEST_CASE("a .glb keeps a camera far from the origin, and its light", "[cli][gltf]") {
    for (const char* eye : {"1e5", "1e7"}) {
        CAPTURE(eye);
        const float z = std::stof(eye);
        const Exported out = exported({fmt::format("/camera/eye=[0, 0, {}]", eye), "/lights/0/space=camera",
                                       "/lights/0/position=[0.25, 1, -2]"});
        CHECK(out.ended.err.empty());
        REQUIRE(out.ended.status == 0);
        CHECK(out.scene.camera.eye == glm::vec3(0, 0, z));
        CHECK(std::abs(out.scene.camera.target.z) <= 1e-6f * z);
        REQUIRE(out.scene.lights.size() == 1);
        CHECK(out.scene.lights[0].space == LightSpace::Camera);
        CHECK(out.scene.lights[0].position == glm::vec4(0.25f, 1, -2, 1));
    }
}

TEST_CASE("a .glb export warns once about mirroring and once about the frustum's height", "[cli][gltf]") {
    const std::string straight = "glint: warning: the frustum is written as a view centred straight ahead\n";
    const std::string mirrored =
        "glint: warning: the frustum mirrors the picture (left > right, or bottom > top): the mirroring is "
        "left out\n";
    CHECK(exported({fmt::format(frustum_of, -1, 1, -1, 1)}).ended.err == straight);
    CHECK(exported({fmt::format(frustum_of, 1, -1, -1, 1)}).ended.err == straight + mirrored);
    CHECK(exported({fmt::format(frustum_of, -1, 1, 1, -1)}).ended.err == straight + mirrored);
    const Exported tall =
        exported({fmt::format(frustum_of, -1, 1, -1e7, 1e7), "/camera/projection/near=1e-6"});
    CHECK(tall.ended.status == 0);
    CHECK(tall.ended.err == straight +
                                "glint: warning: the angle of view is beyond what glTF can express: the "
                                "nearest possible one is written\n");
    CHECK(std::get<Perspective>(tall.scene.camera.projection).fov_y_deg > 179.99f);
}

TEST_CASE("a spot without a cone is written to a .glb as a point light", "[cli][gltf]") {
    const Exported out = exported({"/lights/0/type=spot", "/lights/0/spot/cutoff_deg=180"});
    CHECK(out.ended.err.empty());
    REQUIRE(out.scene.lights.size() == 1);
    CHECK(out.scene.lights[0].kind == LightKind::Point);
    CHECK(out.scene.lights[0].position == glm::vec4(0, 3, 3, 1));
}

TEST_CASE("a scene without lights has none when read back", "[cli][gltf]") {
    const Exported none = exported({"/lights=[]"});
    REQUIRE(none.ended.status == 0);
    CHECK(none.ended.err.empty());
    CHECK(none.scene.lights.empty());
    CHECK(none.scene.global_ambient == glm::vec3(0));
    const Exported off = exported({"/lights/0/enabled=false"});
    REQUIRE(off.ended.status == 0);
    CHECK(off.ended.err == "glint: warning: 1 light that is off is left out\n");
    CHECK(off.scene.lights.empty());
}

TEST_CASE("colours above 1 keep their hue in a .glb", "[cli][gltf]") {
    const Exported out = exported({"/lights/0/diffuse=[4, 2, 0.5]", "/lights/0/specular=[4, 2, 0.5]",
                                   "/objects/0/material/emission=[8, 1, 0]"});
    CHECK(out.ended.err.empty());
    REQUIRE(out.scene.lights.size() == 1);
    const glm::vec3 light = out.scene.lights[0].intensity * out.scene.lights[0].diffuse;
    CHECK(light.x == Approx(36));
    CHECK(light.y == Approx(18));
    CHECK(light.z == Approx(4.5));
    CHECK(out.scene.objects.at(0).material.emission == glm::vec3(8, 1, 0));
    CHECK(exported({"/objects/0/material/diffuse=[2, 0.5, 0.5]"}).ended.err ==
          "glint: warning: 1 material reflects more light than it receives: its colour is clamped to 1\n");
}

TEST_CASE("a scene that glTF cannot express gives one line naming the value, and no file", "[cli][gltf]") {
    const auto check = [](const std::string& setting, const std::string& line) {
        CAPTURE(setting);
        const Exported out = exported({setting});
        CHECK(out.ended.status == 1);
        CHECK(out.ended.err == "glint: error: scene.json: " + line + "\n");
        CHECK_FALSE(out.is_written);
    };
    check("/objects=[]", "/objects: no object is shown; expected a visible one that has a triangle");
    check("/objects/0/visible=false",
          "/objects: no object is shown; expected a visible one that has a triangle");
    check("/lights/0/falloff={\"quadratic\": 1e-30, \"constant\": 0}",
          "/lights/0: in glTF's units its intensity is 2.83e+31; expected at most 1e7, for a dimmer light or "
          "one nearer to the camera's target");
    check("/lights/0={\"type\": \"point\", \"position\": [0, 1e6, 0]}",
          "/lights/0: in glTF's units its intensity is 3.14e+12; expected at most 1e7, for a dimmer light or "
          "one nearer to the camera's target");
}

TEST_CASE("invisible objects are left out of a .glb with a warning", "[cli][gltf]") {
    const Exported out =
        exported({"/objects/1={\"visible\": false, \"mesh\": {\"primitive\": \"sphere\", \"detail\": 8}}"});
    REQUIRE(out.ended.status == 0);
    CHECK(out.ended.err == "glint: warning: 1 invisible object is left out\n");
    CHECK(out.scene.objects.size() == 1);
}

TEST_CASE("a .glb of a scene with arbitrary numbers opens again or is refused", "[gltf][property]") {
    const TemporaryDirectory folder;
    const auto document = std::get<SceneDocument>(open_document(folder.file("scene.json", plain)));
    std::mt19937 random(11);
    const auto number = [&random] {
        const int exponent = static_cast<int>(random() % 51) - 44;
        const float sign = random() % 2 == 0 ? 1.0f : -1.0f;
        const double size = std::stod(fmt::format("{}e{}", 1 + random() % 9, exponent));
        return sign * static_cast<float>(size);
    };
    const auto text = [&number] { return fmt::format("{}", number()); };
    const auto three = [&text] { return fmt::format("[{}, {}, {}]", text(), text(), text()); };
    std::size_t written = 0, refused = 0;
    for (int i = 0; i < 2000; ++i) {
        std::vector<Assignment> settings;
        const auto set = [&](const char* pointer, const std::string& value) {
            if (random() % 3 == 0) settings.push_back({pointer, value});
        };
        set("/camera/eye", three());
        set("/camera/target", three());
        set("/camera/up", three());
        set("/camera/projection",
            fmt::format("{{\"type\": \"frustum\", \"left\": {}, \"right\": {}, \"bottom\": {}, \"top\": {}, "
                        "\"near\": {}, \"far\": 1e7}}",
                        text(), text(), text(), text(), std::abs(number())));
        set("/camera/projection", fmt::format("{{\"type\": \"orthographic\", \"height\": {}, \"near\": "
                                              "1e-40, \"far\": 1e-39}}",
                                              std::abs(number())));
        set("/lights/0/position", three());
        set("/lights/0/space", random() % 2 == 0 ? "camera" : "world");
        set("/lights/0/type", random() % 2 == 0 ? "spot" : "point");
        set("/lights/0/intensity", fmt::format("{}", std::abs(number())));
        set("/lights/0/spot/direction", three());
        set("/lights/0/falloff",
            fmt::format("{{\"constant\": {}, \"quadratic\": {}}}", std::abs(number()), std::abs(number())));
        set("/objects/0/transform/translate", three());
        set("/objects/0/transform/rotate_deg", three());
        set("/objects/0/transform/scale", three());
        const Result<Scene> scene = scene_variant(document, settings);
        if (problem_of(scene) != nullptr) continue;
        const Result<GltfWritten> made = glb_of(std::get<Scene>(scene), "m");
        if (const Problem* problem = problem_of(made)) {
            CAPTURE(problem->text());
            CHECK(problem->pointer.starts_with("/"));  // the offending value
            ++refused;
            continue;
        }
        const Result<SceneDocument> opened =
            open_document(folder.file("out.glb", std::get<GltfWritten>(made).bytes));
        CAPTURE(scene_text(std::get<Scene>(scene)));
        if (const Problem* problem = problem_of(opened)) FAIL_CHECK(problem->text());
        ++written;
    }
    CHECK(written > 200);
    CHECK(refused > 20);
}

TEST_CASE("objects that share a mesh and material are written and read back as one mesh", "[gltf]") {
    Scene scene;
    scene.objects.assign(1, test::object_of(test::primitive(Primitive::Sphere, 40), ""));
    const Result<GltfWritten> alone = glb_of(scene, "m");
    REQUIRE(problem_of(alone) == nullptr);
    scene.objects.assign(3, scene.objects[0]);
    scene.objects[0].name = "Ball";
    scene.objects[1].name = "Second";
    scene.objects.push_back(scene.objects[0]);
    scene.objects.back().material.diffuse = {1, 0, 0};
    const Result<GltfWritten> written = glb_of(scene, "m");
    REQUIRE(problem_of(written) == nullptr);
    const std::string& bytes = std::get<GltfWritten>(written).bytes;
    CHECK(bytes.size() < std::get<GltfWritten>(alone).bytes.size() * 3 / 2);
    const Result<GltfOpened> opened = open_gltf(GltfFile::parse(bytes, ""), "m.glb");
    REQUIRE(problem_of(opened) == nullptr);
    const std::vector<Object>& objects = std::get<GltfOpened>(opened).scene.objects;
    REQUIRE(objects.size() == 4);
    CHECK(objects[0].mesh == objects[1].mesh);
    CHECK(objects[1].name == "Second");
    CHECK(objects[2].name == "Object 3");                          // not the name of the shared mesh
    CHECK(objects[3].material.diffuse == glm::vec3(0.96f, 0, 0));  // 4 % is specular
}
