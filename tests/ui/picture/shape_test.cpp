// Dragging the shapes of lights and objects: cones, panels, and an object's gizmo.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/scenes.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/handles/object_drag.h"

using namespace glint;

namespace {

struct LightStage {
    Camera camera{{3, 2, 5}, {0, 0, 0}, {0, 1, 0}, Perspective{40, 0.1f, 100}};
    DragView view;
    PictureView picture;
    LightStage() {
        view.map = screen_map(camera, {1000, 700});
        view.dome = sun_dome({0, 0, 0}, {{-1, -1, -1}, {1, 1, 1}}, view.map);
        picture.map = view.map;
        picture.dome = view.dome;
        picture.bounds = {{-1, -1, -1}, {1, 1, 1}};
    }
    [[nodiscard]] glm::dvec2 pixel(glm::dvec3 place) const { return project(view.map, place).pixel; }
};

Light lamp(LightSpace space, const LightStage& stage) {
    Light light;
    light.kind = LightKind::Spot;
    light.position = {0.5f, 1.2f, 0.6f, 1};
    light.spot = {{-0.3f, -1, -0.2f}, 25, 2};
    return in_space(light, space, stage.camera);
}

Light panel(LightSpace space, const LightStage& stage) {
    Light light;
    light.kind = LightKind::Area;
    light.position = {-0.4f, -0.6f, 0.5f, 1};
    light.area = {{0.4f, 0, 0.1f}, {0.05f, 0.1f, 0.3f}, 16};
    return in_space(light, space, stage.camera);
}

Transform busy_transform() { return {{0.3f, -0.2f, 0.4f}, {20, -35, 50}, {1, 0.8f, 1.3f}}; }

double largest_difference(const glm::dmat3& a, const glm::dmat3& b) {
    double largest = 0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
    return largest;
}

glm::dmat3 rotation(glm::vec3 deg) { return glm::dmat3(world_from_object({{}, deg, glm::vec3(1)})); }

}  // namespace

TEST_CASE("a dragged cone opens until its rim is under the cursor", "[ui][hands]") {
    const LightStage stage;
    for (const LightSpace space : {LightSpace::World, LightSpace::Camera})
        for (int i = 0; i < 8; ++i) {
            const Light light = lamp(space, stage);
            const double azimuth = i * 0.785398;
            const ShapeGrip grip{
                ShapePart::Rim, azimuth, {}, cone_of(light, stage.view.dome, stage.view.map)->rim(azimuth)};
            Light wanted = light;
            wanted.spot.cutoff_deg = 41;
            const glm::dvec2 to = stage.pixel(cone_of(wanted, stage.view.dome, stage.view.map)->rim(azimuth));
            const Light after = dragged_shape({light, grip, stage.pixel(grip.place)}, stage.view, to, false);
            CHECK(after.spot.cutoff_deg == Approx(41).margin(0.2));
            CHECK(
                dragged_shape({light, grip, stage.pixel(grip.place)}, stage.view, to, true).spot.cutoff_deg ==
                40);
            wanted.spot.cutoff_deg = after.spot.cutoff_deg;
            CHECK(after == wanted);
        }
}

TEST_CASE("a spot's or panel's aim stays under the cursor, and the light stays in place", "[ui][hands]") {
    const LightStage stage;
    for (const LightSpace space : {LightSpace::World, LightSpace::Camera})
        for (const Light& light : {lamp(space, stage), panel(space, stage)}) {
            const ShapeGrip grip = shape_grips(light, stage.view.dome, stage.view.map)[0];
            REQUIRE(grip.part == ShapePart::Aim);
            const glm::dvec2 from = stage.pixel(grip.place), to = from + glm::dvec2(14, -9);
            const Light after = dragged_shape({light, grip, from}, stage.view, to, false);
            CHECK(glm::length(stage.pixel(place_of(grip, after, stage.view.dome, stage.view.map)) - to) <
                  0.5);
            CHECK(after.position == light.position);
        }
}

