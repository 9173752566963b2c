// Drags in the picture: mouse input changes the scene, and undo restores it.
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/commands/command.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// A window with a ball and one light, its highlight far from the light's handle.
struct LitWindow : HeadlessWindow {
    explicit LitWindow(LightKind kind) {
        scene().lights.resize(1);
        Light& light = scene().lights[0];
        light.name = "Lamp";
        light.kind = kind;
        light.space = LightSpace::World;
        light.position = {1.6f, 1.8f, 2.2f, kind == LightKind::Directional ? 0.0f : 1.0f};
        light.spot = {-glm::vec3(light.position), 40, 2};
        scene().objects[0].material.shininess = 60;
        scene().shading.reflection = Reflection::Phong;
        take_document(state.editor, state.editor.document);
        frames(2);
    }
};

/// The pixel with the largest specular term of light 0, found by explaining all pixels.
glm::dvec2 highlight_pixel(const HeadlessWindow& bench, int step = 3) {
    const PictureSize size = bench.state.rendered->size;
    glm::dvec2 best(0);
    float largest = -1;
    for (int y = 1; y < size.height; y += step)
        for (int x = 1; x < size.width; x += step) {
            const Explanation e = bench.state.renderer->explain(x, y);
            if (!e.hit || e.at.lights.empty() || !(e.at.lights[0].specular.g > largest)) continue;
            largest = e.at.lights[0].specular.g;
            best = {x + 0.5, y + 0.5};
        }
    return best;
}

float specular_at(const HeadlessWindow& bench, glm::dvec2 pixel) {
    const Explanation e = bench.state.renderer->explain(int(pixel.x), int(pixel.y));
    return e.hit ? e.at.lights[0].specular.g : 0;
}

}  // namespace

TEST_CASE("a highlight can be dragged, and undo restores the light", "[ui][hands][window]") {
    for (const LightKind kind : {LightKind::Directional, LightKind::Point, LightKind::Spot}) {
        LitWindow bench(kind);
        const Scene before = bench.scene();
        const glm::dvec2 from = highlight_pixel(bench), to = from + glm::dvec2(-50, 35);
        bench.move(bench.at_pixel(from));
        CHECK(bench.state.viewport.hovered_grip == Grip{.kind = GripKind::Highlight, .item = 0});
        bench.drag(bench.at_pixel(from), bench.at_pixel(to));
        CHECK(bench.scene().camera == before.camera);
        CHECK_FALSE(bench.scene().lights == before.lights);
        for (const glm::dvec2 aside :
             {glm::dvec2(3, 0), glm::dvec2(-3, 0), glm::dvec2(0, 3), glm::dvec2(0, -3)})
            CHECK(specular_at(bench, to) > specular_at(bench, to + aside));
        CHECK(glm::length(highlight_pixel(bench, 1) - to) <= 1);
        CHECK(bench.state.editor.history.undo_name() ==
              (kind == LightKind::Directional ? "Turn Lamp" : "Move Lamp"));
        bench.key(Key::Z, true);
        CHECK(bench.scene() == before);
        CHECK_FALSE(bench.state.editor.history.can_undo());
    }
}

TEST_CASE("a light dragged by its highlight keeps its distance from the surface", "[ui][hands][window]") {
    LitWindow bench(LightKind::Point);
    const glm::dvec2 from = highlight_pixel(bench), to = from + glm::dvec2(-50, 35);
    const float before = bench.state.renderer->explain(int(from.x), int(from.y)).at.lights[0].distance;
    bench.drag(bench.at_pixel(from), bench.at_pixel(to));
    CHECK(bench.state.renderer->explain(int(to.x), int(to.y)).at.lights[0].distance == Approx(before));
}

