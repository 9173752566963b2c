// Pictures that exceed the memory limit are refused in one line, most of them before drawing.
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
