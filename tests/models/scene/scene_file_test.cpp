// The meaning of a scene file's keys: defaults, the example in docs/scene_file.md, limits, hostile text.
#include "models/scene_file/scene_file.h"

#include <chrono>

#include "models/fields/choices.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

Scene scene_of(const std::string& text) {
    const Result<Scene> result = parse_scene(text, "scene.json");
    INFO(text.substr(0, 1000) << "\n" << (problem_of(result) != nullptr ? problem_of(result)->text() : ""));
    REQUIRE(problem_of(result) == nullptr);
    return std::get<Scene>(result);
}

std::string problem_in(const std::string& text) {
    const Result<Scene> result = parse_scene(text, "s");
    return problem_of(result) != nullptr ? problem_of(result)->text() : "no problem";
}

/// `count` times `element`, separated by commas.
std::string repeated(const std::string& element, int count) {
    std::string text = element;
    for (int i = 1; i < count; ++i) text.append(",").append(element);
    return text;
}

constexpr const char* example = R"({
  "glint": 1,
  "camera": {
    "eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0],
    "projection": {"type": "perspective", "fov_y_deg": 45, "near": 0.1, "far": 100}
  },
  "global_ambient": [0.1, 0.1, 0.1],
  "lights": [
    {"name": "Sun",  "type": "directional", "space": "world",  "position": [1, 2, 1, 0]},
    {"name": "Bulb", "type": "point", "space": "camera", "position": [0, 1, 0, 1],
     "ambient": [0, 0, 0], "diffuse": [1, 1, 1], "specular": [1, 1, 1], "intensity": 1, "enabled": true,
     "falloff": {"constant": 1, "linear": 0, "quadratic": 0.2}},
    {"name": "Lamp", "type": "spot", "space": "world", "position": [0, 3, 0, 1],
     "spot": {"direction": [0, -1, 0], "cutoff_deg": 30, "exponent": 8}},
    {"name": "Window", "type": "area", "space": "world", "position": [-3, 2, 0, 1],
     "area": {"edge_u": [0, 0.5, 0], "edge_v": [0, 0, 0.5], "samples": 16}}
  ],
  "objects": [
    {"name": "Teapot", "mesh": {"primitive": "teapot", "detail": 12},
     "transform": {"translate": [0, 0, 0], "rotate_deg": [0, 0, 0], "scale": [1, 1, 1]},
     "normals": {"source": "auto", "weighting": "angle", "crease_deg": 180},
     "material": {"ambient": [0.2, 0.2, 0.2], "diffuse": [0.8, 0.3, 0.3], "specular": [1, 1, 1],
                  "emission": [0, 0, 0], "shininess": 32, "roughness": 0.5, "f0": [0.04, 0.04, 0.04]}}
  ],
  "shading": {
    "mode": "phong", "reflection": "phong", "interpolation": "perspective",
    "flat_point": "centroid", "two_sided": false, "local_viewer": true, "cull": "none", "rules": "lecture",
    "terms": {"emission": true, "ambient": true, "diffuse": true, "specular": true},
    "mistakes": {}
  },
  "npr": {"cool_to_warm": false, "cool": [0, 0, 0.55], "warm": [0.3, 0.3, 0], "alpha": 0.25, "beta": 0.5,
          "silhouettes": false, "creases": false, "crease_deg": 40, "stroke": [0, 0, 0], "stroke_width_px": 2},
  "display": {"background": [0.1, 0.1, 0.12], "transfer": "none", "exposure": 1}
})";

}  // namespace

TEST_CASE("the smallest scene has only default values", "[scene_file]") {
    CHECK(scene_of(R"({"glint": 1})") == Scene{});
    CHECK(scene_of("\xEF\xBB\xBF \t\r\n{\"glint\": 1.0}\n") == Scene{});
    CHECK(
        scene_of(
            R"({"glint": 1, "camera": {"projection": {}}, "shading": {"terms": {}, "mistakes": {}}, "npr": {},
                       "display": {}, "lights": [], "objects": []})") == Scene{});
}