TEST_CASE("a light aimed at a target shines at it", "[ui][hands]") {
    const LightStage stage;
    const glm::dvec3 place(0.2, -0.4, -0.3);
    for (const LightSpace space : {LightSpace::World, LightSpace::Camera}) {
        const Light spot = aimed_at(lamp(space, stage), place, stage.view);
        const auto cone = cone_of(spot, stage.view.dome, stage.view.map);
        CHECK(cone->angle == Approx(double(spot.spot.cutoff_deg) * std::numbers::pi / 180));
        CHECK(cone->inner == Approx(double(spot.spot.inner_deg) * std::numbers::pi / 180));
        CHECK(glm::length(cone->axis - glm::normalize(place - cone->place)) < 1e-5);
        const auto shape = panel_of(aimed_at(panel(space, stage), place, stage.view), stage.view.map);
        CHECK(glm::length(shape->normal() - glm::normalize(place - shape->place)) < 1e-5);
    }
}

TEST_CASE("a panel's corners and edges follow the cursor, and its centre stays", "[ui][hands]") {
    const LightStage stage;
    for (const LightSpace space : {LightSpace::World, LightSpace::Camera}) {
        const Light light = panel(space, stage);
        for (const ShapeGrip& grip : shape_grips(light, stage.view.dome, stage.view.map)) {
            if (grip.part == ShapePart::Aim) continue;
            const auto shape = panel_of(light, stage.view.map);
            const glm::dvec3 there = shape->place + 1.3 * grip.at.x * shape->u + 0.7 * grip.at.y * shape->v;
            const Light after =
                dragged_shape({light, grip, stage.pixel(grip.place)}, stage.view, stage.pixel(there), false);
            const float u = grip.at.x != 0 ? 1.3f : 1, v = grip.at.y != 0 ? 0.7f : 1;
            CHECK(glm::length(after.area.edge_u - u * light.area.edge_u) < 1e-3f);
            CHECK(glm::length(after.area.edge_v - v * light.area.edge_v) < 1e-3f);
            CHECK(after.position == light.position);
        }
        const auto dragged_to = [&](const ShapeGrip& grip, glm::dvec2 at) {
            const glm::dvec3 to = panel_of(light, stage.view.map)->point(at);
            return dragged_shape({light, grip, stage.pixel(grip.place)}, stage.view, stage.pixel(to), false);
        };
        const auto grip_at = [&](ShapePart part, glm::dvec2 at) {
            return ShapeGrip{part, 0, at, panel_of(light, stage.view.map)->point(at)};
        };
        // At the centre, a minimal edge remains because the scene file requires a nonzero area.
        const Light thin = dragged_to(grip_at(ShapePart::Edge, {1, 0}), {0, 0});
        CHECK(glm::length(thin.area.edge_u) > 0);
        CHECK(glm::length(thin.area.edge_u) < 0.01f * glm::length(light.area.edge_u));
        // Beyond the centre, the panel grows again and shines in the same direction.
        const Light turned = dragged_to(grip_at(ShapePart::Corner, {1, -1}), {-1.5, 0.5});
        CHECK(glm::length(turned.area.edge_u - 1.5f * light.area.edge_u) < 1e-3f);
        CHECK(glm::length(turned.area.edge_v - 0.5f * light.area.edge_v) < 1e-3f);
    }
}

TEST_CASE("the soft edge's circle follows the cursor up to the rim", "[ui][hands]") {
    const LightStage stage;
    Light light = lamp(LightSpace::World, stage);
    light.spot.cutoff_deg = 30, light.spot.inner_deg = 12;
    Light wanted = light;
    wanted.spot.inner_deg = 20;
    const auto on_ring = [&](const Light& l, float degrees) {
        const auto cone = cone_of(l, stage.view.dome, stage.view.map);
        return stage.pixel(cone->ring(0.78539816, double(degrees) * 0.017453292519943295));
    };
    const auto grip = shape_under(light, stage.picture, on_ring(light, 12));
    REQUIRE(grip);
    CHECK(grip->part == ShapePart::Inner);
    const ShapeDrag drag{light, *grip, stage.pixel(grip->place)};
    CHECK(dragged_shape(drag, stage.view, on_ring(light, 20), false).spot.inner_deg ==
          Approx(20).margin(0.2));
    CHECK(dragged_shape(drag, stage.view, on_ring(light, 60), false).spot.inner_deg == 30);
    CHECK(dragged_shape(drag, stage.view, on_ring(light, 60), false).spot.cutoff_deg == 30);
    light.spot.inner_deg = 180;  // no soft edge
    for (const ShapeGrip& each : shape_grips(light, stage.view.dome, stage.view.map))
        CHECK(each.part != ShapePart::Inner);
}

