// Compares derivatives of a pixel with those of the equation, and a picture's buffers with its explanations.
#include "renderer/debug_views/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/fields/scene_fields.h"
#include "renderer/debug_views/debug_view.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize sensitive_size{64, 48};

/// A ball under a sun, next to another ball.
SceneDocument balls() {
    SceneDocument document;
    Scene& scene = document.scene;
    Light sun;
    sun.name = "Sun";
    sun.kind = LightKind::Directional;
    sun.position = {0.3f, 0.4f, 1, 0};
    scene.lights = {sun};
    scene.camera.eye = {0, 0, 4};
    for (const float x : {0.0f, 2.2f}) {
        Object ball = object_of(primitive(Primitive::Sphere, 24), "Ball");
        ball.source = PrimitiveMesh{Primitive::Sphere, 24};
        ball.transform.translate.x = x;
        ball.material.shininess = 20;
        scene.objects.push_back(ball);
    }
    return document;
}

Sensitivities of_pixel(const SceneDocument& document, int x, int y) {
    auto made = sensitivities(document, sensitive_size, x, y, 1);
    REQUIRE(problem_of(made) == nullptr);
    return std::get<Sensitivities>(std::move(made));
}

glm::dvec3 change_of(const Sensitivities& s, const std::string& pointer) {
    for (const Sensitivity& n : s.numbers)
        if (n.pointer == pointer) return n.change;
    FAIL(pointer << " is not listed");
    return {};
}

bool lists(const std::vector<std::string>& pointers, const std::string& pointer) {
    return std::find(pointers.begin(), pointers.end(), pointer) != pointers.end();
}

}  // namespace

TEST_CASE("sensitivity: the pixel changes with each number by the equation's derivative", "[sensitivity]") {
    const SceneDocument document = balls();
    Renderer renderer(1);
    (void)renderer.render(document.scene, sensitive_size);
    const Explanation e = renderer.explain(30, 20);
    REQUIRE(e.hit);
    const ExplainedLight& sun = e.at.lights.at(0);
    const Sensitivities s = of_pixel(document, 30, 20);

    CHECK(change_of(s, "/objects/0/material/diffuse/0").x == Approx(sun.n_dot_l).epsilon(1e-3));
    CHECK(change_of(s, "/objects/0/material/diffuse/0").y == 0);
    CHECK(change_of(s, "/objects/0/material/emission/2").z == Approx(1).epsilon(1e-3));
    CHECK(change_of(s, "/global_ambient/1").y == Approx(0.2).epsilon(1e-3));  // k_a
    CHECK(change_of(s, "/lights/0/intensity").x == Approx(sun.diffuse.x + sun.specular.x).epsilon(1e-3));
    CHECK(change_of(s, "/objects/0/material/specular/1").y == Approx(sun.specular_factor.y).epsilon(1e-2));
    // d/ds (v.r)^s = (v.r)^s ln(v.r)
    CHECK(change_of(s, "/objects/0/material/shininess").x ==
          Approx(sun.specular_factor.x * std::log(sun.r_dot_v)).epsilon(2e-2));
    CHECK(change_of(s, "/display/exposure").x == Approx(e.sum.x).epsilon(1e-3));
    CHECK(std::is_sorted(s.numbers.begin(), s.numbers.end(), [](const Sensitivity& a, const Sensitivity& b) {
        const auto most = [](glm::dvec3 v) {
            return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        };
        return most(a.change) > most(b.change);
    }));
}

TEST_CASE("sensitivity: derivatives at 0 match difference quotients with a large step", "[sensitivity]") {
    SceneDocument document = balls();
    document.scene.objects[0].transform = {{0, 0, 0}, {0, 0, 0}, {1, 1.3f, 0.8f}};
    const Sensitivities s = of_pixel(document, 30, 20);
    const auto sum_with = [&](const std::string& pointer, double value) {
        Scene scene = document.scene;
        REQUIRE(set_number(scene, pointer, value) == std::nullopt);
        Renderer renderer(1);
        (void)renderer.render(scene, sensitive_size);
        return glm::dvec3(renderer.explain(30, 20).sum);
    };
    for (const auto& [pointer, h] : {std::pair{std::string("/objects/0/transform/rotate_deg/0"), 2.0},
                                     {"/objects/0/transform/rotate_deg/1", 2.0},
                                     {"/objects/0/transform/translate/1", 0.02}}) {
        INFO(pointer);
        const glm::dvec3 far = (sum_with(pointer, h) - sum_with(pointer, -h)) / (2 * h);
        CHECK(change_of(s, pointer).x == Approx(far.x).epsilon(0.05));
    }
}

