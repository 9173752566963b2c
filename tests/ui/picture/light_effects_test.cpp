// Positioning a light by its effect at a point (brightest there, or from behind), finding the light with the
// largest effect there, and changing its brightness.
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/lecture_scene.h"
#include "tests/support/person.h"
#include "tests/support/scenes.h"
#include "ui/picture/handles/light_handles.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

const PictureSize effect_picture{240, 180};

Scene ball_under(LightKind kind, LightSpace space) {
    Scene scene;
    scene.camera.eye = {0.8f, 0.9f, 4};
    scene.objects = {test::object_of(test::primitive(Primitive::Sphere, 64), "Ball")};
    Light light;
    light.name = "Lamp";
    light.kind = kind;
    light.position = {2, 1.5f, 1, kind == LightKind::Directional ? 0.0f : 1.0f};
    light.spot = {{-1, 0, 0}, 35, 2};
    scene.lights = {in_space(light, space, scene.camera)};
    return scene;
}

/// A drawn scene in which a light is positioned.
struct DrawnBall {
    Scene scene;
    Renderer renderer{1};
    ScreenMap map;
    Dome dome;

    explicit DrawnBall(const Scene& s) : scene(s), map(screen_map(s.camera, effect_picture)) {
        dome = sun_dome(s.camera.target, scene_bounds(s), map);
        (void)renderer.render(scene, effect_picture);
    }
    [[nodiscard]] std::optional<Light> with(LightEffect effect, glm::dvec2 pixel) const {
        return with_effect(effect, scene.lights[0], {scene, renderer, map, dome}, pixel);
    }
};

/// The vectors n, l and v at a point, and the distance to a light, from the geometry in world coordinates
/// and without the equation.
struct LightAngles {
    glm::dvec3 n, l, v;
    double distance = 0;

    LightAngles(const DrawnBall& stage, const Light& light, const Explanation& e)
        : n(glm::normalize(glm::dvec3(e.at.normal.world))), v(glm::normalize(glm::dvec3(e.at.view.world))) {
        const glm::dvec3 to_light =
            light.kind == LightKind::Directional
                ? direction_of(light, stage.map)
                : handle_of(light, stage.dome, stage.map) - glm::dvec3(e.at.point.world);
        distance = glm::length(to_light);
        l = to_light / distance;
    }
};

template <class Check> void for_all_lights(Check check) {
    for (const LightKind kind : {LightKind::Directional, LightKind::Point, LightKind::Spot, LightKind::Area})
        for (const LightSpace space : {LightSpace::World, LightSpace::Camera}) {
            CAPTURE(static_cast<int>(kind), static_cast<int>(space));
            DrawnBall stage(ball_under(kind, space));
            int checked = 0;
            for (int y = 6; y < effect_picture.height; y += 12)
                for (int x = 6; x < effect_picture.width; x += 12) {
                    const Explanation e = stage.renderer.explain(x, y);
                    if (!e.hit) continue;
                    check(stage, e, glm::dvec2(x + 0.5, y + 0.5));
                    ++checked;
                }
            CHECK(checked > 20);
        }
}

/// How directly a spot or a panel shines at a point: the cosine of the angle off its axis.
double aim_at(const DrawnBall& stage, const Light& light, glm::dvec3 place) {
    const glm::dvec3 way = glm::normalize(place - handle_of(light, stage.dome, stage.map));
    if (light.kind == LightKind::Spot)
        return glm::dot(way, glm::normalize(to_world(light, light.spot.direction, 0, stage.map)));
    return std::abs(
        glm::dot(way, glm::normalize(glm::cross(to_world(light, light.area.edge_u, 0, stage.map),
                                                to_world(light, light.area.edge_v, 0, stage.map)))));
}

}  // namespace

TEST_CASE("brightest here: n·l is 1 under the cursor for every light kind and space",
          "[ui][hands][property]") {
    for_all_lights([](DrawnBall& stage, const Explanation& e, glm::dvec2 pixel) {
        const Light& start = stage.scene.lights[0];
        const auto light = stage.with(LightEffect::Brightest, pixel);
        REQUIRE(light);
        const LightAngles before(stage, start, e), now(stage, *light, e);
        CHECK(glm::dot(now.n, now.l) == Approx(1).margin(1e-4));
        CHECK(now.distance == Approx(before.distance).epsilon(1e-5));
        if (light->kind == LightKind::Spot || light->kind == LightKind::Area)
            CHECK(aim_at(stage, *light, glm::dvec3(e.at.point.world)) == Approx(1).margin(1e-5));
    });
}