TEST_CASE("every handle of a shape can be hovered, and the rim all the way around", "[ui][hands]") {
    const LightStage stage;
    for (const Light& light : {lamp(LightSpace::World, stage), panel(LightSpace::Camera, stage)})
        for (const ShapeGrip& grip : shape_grips(light, stage.view.dome, stage.view.map)) {
            const auto found = shape_under(light, stage.picture, stage.pixel(grip.place));
            REQUIRE(found);
            CHECK(found->part == grip.part);
        }
    const Light light = lamp(LightSpace::World, stage);
    const auto on_rim = cone_of(light, stage.view.dome, stage.view.map)->rim(0.6);
    CHECK(shape_under(light, stage.picture, stage.pixel(on_rim))->part == ShapePart::Rim);
    CHECK_FALSE(shape_under(light, stage.picture, {5, 5}));
}

TEST_CASE("an object moved along an axis or in a plane changes only those coordinates", "[ui][hands]") {
    const LightStage stage;
    const Transform start = busy_transform();
    const auto gizmo = gizmo_of(start, GizmoMode::Move, stage.picture);
    REQUIRE(gizmo);
    for (int k = 0; k < 7; ++k) {
        const auto part = static_cast<GizmoPart>(k);
        glm::dvec3 motion(0.25, -0.15, 0.2);  // reduced below to what the handle allows
        if (part <= GizmoPart::Z)
            for (int i = 0; i < 3; ++i) motion[i] = i == k ? motion[i] : 0;
        else if (part != GizmoPart::Free)
            motion[k - 3] = 0;
        else
            motion = 0.2 * glm::dvec3(stage.view.map.world_from_view[0]);
        const glm::dvec3 hand =
            gizmo->origin +
            (part <= GizmoPart::Z ? 0.8 * gizmo->length * gizmo->axes[std::size_t(k)] : glm::dvec3(0));
        const ObjectDrag drag{start, *gizmo, GizmoMode::Move, part, stage.pixel(hand)};
        const Transform after = dragged_object(drag, stage.view, stage.pixel(hand + motion), false);
        // The cursor kept its distance from the origin on the screen: along an axis the depth differs
        // slightly.
        CHECK(glm::length(glm::dvec3(after.translate - start.translate) - motion) <
              (part <= GizmoPart::Z ? 0.05 : 1e-4));
        CHECK(after.rotate_deg == start.rotate_deg);
        CHECK(after.scale == start.scale);
        const Transform snapped = dragged_object(drag, stage.view, stage.pixel(hand + motion), true);
        for (int i = 0; i < 3; ++i)
            if (snapped.translate[i] != start.translate[i])
                CHECK(snapped.translate[i] / 0.25f == Approx(std::round(snapped.translate[i] / 0.25f)));
    }
}

TEST_CASE("an object dragged by a ring turns about its axis by the cursor's angle", "[ui][hands]") {
    const LightStage stage;
    const Transform start = busy_transform();
    const auto gizmo = gizmo_of(start, GizmoMode::Rotate, stage.picture);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 axis = gizmo->axes[k], u = gizmo->axes[(k + 1) % 3], v = gizmo->axes[(k + 2) % 3];
        const auto on_ring = [&](double a) {
            return gizmo->origin + gizmo->length * (std::cos(a) * u + std::sin(a) * v);
        };
        const ObjectDrag drag{start, *gizmo, GizmoMode::Rotate, static_cast<GizmoPart>(k),
                              stage.pixel(on_ring(0.3))};
        const Transform after = dragged_object(drag, stage.view, stage.pixel(on_ring(0.3 + 0.6)), false);
        glm::dmat3 turn(1);
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        turn[int(i)][int(i)] = turn[int(j)][int(j)] = std::cos(0.6);
        turn[int(i)][int(j)] = std::sin(0.6), turn[int(j)][int(i)] = -std::sin(0.6);
        CHECK(largest_difference(rotation(after.rotate_deg), turn * rotation(start.rotate_deg)) < 0.01);
        CHECK(after.translate == start.translate);
        CHECK(after.scale == start.scale);
        CHECK(axis[int(k)] == 1);
    }
}

