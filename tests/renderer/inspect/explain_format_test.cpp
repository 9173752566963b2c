// The explanation's spaces and its LaTeX form; JSON and text are tested with the command line.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>

#include "models/fields/choices.h"
#include "models/json/json.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "renderer/explain/equation_text.h"
#include "renderer/renderer.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

TEST_CASE("a picked point transformed through every space returns to its pixel", "[explain][lecture]") {
    Renderer renderer(1);
    const Scene scene = busy_scene();
    renderer.render(scene, {96, 72});
    int hits = 0;
    for (int y = 0; y < 72; y += 3)
        for (int x = 0; x < 96; x += 3) {
            const Explanation e = renderer.explain(x, y);
            if (!e.hit) continue;
            ++hits;
            const ExplainedSpaces& in = e.spaces;
            CHECK(in.pixel.x == Approx(x + 0.5).margin(0.01));
            CHECK(in.pixel.y == Approx(y + 0.5).margin(0.01));
            CHECK(in.clip.w == Approx(-in.camera.z));
            for (int i = 0; i < 3; ++i) CHECK(in.ndc[i] == Approx(in.clip[i] / in.clip.w).margin(1e-5));
            const Object& object = scene.objects[static_cast<std::size_t>(e.object_index)];
            const glm::dvec4 world =
                world_from_object(object.transform) * glm::dvec4(glm::dvec3(in.object), 1);
            for (int i = 0; i < 3; ++i) CHECK(in.world[i] == Approx(world[i]).margin(1e-5));
            for (int i = 0; i < 3; ++i) CHECK(in.world[i] == Approx(e.at.point.world[i]).margin(1e-5));
        }
    CHECK(hits > 50);
}

TEST_CASE("the explanation of a point in the eye's plane contains no infinite numbers", "[explain]") {
    Renderer renderer(1);
    const Scene scene = busy_scene();
    renderer.render(scene, {96, 72});
    Explanation e = renderer.explain(38, 36);
    REQUIRE(e.hit);
    const std::string before = explain_text(e, scene);
    CHECK(before.find("divided by 0") == std::string::npos);
    e.spaces.clip.w = 0;
    e.spaces.ndc = glm::vec3(e.spaces.clip) / 0.0f;
    e.spaces.pixel = glm::vec2(e.spaces.clip) / 0.0f;
    const std::string text = explain_text(e, scene);
    CHECK(text.find("\n  ndc           none: divided by 0\n  pixel         none: divided by 0\n") !=
          std::string::npos);
    CHECK(text.find("inf") == std::string::npos);
}

TEST_CASE("the LaTeX form is balanced, escapes names and ends with the bytes", "[explain][latex]") {
    Renderer renderer(1);
    for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong}) {
        Scene scene = busy_scene();
        scene.shading.mode = mode;
        scene.objects[0].name = "100%_ball & {box}";
        scene.lights[0].name = "a<b>|c|\n\nd";
        renderer.render(scene, {96, 72});
        const Explanation e = renderer.explain(38, 36);
        REQUIRE(e.object_index == 0);
        const std::string text = explain_latex(e, scene);
        const auto count = [&text](std::string_view what) {
            int n = 0;
            for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
            return n;
        };
        CHECK(count("\\begin{align*}") == count("\\end{align*}"));
        CHECK(count("\\begin{align*}") == (mode == ShadingMode::Gouraud ? 3 : 1));
        CHECK(count("\\[") == count("\\]"));
        CHECK(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'));
        CHECK(count("100\\%\\_ball \\& \\{box\\}") == 1);
        CHECK(count("a\\textless{}b\\textgreater{}\\textbar{}c\\textbar{}\\textbackslash{}n") > 0);
        CHECK(count("\n\n") == 0);  // an empty line would end the equation
        const std::string bytes = fmt::format("({}, {}, {})", e.byte[0], e.byte[1], e.byte[2]);
        CHECK(text.rfind(bytes) > text.size() - 40);
    }
}

// A pixel explained for a changed scene equals the explanation of that scene.
namespace {

constexpr PictureSize small{96, 72};

int differing_pixels(const Renderer& drawn, const Renderer& other, const Scene& scene) {
    const int apart = sanitized ? 7 : 3;
    int wrong = 0;
    for (int y = 0; y < small.height; y += apart)
        for (int x = 0; x < small.width; x += apart)
            wrong += explain_json(drawn.explain_as(scene, x, y)) != explain_json(other.explain(x, y));
    return wrong;
}

}  // namespace

