// Pictures that exceed the memory: refused in one line, most of them before drawing.
#include <chrono>

#include "models/memory_limit.h"
#include "models/scene_file/scene_file.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/object_normals.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"

using namespace glint;
using test::MemoryLimit;

namespace {

constexpr std::uint64_t mib = std::uint64_t{1} << 20;

Scene scene_of(const PrimitiveMesh& source, std::size_t count) {
    Scene scene;
    scene.lights.emplace_back();
    scene.objects.resize(count);
    for (Object& object : scene.objects) object.source = source;
    REQUIRE(problem_of(load_meshes(scene, "", "")) == nullptr);
    return scene;
}

std::string refusal_of(Renderer& renderer, const Scene& scene, PictureSize size, int samples = 1) {
    try {
        (void)renderer.render(scene, size, false, samples);
    } catch (const LimitExceeded& exceeded) {
        return exceeded.what();
    }
    return {};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("objects of one mesh share data that does not depend on their transforms", "[memory][geometry]") {
    Scene scene = scene_of({Primitive::Teapot, 6}, 4);
    scene.objects[3].normals.source = NormalSource::Facet;
    for (std::size_t i = 0; i < 4; ++i) scene.objects[i].transform.translate.x = static_cast<float>(i);
    Geometry g;
    REQUIRE(update_geometry(g, scene, {64, 64}));
    std::vector<ObjectNormals> normals;
    update_normals(normals, scene, g, {});
    for (std::size_t i = 1; i < 4; ++i) {
        CHECK(g.objects[i].triangle_vertices.data() == g.objects[0].triangle_vertices.data());
        CHECK((normals[i].of_mesh == normals[0].of_mesh) == (i < 3));
    }
    // Adding a fifth one and giving the first another mesh keeps the lists of the others.
    const std::uint32_t* const list = g.objects[1].triangle_vertices.data();
    const auto of_mesh = normals[1].of_mesh;
    scene.objects.push_back(scene.objects[1]);
    scene.objects[0].mesh = std::make_shared<const Mesh>(make_primitive(Primitive::Cube, 2));
    REQUIRE(update_geometry(g, scene, {64, 64}));
    update_normals(normals, scene, g, {});
    CHECK(g.objects[0].triangle_vertices.size() == 3 * scene.objects[0].mesh->triangles.size());
    for (const std::size_t i : {1u, 2u, 3u, 4u}) CHECK(g.objects[i].triangle_vertices.data() == list);
    CHECK(normals[4].of_mesh == of_mesh);
}

TEST_CASE("a scene that is too large is refused before drawing, keeping the last picture",
          "[memory][renderer]") {
    const Scene scene = scene_of({Primitive::Sphere, 24}, 1);
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, {64, 48});
    const std::vector<std::uint8_t> before = picture.rgba;
    const MemoryLimit limit(300 * mib);
    CHECK(contains(refusal_of(renderer, scene, {2048, 2048}, 8),
                   "of it for the picture; expected at most 300.0 MiB"));
    CHECK(picture.rgba == before);
    CHECK(renderer.object_at(32, 24) == 0);
    CHECK(renderer.render(scene, {64, 48}).rgba == before);
}

TEST_CASE("many objects of a large mesh are refused before any is transformed", "[memory][renderer]") {
    const Scene scene = scene_of({Primitive::Teapot, 100}, 200);
    const MemoryLimit limit(1000 * mib);
    Renderer renderer(1);
    const auto start = std::chrono::steady_clock::now();
    CHECK(contains(refusal_of(renderer, scene, {64, 64}), "of it for the objects"));
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::milliseconds(500));
}

TEST_CASE("the largest picture is refused at once if it does not fit", "[memory][cli]") {
    const std::string teapot = project_file("assets/scenes/default.json");
    const auto start = std::chrono::steady_clock::now();
    const TemporaryDirectory directory;
    const Ended ended = run_glint({"render", teapot, "-o", directory.path("o.png"), "--size", "16384x16384",
                                   "--samples", "4", "--memory", "8G"});
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
    CHECK(ended.status == 1);
    CHECK(ended.out.empty());
    CHECK(ended.err.starts_with("glint: error: " + teapot + ": this needs "));
    CHECK(contains(ended.err,
                   " of it for the picture; expected at most 8.0 GiB (--memory and "
                   "GLINT_MEMORY change that)\n"));
}

TEST_CASE("every command with a scene has a memory limit option and uses GLINT_MEMORY", "[memory][cli]") {
    const TemporaryDirectory directory;
    const std::string scene = directory.file(
        "s.json", R"({"glint": 1, "objects": [{"mesh": {"primitive": "sphere", "detail": 500}}]})");
    const std::string refused = "glint: error: " + scene + ": this needs ";
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"render", scene, "-o", directory.path("o.png")},
          {"explain", scene, "--pixel", "1,1"},
          {"profile", scene, "--from", "1,1", "--to", "9,9"},
          {"info", scene},
          {"bench", scene},
          {"lobe", scene},
          {"sheet", scene, "--rows", "/display/exposure=1,2", "--cols", "/shading/mode=flat,phong", "-o",
           directory.path("o.png")},
          {scene}}) {
        CAPTURE(words);
        std::vector<std::string> with_option = words;
        with_option.insert(with_option.begin(), {"--memory", "20M"});
        const Ended ended = run_glint(with_option);
        CHECK(ended.status == 1);
        CHECK(ended.err.starts_with(refused));
        CHECK(contains(ended.err, "expected at most 20.0 MiB"));
    }
    setenv("GLINT_MEMORY", "21M", 1);
    CHECK(contains(run_glint({"info", scene}).err, "expected at most 21.0 MiB"));
    CHECK(run_glint({"info", scene, "--memory", "1G"}).status == 0);
    setenv("GLINT_MEMORY", "much", 1);
    const Ended wrong = run_glint({"info", scene});
    CHECK(wrong.status == 2);
    CHECK(wrong.err.starts_with("glint: error: GLINT_MEMORY: much is not a memory size; expected "));
    unsetenv("GLINT_MEMORY");
    const Ended option = run_glint({"info", scene, "--memory", "much"});
    CHECK(option.status == 2);
    CHECK(option.err.starts_with("glint: error: --memory: much is not a memory size; expected "));
}
