// Each frame of a drag reuses the memory of the previous frame; Glint's code allocates nothing. Allocations
// are counted in operator new, on all threads; the thread library allocates its tasks elsewhere.
#include <fmt/format.h>

#include <string>

#include "models/gltf/gltf.h"
#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/allocations/counted_new.h"
#include "tests/places.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

constexpr PictureSize size{320, 180};

Scene knot() {
    const std::string path = project_file("tests/bench/knot.json");
    return std::get<SceneDocument>(open_document(path, {{"/objects/0/mesh/detail", "90"}})).scene;
}

/// The number of allocations in ten frames, after warm-up frames. `drag(scene, frame)` moves something.
template <class Drag>
long allocations_of(Renderer& renderer, Scene scene, const Drag& drag, int samples = 1, bool linear = false) {
    long before = 0;
    for (int frame = 0; frame < 30; ++frame) {
        if (frame == 20) before = allocations;
        drag(scene, frame);
        (void)renderer.render(scene, size, linear, samples);
    }
    return allocations - before;
}

long allocations_of_a_light_drag(const Scene& scene, bool keep_sums, int samples = 1, bool linear = false) {
    Renderer renderer(2);
    renderer.keep_sums(keep_sums);
    const auto drag = [](Scene& s, int) { s.lights[0].position.x += 0.01f; };
    return allocations_of(renderer, scene, drag, samples, linear);
}

/// The eye moves back and forth over the same ten positions, so no frame needs more memory than earlier ones.
long allocations_of_a_camera_drag(const Scene& scene, int samples = 1) {
    Renderer renderer(2);
    const glm::vec3 eye = scene.camera.eye;
    const auto drag = [eye](Scene& s, int frame) {
        s.camera.eye = eye + glm::vec3(0.02f * static_cast<float>(frame % 10), 0, 0);
    };
    return allocations_of(renderer, scene, drag, samples);
}

}  // namespace

TEST_CASE("the allocation counter counts allocations", "[allocations]") {
    const long before = allocations;
    int* volatile kept = new int(1);  // volatile, so that the compiler keeps new and delete
    delete kept;
    const long after = allocations;  // before CHECK itself allocates
    CHECK(after == before + 1);
}

TEST_CASE("a steady light drag allocates nothing", "[allocations]") {
    for (const ShadingMode mode : {ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat}) {
        Scene scene = knot();
        scene.shading.mode = mode;
        CAPTURE(static_cast<int>(mode));
        CHECK(allocations_of_a_light_drag(scene, true) == 0);
        CHECK(allocations_of_a_light_drag(scene, false) == 0);
        CHECK(allocations_of_a_light_drag(scene, true, 4) == 0);
        CHECK(allocations_of_a_light_drag(scene, true, 1, true) == 0);
    }
}

TEST_CASE("a steady camera drag allocates nothing", "[allocations]") {
    for (const ShadingMode mode : {ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat}) {
        Scene scene = knot();
        scene.shading.mode = mode;
        CAPTURE(static_cast<int>(mode));
        CHECK(allocations_of_a_camera_drag(scene) == 0);
        CHECK(allocations_of_a_camera_drag(scene, 4) == 0);
    }
}

TEST_CASE("a frame with an object cut by the near plane allocates nothing", "[allocations]") {
    Scene scene = knot();
    std::get<Perspective>(scene.camera.projection).near = 2;
    scene.objects.push_back(scene.objects.front());
    scene.objects.back().transform.translate.x = 0.5f;
    CHECK(allocations_of_a_camera_drag(scene) == 0);
}

TEST_CASE("vertices shared by many glTF primitives are read only once", "[allocations][bad-input]") {
    constexpr std::size_t vertices = 50'000, bytes = 12 * vertices;  // all vertices at one position
    constexpr int primitives = 200;
    std::string json = R"({"asset": {"version": "2.0"}, "meshes": [{"primitives": [)";
    for (int i = 0; i < primitives; ++i)
        json += std::string(i == 0 ? "" : ",") + R"({"attributes": {"POSITION": 0}, "indices": 1})";
    json += fmt::format(R"(]}}],
      "accessors": [{{"bufferView": 0, "componentType": 5126, "count": {}, "type": "VEC3"}},
                    {{"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}}],
      "bufferViews": [{{"buffer": 0, "byteLength": {}}}, {{"buffer": 1, "byteLength": 3}}],
      "buffers": [{{"byteLength": {}, "uri": "data:application/octet-stream;base64,{}"}},
                  {{"byteLength": 3, "uri": "data:application/octet-stream;base64,AAEC"}}]}})",
                        vertices, bytes, bytes, std::string(bytes / 3 * 4, 'A'));
    const auto read = GltfFile::parse(json, "t.gltf");
    REQUIRE(std::holds_alternative<GltfFile>(read));
    const auto& file = std::get<GltfFile>(read);
    const std::int64_t before = all_bytes;
    for (int part = 0; part < primitives; ++part) {
        const auto mesh = file.mesh(part);
        REQUIRE(std::holds_alternative<Mesh>(mesh));
    }
    const std::int64_t taken = all_bytes - before;
    CHECK(taken < 10 * std::int64_t(bytes));
}
