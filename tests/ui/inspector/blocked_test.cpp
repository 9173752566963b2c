// The inspector shows where a shadow would fall, although the picture has none.
#include "tests/places.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/features/inspector/inspector.h"

using namespace glint;
using test::HeadlessWindow;

TEST_CASE("the inspector names the blocking object only where a light is blocked", "[ui][why][lecture]") {
    HeadlessWindow bench;
    const Result<SceneDocument> opened = open_document(project_file("assets/scenes/no-shadows.json"));
    REQUIRE(problem_of(opened) == nullptr);
    take_document(bench.state.editor, std::get<SceneDocument>(opened));
    const auto words_at = [&bench](glm::dvec2 pixel_of_1280x720) {
        test::ask(bench, InspectorTab::Equation, {pixel_of_1280x720.x / 1280, pixel_of_1280x720.y / 720});
        REQUIRE(bench.state.on_screen.explanation);
        const Explanation& why = *bench.state.on_screen.explanation;
        return blocked_words(bench.state, why, 0);
    };
    // The pixel of docs/lecture_map.md, row 2: on the floor, behind the objects on it.
    const std::string words = words_at({652, 558});
    INFO(words);
    CHECK(words.find(" is between this light and the point") != std::string::npos);
    CHECK(words_at({40, 680}).empty());
    // A light moved to the other side of the obstacle in the same frame is tested again.
    (void)words_at({652, 558});
    bench.scene().lights[0].position = {0, 30, 0, 1};
    bench.scene().objects.resize(1);
    CHECK(words_at({652, 558}).empty());
}

TEST_CASE("an object that only marks a light's position does not block it", "[ui][why][lecture]") {
    HeadlessWindow bench;
    SceneDocument document = first_scene();
    Scene& scene = document.scene;
    scene.lights.resize(1);
    scene.lights[0].kind = LightKind::Point;
    scene.lights[0].space = LightSpace::World;
    scene.lights[0].enabled = true;
    const glm::vec3 light = scene.camera.eye + glm::vec3(0, 2, 0);  // lights the middle of the visible part
    scene.lights[0].position = glm::vec4(light, 1);
    Object marker = scene.objects[0];
    marker.source = PrimitiveMesh{Primitive::Icosphere, 2};
    marker.mesh = nullptr;
    marker.transform = {};
    marker.transform.scale = glm::vec3(0.02f);
    marker.transform.translate = light;
    scene.objects.push_back(marker);
    REQUIRE(problem_of(load_meshes(scene, "", "")) == nullptr);
    take_document(bench.state.editor, std::move(document));
    test::ask(bench, InspectorTab::Equation, {0.5, 0.5});
    REQUIRE(bench.state.on_screen.explanation);
    REQUIRE(bench.state.on_screen.explanation->hit);
    const Explanation why = *bench.state.on_screen.explanation;
    const auto words = [&] { return blocked_words(bench.state, why, 0); };
    CHECK(words().empty());
    // Halfway to the light, it is an ordinary obstacle.
    bench.scene().objects.back().transform.translate = 0.5f * (light + why.spaces.world);
    bench.frames(2);
    INFO(words());
    CHECK(words().find("is between this light and the point") != std::string::npos);
}