TEST_CASE("with Shift a highlight stays put and its light moves smoothly in depth", "[ui][hands][window]") {
    LitWindow bench(LightKind::Point);
    const glm::dvec2 from = highlight_pixel(bench), to = from + glm::dvec2(-40, 30);
    const ExplainedLight before = bench.state.renderer->explain(int(from.x), int(from.y)).at.lights[0];
    bench.move(bench.at_pixel(from));
    bench.button(true);
    bench.move(bench.at_pixel(to));
    ImGui::GetIO().KeyShift = true;
    // Dragging down by a third of the picture's height moves the light nearer by a factor of e.
    const glm::dvec2 down = to + glm::dvec2(0, bench.state.rendered->size.height / 3.0);
    bench.move(bench.at_pixel({to.x, (to.y + down.y) / 2}));
    bench.move(bench.at_pixel(down));
    bench.frames(1);
    const ExplainedLight near = bench.state.renderer->explain(int(to.x), int(to.y)).at.lights[0];
    CHECK(near.distance == Approx(before.distance / std::exp(1.0)).epsilon(0.01));
    CHECK(glm::length(highlight_pixel(bench, 1) - to) <= 1);
    ImGui::GetIO().KeyShift = false;
    const Light held = bench.scene().lights[0];
    (void)bench.frame();
    CHECK(glm::length(glm::vec3(bench.scene().lights[0].position - held.position)) < 1e-3f);
    bench.move(bench.at_pixel(down + glm::dvec2(30, 0)));
    bench.frames(1);
    CHECK(glm::length(highlight_pixel(bench, 1) - (to + glm::dvec2(30, 0))) <= 1);
    bench.button(false);
    bench.frames(1);
    CHECK(bench.state.editor.history.undo_name() == "Move Lamp");
}

TEST_CASE("a highlight dragged off the surface stays put, and Escape reverts the drag",
          "[ui][hands][window]") {
    LitWindow bench(LightKind::Point);
    const Scene before = bench.scene();
    const glm::dvec2 from = highlight_pixel(bench);
    bench.move(bench.at_pixel(from));
    bench.button(true);
    bench.move(bench.at_pixel(from + glm::dvec2(-30, 20)));
    const Light last = bench.scene().lights[0];
    bench.move(bench.at_pixel({4, 4}));
    CHECK(bench.state.viewport.held.no_solution);
    CHECK(bench.scene().lights[0] == last);
    bench.key(Key::Escape);
    CHECK(bench.scene() == before);
    bench.button(false);
    CHECK(bench.scene() == before);
}

TEST_CASE("a click on a highlight picks the pixel, an Alt-drag turns the camera", "[ui][hands][window]") {
    LitWindow bench(LightKind::Point);
    const Scene before = bench.scene();
    const glm::dvec2 at = highlight_pixel(bench);
    bench.click(bench.at_pixel(at));
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.explanation->x == int(at.x));
    ImGui::GetIO().KeyAlt = true;
    bench.drag(bench.at_pixel(at), bench.at_pixel(at + glm::dvec2(40, 0)));
    ImGui::GetIO().KeyAlt = false;
    CHECK(bench.scene().lights == before.lights);
    CHECK_FALSE(bench.scene().camera == before.camera);
}

TEST_CASE("without a highlight, its term or its light, there is nothing to grab", "[ui][hands][window]") {
    LitWindow bench(LightKind::Point);
    const glm::dvec2 at = highlight_pixel(bench);
    const Scene scene = bench.scene();
    const auto gripped = [&] {
        bench.frames(2);
        bench.move(bench.at_pixel(at));
        return bool(bench.state.viewport.hovered_grip);
    };
    CHECK(gripped());
    bench.scene().shading.reflection = Reflection::Lambert;
    CHECK_FALSE(gripped());
    bench.scene() = scene;
    bench.scene().shading.terms.specular = false;
    CHECK_FALSE(gripped());
    bench.scene() = scene;
    bench.scene().lights[0].enabled = false;
    CHECK_FALSE(gripped());
    bench.scene() = scene;
    bench.scene().objects[0].material.specular = glm::vec3(0);
    CHECK_FALSE(gripped());
}

TEST_CASE("the selected light's terminator follows the cursor", "[ui][hands][window]") {
    for (const LightKind kind : {LightKind::Directional, LightKind::Point, LightKind::Spot}) {
        LitWindow bench(kind);
        bench.state.editor.selection = {Selection::Kind::Light, 0};
        const Scene before = bench.scene();
        // Moves from the highlight, away from the light, until the surface faces away from the light.
        glm::dvec2 from = highlight_pixel(bench);
        const auto cosine = [&](glm::dvec2 p) {
            return bench.state.renderer->explain(int(p.x), int(p.y)).at.lights.at(0).n_dot_l;
        };
        while (cosine(from) > 0) from += glm::dvec2(-0.7, 0.7);
        bench.move(bench.at_pixel(from));
        CHECK(bench.state.viewport.hovered_grip == Grip{.kind = GripKind::Terminator, .item = 0});
        const glm::dvec2 to = from + glm::dvec2(40, -24);
        bench.drag(bench.at_pixel(from), bench.at_pixel(to));
        CHECK(cosine(to) == Approx(0).margin(1e-5));
        CHECK(cosine(to + glm::dvec2(2, -2)) > 0);
        CHECK(cosine(to + glm::dvec2(-2, 2)) < 0);
        bench.key(Key::Z, true);
        CHECK(bench.scene() == before);
    }
}

