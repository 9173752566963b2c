#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "models/fields/choices.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "programs/gl_calls.h"
#include "tests/oracle/random_scene.h"
#include "tests/places.h"
#include "tests/programs/same_picture.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"
#include "tests/support/mistake_scenes.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::programs;

namespace {

constexpr PictureSize small{120, 90};

bool can(const Scene& scene, Language language) {
    return problem_of(write_program({scene, small, "scene"}, language)) == nullptr;
}

/// Limits the scene to what fixed function can draw: its shading, its lights, its numbers. The seed chooses
/// among alternatives.
void as_fixed_function(Scene& scene, unsigned seed) {
    scene.shading = {};
    scene.shading.mode = seed % 3 == 2 ? ShadingMode::Flat : ShadingMode::Gouraud;
    scene.shading.flat_point = FlatPoint::Provoking;
    scene.shading.reflection = seed % 4 == 3 ? Reflection::Lambert : Reflection::BlinnPhong;
    scene.shading.rules = seed % 2 == 0 ? Rules::Lecture : Rules::OpenGL2;
    scene.shading.two_sided = seed % 5 == 0;
    scene.shading.local_viewer = seed % 7 != 0;
    scene.npr = {};
    scene.display.transfer = Transfer::None;
    scene.display.exposure = 1;
    std::erase_if(scene.lights, [](const Light& l) { return l.kind == LightKind::Area; });
    if (scene.lights.empty()) scene.lights.emplace_back();
    if (scene.lights.size() > 8) scene.lights.resize(8);
    for (Light& light : scene.lights) light.spot.exponent = std::min(light.spot.exponent, 128.0f);
    for (Object& object : scene.objects) {
        object.material.shininess = std::clamp(object.material.shininess, 1.0f, 128.0f);
        object.material.reflection = OwnReflection::Scene;
    }
}
Scene fixed_function_scene(unsigned seed) {
    Scene scene = oracle::random_scene(seed);
    as_fixed_function(scene, seed);
    return scene;
}

/// Prints the results and fails for each scene that disagrees.
void report(const Comparison& comparison, Language language) {
    const Figure& f = comparison.figure();
    std::printf(
        "programs: %s: %d scenes, %zu pixels, %zu on surfaces; %.2f of the bound at most, %d levels\n",
        std::string(name_of(language)).c_str(), f.scenes, f.pixels, f.surfaces, f.largest, f.largest_bytes);
    for (const std::string& line : f.disagreements) FAIL_CHECK(line);
}

/// Draws the scenes in assets/ that the language supports; returns the names of the others.
std::string compare_assets(Language language, void (*change)(Scene&) = nullptr) {
    Comparison comparison;
    std::string left;
    for (const std::string& path : test::asset_scenes()) {
        const Result<SceneDocument> opened = open_document(path);
        REQUIRE_FALSE(problem_of(opened));
        Scene scene = std::get<SceneDocument>(opened).scene;
        scene.transport = {};  // programs only draw the local model
        if (change != nullptr) change(scene);
        const std::string name = std::filesystem::path(path).stem().string();
        if (can(scene, language))
            comparison.add(name, scene, small, language);
        else
            left += (left.empty() ? "" : " ") + name;
    }
    report(comparison, language);
    return left;
}

/// Draws `count` random scenes, or as many of them as the language supports.
int compare_random(Language language, unsigned first, unsigned count) {
    Comparison comparison;
    for (unsigned i = first; i < first + count; ++i) {
        const Scene scene = oracle::random_scene(i);
        const auto program = write_program({scene, small, ""}, language);
        if (const Problem* problem = problem_of(program))
            std::printf("  not drawn: random scene %u: %s\n", i, problem->text().c_str());
        else
            comparison.add("random scene " + std::to_string(i), scene, small, language);
    }
    report(comparison, language);
    return comparison.figure().scenes;
}

/// Mistakes that programs in no language can make, in the order of the catalogue.
const std::string unwritten =
    "power_of_negative_is_nan specular_without_cosine fresnel_of_view_angle ambient_not_attenuated "
    "position_is_direction distance_is_one distance_includes_w divided_by_square distance_across_spaces "
    "spot_direction_left_in_world ambient_without_material highlight_tinted highlight_normalized "
    "alpha_not_squared normals_without_model normals_by_inverse normals_by_projection "
    "facet_normals_of_screen_points cross_component_wrong facet_normal_of_first_corners last_facet_wins "
    "normals_axes_exchanged positions_as_normals normals_by_position_index interpolated_lengths "
    "zero_normal_is_nan";

/// Checks that the program makes each visible mistake as Glint does and documents it. Returns the names of
/// the mistakes that the language cannot make.
std::string compare_mistakes(Language language) {
    Comparison comparison;
    std::string left;
    for (std::size_t i = 0; i < mistake_names().size(); ++i) {
        const MistakeName& mistake = mistake_names()[i];
        const std::string name(mistake.name);
        Scene scene = test::telling_scene();
        test::mistake_scenes()[i].where_it_shows(scene);
        scene.shading.mistakes.*mistake.flag = true;
        if (!can(scene, language)) {
            left += (left.empty() ? "" : " ") + name;
            continue;
        }
        comparison.add(name, scene, small, language);
        INFO(name);
        CHECK(comparison.text().find("MISTAKE " + name + ": ") != std::string::npos);
    }
    report(comparison, language);
    return left;
}

}  // namespace

