// Objects in the window: hidden ones, one number for the three scales, and the gizmo's position.
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/scenes.h"
#include "ui/picture/handles/object_drag.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// A box whose mesh is far from its origin.
Object far_off() {
    Object object = test::object_of(
        test::polygon_mesh(
            {{4, 4, 4}, {5, 4, 4}, {5, 5, 4}, {4, 5, 4}, {4, 4, 6}, {5, 4, 6}, {5, 5, 6}, {4, 5, 6}},
            {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}),
        "Box");
    object.transform = {{-3, -2, -4}, {10, 25, -15}, {0.7f, 0.9f, 0.6f}};
    return object;
}

struct Seen {
    Camera camera{{1, 1, 8}, {0, 0, 0}, {0, 1, 0}, Perspective{40, 0.1f, 100}};
    PictureView picture;
    DragView view;
    Seen() {
        picture.map = screen_map(camera, {1000, 700});
        picture.bounds = {{-1, -1, -1}, {1, 1, 1}};
        picture.dome = sun_dome({0, 0, 0}, picture.bounds, picture.map);
        view = {picture.map, picture.dome};
    }
};

glm::dvec3 in_world(const Transform& t, glm::dvec3 place) {
    return glm::dvec3(world_from_object(t) * glm::dvec4(place, 1));
}

}  // namespace

TEST_CASE("hiding an object excludes it from the picture, picking, framing and handles",
          "[ui][window][objects]") {
    HeadlessWindow bench;
    Object small = bench.scene().objects[0];
    small.name = "Pea";
    small.transform = {{1.4f, 0, 0}, {}, glm::vec3(0.2f)};
    bench.scene().objects.push_back(small);
    take_document(bench.state.editor, bench.state.editor.document);
    bench.frames(2);
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    const glm::dvec2 middle =
        project(screen_map(bench.scene().camera, bench.state.rendered->size), {0, 0, 0}).pixel;
    bench.move(bench.at_pixel(middle));
    CHECK(bench.state.viewport.hovered_grip.kind == GripKind::Object);
    bench.click_on("/objects/0/visible");
    CHECK_FALSE(bench.scene().objects[0].visible);
    CHECK(bench.state.editor.history.undo_name() == "Hide Ball");
    bench.move(bench.at_pixel(middle));
    CHECK(bench.state.viewport.hovered_grip.kind == GripKind::None);
    CHECK(bench.state.renderer->object_at(int(middle.x), int(middle.y)) == -1);
    bench.key(Key::F, false, true);
    // Only the pea is framed.
    CHECK(glm::length(bench.scene().camera.target - glm::vec3(1.4f, 0, 0)) < 0.01f);
    bench.click_on("/objects/0/visible");
    CHECK(bench.scene().objects[0].visible);
    CHECK(bench.state.editor.history.undo_name() == "Show Ball");
}

TEST_CASE("one number scales an object uniformly and keeps ratios and mirroring", "[ui][window][objects]") {
    HeadlessWindow bench({1280, 1200});
    bench.scene().objects[0].transform.scale = {1, -0.5f, 0.25f};
    take_document(bench.state.editor, bench.state.editor.document);
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(3);
    const ImVec2 field = bench.control("Scale all");
    bench.drag(field, {field.x + 60, field.y});
    bench.frames(2);
    const glm::vec3 scale = bench.scene().objects[0].transform.scale;
    CHECK(scale.x > 1.05f);
    CHECK(scale.y / scale.x == Approx(-0.5));
    CHECK(scale.z / scale.x == Approx(0.25));
    CHECK(bench.state.editor.history.undo_name() == "Scale Ball");
}

TEST_CASE("a uniform scale typed digit by digit keeps the ratios, and 0 is rejected",
          "[ui][window][objects]") {
    HeadlessWindow bench({1280, 1200});
    const glm::vec3 first = GENERATE(glm::vec3(1), glm::vec3(1, -0.5f, 0.25f), glm::vec3(1, 0.625f, 0.625f));
    bench.scene().objects[0].transform.scale = first;
    take_document(bench.state.editor, bench.state.editor.document);
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(3);
    const auto scale = [&bench] { return bench.scene().objects[0].transform.scale; };
    const auto type = [&bench](const char* text) {
        bench.click(bench.control("Scale all"));
        for (const char* letter = text; *letter != 0; ++letter) bench.type(std::string(1, *letter).c_str());
        bench.click({5, 1195});
        bench.frames(2);
    };
    type("0.5");
    CHECK(scale() == 0.5f * first);
    type("0");
    CHECK(scale().x > 0);
    type("2");
    CHECK(scale() == 2.0f * first);
    CHECK(same_description(std::get<Scene>(parse_scene(scene_text(bench.scene()), "scaled.json")),
                           bench.scene()));
}