TEST_CASE("clicking W or C on a light keeps it in place, with Alt it keeps its coordinates",
          "[ui][hands][window]") {
    LitWindow bench(LightKind::Point);
    const Light start = bench.scene().lights[0];
    // The letter is to the left of the eye icon, at the right end of the row.
    const float right = lay_out({1280, 800}, bench.state.layout, 1).left.high.x;
    ImVec2 letter{right - 1.7f * ImGui::GetFrameHeight(), 60};
    while (bench.scene().lights[0].space == LightSpace::World && letter.y < 400) {
        letter.y += 6;
        bench.click(letter);
    }
    REQUIRE(bench.scene().lights[0].space == LightSpace::Camera);
    const glm::dvec2 before = bench.handle_pixel(0);
    CHECK(glm::length(glm::vec3(bench.scene().lights[0].position - start.position)) > 0.1f);
    CHECK(bench.state.editor.history.undo_name() == "Lamp to camera coordinates");
    bench.click(letter);
    CHECK(bench.scene().lights[0].space == LightSpace::World);
    CHECK(glm::length(bench.handle_pixel(0) - before) < 0.01);
    ImGui::GetIO().KeyAlt = true;
    const glm::vec4 numbers = bench.scene().lights[0].position;
    bench.click(letter);
    ImGui::GetIO().KeyAlt = false;
    CHECK(bench.scene().lights[0].space == LightSpace::Camera);
    CHECK(bench.scene().lights[0].position == numbers);
    CHECK(glm::length(bench.handle_pixel(0) - before) > 1);
}

TEST_CASE("moving, turning or scaling an object in the picture is one named undo step",
          "[ui][hands][window]") {
    LitWindow bench(LightKind::Point);
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    const Scene before = bench.scene();
    const glm::dvec2 middle = [&] {
        const ScreenMap map = screen_map(before.camera, bench.state.rendered->size);
        return project(map, glm::dvec3(before.objects[0].transform.translate)).pixel;
    }();
    const struct {
        Key key;
        glm::dvec2 from;
        const char* name;
    } deeds[] = {{Key::G, {0, 0}, "Move "}, {Key::R, {70.0, 70.0}, "Rotate "}, {Key::T, {0, 0}, "Scale "}};
    bench.key(Key::G);
    CHECK(bench.state.viewport.gizmo == GizmoMode::None);  // G hides a gizmo that is already shown
    for (const auto& action : deeds) {
        bench.key(action.key);
        // The outer ring's radius is 1.18 times the axis length of 84 units.
        const glm::dvec2 from =
            middle + (action.key == Key::R ? glm::normalize(action.from) * 84.0 * 1.18 : action.from);
        bench.move(bench.at_pixel(from));
        CHECK(bench.state.viewport.hovered_grip.kind == GripKind::Object);
        CHECK(bench.state.viewport.hovered_grip.part == GizmoPart::Free);
        bench.drag(bench.at_pixel(from), bench.at_pixel(from + glm::dvec2(30, -12)));
        CHECK(bench.state.editor.history.undo_name() == action.name + before.objects[0].name);
        CHECK_FALSE(bench.scene().objects == before.objects);
        CHECK(bench.scene().lights == before.lights);
        bench.key(Key::Z, true);
        CHECK(bench.scene() == before);
    }
    bench.key(Key::G);
    bench.move(bench.at_pixel(middle));
    bench.button(true);
    bench.move(bench.at_pixel(middle + glm::dvec2(40, 10)));
    CHECK_FALSE(bench.scene() == before);
    bench.key(Key::Escape);
    bench.button(false);
    CHECK(bench.scene() == before);
}