TEST_CASE("a pixel explained for another scene equals that scene's explanation bit for bit",
          "[explain][why]") {
    const Scene scene = busy_scene();
    const std::vector<std::function<void(Scene&)>> changes{
        [](Scene& s) { s.shading.mode = ShadingMode::Flat; },
        [](Scene& s) { s.shading.mode = ShadingMode::Facet; },
        [](Scene& s) { s.shading.mode = ShadingMode::Gouraud; },
        [](Scene& s) {
            s.shading.mode = ShadingMode::Gouraud;
            s.shading.interpolation = Interpolation::Scanline;
            s.shading.rules = Rules::OpenGL2;
        },
        [](Scene& s) { s.shading.reflection = Reflection::None; },
        [](Scene& s) { s.shading.mistakes.normals_flipped = true; },
        [](Scene& s) { s.objects.front().normals.source = NormalSource::Facet; },
        [](Scene& s) { s.lights.front().position.x += 0.5f; },
        [](Scene& s) { s.objects.back().material.shininess = 3; },
        [](Scene& s) { s.display.exposure = 0.5f; },
    };
    Renderer drawn(1), other(1);
    (void)drawn.render(scene, small);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        Scene changed = scene;
        changes[i](changed);
        (void)other.render(changed, small);
        CAPTURE(i);
        CHECK(differing_pixels(drawn, other, changed) == 0);
    }
    CHECK(differing_pixels(drawn, drawn, scene) == 0);
}

// The guarantee of docs/explain.md: the values that `explain` lists, added as floats in order, equal the
// pixel bit for bit.
namespace {

using Rgb = std::array<float, 3>;

Rgb rgb_of(const Json& json) { return {json[0].get<float>(), json[1].get<float>(), json[2].get<float>()}; }

void add(Rgb& sum, const Rgb& more) {
    for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + more[i];
}

/// The base plus the shares in order, clamped like fixed-function OpenGL if `clamps`.
Rgb added_up(const Json& at, bool clamps) {
    Rgb sum = rgb_of(at["base"]);
    for (const Json& light : at["lights"]) {
        if (!light.contains("samples")) {
            add(sum, rgb_of(light["share"]));
            continue;
        }
        CHECK_FALSE(light.contains("share"));
        for (const Json& sample : light["samples"]) add(sum, rgb_of(sample["share"]));
    }
    if (clamps)
        for (float& x : sum) x = std::min(std::max(x, 0.0f), 1.0f);
    return sum;
}

bool same_bits(const Rgb& a, const Rgb& b) {
    using Bits = std::array<std::uint32_t, 3>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

void check_pixel(const Json& e, const Scene& scene, const glm::vec3& pixel) {
    const Rgb sum = rgb_of(e["sum"]);
    CHECK(same_bits(sum, {pixel.x, pixel.y, pixel.z}));
    if (!e["hit"].get<bool>() || scene.shading.reflection == Reflection::None || e.contains("stroke")) return;
    const bool per_corner = e.contains("corners");
    const bool clamps = per_corner && scene.shading.rules == Rules::OpenGL2;
    if (!per_corner) CHECK(same_bits(added_up(e, clamps), sum));
    if (per_corner)
        for (const Json& corner : e["corners"])
            CHECK(same_bits(added_up(corner, clamps), rgb_of(corner["sum"])));
}

}  // namespace

TEST_CASE("base and shares add up to the sum for each shipped scene, mode, model and rules",
          "[explain][release]") {
    Renderer renderer(1);
    const PictureSize size{47, 29};
    for (const std::string& path : test::asset_scenes()) {
        Scene scene = std::get<SceneDocument>(open_document(path)).scene;
        for (const ShadingMode mode : enumerators<ShadingMode>)
            for (const Reflection reflection : enumerators<Reflection>)
                for (const Rules rules : enumerators<Rules>) {
                    scene.shading.mode = mode;
                    scene.shading.reflection = reflection;
                    scene.shading.rules = rules;
                    INFO(path << ' ' << name_of(mode) << ' ' << name_of(reflection) << ' ' << name_of(rules));
                    const Picture& picture = renderer.render(scene, size, true);
                    for (const auto& [x, y] : {std::pair{23, 14}, {9, 20}, {36, 8}})
                        check_pixel(Json::parse(explain_json(renderer.explain(x, y))), scene,
                                    picture.linear_at(x, y));
                }
    }
}
