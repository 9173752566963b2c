// Runs in a copy of the tree to which the patches beside this file were applied: what each added is known to
// the scene file, the schema, the numbers, the picture and its explanation, without another line.
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <string>

#include "models/fields/choices.h"
#include "models/fields/scene_numbers.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

constexpr PictureSize size{48, 48};

/// A white ball, diffuse alone, under one white sun from the upper right. `light`, `shading`: further
/// members.
Scene ball(const std::string& light = "", const std::string& shading = "",
           const std::string& primitive = "sphere") {
    const std::string text = R"({"glint": 1, "lights": [{"type": "directional", "position": [1, 1, 2, 0])" +
                             light + R"(}], "objects": [{"mesh": {"primitive": ")" + primitive +
                             R"("}, "material": {"ambient": [0, 0, 0], "diffuse": [1, 1, 1],
                             "specular": [0, 0, 0]}}], "global_ambient": [0, 0, 0],
                             "shading": {"two_sided": false)" +
                             shading + "}}";
    Result<Scene> scene = parse_scene(text, "ball.json");
    if (const Problem* problem = problem_of(scene)) FAIL(problem->what << ", " << problem->expected);
    REQUIRE(problem_of(load_meshes(std::get<Scene>(scene), "ball.json", ".")) == nullptr);
    return std::get<Scene>(scene);
}

std::vector<float> pixels_of(const Scene& scene) {
    Renderer renderer(1);
    return renderer.render(scene, size, true).linear;
}

/// Explains each surface pixel, after it has been held to the picture.
template <class Check> void for_each_explained(const Scene& scene, const Check& check) {
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene, size, true);
    int surfaces = 0;
    for (int y = 0; y < size.height; y += 3)
        for (int x = 0; x < size.width; x += 3) {
            const Explanation e = renderer.explain(x, y);
            if (!e.hit) continue;
            ++surfaces;
            const std::size_t i = 3 * static_cast<std::size_t>(y * size.width + x);
            REQUIRE(e.sum.x == picture.linear[i]);
            check(e.at.lights.at(0), e.sum.x);
        }
    REQUIRE(surfaces > 20);
}

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

int files_of(const char* patch) {
    const std::string text = file_text(std::filesystem::path(GLINT_PATCHES) / patch);
    int files = 0;
    for (std::size_t at = 0; (at = text.find("\n+++ ", at)) != std::string::npos; ++at) ++files;
    return files;
}

}  // namespace

TEST_CASE("no addition touches more files than docs/changing.md says") {
    CHECK(files_of("light_number.patch") == 3);  // one of them is its effect
    CHECK(files_of("reflection_model.patch") == 3);
    CHECK(files_of("primitive.patch") == 2);
    CHECK(files_of("mistake.patch") == 3);
    CHECK(files_of("window_command.patch") == 1);
}

TEST_CASE("a light's new number is read, written, held to its range, listed and seen") {
    const Scene scene = ball(R"(, "gain": 2.5)");
    CHECK(scene.lights[0].gain == 2.5f);
    CHECK(scene_text(scene).find("\"gain\": 2.5") != std::string::npos);
    CHECK(scene_schema().find("\"gain\"") != std::string::npos);

    const Result<Scene> refused = parse_scene(R"({"glint": 1, "lights": [{"gain": 11}]})", "a.json");
    REQUIRE(problem_of(refused) != nullptr);
    CHECK(problem_of(refused)->pointer == "/lights/0/gain");
    CHECK(problem_of(refused)->expected == "0 to 10");

    const auto number = number_at(scene, "/lights/0/gain");
    REQUIRE(number);
    CHECK(number->initial == 1);
    CHECK(number->kind.range.high == 10);

    CHECK(pixels_of(scene) == pixels_of(ball(R"(, "intensity": 2.5)")));
    CHECK(pixels_of(scene) != pixels_of(ball()));
}

TEST_CASE("a new reflection model is named, drawn and explained") {
    const Scene scene = ball("", R"(, "reflection": "toon")");
    CHECK(scene_text(scene).find("\"reflection\": \"toon\"") != std::string::npos);
    CHECK(scene_schema().find("\"toon\"") != std::string::npos);
    std::set<float> seen;
    for_each_explained(scene, [&](const ExplainedLight& light, float sum) {
        const float n_dot_l = light.n_dot_l;
        const float expected = n_dot_l > 2.0f / 3   ? 1.0f
                               : n_dot_l > 1.0f / 3 ? 2.0f / 3
                               : n_dot_l > 0        ? 1.0f / 3
                                                    : 0;
        CHECK(light.diffuse_factor == expected);
        CHECK(sum == expected);
        seen.insert(sum);
    });
    CHECK(seen.size() >= 3);
}

TEST_CASE("a new primitive is named, built and drawn") {
    const Scene scene = ball("", "", "octahedron");
    CHECK(scene_schema().find("\"octahedron\"") != std::string::npos);
    const Mesh& mesh = *scene.objects[0].mesh;
    CHECK(mesh.positions.size() == 6);
    REQUIRE(mesh.face_count() == 8);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (std::uint32_t face = 0; face < 8; ++face) {
        const auto corners = mesh.corners_of(face);
        REQUIRE(corners.size() == 3);
        glm::vec3 middle(0);
        for (const std::uint32_t corner : corners) middle += mesh.positions[corner] / 3.0f;
        CHECK(dot(facet_normal(mesh, face), glm::normalize(middle)) == Approx(1));  // outward
        for (std::size_t i = 0; i < 3; ++i) ++sides[{corners[i], corners[(i + 1) % 3]}];
    }
    CHECK(sides.size() == 24);  // 12 edges, each once from either side: it is closed
    for_each_explained(
        ball("", R"(, "mode": "facet")", "octahedron"),
        [](const ExplainedLight& light, float sum) { CHECK(sum == Approx(std::max(light.n_dot_l, 0.0f))); });
}

TEST_CASE("a new mistake is named, made and explained, and does nothing where it has no part") {
    const std::string halved = R"(, "mistakes": {"diffuse_halved": true})";
    const Scene right = ball(), wrong = ball("", halved);
    CHECK(scene_text(wrong).find("\"diffuse_halved\": true") != std::string::npos);
    CHECK(scene_text(right).find("diffuse_halved") == std::string::npos);
    CHECK(scene_schema().find("\"diffuse_halved\"") != std::string::npos);
    CHECK(mistake_names().size() > 52);
    for_each_explained(wrong, [](const ExplainedLight& light, float sum) {
        CHECK(sum == Approx(0.5f * std::max(light.n_dot_l, 0.0f)));
    });
    CHECK(pixels_of(wrong) != pixels_of(right));
    const std::string without = R"(, "terms": {"diffuse": false})";
    CHECK(pixels_of(ball("", halved + without)) == pixels_of(ball("", without)));
}