TEST_CASE("sensitivity: a light that culls faces is treated as moving them", "[sensitivity][mistakes]") {
    SceneDocument document = balls();
    document.scene.shading.mistakes.culled_by_light = true;
    document.scene.objects.resize(1);
    Object& cube = document.scene.objects[0];
    cube.source = PrimitiveMesh{Primitive::Cube, 1};
    cube.mesh = primitive(Primitive::Cube, 1);
    document.scene.shading.cull = Cull::Back;          // the background is behind that face
    constexpr float z = 5e-5f, h = 1e-4f;              // h: a thousandth of 0.1, the smallest assumed size
    document.scene.lights[0].position = {1, 0, z, 0};  // grazes the face in front of the eye
    const auto drawn = [&document](float at) {
        Scene scene = document.scene;
        scene.lights[0].position.z = at;
        return glm::dvec3(Renderer(1).render(scene, sensitive_size, true).linear_at(32, 24));
    };
    const double expected = (drawn(z + h).x - drawn(z - h).x) / (2.0 * h);
    REQUIRE(std::abs(expected) > 100);
    CHECK(change_of(of_pixel(document, 32, 24), "/lights/0/position/2").x == Approx(expected));
}

TEST_CASE("sensitivity: numbers that move faces get the difference quotient of two pictures",
          "[sensitivity]") {
    const SceneDocument document = balls();
    const Sensitivities s = of_pixel(document, 30, 20);
    const auto pixel_with = [&](const std::string& pointer, double value) {
        Scene scene = document.scene;
        REQUIRE_FALSE(set_number(scene, pointer, value));
        Renderer renderer(1);
        return glm::dvec3(renderer.render(scene, sensitive_size, true).linear_at(30, 20));
    };
    for (const std::string pointer : {"/camera/eye/0", "/camera/projection/fov_y_deg",
                                      "/objects/0/transform/translate/0", "/objects/0/transform/scale/1"}) {
        INFO(pointer);
        const double value = number_at(document.scene, pointer)->value;
        const double h = 1e-3 * std::max(std::abs(value), 0.1);
        const glm::dvec3 between =
            (pixel_with(pointer, value + h) - pixel_with(pointer, value - h)) / (2 * h);
        REQUIRE(std::abs(between.x) > 1e-3);
        CHECK(change_of(s, pointer).x == Approx(between.x).epsilon(1e-4));
    }
}

TEST_CASE("sensitivity: the w of a position is marked as such", "[sensitivity]") {
    SceneDocument document = balls();
    document.scene.lights[0].kind = LightKind::Point;
    document.scene.lights[0].position = {2, 3, 4, 1};
    std::vector<std::string> w;
    for (const Sensitivity& number : of_pixel(document, 30, 20).numbers)
        if (number.is_w) w.push_back(number.pointer);
    CHECK(w == std::vector<std::string>{"/lights/0/position/3"});
}

TEST_CASE("sensitivity: numbers without effect and those that cannot change are listed", "[sensitivity]") {
    const Sensitivities s = of_pixel(balls(), 30, 20);
    for (const char* zero : {"/lights/0/falloff/quadratic", "/lights/0/spot/cutoff_deg", "/objects/1",
                             "/display/background/0", "/objects/0/material/roughness", "/npr/alpha"}) {
        INFO(zero);
        CHECK(lists(s.no_effect, zero));
    }
    CHECK(lists(s.fixed, "/objects/0/mesh/detail"));
    CHECK(lists(s.fixed, "/lights/0/position/3"));
    const Sensitivities background = of_pixel(balls(), 1, 1);
    CHECK(change_of(background, "/display/background/1").y == Approx(1).epsilon(1e-3));
    CHECK(lists(background.no_effect, "/objects/0"));
    CHECK(background.numbers.size() == 4);  // three of the background, and the exposure
}

