// How long a program may be, and what is said of one that would be longer.
#include "renderer/programs/program.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;

namespace {

/// A small scene, but for so many lights and balls: each is a line of every program, or more.
Scene scene_of(std::size_t lights, std::size_t balls) {
    Scene scene = test::busy_scene();
    scene.shading.mode = ShadingMode::Phong;  // which OpenGL 1 cannot do
    scene.lights.assign(lights, Light{});
    scene.objects.assign(balls, scene.objects.front());
    return scene;
}

std::string refused(const Scene& scene, Language language) {
    const auto program = write_program({scene, {64, 48}, "scene"}, language);
    return problem_of(program) == nullptr ? "" : problem_of(program)->expected;
}

}  // namespace

TEST_CASE("of a program that is too long it is said in which language it is not", "[programs]") {
    CHECK(refused(scene_of(1, 1), Language::Python).empty());
    CHECK(refused(scene_of(60, 1), Language::Python) ==  // of which GLSL takes 32
          "at most 250: fewer lights and objects, or --language cpp");
    CHECK(refused(scene_of(1, 400), Language::Cpp) ==
          "at most 400: fewer lights and objects, or --language glsl");
    CHECK(refused(scene_of(60, 400), Language::Cpp) == "at most 400: fewer lights and objects");
}