TEST_CASE("a C++ program draws the scenes in assets/ as Glint does", "[programs]") {
    CHECK(compare_assets(Language::Cpp) == "silhouettes-and-creases");
}

// Compiling takes longer than drawing, so random scenes are for tests/nightly.sh.
TEST_CASE("a C++ program draws random scenes as Glint does", "[.nightly][programs]") {
    CHECK(compare_random(Language::Cpp, 0, 12) == 12);
}
TEST_CASE("a C++ program draws scenes without a reflection model as Glint does", "[programs]") {
    Comparison comparison;
    for (const Transfer transfer : {Transfer::None, Transfer::Srgb}) {
        Scene scene = oracle::random_scene(1);
        scene.shading.reflection = Reflection::None;
        scene.display.transfer = transfer;
        comparison.add(transfer == Transfer::Srgb ? "encoded" : "unencoded", scene, small, Language::Cpp);
    }
    report(comparison, Language::Cpp);
}
TEST_CASE("a C++ program draws more random scenes as Glint does", "[.nightly][programs]") {
    CHECK(compare_random(Language::Cpp, 12, 28) == 28);
}

TEST_CASE("a Python program draws the scenes in assets/ as Glint does", "[programs]") {
    CHECK(compare_assets(Language::Python) == "silhouettes-and-creases");
}

TEST_CASE("programs draw a spot's soft edge as Glint does", "[programs]") {
    Scene scene = std::get<SceneDocument>(open_document(project_file("assets/scenes/spot-cone.json"))).scene;
    for (Light& light : scene.lights) light.spot.inner_deg = light.spot.cutoff_deg / 3;
    for (const Language language : {Language::Cpp, Language::Python, Language::Glsl}) {
        Comparison comparison;
        comparison.add("soft spot", scene, small, language);
        report(comparison, language);
    }
    CHECK_FALSE(can(scene, Language::Gl1));
}

TEST_CASE("a Python program draws random scenes as Glint does", "[.nightly][programs]") {
    CHECK(compare_random(Language::Python, 0, 40) == 40);
}

TEST_CASE("a Python program makes every mistake as Glint does", "[programs]") {
    CHECK(compare_mistakes(Language::Python) == unwritten);
}

// Compiles one program per mistake, a minute's work; the Python programs make the same mistakes.
TEST_CASE("a C++ program makes every mistake as Glint does", "[.nightly][programs][every-mistake]") {
    CHECK(compare_mistakes(Language::Cpp) == unwritten);
}