TEST_CASE("an empty light, object and projection have the documented defaults", "[scene_file]") {
    const Scene scene = scene_of(R"({"glint": 1, "lights": [{}], "objects": [{"mesh": {}}],
                                     "camera": {"projection": {"type": "orthographic"}}})");
    const Light& l = scene.lights.at(0);
    CHECK(l.kind == LightKind::Point);
    CHECK(l.space == LightSpace::World);
    CHECK(l.position == glm::vec4(0, 2, 2, 1));
    CHECK(l.ambient == glm::vec3(0));
    CHECK(l.diffuse == glm::vec3(1));
    CHECK(l.specular == glm::vec3(1));
    CHECK((l.intensity == 1 && l.enabled));
    CHECK(l.falloff == Falloff{1, 0, 0});
    CHECK(l.spot == SpotCone{{0, -1, 0}, 30, 1});
    CHECK(l.area == AreaShape{{0.5f, 0, 0}, {0, 0, 0.5f}, 16});
    const Object& o = scene.objects.at(0);
    CHECK(std::get<PrimitiveMesh>(o.source) == PrimitiveMesh{Primitive::Sphere, 48});
    CHECK(o.transform == Transform{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}});
    CHECK(o.normals == NormalOptions{NormalSource::Auto, NormalWeighting::Angle, 180});
    CHECK(o.material.ambient == glm::vec3(0.2f));
    CHECK(o.material.diffuse == glm::vec3(0.8f));
    CHECK(o.material.f0 == glm::vec3(0.04f));
    CHECK((o.material.shininess == 32 && o.material.roughness == 0.5f));
    CHECK(std::get<Orthographic>(scene.camera.projection) == Orthographic{4, 0.1f, 100});
}

TEST_CASE("the example in the documentation reads as documented", "[scene_file]") {
    const Scene scene = scene_of(example);
    REQUIRE(scene.lights.size() == 4);
    CHECK(scene.lights[0].kind == LightKind::Directional);
    CHECK(scene.lights[0].position == glm::vec4(1, 2, 1, 0));
    CHECK(scene.lights[1].space == LightSpace::Camera);
    CHECK(scene.lights[1].falloff == Falloff{1, 0, 0.2f});
    CHECK(scene.lights[2].spot == SpotCone{{0, -1, 0}, 30, 8});
    CHECK(scene.lights[3].area == AreaShape{{0, 0.5f, 0}, {0, 0, 0.5f}, 16});
    REQUIRE(scene.objects.size() == 1);
    CHECK(scene.objects[0].name == "Teapot");
    CHECK(std::get<PrimitiveMesh>(scene.objects[0].source) == PrimitiveMesh{Primitive::Teapot, 12});
    CHECK(scene.objects[0].material.diffuse == glm::vec3(0.8f, 0.3f, 0.3f));
    Scene rest = scene;  // the other keys of the example have their defaults
    rest.lights.clear();
    rest.objects.clear();
    CHECK(rest == Scene{});
}

TEST_CASE("every primitive has its own default detail", "[scene_file]") {
    const std::vector<std::pair<std::string, int>> defaults{
        {"sphere", 48},   {"bumpy-sphere", 48}, {"icosphere", 3},       {"cube", 1},    {"plane", 1},
        {"torus", 48},    {"cylinder", 48},     {"cone", 48},           {"teapot", 12}, {"knot", 256},
        {"skew-quad", 1}, {"t-junction", 1},    {"tessellated-quad", 8}};
    for (const auto& [name, detail] : defaults) {
        const Scene scene =
            scene_of(std::string(R"({"glint": 1, "objects": [{"mesh": {"primitive": ")") + name + "\"}}]}");
        CHECK(name_of(std::get<PrimitiveMesh>(scene.objects[0].source).primitive) == name);
        CHECK(std::get<PrimitiveMesh>(scene.objects[0].source).detail == detail);
    }
}