TEST_CASE("the cone of the selected spot can be opened and aimed in the picture", "[ui][hands][window]") {
    LitWindow bench(LightKind::Spot);
    bench.scene().lights[0].position = {-1.6f, 1.0f, 1.2f, 1};
    bench.scene().lights[0].spot = {{1.6f, -1.0f, -1.2f}, 20, 1};
    take_document(bench.state.editor, bench.state.editor.document);
    bench.state.editor.selection = {Selection::Kind::Light, 0};
    bench.frames(2);
    const Scene before = bench.scene();
    const auto place = [&](ShapePart part) {
        const ScreenMap map = screen_map(bench.scene().camera, bench.state.rendered->size);
        const Dome dome = sun_dome(bench.scene().camera.target, scene_bounds(bench.scene()), map);
        for (const ShapeGrip& grip : shape_grips(bench.scene().lights[0], dome, map))
            if (grip.part == part) return project(map, grip.place).pixel;
        return glm::dvec2(0);
    };
    for (const ShapePart part : {ShapePart::Rim, ShapePart::Aim}) {
        // Drags inwards, because beyond the rim of the free aim's sphere the cursor has no position on it.
        const glm::dvec2 from = place(part), to = from + glm::round(0.2 * (bench.handle_pixel(0) - from));
        ImGui::GetIO().KeyShift = part == ShapePart::Aim;
        bench.move(bench.at_pixel(from));
        bench.button(true);
        bench.move(bench.at_pixel(to));
        CHECK(gesture_hint(bench.state.viewport, bench.scene()).starts_with("It shines at") ==
              (part == ShapePart::Aim));
        bench.button(false);
        ImGui::GetIO().KeyShift = false;
        CHECK(bench.state.editor.history.undo_name() == "Cone of Lamp");
        if (part == ShapePart::Aim) CHECK(glm::length(place(part) - to) < 0.5);
        bench.key(Key::Z, true);
        CHECK(bench.scene() == before);
    }
    // The axis goes through the point under the cursor: on the surface, and off it at a visible depth.
    const glm::dvec2 from = place(ShapePart::Aim);
    const ScreenMap map = screen_map(before.camera, bench.state.rendered->size);
    const glm::dvec2 on_ball = project(map, {0.1, 0.2, 0.95}).pixel, off = {30, 40};
    for (const glm::dvec2 to : {on_ball, off}) {
        bench.drag(bench.at_pixel(from), bench.at_pixel(to));
        const Light& light = bench.scene().lights[0];
        CHECK(light.position == before.lights[0].position);
        const glm::dvec3 start(light.position), axis = glm::normalize(glm::dvec3(light.spot.direction));
        double nearest = 1e9;
        for (double along = 0; along < 20; along += 1e-3)
            if (const ProjectedPoint at = project(map, start + along * axis); at.in_front)
                nearest = std::min(nearest, glm::length(at.pixel - (glm::floor(to))));
        CHECK(nearest < 1.5);
        if (to == on_ball) {
            const Explanation e = bench.state.renderer->explain(int(to.x), int(to.y));
            CHECK(e.at.lights.at(0).spot_angle_deg < 0.2f);
        }
        bench.key(Key::Z, true);
        CHECK(bench.scene() == before);
    }
}

TEST_CASE("turning a skew quad about a picked point changes its colour only with scanlines",
          "[ui][hands][window]") {
    for (const Interpolation interpolation : {Interpolation::Scanline, Interpolation::Perspective}) {
        HeadlessWindow bench;
        take_document(bench.state.editor, std::get<SceneDocument>(open_document(
                                              project_file("assets/scenes/skew-quad.json"), {})));
        bench.scene().shading.interpolation = interpolation;
        bench.frames(2);
        CHECK_FALSE(why_disabled(bench.state, test::command_named("Rotate the object about the picked point"))
                        .empty());
        const glm::dvec2 pixel =
            project(screen_map(bench.scene().camera, bench.state.rendered->size), {-2.5, 0.1, 0}).pixel;
        bench.click(bench.at_pixel(pixel));
        bench.frames(2);
        REQUIRE(bench.state.on_screen.explanation);
        const Explanation before = *bench.state.on_screen.explanation;
        bench.key(Key::R, false, true);
        REQUIRE(bench.state.viewport.pivot);
        CHECK(bench.state.editor.selection == Selection{Selection::Kind::Object, before.object_index});
        // Turns by a right angle. The outer ring rotates about the line of sight; its radius is 1.18 times
        // the axis length of 84 units.
        const double out = 84 * 1.18;
        bench.drag(bench.at_pixel(pixel + glm::dvec2(out, 0)), bench.at_pixel(pixel + glm::dvec2(0, -out)));
        bench.frames(2);
        CHECK(bench.state.editor.history.undo_name() == "Rotate As it is");
        const Explanation after = *bench.state.on_screen.explanation;
        CHECK(std::abs(bench.scene().objects[0].transform.rotate_deg.z) == Approx(90).margin(2));
        CHECK(glm::length(after.spaces.object - before.spaces.object) < 0.03f);
        const float change = glm::length(after.sum - before.sum);
        INFO("change " << change);
        CHECK((interpolation == Interpolation::Scanline ? change > 0.08f : change < 0.02f));
        bench.key(Key::R);
        CHECK_FALSE(bench.state.viewport.pivot);
        CHECK(bench.state.viewport.gizmo == GizmoMode::Rotate);
    }
}