TEST_CASE("an OpenGL 1 program draws the scenes in assets/, adapted to it, as Glint does", "[programs]") {
    const auto under_its_own = [](Scene& scene) { as_fixed_function(scene, 0); };
    CHECK(compare_assets(Language::Gl1, under_its_own) == "");
}
TEST_CASE("an OpenGL 1 program draws fixed-function scenes as Glint does", "[programs]") {
    Comparison comparison;
    for (unsigned i = 0; i < 40; ++i) {
        const Scene scene = fixed_function_scene(i);
        INFO(i);
        const auto program = write_program({scene, small, ""}, Language::Gl1);
        if (const Problem* problem = problem_of(program)) FAIL(problem->text());
        if (i < 10) comparison.add("fixed-function scene " + std::to_string(i), scene, small, Language::Gl1);
    }
    report(comparison, Language::Gl1);
}
TEST_CASE("an OpenGL 1 program makes the mistakes its calls allow as Glint does", "[programs]") {
    Comparison comparison;
    for (bool Mistakes::*wrong :
         {&Mistakes::light_in_wrong_space, &Mistakes::no_normals_given, &Mistakes::normals_flipped}) {
        Scene scene = fixed_function_scene(0);
        scene.shading.mistakes.*wrong = true;
        comparison.add("fixed-function mistake", scene, small, Language::Gl1);
        CHECK(comparison.text().find("MISTAKE ") != std::string::npos);
    }
    report(comparison, Language::Gl1);
}
TEST_CASE("a feature that OpenGL 1 lacks gives one line naming languages that support it", "[programs]") {
    const auto refused = [](const auto& change) {
        Scene scene = fixed_function_scene(0);
        change(scene);
        const auto program = write_program({scene, small, ""}, Language::Gl1);
        return problem_of(program) == nullptr ? "" : problem_of(program)->text();
    };
    CHECK(refused([](Scene&) {}) == "");
    CHECK(
        refused([](Scene& s) { s.shading.mode = ShadingMode::Phong; }) ==
        "/shading/mode: normals are interpolated and lit at each pixel, which gl1 does not support; expected "
        "--language glsl or cpp or python or webgl");
    CHECK(refused([](Scene& s) {
              s.lights[0].kind = LightKind::Area;
              s.lights[0].position.w = 1;
          }) ==
          "/lights: an area light shines, which gl1 does not support; expected --language glsl or cpp or "
          "python or "
          "webgl");
    CHECK(refused([](Scene& s) { s.shading.reflection = Reflection::Phong; }) ==
          "/shading/reflection: the model is phong, which gl1 does not support; expected --language glsl or "
          "cpp or "
          "python or webgl");
    CHECK(refused([](Scene& s) { s.lights.resize(9, s.lights[0]); }) ==
          "/lights: more than 8 lights shine, which gl1 does not support; expected --language glsl or cpp or "
          "python "
          "or webgl");
    CHECK(
        refused([](Scene& s) { s.objects[0].material.shininess = 200; }) ==
        "/objects: a shininess is above 128, which gl1 does not support; expected --language glsl or cpp or "
        "python or webgl");
}
TEST_CASE("an OpenGL 3.3 program draws the scenes in assets/ as Glint does", "[programs]") {
    CHECK(compare_assets(Language::Glsl) == "silhouettes-and-creases skew-quad t-junction");
}
TEST_CASE("an OpenGL 3.3 program draws random scenes as Glint does", "[.nightly][programs]") {
    CHECK(compare_random(Language::Glsl, 0, 8) >= 7);
}
TEST_CASE("an OpenGL 3.3 program draws more random scenes as Glint does", "[.nightly][programs]") {
    CHECK(compare_random(Language::Glsl, 8, 32) > 24);
}
TEST_CASE("an OpenGL 3.3 program makes mistakes as Glint does", "[.nightly][programs][every-mistake]") {
    CHECK(compare_mistakes(Language::Glsl) == "power_zero_is_nan culled_by_light " + unwritten);
}

namespace {

/// A scene whose picture reveals many mistakes, with these mistakes enabled.
Scene scene_with(std::initializer_list<bool Mistakes::*> mistakes) {
    Scene scene = test::telling_scene();
    for (bool Mistakes::*mistake : mistakes) scene.shading.mistakes.*mistake = true;
    return scene;
}

void compare(Language language, const std::vector<std::pair<std::string, Scene>>& scenes) {
    Comparison comparison;
    for (const auto& [name, scene] : scenes) {
        INFO(name);
        const auto program = write_program({scene, small, "scene"}, language);
        if (const Problem* problem = problem_of(program)) FAIL(problem->text());
        comparison.add(name, scene, small, language);
    }
    report(comparison, language);
}

}  // namespace