TEST_CASE("a light's position is homogeneous, three numbers imply the w of its type", "[scene_file]") {
    const auto position = [](const std::string& light) {
        return scene_of(std::string(R"({"glint": 1, "lights": [{)") + light + "}]}").lights.at(0).position;
    };
    CHECK(position(R"("position": [2, 4, 6, 2])") == glm::vec4(1, 2, 3, 1));
    CHECK(position(R"("type": "spot", "position": [2, 4, 6, 0.5])") == glm::vec4(4, 8, 12, 1));
    CHECK(position(R"("position": [1, 2, 3])") == glm::vec4(1, 2, 3, 1));
    CHECK(position(R"("position": [1, 2, 3], "type": "directional")") == glm::vec4(1, 2, 3, 0));
    CHECK(position(R"("type": "directional", "position": [1, 2, 3, 0])") == glm::vec4(1, 2, 3, 0));
    CHECK(position(R"("type": "directional")") == glm::vec4(0, 2, 2, 0));
    CHECK(position(R"("position": [0, 0, 0])") == glm::vec4(0, 0, 0, 1));
}

TEST_CASE("a range of allowed values includes its ends", "[scene_file]") {
    const Scene scene = scene_of(R"({"glint": 1,
        "lights": [{"spot": {"cutoff_deg": 0, "exponent": 0}}, {"spot": {"cutoff_deg": 90}},
                   {"spot": {"cutoff_deg": 180}, "intensity": 0, "diffuse": [0, 0, 1e7], "area": {"samples": 64}}],
        "objects": [{"normals": {"crease_deg": 0}, "material": {"shininess": 10000, "roughness": 1},
                     "transform": {"translate": [1e7, -1e7, 0], "scale": [-1, 1, 1]}}]})");
    CHECK(scene.lights[2].spot.cutoff_deg == 180);
    CHECK(scene.lights[2].diffuse.z == 1e7f);
    CHECK(scene.objects[0].material.shininess == 10000);
}

TEST_CASE("a scene has at most 4096 lights, 10000 objects and 64 levels of nesting", "[scene_file]") {
    const auto lights = [](int n) {
        return std::string(R"({"glint": 1, "lights": [)") + repeated("{}", n) + "]}";
    };
    const auto objects = [](int n) {
        return std::string(R"({"glint": 1, "objects": [)") + repeated("{}", n) + "]}";
    };
    CHECK(scene_of(lights(4096)).lights.size() == 4096);
    CHECK(problem_in(lights(4097)) == "s: /lights: 4097 lights; expected at most 4096");
    CHECK(scene_of(objects(10'000)).objects.size() == 10'000);
    CHECK(problem_in(objects(10'001)) == "s: /objects: 10001 objects; expected at most 10000");
    const auto nested = [](std::size_t n) {  // an object, and arrays in it: n + 1 deep
        return std::string(R"({"npr": )") + std::string(n, '[') + std::string(n, ']') + "}";
    };
    CHECK(problem_in(nested(63)) ==
          "s: the key \"glint\" is missing; expected \"glint\": 1, the version of the format");
    CHECK(problem_in(nested(64)).find("nested too deeply; expected at most 64 deep") != std::string::npos);
    CHECK(problem_in(std::string(200'000, '[')).find("nested too deeply") != std::string::npos);
    CHECK(problem_in(std::string((64 << 20) + 1, ' ')) ==
          "s: 67108865 bytes of text; expected at most 64 MiB");
    CHECK(problem_in(std::string("[") + repeated("[]", 2'000'001) + "]").find("too many values") !=
          std::string::npos);
}

TEST_CASE("a scene of 10000 objects is read in well under a second", "[scene_file]") {
    Scene scene;
    scene.objects.resize(10'000);
    const std::string text = scene_text(scene);
    const auto start = std::chrono::steady_clock::now();
    CHECK(scene_of(text) == scene);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    INFO(text.size() << " bytes, " << seconds.count() << " s");
    CHECK(seconds.count() < 60);  // with sanitizers on a busy machine; 0.15 s in Release
}
