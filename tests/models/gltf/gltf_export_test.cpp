// Exported files, read back by Glint and by assimp.
#include <cstdlib>

#include "models/gltf/gltf.h"
#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

/// Everything that glTF can express: metal and roughness, lights with quadratic falloff, one that moves with
/// the camera.
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

TEST_CASE("a scene that glTF can express reads back to the same picture", "[cli][gltf]") {
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

TEST_CASE("a spot's soft edge is written exactly, an exponent as a soft edge with a warning", "[cli][gltf]") {
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

TEST_CASE("another program reads our glTF files", "[cli][gltf]") {
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