TEST_CASE("OpenGL accepts a background whose channels are integers", "[programs]") {
    Scene scene = fixed_function_scene(0);
    scene.display.background = {0, 0.5f, 1};
    compare(Language::Gl1, {{"whole numbers", scene}});
    compare(Language::Glsl, {{"whole numbers", scene}});
}

TEST_CASE("an OpenGL 3.3 program wraps encoded bytes and normalises facets as Glint does", "[programs]") {
    Scene encoded = scene_with({&Mistakes::bytes_wrap});
    encoded.display.transfer = Transfer::Srgb;
    Scene facet = scene_with({&Mistakes::unnormalized_normals}), flat = facet;
    facet.shading.mode = ShadingMode::Facet;
    flat.shading.mode = ShadingMode::Flat;
    compare(Language::Glsl, {{"encoded", encoded}, {"facet", facet}, {"flat", flat}});
}

TEST_CASE("an unnormalised l and a huge interpolated highlight are drawn as in Glint", "[programs]") {
    Scene scene = scene_with({&Mistakes::unnormalized_light}), gouraud = scene;
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].position = {2, 3, 4, 0};
    std::vector<std::pair<std::string, Scene>> scenes;
    for (const Reflection model : {Reflection::Retro, Reflection::OrenNayar}) {
        scene.shading.reflection = model;
        scenes.emplace_back(name_of(model), scene);
    }
    compare(Language::Python, scenes);
    gouraud.shading.mode = ShadingMode::Gouraud;
    for (Object& object : gouraud.objects) object.material.shininess = 500;
    scenes.emplace_back("gouraud", gouraud);
    compare(Language::Glsl, scenes);
}

TEST_CASE("an OpenGL 3.3 program interpolates screen-linearly beyond the picture's edges", "[programs]") {
    Scene phong;
    phong.lights.emplace_back();
    phong.objects.push_back(test::object_of(test::primitive(Primitive::Plane, 1)));
    phong.objects[0].transform.rotate_deg = {60, 20, 0};
    phong.objects[0].transform.scale = {3, 3, 3};
    phong.shading.interpolation = Interpolation::Screen;
    phong.shading.two_sided = true;
    Scene gouraud = phong, unit = phong;
    gouraud.shading.mode = ShadingMode::Gouraud;
    unit.shading.mistakes.interpolated_normals_not_normalized = true;
    compare(Language::Glsl, {{"phong", phong}, {"gouraud", gouraud}, {"normals left unnormalized", unit}});
}

TEST_CASE("two mistakes in one formula combine as in Glint in every language", "[programs]") {
    const std::vector<std::pair<std::string, Scene>> scenes = {
        {"cosine", scene_with({&Mistakes::no_clamp_of_cosine, &Mistakes::absolute_cosine})},
        {"normals", scene_with({&Mistakes::normals_left_in_world, &Mistakes::normals_as_points})}};
    for (const Language language : {Language::Cpp, Language::Glsl, Language::Python})
        compare(language, scenes);
}

TEST_CASE("a program compiles even if a light or object has the name of a library symbol", "[programs]") {
    const std::vector<std::string> names{
        "NULL",     "EOF",          "stdin",    "stdout", "printf",     "malloc",   "exp",
        "log",      "pow",          "abs",      "sqrt",   "rand",       "div",      "signgam",
        "INFINITY", "NAN",          "HUGE_VAL", "M_PI_2", "BUFSIZ",     "SEEK_SET", "random",
        "RAND_MAX", "EXIT_FAILURE", "va_list",  "remove", "rename",     "system",   "getenv",
        "tolower",  "errno",        "isnan",    "GLint",  "GLFWwindow", "glFlush",  "glm",
        "std",      "np",           "print",    "len",    "class",      "Teapot",   "OSMesaPixelStore",
        "M_PIf",    "P_tmpdir"};
    constexpr std::size_t at_once = 10;  // the maximum number of lines in a program
    std::vector<std::pair<std::string, Scene>> scenes;
    for (std::size_t first = 0; first < names.size(); first += at_once) {
        Scene scene = fixed_function_scene(4);
        scene.lights.resize(1);
        scene.lights[0].name = "free";
        const std::size_t end = std::min(first + at_once, names.size());
        scene.objects.assign(end - first, scene.objects[0]);
        for (std::size_t i = first; i < end; ++i) scene.objects[i - first].name = names[i];
        scenes.emplace_back(names[first], scene);
    }
    for (const Language language : {Language::Cpp, Language::Gl1, Language::Glsl, Language::Python})
        compare(language, scenes);
}

