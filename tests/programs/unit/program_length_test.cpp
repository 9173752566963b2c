// The contents of a program that do not depend on its language, its maximum length, and the message about one
// that is too long.
#include <ctime>
#include <regex>

#include "programs/program.h"
#include "programs/scene_tables.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;

namespace {

/// A small scene with this many lights and balls, each of which adds at least one line to every program.
Scene scene_of(std::size_t lights, std::size_t balls) {
    Scene scene = test::busy_scene();
    scene.shading.mode = ShadingMode::Phong;  // OpenGL 1 does not support it
    scene.lights.assign(lights, Light{});
    scene.objects.assign(balls, scene.objects.front());
    return scene;
}

std::string refused(const Scene& scene, Language language) {
    const auto program = write_program({scene, {64, 48}, "scene"}, language);
    return problem_of(program) == nullptr ? "" : problem_of(program)->expected;
}

}  // namespace

TEST_CASE("a program keeps the kind of every light except a spot without a cone", "[programs]") {
    const float cutoff_deg = GENERATE(0.0f, 1.0f, 45.0f, 89.5f, 90.0f, 180.0f);
    Scene scene = scene_of(4, 1);
    for (std::size_t i = 0; i < 4; ++i) scene.lights[i].kind = static_cast<LightKind>(i);
    for (Light& light : scene.lights) light.spot.cutoff_deg = cutoff_deg;
    const std::vector<Light> lights = shining(scene);
    REQUIRE(lights.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        const bool lacks_cone = scene.lights[i].kind == LightKind::Spot && cutoff_deg == 180;
        CHECK(lights[i].kind == (lacks_cone ? LightKind::Point : scene.lights[i].kind));
    }
}

TEST_CASE("the message about a program that is too long names a shorter language", "[programs]") {
    CHECK(refused(scene_of(1, 1), Language::Python).empty());
    CHECK(refused(scene_of(60, 1), Language::Python) ==  // GLSL supports 32 lights
          "at most 250: fewer lights and objects, or --language cpp");
    CHECK(refused(scene_of(1, 400), Language::Cpp) ==
          "at most 400: fewer lights and objects, or --language glsl or webgl");
    CHECK(refused(scene_of(60, 400), Language::Cpp) == "at most 400: fewer lights and objects");
}

TEST_CASE("many objects with one mesh make a program only slightly longer than one object", "[programs]") {
    Scene scene = scene_of(1, 1);
    scene.objects[0].mesh = test::primitive(Primitive::Sphere, 100);
    scene.objects[0].normals = {NormalSource::Vertex, NormalWeighting::Angle, 30, false};
    const auto seconds = [&scene] {
        const std::clock_t start = std::clock();
        REQUIRE(problem_of(write_program({scene, {64, 48}, "scene"}, Language::Glsl)) == nullptr);
        return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    };
    const double of_one = seconds();
    scene.objects.assign(400, scene.objects[0]);
    CHECK(seconds() < 100 * of_one);
}

TEST_CASE("a scene's description does not set Python's source encoding", "[programs]") {
    Scene scene = scene_of(1, 1);
    scene.about = "Encoding: sRGB against none";
    const auto program = write_program({scene, {64, 48}, "scene"}, Language::Python);
    REQUIRE(problem_of(program) == nullptr);
    const std::string& text = std::get<Program>(program).texts.front().text;
    // PEP 263: the first match in the first two lines counts. It must name an encoding that Python supports.
    std::smatch told;
    REQUIRE(std::regex_search(text, told, std::regex("coding[:=][ \t]*([-_.a-zA-Z0-9]+)")));
    CHECK(told[1] == "utf-8");
    CHECK(text.find("Encoding: sRGB against none") != std::string::npos);
}

TEST_CASE("a program's mesh file has a valid file name", "[programs]") {
    Scene scene = scene_of(1, 2);
    for (Object& object : scene.objects) {
        object.name = std::string(1000, 'n');
        object.source = MeshFile{"scene.glb", 0};
    }
    scene.objects[1].normals.source = NormalSource::Facet;  // needs a separate mesh file
    const auto program = write_program({scene, {64, 48}, "scene"}, Language::Python);
    REQUIRE(problem_of(program) == nullptr);
    const std::vector<ProgramMesh>& meshes = std::get<Program>(program).meshes;
    REQUIRE(meshes.size() == 2);
    CHECK(meshes[0].name != meshes[1].name);
    for (const ProgramMesh& mesh : meshes) CHECK(mesh.name.size() < 80);
}

TEST_CASE("equal names are numbered in a program, skipping numbers already used", "[programs]") {
    Identifiers identifiers({"x_4"});
    CHECK(identifiers.once("x") == "x");
    CHECK(identifiers.once("x_3") == "x_3");
    CHECK(identifiers.once("x") == "x_2");
    CHECK(identifiers.once("x") == "x_5");
    CHECK(identifiers.once("x") == "x_6");
    CHECK(identifiers.once("x_3") == "x_3_2");
    CHECK(identifiers.once("y") == "y");
}

TEST_CASE("a name that a library may define is not used in a program", "[programs]") {
    Identifiers identifiers({});
    for (const std::string name :
         {"log", "NULL", "GLint", "glFlush", "OSMesaPixelStore", "M_PIf", "L_tmpnam", "P_tmpdir"})
        CHECK(identifiers.of(name, "object") == name + "_object");
    for (const std::string name : {"Teapot", "Left_lamp", "Moon", "Plate"})
        CHECK(identifiers.of(name, "object") == name);
}