TEST_CASE("brightest here: the equation itself has n·l = 1 there", "[ui][hands]") {
    for (const LightKind kind : {LightKind::Directional, LightKind::Point, LightKind::Spot}) {
        DrawnBall stage(ball_under(kind, LightSpace::Camera));
        const auto light = stage.with(LightEffect::Brightest, {115.5, 80.5});
        REQUIRE(light);
        stage.scene.lights[0] = *light;
        (void)stage.renderer.render(stage.scene, effect_picture);
        const ExplainedLight lit = stage.renderer.explain(115, 80).at.lights.at(0);
        CHECK(lit.n_dot_l == Approx(1).margin(1e-4));
        CHECK(lit.spot == Approx(1).margin(1e-4));
    }
}

TEST_CASE("rim light: from behind with n·l = cos 75°, lit from the cursor to the outline",
          "[ui][hands][property]") {
    const double cosine = std::cos(75 * std::acos(-1.0) / 180);
    int from_behind = 0;
    for_all_lights([&](DrawnBall& stage, const Explanation& e, glm::dvec2 pixel) {
        const LightAngles before(stage, stage.scene.lights[0], e);
        const auto light = stage.with(LightEffect::Rim, pixel);
        const double facing = glm::dot(before.n, before.v);
        // Within 15 degrees of the line of sight, no direction 75 degrees off n comes from behind.
        if (std::abs(facing - std::sqrt(1 - cosine * cosine)) > 1e-4)
            CHECK(bool(light) == (facing < std::sqrt(1 - cosine * cosine)));
        if (!light) return;
        ++from_behind;
        const LightAngles now(stage, *light, e);
        CHECK(glm::dot(now.n, now.l) == Approx(cosine).margin(1e-4));
        CHECK(glm::dot(now.v, now.l) < 1e-4);
        CHECK(std::abs(glm::dot(now.l, glm::cross(now.n, now.v))) < 1e-4);
        CHECK(now.distance == Approx(before.distance).epsilon(1e-5));
        if (light->kind != LightKind::Directional) return;
        // On a ball, normals from here to the outline are between n and the outline's, which is perpendicular
        // to v.
        const glm::dvec3 outline = glm::normalize(now.n - facing * now.v);
        for (double share = 0; share <= 1; share += 0.125)
            CHECK(glm::dot(glm::normalize(glm::mix(now.n, outline, share)), now.l) > 0.2);
    });
    CHECK(from_behind > 100);
}

TEST_CASE("the main light is the one whose removal darkens the pixel most", "[ui][hands]") {
    for (const ShadingMode mode : {ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat}) {
        Scene scene = test::busy_scene();
        scene.shading.mode = mode;
        const test::Drawn all(scene, effect_picture);
        std::vector<std::unique_ptr<test::Drawn>> others;
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            Scene less = scene;
            less.lights[i].enabled = false;
            others.push_back(std::make_unique<test::Drawn>(less, effect_picture));
        }
        const auto total = [](const test::Drawn& drawn, int x, int y) {
            const glm::vec3 c = drawn.picture().linear_at(x, y);
            return double(c.x) + double(c.y) + double(c.z);
        };
        int seen = 0;
        for (int y = 3; y < effect_picture.height; y += 7)
            for (int x = 3; x < effect_picture.width; x += 7) {
                const Explanation e = all.at(x, y);
                const auto main = main_light(e);
                if (!e.hit || !main) continue;
                ++seen;
                double most = 0;
                for (const auto& other : others)
                    most = std::max(most, total(all, x, y) - total(*other, x, y));
                const double its = total(all, x, y) - total(*others[std::size_t(main->light)], x, y);
                CHECK(its == Approx(most).margin(1e-4));
                CHECK(main->share == Approx(its / total(all, x, y)).margin(1e-3));
            }
        CHECK(seen > 100);
    }
    CHECK_FALSE(main_light(Explanation{}));
}