TEST_CASE("a program with cool-to-warm tones has no unused variable", "[programs]") {
    std::vector<std::pair<std::string, Scene>> scenes;
    for (const Reflection reflection : {Reflection::BlinnPhong, Reflection::Retro}) {
        Scene scene = scene_with({&Mistakes::specular_behind_surface});
        scene.npr.cool_to_warm = true;
        scene.shading.reflection = reflection;
        scenes.emplace_back("tones", scene);
    }
    compare(Language::Cpp, scenes);
}

TEST_CASE("of a face and its reverse, the first in the file is visible in every language", "[programs]") {
    const TemporaryDirectory folder;
    const std::string mesh =
        folder.file("twice.obj", "v -1.1 -0.9 0.3\nv 1.2 -1 -0.4\nv 0.1 1.3 0.2\nf 1 2 3\nf 3 2 1\n");
    Scene scene = std::get<SceneDocument>(open_document(mesh)).scene;
    scene.camera.eye = {0.7f, 0.4f, 4};
    scene.lights.resize(1);
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].position = {0.3f, 0.5f, 1, 0};
    scene.objects[0].normals.source = NormalSource::Facet;
    for (const Language language : {Language::Cpp, Language::Glsl, Language::Python})
        compare(language, {{"twice", scene}});
}

TEST_CASE("without a reflection model a program makes no lighting mistakes", "[programs]") {
    Scene scene = test::telling_scene();
    scene.shading.reflection = Reflection::None;
    for (const MistakeName& mistake : mistake_names())
        if (mistake.stage != MistakeStage::Faces && mistake.stage != MistakeStage::Display)
            scene.shading.mistakes.*mistake.flag = true;
    for (const Language language : {Language::Cpp, Language::Glsl, Language::Python})
        compare(language, {{"none", scene}});
    scene.shading.mistakes = {.culled_by_light = true};
    const auto program = write_program({scene, small, ""}, Language::Cpp);
    REQUIRE(problem_of(program) != nullptr);
    CHECK(
        problem_of(program)->text() ==
        "/shading/mistakes/culled_by_light: faces are culled by a light's direction although nothing is lit, "
        "which cpp does not support; "
        "expected a scene without it: no language supports it");
    // Each language lacks a feature that the other supports.
    scene.shading.reflection = Reflection::Phong;
    scene.shading.power_table = 16;
    scene.shading.mistakes = {.culled_by_light = true};
    const auto both = write_program({scene, small, ""}, Language::Cpp);
    REQUIRE(problem_of(both) != nullptr);
    CHECK(
        problem_of(both)->text() ==
        "/shading/power_table: powers are looked up in a table, which cpp does not support; expected a scene "
        "without "
        "it, or --language glsl and a scene without /shading/mistakes/culled_by_light");
}

TEST_CASE("the calls copied from the window compile as C and as C++", "[programs][calls]") {
    std::string all;
    int functions = 0;
    const auto add = [&](const Scene& scene) {
        std::string text = calls_text(gl_calls(scene));
        const std::string name = "void draw";
        text.insert(text.find(name) + name.size(), std::to_string(functions++));
        all += text;
    };
    for (const std::string& path : test::asset_scenes()) {
        Scene scene = std::get<SceneDocument>(open_document(path)).scene;
        add(scene);
        scene.camera.projection = Orthographic{5, 0.1f, 100};
        scene.shading.rules = Rules::OpenGL2;
        scene.lights.resize(12);
        for (Light& light : scene.lights) light.enabled = true;
        scene.lights[0].name = "line\nbreak, end of a line \\";
        add(scene);
    }
    const TemporaryDirectory folder;
    (void)folder.file("calls.c", all);
    for (const char* compiler : {"gcc -std=c99", "g++ -std=c++17 -x c++"}) {
        const std::string command = fmt::format(
            "cd '{}' && {} -fsyntax-only -Wall -Werror calls.c >said 2>&1", folder.path(), compiler);
        const bool compiles = std::system(command.c_str()) == 0;
        INFO(compiler << ": " << bytes_of(folder.path("said")));
        CHECK(compiles);
    }
}
