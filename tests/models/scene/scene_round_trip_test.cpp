// Reading a written scene gives an equal scene; a damaged one gives a one-line problem.
#include <cmath>

#include "models/scene_file/scene_file.h"
#include "models/utf8.h"
#include "tests/support/catch.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

using namespace glint;

namespace {

/// `text` with one to three random defects: bytes changed, dropped, duplicated or moved.
std::string wounded(std::string text, std::mt19937& random) {
    constexpr std::string_view bytes = "{}[]:,\"\\/-+.eE019 \n\tantx~*\xff\xc3\xe2";
    for (std::size_t wounds = 1 + random() % 3; wounds > 0 && !text.empty(); --wounds) {
        const std::size_t at = random() % text.size(), length = 1 + random() % 20;
        switch (random() % 5) {
        case 0:
            text[at] = bytes[random() % bytes.size()];
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(random() % text.size(), text.substr(at, length));
            break;
        case 3:
            text.insert(at, 1, bytes[random() % bytes.size()]);
            break;
        default:
            if (random() % 20 == 0) text.resize(at);
        }
    }
    return text;
}

void check_problem(const Problem& problem) {
    const std::string text = problem.text();
    CHECK(text.size() <= 4096);
    CHECK(text.find('\n') == std::string::npos);
    CHECK(first_invalid_utf8(text) == text.size());
    CHECK(text.find("json.exception") == std::string::npos);
}

}  // namespace

TEST_CASE("reading a written scene gives an equal scene", "[scene_round_trip]") {
    for (unsigned seed = 0; seed < 300; ++seed) {
        const Scene scene = RandomScene(seed).scene();
        const std::string text = scene_text(scene);
        const Result<Scene> result = parse_scene(text, "s");
        INFO(seed << (problem_of(result) != nullptr ? problem_of(result)->text() : ""));
        REQUIRE(problem_of(result) == nullptr);
        REQUIRE(std::get<Scene>(result) == scene);
        REQUIRE(scene_text(std::get<Scene>(result)) == text);
    }
}

TEST_CASE("a float is written with the fewest digits that give it back when read", "[scene_round_trip]") {
    // 7.0385307e-26 has the shortest decimal form 7.038531e-26, whose double rounds to the float below.
    const std::vector<std::pair<float, std::string>> numbers{
        {0.1f, "0.1"}, {1.0f, "1"}, {-2.5f, "-2.5"}, {1.0f / 3, "0.33333334"}, {16777216.0f, "16777216"}};
    for (const auto& [number, text] : numbers) {
        Scene scene;
        scene.camera.target.x = number;
        CHECK(scene_text(scene).find("\"target\": [" + text + ",") != std::string::npos);
    }
    for (const float number : {7.0385307e-26f, 1e7f, 1e-45f, -0.0f, 3.4028235e-38f}) {
        Scene scene;
        scene.camera.target.x = number;
        const auto back = std::get<Scene>(parse_scene(scene_text(scene), "s")).camera.target.x;
        CHECK(back == number);
        CHECK(std::signbit(back) == std::signbit(number));
    }
}

TEST_CASE("names and paths keep every character, bytes that are not UTF-8 are replaced",
          "[scene_round_trip]") {
    Scene scene;
    scene.objects.emplace_back().name = std::string("\0\x1f\"\\/ \xe2\x80\xa8 é😀", 16);
    CHECK(std::get<Scene>(parse_scene(scene_text(scene), "s")) == scene);
    scene.objects[0].name = "a\xff\xc3z";
    CHECK(std::get<Scene>(parse_scene(scene_text(scene), "s")).objects[0].name == "a\uFFFD\uFFFDz");
}

TEST_CASE("a damaged scene is read as a scene or gives a one-line problem", "[scene_round_trip][fuzz]") {
    std::mt19937 random(11);
    int scenes = 0, problems = 0;
    for (unsigned i = 0; i < 3000; ++i) {
        const std::string text = wounded(scene_text(RandomScene(i % 40).scene()), random);
        const Result<Scene> result = parse_scene(text, "s");
        ++(problem_of(result) != nullptr ? problems : scenes);
        if (problem_of(result) != nullptr) {
            check_problem(*problem_of(result));
        } else if (const Scene& scene = std::get<Scene>(result); i % 16 == 0) {
            CHECK(std::get<Scene>(parse_scene(scene_text(scene), "s")) == scene);
        }
    }
    CHECK(problems > 500);
    CHECK(scenes > 50);
}

TEST_CASE("replacing a mesh makes a different scene with the same description", "[scene]") {
    Scene scene = RandomScene(1).scene();
    scene.objects.resize(2);
    Scene other = scene;
    other.objects[1].mesh = test::primitive(Primitive::Sphere, 8);
    CHECK(scene != other);
    CHECK(same_description(scene, other));
    for (const auto& edit : std::vector<void (*)(Scene&)>{
             [](Scene& s) { s.camera.eye.x += 1; }, [](Scene& s) { s.global_ambient.y += 1; },
             [](Scene& s) { s.lights.emplace_back(); }, [](Scene& s) { s.objects.emplace_back(); },
             [](Scene& s) { s.objects[0].name += "'"; },
             [](Scene& s) { s.objects[1].source = MeshFile{"other.obj"}; },
             [](Scene& s) { s.objects[1].transform.translate.x += 1; },
             [](Scene& s) { s.objects[1].normals.crease_deg += 1; },
             [](Scene& s) { s.objects[1].material.shininess += 1; },
             [](Scene& s) { s.shading.two_sided ^= true; }, [](Scene& s) { s.npr.creases ^= true; },
             [](Scene& s) { s.display.exposure += 1; }}) {
        Scene edited = scene;
        edit(edited);
        CHECK_FALSE(same_description(scene, edited));
    }
}