TEST_CASE("sensitivity: numbers of the second object keep their pointers", "[sensitivity]") {
    const SceneDocument document = balls();
    Renderer renderer(1);
    (void)renderer.render(document.scene, sensitive_size);
    REQUIRE(renderer.object_at(60, 24) == 1);
    const Sensitivities s = of_pixel(document, 60, 24);
    CHECK(change_of(s, "/objects/1/material/emission/0").x == Approx(1).epsilon(1e-3));
    CHECK(lists(s.no_effect, "/objects/0"));
}

TEST_CASE("sensitivity: another object's stroke over the pixel counts by its coverage", "[sensitivity]") {
    SceneDocument document = balls();
    Scene& scene = document.scene;
    scene.objects[0].transform.scale = glm::vec3(2);  // fills the picture behind the other ball
    scene.objects[1].transform.translate = {0, 0, 2};
    scene.objects[1].transform.scale = glm::vec3(0.3f);
    scene.npr.silhouettes = true;
    scene.npr.stroke_width_px = 6;
    Renderer renderer(1);
    (void)renderer.render(scene, sensitive_size);
    bool whole = false, partly = false;
    for (int x = 16; x < 48; ++x) {  // around the small ball, far from the large one's own stroke
        const Explanation e = renderer.explain(x, 24);
        const double coverage = double(e.stroke.coverage);
        if (e.object_index != 0 || coverage == 0 || (coverage == 1 ? whole : partly)) continue;
        (coverage == 1 ? whole : partly) = true;
        CAPTURE(x, coverage);
        const Sensitivities s = of_pixel(document, x, 24);
        CHECK(change_of(s, "/npr/stroke/0").x == Approx(coverage).epsilon(1e-3));
        CHECK(lists(s.no_effect, "/objects/0/material/emission/0") == (coverage == 1));
        CHECK_FALSE(lists(s.no_effect, "/objects/1"));
        if (coverage < 1) CHECK(change_of(s, "/objects/1/transform/scale/0").x != 0);
    }
    CHECK(whole);
    CHECK(partly);
}

TEST_CASE("sensitivity: a scene with too many lights is refused", "[sensitivity][bad-input]") {
    SceneDocument document = balls();
    document.scene.lights.resize(max_sensitivity_lights + 1);
    const auto made = sensitivities(document, sensitive_size, 1, 1, 1);
    REQUIRE(problem_of(made) != nullptr);
    CHECK(problem_of(made)->pointer == "/lights");
}

TEST_CASE("buffers: their terms add up to the picture in every shading mode", "[buffers]") {
    Scene scene = busy_scene();
    for (const ShadingMode mode :
         {ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Gouraud, ShadingMode::Phong}) {
        scene.shading.mode = mode;
        Renderer renderer(2);
        const Picture& picture = renderer.render(scene, sensitive_size, true);
        const auto buffers = pixel_buffers(renderer, scene, sensitive_size, buffer_names(scene));
        const auto buffer = [&](const std::string& name) -> const Picture& {
            const auto found = std::find_if(buffers.begin(), buffers.end(),
                                            [&](const PixelBuffer& b) { return b.name == name; });
            REQUIRE(found != buffers.end());
            return found->picture;
        };
        CHECK(buffer("sum").linear == picture.linear);
        float shortest = 1;
        for (int y = 0; y < sensitive_size.height; ++y)
            for (int x = 0; x < sensitive_size.width; ++x) {
                const auto seen = renderer.seen_at(x, y);
                REQUIRE(buffer("face").linear_at(x, y) ==
                        (seen ? glm::vec3(1, seen->object, seen->face) : glm::vec3(0)));
                REQUIRE(buffer("side").linear_at(x, y) == glm::vec3(seen ? (seen->front ? 1 : -1) : 0));
                if (!seen) continue;
                REQUIRE(buffer("position").linear_at(x, y) == seen->position);
                REQUIRE(buffer("normal").linear_at(x, y) == seen->normal);
                REQUIRE(buffer("depth").linear_at(x, y).x == renderer.depth_at(x, y));
                glm::vec3 sum(0);
                for (const char* term : {"emission", "global_ambient", "ambient", "diffuse", "specular"})
                    sum += buffer(term).linear_at(x, y);
                for (int c = 0; c < 3; ++c)
                    REQUIRE(sum[c] == Approx(picture.linear_at(x, y)[c]).margin(2e-6));
                for (const char* direction : {"view", "l_1"}) {  // for a bulb
                    const float length = glm::length(buffer(direction).linear_at(x, y));
                    if (mode == ShadingMode::Gouraud)
                        shortest = std::min(shortest, length);
                    else
                        REQUIRE(length == Approx(1));
                }
            }
        CHECK((shortest < 0.9999f) == (mode == ShadingMode::Gouraud));
    }
}

