// Finds numbers of a scene that have a row but change no picture.
#include <algorithm>
#include <chrono>
#include <regex>
#include <set>

#include "models/fields/scene_fields.h"
#include "models/memory_limit.h"
#include "models/scene_file/scene_file.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/object_normals.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;
using test::MemoryLimit;

namespace {

constexpr PictureSize number_size{64, 48};

/// Scenes that together use every number.
std::vector<Scene> scenes() {
    Scene first = busy_scene();
    for (Object& object : first.objects) {
        object.source = PrimitiveMesh{Primitive::Cube, 2};
        object.mesh.reset();
    }
    first.objects[0].normals = {NormalSource::Vertex, NormalWeighting::Angle, 100};
    first.shading.power_table = 16;
    REQUIRE(problem_of(load_meshes(first, "scene.json", ".")) == nullptr);
    std::vector<Scene> all(6, first);
    for (Scene& scene : all) scene.shading.power_table = 0;
    all.push_back(first);
    all[0].shading.reflection = Reflection::CookTorrance;
    all[1].shading.reflection = Reflection::OrenNayar;
    all[2].camera.projection = Orthographic{3};
    all[2].shading.mistakes.half_lambert = true;
    all[3].camera.projection = Frustum{-0.1f, 0.1f, -0.08f, 0.08f, 0.2f, 6};
    all[5].transport = {TransportModel::Bounces, 2, 1, 1};
    all[4].npr.cool_to_warm = all[4].npr.silhouettes = all[4].npr.creases = true;
    for (Light& light : all[5].lights) light.spot.inner_deg = light.spot.cutoff_deg / 2;
    for (Scene& scene : all)  // planes that cut through the objects
        std::visit([](auto& projection) { projection.near = 3.2f, projection.far = 4.4f; },
                   scene.camera.projection);
    return all;
}

std::vector<std::uint8_t> drawn_bytes(Renderer& renderer, Scene scene) {
    REQUIRE(problem_of(load_meshes(scene, "scene.json", ".")) == nullptr);
    return renderer.render(scene, number_size).rgba;
}

/// The pointer without the number of the light or object: "/lights/*/falloff/linear".
std::string of_any_item(const std::string& pointer) {
    return std::regex_replace(pointer, std::regex("^/(lights|objects)/[0-9]+"), "/$1/*");
}

/// Whether some other value of the number gives a different picture.
bool has_effect(Renderer& renderer, const Scene& scene, const SceneNumber& number,
                const std::vector<std::uint8_t>& before) {
    const double v = number.value;
    for (const double other : {v + 0.4, 0.5 * v, 1.5 * v + 0.1, v + 1, v + 5, v + 30, v - 40}) {
        Scene changed = scene;
        if (set_number(changed, number.pointer, other)) continue;
        if (drawn_bytes(renderer, changed) != before) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("every number of a scene changes a picture", "[renderer][scene_fields]") {
    std::set<std::string> all, with_effect;
    Renderer renderer(1);
    for (const Scene& scene : scenes()) {
        const std::vector<std::uint8_t> before = drawn_bytes(renderer, scene);
        for (const SceneNumber& number : numbers_of(scene)) {
            const std::string name = of_any_item(number.pointer);
            all.insert(name);
            if (!with_effect.count(name) && has_effect(renderer, scene, number, before))
                with_effect.insert(name);
        }
    }
    CHECK(all.size() > 80);
    std::vector<std::string> idle;
    std::set_difference(all.begin(), all.end(), with_effect.begin(), with_effect.end(),
                        std::back_inserter(idle));
    CHECK(idle == std::vector<std::string>{});
}

// Pictures that exceed the memory limit are refused in one line, most of them before drawing.
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