TEST_CASE("an object turned about a point keeps that point in place", "[ui][hands]") {
    const LightStage stage;
    const Transform start = busy_transform();
    const glm::dvec3 pivot(0.6, 0.1, 0.2);
    const glm::dvec4 in_object = glm::inverse(glm::dmat4(world_from_object(start))) * glm::dvec4(pivot, 1);
    const auto gizmo = gizmo_of(start, GizmoMode::Rotate, stage.picture, {.pivot = pivot});
    REQUIRE(gizmo);
    CHECK(gizmo->origin == pivot);
    CHECK(gizmo_of(start, GizmoMode::Move, stage.picture, {.pivot = pivot})->origin ==
          glm::dvec3(start.translate));
    for (const GizmoPart part : {GizmoPart::X, GizmoPart::Y, GizmoPart::Z, GizmoPart::Free}) {
        const glm::dvec2 at = stage.pixel(pivot) + glm::dvec2(60, 20);
        const ObjectDrag drag{start, *gizmo, GizmoMode::Rotate, part, at};
        const Transform after = dragged_object(drag, stage.view, at + glm::dvec2(-30, 50), false);
        CHECK(largest_difference(rotation(after.rotate_deg), rotation(start.rotate_deg)) > 0.1);
        CHECK(glm::length(after.translate - start.translate) > 0.05f);
        const glm::dvec4 there = glm::dmat4(world_from_object(after)) * in_object;
        CHECK(glm::length(glm::dvec3(there) - pivot) < 2e-5);  // angles are rounded to 0.001 degrees
    }
}

TEST_CASE("angles of a rotation reproduce it and stay near the previous ones", "[ui][hands][property]") {
    std::mt19937 random(5);
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 deg = test::uniform_vec3(random, -400, 400);
        const glm::vec3 found = euler_deg(rotation(deg), deg);
        CHECK(glm::length(found - deg) < 0.05f);
        const glm::vec3 other = euler_deg(rotation(deg), {0, 0, 0});
        CHECK(largest_difference(rotation(other), rotation(deg)) < 1e-4);
    }
    for (const float y : {90.0f, -90.0f})
        CHECK(largest_difference(rotation(euler_deg(rotation({25, y, 40}), {10, 0, 0})),
                                 rotation({25, y, 40})) < 1e-4);
}

TEST_CASE("an object scaled by dragging never gets a scale of 0 and keeps its mirroring", "[ui][hands]") {
    const LightStage stage;
    Transform start = busy_transform();
    start.scale.x = -1;
    const auto gizmo = gizmo_of(start, GizmoMode::Scale, stage.picture);
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 axis = gizmo->axes[std::size_t(k)];
        CHECK(glm::length(axis - rotation(start.rotate_deg)[k]) < 1e-6);
        const glm::dvec2 from = stage.pixel(gizmo->origin + gizmo->length * axis);
        const ObjectDrag drag{start, *gizmo, GizmoMode::Scale, static_cast<GizmoPart>(k), from};
        const Transform twice =
            dragged_object(drag, stage.view, stage.pixel(gizmo->origin + 2 * gizmo->length * axis), false);
        CHECK(twice.scale[k] == Approx(2 * start.scale[k]).epsilon(0.05));
        const Transform none =
            dragged_object(drag, stage.view, stage.pixel(gizmo->origin - gizmo->length * axis), false);
        CHECK(none.scale[k] * start.scale[k] > 0);
    }
    const ObjectDrag whole{start, *gizmo, GizmoMode::Scale, GizmoPart::Free, {500, 350}};
    const Transform after = dragged_object(whole, stage.view, {560, 330}, false);
    CHECK(after.scale.x / start.scale.x == Approx(after.scale.z / start.scale.z));
    CHECK(after.scale.z > start.scale.z);
}
