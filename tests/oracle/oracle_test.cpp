#include <cstdio>
#include <filesystem>

#include "models/scene_file/scene_file.h"
#include "programs/program.h"
#include "tests/gl/program.h"
#include "tests/oracle/agreement.h"
#include "tests/oracle/random_scene.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::oracle;

namespace {

/// Prints the results of a run and fails for every scene that disagrees.
void report(const Comparison& comparison) {
    std::printf("%s\n", comparison.figure().text().c_str());
    for (const std::string& line : comparison.figure().disagreements) FAIL_CHECK(line);
}

/// A shader in a page for browsers, with the text that the page puts before it. `stage`: VERTEX or FRAGMENT.
test::ShaderSource shader_in(const std::string& page, const std::string& stage, const std::string& name) {
    const auto element = [&page](const std::string& id) {
        const std::size_t from = page.find('\n', page.find("id=\"" + id + "\""));
        REQUIRE(from != std::string::npos);
        return page.substr(from, page.find("</script>", from) - from);
    };
    const bool is_lit = page.find(stage + "_SHADER, \"lighting.glsl\"") != std::string::npos;
    return {name, "#version 300 es\nprecision highp float;\nprecision highp int;\n" +
                      (is_lit ? element("lighting.glsl") : "") + element(name)};
}

}  // namespace

TEST_CASE("OpenGL draws random scenes as Glint does", "[oracle]") {
    Comparison comparison;
    for (unsigned i = 0; i < 168; ++i) {
        const Scene scene = random_scene(i);
        REQUIRE(can_draw(scene));
        comparison.add("random scene " + std::to_string(i), scene, {160, 120}, Route::Shader);
    }
    for (unsigned i = 0; i < 72; ++i) {
        const Scene scene = random_fixed_function_scene(i);
        REQUIRE(fixed_function_can_draw(scene));
        comparison.add("fixed-function scene " + std::to_string(i), scene, {160, 120}, Route::FixedFunction);
    }
    report(comparison);
    CHECK(comparison.figure().pixels > 500000);
}

TEST_CASE("OpenGL draws the scenes in assets/ as Glint does", "[oracle]") {
    Comparison comparison;
    std::string not_drawn;
    for (const std::string& path : test::asset_scenes()) {
        const Result<SceneDocument> opened = open_document(path);
        REQUIRE_FALSE(problem_of(opened));
        Scene scene = std::get<SceneDocument>(opened).scene;
        // OpenGL uses the local lighting model and shows the sum without exposure.
        scene.transport = {};
        scene.display.exposure = 1;
        // OpenGL draws no such strokes, only the faces under them.
        scene.npr.silhouettes = scene.npr.creases = false;
        const std::string name = std::filesystem::path(path).stem().string();
        if (!can_draw(scene)) {
            not_drawn += " " + name;
            continue;
        }
        const Route route = fixed_function_can_draw(scene) ? Route::FixedFunction : Route::Shader;
        comparison.add(name, scene, {320, 240}, route);
    }
    report(comparison);
    std::printf("  not drawn by OpenGL:%s\n", not_drawn.c_str());
    CHECK(comparison.figure().scenes > 0);
}

TEST_CASE("OpenGL ES compiles the shaders of the pages for browsers", "[oracle]") {
    int compiled = 0;
    for (const std::string& path : test::asset_scenes()) {
        INFO(path);
        const Result<SceneDocument> opened = open_document(path);
        REQUIRE_FALSE(problem_of(opened));
        const Result<Program> page =
            write_program({std::get<SceneDocument>(opened).scene, {64, 48}, "page"}, Language::Webgl);
        if (problem_of(page) != nullptr) continue;
        const std::string& text = std::get<Program>(page).texts.front().text;
        (void)GlCanvas().bytes({8, 8}, [&] {
            CHECK(test::link_program(shader_in(text, "VERTEX", "scene.vert"),
                                     shader_in(text, "FRAGMENT", "scene.frag")) > 0);
        });
        ++compiled;
    }
    CHECK(compiled > 30);
}
