#include <cstdio>
#include <filesystem>

#include "models/fields/choices.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "tests/oracle/random_scene.h"
#include "tests/programs/same_picture.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"
#include "tests/support/mistake_scenes.h"

using namespace glint;
using namespace glint::programs;

namespace {

constexpr PictureSize small{120, 90};

bool can(const Scene& scene, Language language) {
    return problem_of(write_program({scene, small, "scene"}, language)) == nullptr;
}

/// Prints the figure and fails for each scene that disagrees.
void report(const Comparison& comparison, Language language) {
    const Figure& f = comparison.figure();
    std::printf(
        "programs: %s: %d scenes, %zu pixels, %zu of surfaces; %.2f of the bound at most, %d levels\n",
        std::string(name_of(language)).c_str(), f.scenes, f.pixels, f.surfaces, f.largest, f.largest_bytes);
    for (const std::string& line : f.disagreements) FAIL_CHECK(line);
}

/// Draws the scenes of assets that the language can; the names of the others.
std::string compare_assets(Language language) {
    Comparison comparison;
    std::string left;
    for (const std::string& path : test::asset_scenes()) {
        const Result<SceneDocument> opened = open_document(path);
        REQUIRE_FALSE(problem_of(opened));
        const Scene& scene = std::get<SceneDocument>(opened).scene;
        const std::string name = std::filesystem::path(path).stem().string();
        if (can(scene, language))
            comparison.add(name, scene, small, language);
        else
            left += (left.empty() ? "" : " ") + name;
    }
    report(comparison, language);
    return left;
}

/// Draws `count` random scenes, or as many of them as the language can.
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

/// The program makes each mistake as we do, where it shows, and says so. The names of those that the language
/// cannot make.
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

TEST_CASE("a C++ program draws the scenes of assets as we do", "[programs]") {
    CHECK(compare_assets(Language::Cpp) == "silhouettes-and-creases");
}

// Compiling takes longer than drawing: of the random scenes some, and all where they are asked for.
TEST_CASE("a C++ program draws random scenes as we do", "[programs]") {
    CHECK(compare_random(Language::Cpp, 0, 12) == 12);
}
TEST_CASE("a C++ program draws more random scenes as we do", "[.][programs]") {
    CHECK(compare_random(Language::Cpp, 12, 28) == 28);
}

TEST_CASE("a Python program draws the scenes of assets as we do", "[programs]") {
    CHECK(compare_assets(Language::Python) == "silhouettes-and-creases");
}

TEST_CASE("a Python program draws random scenes as we do", "[programs]") {
    CHECK(compare_random(Language::Python, 0, 40) == 40);
}

TEST_CASE("a Python program makes every mistake as we do", "[programs]") {
    CHECK(compare_mistakes(Language::Python) == "");
}

// Compiles 52 programs, a minute's work; those of Python are the same text but for the spelling.
TEST_CASE("a C++ program makes every mistake as we do", "[.][programs][every-mistake]") {
    CHECK(compare_mistakes(Language::Cpp) == "");
}

TEST_CASE("an OpenGL 3.3 program draws the scenes of assets as we do", "[programs]") {
    CHECK(compare_assets(Language::Glsl) == "silhouettes-and-creases skew-quad t-junction");
}
TEST_CASE("an OpenGL 3.3 program draws random scenes as we do", "[programs]") {
    CHECK(compare_random(Language::Glsl, 0, 8) >= 7);
}
TEST_CASE("an OpenGL 3.3 program draws more random scenes as we do", "[.][programs]") {
    CHECK(compare_random(Language::Glsl, 8, 32) > 24);
}
TEST_CASE("an OpenGL 3.3 program makes mistakes as we do", "[.][programs][every-mistake]") {
    CHECK(compare_mistakes(Language::Glsl) == "power_zero_is_nan culled_by_light");
}