TEST_CASE("placing a light that follows the cursor is one step, Escape reverts it", "[ui][hands][window]") {
    for (const bool shift : {false, true}) {
        DrawnWindow bench;
        bench.state.editor.selection = {Selection::Kind::Light, 1};
        const Scene before = bench.scene();
        const glm::dvec2 at =
            project(screen_map(before.camera, bench.state.rendered->size), {0.75, 0.3, 0.58}).pixel;
        bench.move(bench.at_pixel(at));
        bench.key(Key::H, false, shift);
        bench.move(bench.at_pixel(at + glm::dvec2(2, 0)));
        CHECK(bench.state.viewport.gesture == Gesture::Effect);
        CHECK_FALSE(bench.scene().lights[1] == before.lights[1]);
        CHECK(bench.scene().lights[0] == before.lights[0]);
        bench.key(Key::Escape);
        CHECK(bench.scene() == before);
        CHECK_FALSE(bench.state.editor.history.can_undo());

        bench.key(Key::H, false, shift);
        bench.click(bench.at_pixel(at));
        bench.frames(2);
        CHECK(bench.state.viewport.gesture == Gesture::None);
        CHECK(bench.state.editor.history.undo_name() == "Move Bulb");
        CHECK_FALSE(bench.state.viewport.probe);  // the click did not pick a pixel
        const Explanation e = bench.state.renderer->explain(int(at.x), int(at.y));
        CHECK(e.at.lights.at(1).n_dot_l ==
              Approx(shift ? std::cos(75 * std::acos(-1.0) / 180) : 1).margin(1e-4));
        bench.key(Key::Z, true);
        CHECK(bench.scene() == before);
    }
}

TEST_CASE("off the surface, a light that follows the cursor does not move", "[ui][hands][window]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    bench.key(Key::H);
    bench.move(bench.at_pixel({4, 4}));
    CHECK(bench.state.viewport.effect.no_solution);
    CHECK(bench.scene() == before);
    bench.key(Key::Escape);
    bench.scene().lights.clear();
    CHECK_FALSE(why_disabled(bench.state, test::command_named("Brightest here: the light follows the cursor"))
                    .empty());
}

TEST_CASE("K selects the main light under the cursor, or else the one at the picked point",
          "[ui][hands][window]") {
    DrawnWindow bench;
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    // The bulb is on the left of the ball, the sun on the right.
    const PictureSize whole = bench.state.rendered->size;
    const glm::dvec2 middle{whole.width / 2.0, whole.height / 2.0};
    const ScreenMap map = screen_map(bench.scene().camera, whole);
    const glm::dvec2 left = project(map, {-0.85, 0, 0.5}).pixel, right = project(map, {0.8, 0.3, 0.5}).pixel;
    bench.move(bench.at_pixel(left));
    bench.key(Key::K);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 1});
    bench.move(bench.at_pixel(right));
    bench.key(Key::K);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 0});
    bench.click(bench.at_pixel(left));
    bench.move({5, 5});
    bench.key(Key::K);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 1});
}

TEST_CASE("a Ctrl+Shift drag changes a light's brightness, not its position", "[ui][hands][window]") {
    HeadlessWindow bench;
    bench.scene().lights[1].position.x = -1;
    take_document(bench.state.editor, bench.state.editor.document);
    bench.frames(2);
    const Scene before = bench.scene();
    const glm::dvec2 handle = bench.handle_pixel(1);
    const double third = bench.state.rendered->size.height / 3.0;
    bench.move(bench.at_pixel(handle));
    bench.button(true);
    ImGui::GetIO().KeyShift = ImGui::GetIO().KeyCtrl = true;
    bench.move(bench.at_pixel(handle - glm::dvec2(0, third / 2)));
    bench.move(bench.at_pixel(handle - glm::dvec2(0, third)));
    CHECK(bench.scene().lights[1].intensity == Approx(std::exp(1.0)).epsilon(0.01));
    CHECK(bench.scene().lights[1].position == before.lights[1].position);
    // After the keys are released, the drag continues from here.
    ImGui::GetIO().KeyShift = ImGui::GetIO().KeyCtrl = false;
    (void)bench.frame();
    CHECK(glm::length(bench.scene().lights[1].position - before.lights[1].position) < 1e-3f);
    ImGui::GetIO().KeyShift = ImGui::GetIO().KeyCtrl = true;
    bench.button(false);
    ImGui::GetIO().KeyShift = ImGui::GetIO().KeyCtrl = false;
    bench.frames(2);
    CHECK(bench.state.editor.history.undo_name() == "Brightness of Bulb");
    bench.key(Key::Z, true);
    CHECK(bench.scene() == before);
    CHECK(dimmed(0, 30, 300) > 0);
    CHECK(dimmed(0, -30, 300) == 0);
}