TEST_CASE("the gizmo is at the visible part's centre if the origin is outside the picture", "[ui][objects]") {
    const Seen seen;
    const Object object = far_off();
    const glm::dvec3 middle(4.5, 4.5, 5);
    CHECK(gizmo_anchor(object, seen.picture) == middle);
    Object centred = object;
    centred.mesh = test::primitive(Primitive::Cube, 1);
    centred.transform = {{0.2f, 0, 0}, {}, glm::vec3(1)};
    CHECK(gizmo_anchor(centred, seen.picture) == glm::dvec3(0));
    // A long plank with its origin at one end, which is outside the picture.
    Object plank =
        test::object_of(test::polygon_mesh({{-1, 0, 0}, {9, 0, 0}, {9, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}));
    plank.transform.translate = {-5, 0, 0};
    CHECK(gizmo_anchor(plank, seen.picture) == glm::dvec3(4, 0.5, 0));
    plank.transform.translate = {0, 0, 0};
    CHECK(gizmo_anchor(plank, seen.picture) == glm::dvec3(0));
    plank.transform.translate = {-500, 0, 0};  // no part of it is visible
    CHECK(gizmo_anchor(plank, seen.picture) == glm::dvec3(0));
    plank.mesh = nullptr;
    CHECK(gizmo_anchor(plank, seen.picture) == glm::dvec3(0));
}

TEST_CASE("an object turned or scaled about its gizmo keeps the gizmo's position", "[ui][objects]") {
    const Seen seen;
    const Transform start = far_off().transform;
    const glm::dvec3 anchor = gizmo_anchor(far_off(), seen.picture), stand = in_world(start, anchor);
    for (const GizmoMode mode : {GizmoMode::Rotate, GizmoMode::Scale})
        for (const GizmoPart part : {GizmoPart::X, GizmoPart::Y, GizmoPart::Z, GizmoPart::Free}) {
            const auto gizmo = gizmo_of(start, mode, seen.picture, {.anchor = anchor});
            REQUIRE(gizmo);
            CHECK(glm::length(gizmo->origin - stand) < 1e-9);
            const glm::dvec2 from = project(seen.view.map, stand).pixel + glm::dvec2(60, -40);
            const Transform after = dragged_object({start, *gizmo, mode, part, from}, seen.view,
                                                   from + glm::dvec2(35, -20), false);
            CHECK_FALSE(after == start);
            CHECK(glm::length(in_world(after, anchor) - stand) < 1e-3);  // angles are rounded to 0.001°
            CHECK((after.scale == start.scale) == (mode == GizmoMode::Rotate));
            CHECK((after.rotate_deg == start.rotate_deg) == (mode == GizmoMode::Scale));
        }
    const auto gizmo = gizmo_of(start, GizmoMode::Move, seen.picture, {.anchor = anchor});
    const glm::dvec2 from = project(seen.view.map, stand).pixel, to = from + glm::dvec2(40, 25);
    const Transform after =
        dragged_object({start, *gizmo, GizmoMode::Move, GizmoPart::Free, from}, seen.view, to, false);
    CHECK(glm::length(project(seen.view.map, in_world(after, anchor)).pixel - to) < 0.01);
    CHECK(after.rotate_deg == start.rotate_deg);
    CHECK(after.scale == start.scale);
}

TEST_CASE("scaling an object about the centre of its bounds is a step named Scale", "[ui][objects]") {
    Scene before;
    before.objects = {far_off()};
    Scene after = before;
    after.objects[0].transform.scale *= 2.0f;
    after.objects[0].transform.translate += glm::vec3(1, 0, 0);
    CHECK(step_name(before, after) == "Scale Box");
    after.objects[0].transform.rotate_deg.x += 5;
    CHECK(step_name(before, after) == "Transform Box");
}
