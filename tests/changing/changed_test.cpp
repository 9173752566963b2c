// What the patches beside this file add to Glint, as a user of the library meets it. Compiled by changing.sh in a copy of
// the tree to which they are applied.
#include <cmath>

#include "models/fields/reflection_info.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "models/scene_file/schema.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

Scene scene_of(const std::string& text) {
    Result<Scene> read = parse_scene(text, "s.json");
    if (const Problem* problem = problem_of(read)) FAIL(problem->text());
    Scene scene = std::get<Scene>(std::move(read));
    REQUIRE(problem_of(load_meshes(scene, "", "")) == nullptr);
    return scene;
}

std::string with(const std::string& light, const std::string& mesh, const std::string& shading) {
    return R"({"glint": 1, "lights": [{"type": "directional", "position": [0, 0, 1], "specular": [0, 0, 0])" +
           light + R"(}], "objects": [{"mesh": {"primitive": ")" + mesh +
           R"("}, "material": {"ambient": [0, 0, 0], "diffuse": [0.5, 0.5, 0.5]}}], "shading": {"local_viewer": false)" +
           shading + "}}";
}

/// The pixel's sum, which must be what its explanation says.
glm::vec3 center_of(const std::string& text) {
    Renderer renderer(1);
    const Picture& picture = renderer.render(scene_of(text), {33, 33}, true);
    REQUIRE(renderer.object_at(16, 16) == 0);
    CHECK(renderer.explain(16, 16).sum == picture.linear_at(16, 16));
    return picture.linear_at(16, 16);
}

}  // namespace

TEST_CASE("a light's new number is read, written, checked, described, and does something") {
    const float once = center_of(with("", "sphere", "")).x;
    CHECK(once > 0.3f);
    CHECK(center_of(with(R"(, "gain": 2)", "sphere", "")).x == 2 * once);
    const Scene scene = scene_of(with(R"(, "gain": 2)", "sphere", ""));
    CHECK(scene_text(scene).find(R"("gain": 2)") != std::string::npos);
    CHECK(schema_text().find(R"("gain")") != std::string::npos);
    const Result<Scene> refused = parse_scene(with(R"(, "gain": 11)", "sphere", ""), "s.json");
    REQUIRE(problem_of(refused) != nullptr);
    CHECK(problem_of(refused)->text() == "s.json: /lights/0/gain: 11 is out of range; expected 0 to 10");
}

TEST_CASE("a new reflection model has its words, is lit by its formula and explained") {
    const std::string model = R"(, "reflection": "half-lambert")";
    const Renderer renderer(1);
    CHECK(schema_text().find(R"("half-lambert")") != std::string::npos);
    // Seen along the light: n.l = 1 in the middle, where it equals Lambert's.
    CHECK(center_of(with("", "sphere", model)).x == Approx(center_of(with("", "sphere", "")).x));
    // From the side n.l = 0: (0/2 + 1/2)^2 = 1/4 of it.
    const auto lit_from_the_side = [&](const std::string& shading) {
        std::string text = with("", "cube", shading);
        text.replace(text.find("[0, 0, 1]"), 9, "[0, 1, 0]");
        return center_of(text.replace(text.find(R"("lights")"), 0, R"("camera": {"eye": [0, 0, 5]}, )")).x;
    };
    CHECK(lit_from_the_side("") == 0);
    CHECK(lit_from_the_side(model) == Approx(0.125));
}

TEST_CASE("a new primitive has its words and its shape") {
    const Scene scene = scene_of(with("", "octahedron", ""));
    const MeshInfo info = mesh_info(*scene.objects[0].mesh);
    CHECK(info.faces == 8);
    CHECK(info.vertices == 6);
    CHECK(info.boundary_edges == 0);
    CHECK(schema_text().find(R"("octahedron")") != std::string::npos);
}

TEST_CASE("a new mistake has its name, does its wrong, and is inert where it has no part") {
    const std::string wrong = R"(, "mistakes": {"diffuse_squared": true})";
    CHECK(center_of(with("", "sphere", wrong)).x == Approx(0.5 * center_of(with("", "sphere", "")).x));
    const std::string dark = R"(, "terms": {"diffuse": false})";
    CHECK(center_of(with("", "sphere", dark)) == center_of(with("", "sphere", dark + wrong)));
    bool named = false;
    for (const MistakeName& mistake : mistake_names()) named |= std::string(mistake.name) == "diffuse_squared";
    CHECK(named);
}
