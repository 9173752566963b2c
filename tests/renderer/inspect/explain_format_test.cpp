// The explanation's spaces and its LaTeX form; JSON and text are tested with the command line.
#include <fmt/core.h>

#include <algorithm>

#include "renderer/explain/equation_text.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
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

TEST_CASE("the text of a point in the eye's plane has no infinite numbers", "[explain]") {
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