TEST_CASE("an effect that removes the object shows the one behind it", "[sensitivity]") {
    SceneDocument document = balls();
    document.scene.objects[1].transform.translate = {0, 0, -2};  // behind the first ball
    document.scene.objects[1].transform.scale = glm::vec3(3);
    document.scene.objects[1].material.diffuse = {0.1f, 0.9f, 0.2f};
    Renderer renderer(1);
    (void)renderer.render(document.scene, sensitive_size);
    glm::ivec2 edge{32, 24};  // the last pixel of the first ball along its row
    while (renderer.object_at(edge.x + 1, edge.y) == 0) ++edge.x;
    REQUIRE(renderer.object_at(edge.x + 1, edge.y) == 1);
    const glm::dvec3 now(renderer.explain(edge.x, edge.y).sum);
    const Sensitivities found = of_pixel(document, edge.x, edge.y);
    int behind = 0;  // numbers whose change shows the other ball
    for (const Sensitivity& s : found.numbers) {
        Scene moved = document.scene;
        if (set_number(moved, s.pointer, s.value + s.move)) continue;
        if (problem_of(load_meshes(moved, "", "")) != nullptr) continue;
        (void)renderer.render(moved, sensitive_size);
        const glm::dvec3 gain =
            glm::dvec3(renderer.explain(edge.x, edge.y).sum) * double(moved.display.exposure) - now;
        INFO(s.pointer);
        behind += renderer.object_at(edge.x, edge.y) == 1 ? 1 : 0;
        for (int c = 0; c < 3; ++c) CHECK(s.effect[c] == Approx(gain[c]).margin(1e-6));
    }
    CHECK(behind > 3);
}

TEST_CASE("an effect is the pixel's change for a tenth of its number's usual range", "[sensitivity]") {
    SceneDocument document;
    document.scene = test::busy_scene();
    const PictureSize sensitive_size{64, 48};
    Renderer still(1), moved(1);
    (void)still.render(document.scene, sensitive_size);
    REQUIRE(still.object_at(24, 24) == 0);
    const glm::dvec3 now = still.explain(24, 24).sum;
    const auto made = sensitivities(document, sensitive_size, 24, 24, 1);
    int compared = 0;
    for (const Sensitivity& s : std::get<Sensitivities>(made).numbers) {
        if (!s.pointer.starts_with("/lights/") && !s.pointer.starts_with("/objects/0/material/")) continue;
        INFO(s.pointer);
        CHECK(std::abs(s.move) == Approx(usual_move(*number_at(document.scene, s.pointer))));
        Scene other = document.scene;
        REQUIRE_FALSE(set_number(other, s.pointer, s.value + s.move));
        (void)moved.render(other, sensitive_size);
        const glm::dvec3 gain = glm::dvec3(moved.explain(24, 24).sum) - now;
        for (int c = 0; c < 3; ++c) CHECK(s.effect[c] == Approx(gain[c]).margin(1e-6));
        ++compared;
    }
    CHECK(compared > 20);
    const auto move_of = [&](const char* pointer) { return usual_move(*number_at(document.scene, pointer)); };
    CHECK(move_of("/lights/0/intensity") == Approx(0.4));
    CHECK(move_of("/objects/0/material/roughness") == Approx(0.1));
    CHECK(move_of("/objects/0/material/shininess") == Approx(document.scene.objects[0].material.shininess));
    CHECK(move_of("/camera/eye/0") == Approx(2));
}
