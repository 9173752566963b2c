// What telling of a mesh or of a pixel needs is reckoned before it is taken.
#include "models/mesh/topology.h"
#include "renderer/inspect/answers/answers.h"
#include "renderer/inspect/answers/reflectance_answers.h"
#include "renderer/inspect/debug_views/buffers.h"
#include "renderer/inspect/explain/explain_format.h"
#include "renderer/programs/mesh_text.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/scenes.h"

using namespace glint;

TEST_CASE("the edges of a mesh are counted only where there is memory for them", "[memory]") {
    const Object ball = test::object_of(test::primitive(Primitive::Sphere, 200));
    const std::uint64_t needed = topology_memory(*ball.mesh);
    {
        const test::MemoryLimit limit(needed);
        CHECK_NOTHROW((void)info_json(*ball.mesh));
    }
    const test::MemoryLimit limit(needed - 1);
    CHECK_THROWS_AS((void)info_json(*ball.mesh), Refused);
}

TEST_CASE("what many objects hold is told only where there is memory for it", "[memory]") {
    Scene scene;
    scene.objects.assign(1000, test::object_of(test::primitive(Primitive::Cube, 1)));
    const std::uint64_t needed = info_json(scene, {8, 6}).memory();
    CHECK(needed > 1000 * 20 * sizeof(JsonValue));  // 16 members of an object, and what those hold
    {
        const test::MemoryLimit limit(2 * needed);  // with the text
        CHECK_NOTHROW((void)info_json(scene, {8, 6}));
    }
    const test::MemoryLimit limit(needed);
    CHECK_THROWS_AS((void)info_json(scene, {8, 6}), Refused);
}

TEST_CASE("rays are bounced off a rough surface only where there is memory for telling of them", "[memory]") {
    MicrofacetOptions options;
    options.rays = options.facets = 20'000;
    const std::uint64_t needed = microfacets_json(options, 100).memory();
    {
        const test::MemoryLimit limit(3 * needed);
        CHECK_NOTHROW((void)microfacets_json(options, 100));
    }
    const test::MemoryLimit limit(needed);
    CHECK_THROWS_AS((void)microfacets_json(options, 100), Refused);
}

TEST_CASE("the text of a mesh is made only where there is memory for it, and is no longer than was reckoned",
          "[memory][programs]") {
    for (const int detail : {3, 40, 200}) {
        Object ball = test::object_of(test::primitive(Primitive::Sphere, detail));
        ball.transform = {};
        MemoryShare share;
        const std::string text = mesh_text(ball, {}, share);
        const std::uint64_t reckoned = share.need().total();
        CHECK(text.size() <= reckoned);
        CHECK(reckoned < 3 * text.size() + 1000);
        share = {};
        const test::MemoryLimit limit(reckoned - 1);
        CHECK_THROWS_AS((void)mesh_text(ball, {}, share), Refused);
    }
}

TEST_CASE("the JSON of a pixel under many lights is made only where there is memory for it",
          "[memory][explain]") {
    ExplainedLight light;
    light.name = "Window";
    light.samples.resize(64);
    Explanation of_one, of_many;
    of_one.hit = of_many.hit = true;
    of_one.at.lights = {light};
    of_many.at.lights.assign(100, light);
    const std::uint64_t one = explanation_json(of_one).memory(), all = explanation_json(of_many).memory();
    const std::string text = explanation_json(of_one).text();
    std::size_t names = 0;
    for (std::size_t at = text.find("Window"); at != text.npos; at = text.find("Window", at + 1)) ++names;
    CHECK(names == 65);                        // each sample has it, too
    CHECK(one > 64 * 20 * sizeof(JsonValue));  // 18 members of a sample, and what those hold
    CHECK(all > 90 * one);
    {
        const test::MemoryLimit limit(all);
        CHECK_NOTHROW((void)explanation_json(of_many));
    }
    const test::MemoryLimit limit(all / 2);
    CHECK_NOTHROW((void)explanation_json(of_one));
    CHECK_THROWS_AS((void)explanation_json(of_many), Refused);
    of_many.lit_per_corner = true;
    of_many.corners.resize(1);
    of_many.corners[0].at = of_many.at;
    CHECK_THROWS_AS((void)explanation_json(of_many), Refused);
}

TEST_CASE("explaining a pixel under the samples of many lights takes what is reckoned at most",
          "[memory][explain]") {
    Scene scene;
    scene.objects = {test::object_of(test::primitive(Primitive::Plane, 1))};
    scene.objects[0].transform.rotate_deg = {90, 0, 0};
    Light light;
    light.name = "Window";
    light.kind = LightKind::Area;
    light.area.samples = 64;
    light.position = {0, 0, 3, 1};
    scene.lights.assign(50, light);
    Renderer renderer(1);
    for (const ShadingMode mode : {ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat}) {
        scene.shading.mode = mode;
        (void)renderer.render(scene, {16, 16});
        const Explanation e = renderer.explain(8, 8);
        std::size_t points = 0, samples = 0;
        const auto count = [&](const ExplainedPoint& at) {
            ++points;
            for (const ExplainedLight& l : at.lights) {
                CHECK(l.name == "Window");
                for (const ExplainedLight& sample : l.samples) {
                    ++samples;
                    CHECK(sample.name.empty());  // 64 more of a long one would be held
                }
            }
        };
        if (!e.lit_per_corner) count(e.at);
        for (const ExplainedCorner& corner : e.corners) count(corner.at);
        CAPTURE(points);
        CHECK(samples == points * 50 * 64);
        const std::uint64_t listed = samples * sizeof(ExplainedLight) + explain_text(e, scene).size();
        CHECK(explanation_memory(scene) >= listed);
        CHECK(explanation_memory(scene) < 10 * listed);
    }
}

TEST_CASE("each pixel is explained at most eight times for all buffers, however many lights they tell of",
          "[memory][buffers]") {
    for (const PictureSize size : {PictureSize{1, 1}, PictureSize{640, 480}, PictureSize{16384, 16384}})
        for (const std::size_t all : {1, 12, 13, 96, 97, 1000, 32000}) {
            const std::size_t at_once = buffers_at_once(size, all);
            CAPTURE(size.width, all, at_once);
            CHECK((all + at_once - 1) / at_once <= 8);
            CHECK(at_once <= std::max<std::size_t>(12 + all / 8, (64 << 20) / (12 * size.pixels())));
        }
}

TEST_CASE("a lobe is told only where there is memory for telling of it", "[memory][lobes]") {
    const std::vector<LobeSample> slice = lobe_slice({}, 45, 20'000);
    const std::uint64_t needed = lobe_json({}, "Object", 45, slice).memory();
    {
        const test::MemoryLimit limit(3 * needed);
        CHECK_NOTHROW((void)lobe_json({}, "Object", 45, slice));
    }
    const test::MemoryLimit limit(needed);
    CHECK_THROWS_AS((void)lobe_json({}, "Object", 45, slice), Refused);
}
