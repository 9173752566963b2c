// A written scene reads back equal; a damaged one is a problem of one line.
#include <cmath>

#include "models/scene_file/scene_file.h"
#include "models/utf8.h"
#include "tests/support/catch.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

using namespace glint;

namespace {

/// `text` with one to three random defects: bytes changed, dropped, doubled or moved.
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

/// A random value that occurs in a scene, is similar to one, or does not belong there.
std::string any_value(std::mt19937& random) {
    constexpr const char* values[] = {
        "0",      "1",        "-1",           "1e999", "1e-60",        "null",    "true",
        "\"\"",   "\"spot\"", "[]",           "{}",    "[0, 0, 0]",    "180",     "1e7",
        "[[[]]]", "-0",       "[1, 2, 3, 0]", "64",    "\"a\\u0000\"", "16777217"};
    return values[random() % std::size(values)];
}

void check_problem(const Problem& problem) {
    const std::string text = problem.text();
    CHECK(text.size() <= 4096);
    CHECK(text.find('\n') == std::string::npos);
    CHECK(first_invalid_utf8(text) == text.size());
    CHECK(text.find("json.exception") == std::string::npos);
}

}  // namespace

TEST_CASE("a written scene reads back equal", "[scene_round_trip]") {
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

TEST_CASE("a float is written with the fewest digits that read back equal", "[scene_round_trip]") {
    // 7.0385307e-26 has the shortest decimals 7.038531e-26, whose double rounds to the float below.
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

TEST_CASE("names and paths keep every character; bytes that are not UTF-8 are replaced",
          "[scene_round_trip]") {
    Scene scene;
    scene.objects.emplace_back().name = std::string("\0\x1f\"\\/ \xe2\x80\xa8 é😀", 16);
    CHECK(std::get<Scene>(parse_scene(scene_text(scene), "s")) == scene);
    scene.objects[0].name = "a\xff\xc3z";
    CHECK(std::get<Scene>(parse_scene(scene_text(scene), "s")).objects[0].name == "a\uFFFD\uFFFDz");
}

TEST_CASE("the name of a mesh file keeps every byte, UTF-8 or not", "[scene_round_trip]") {
    CHECK(escaped_bytes("caf\xe9.obj") == "caf\uEFE9.obj");
    CHECK(unescaped_bytes("caf\uEFE9.obj") == "caf\xe9.obj");
    CHECK(escaped_bytes("\x80\xff") == "\uEF80\uEFFF");
    CHECK(escaped_bytes("\uEF80") == "\uEFEE\uEFBE\uEF80");  // the bytes EE BE 80
    CHECK(escaped_bytes("caf\u00e9 \uEF7F \uF000 😀%20\\xe9") == "caf\u00e9 \uEF7F \uF000 😀%20\\xe9");
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
        std::string path = "x";
        for (std::size_t n = random() % 12; n > 0; --n)  // half of them bytes that escapes consist of
            path += random() % 2 ? "\xEE\xBE\xBF\x80"[random() % 4] : static_cast<char>(1 + random() % 255);
        Scene scene;
        scene.objects.emplace_back().source = MeshFile{path};
        REQUIRE(first_invalid_utf8(escaped_bytes(path)) == escaped_bytes(path).size());
        REQUIRE(std::get<Scene>(parse_scene(scene_text(scene), "s")) == scene);
    }
}

TEST_CASE("a damaged scene is a scene or a problem of one line", "[scene_round_trip][fuzz]") {
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

TEST_CASE("any assignment to any pointer gives a scene or a problem of one line",
          "[scene_round_trip][fuzz]") {
    constexpr const char* pointers[] = {"/camera/eye",
                                        "/camera/eye/2",
                                        "/camera/up",
                                        "/camera/projection/type",
                                        "/camera/projection",
                                        "/lights",
                                        "/lights/0",
                                        "/lights/0/type",
                                        "/lights/-",
                                        "/lights/1/position",
                                        "/lights/0/position/3",
                                        "/lights/0/spot/cutoff_deg",
                                        "/lights/00/type",
                                        "/lights/-/type",
                                        "/objects/0/mesh",
                                        "/objects/0/mesh/primitive",
                                        "/objects/0/mesh/detail",
                                        "/objects/0/transform/scale/0",
                                        "/shading/mistakes/x",
                                        "/display",
                                        "/glint",
                                        "/",
                                        "/~01~1",
                                        "/npr/cool/-",
                                        "/lights/0/type/x",
                                        "/lights/18446744073709551616",
                                        "/a\xff",
                                        "/~",
                                        "/objects/0/material/diffuse/1"};
    std::mt19937 random(12);
    int scenes = 0;
    for (unsigned i = 0; i < 3000; ++i) {
        std::vector<Assignment> assignments;
        for (std::size_t n = 1 + random() % 3; n > 0; --n)
            assignments.push_back(
                {pointers[random() % std::size(pointers)], random() % 4 == 0 ? "area" : any_value(random)});
        const std::string text = i % 3 == 0 ? "{\"glint\": 1}" : scene_text(RandomScene(i % 40).scene());
        const Result<Scene> result = parse_scene(text, "s", assignments);
        if (const Problem* problem = problem_of(result)) {
            check_problem(*problem);
            CHECK(problem->file == "--set");
        } else {
            ++scenes;
        }
    }
    CHECK(scenes > 50);
}

TEST_CASE("a scene with another mesh is a different scene with the same description", "[scene]") {
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
