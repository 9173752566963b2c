// Dragging lights, checked by projecting the handle before and after the drag.
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/catch.h"
#include "ui/picture/handles/light_handles.h"

using namespace glint;

namespace {

const PictureSize drag_picture{1000, 700};

struct Case {
    Camera camera;
    DragView view;
    Case(glm::vec3 eye, Projection projection, glm::vec3 centre = glm::vec3(0))
        : camera{centre + eye, centre, {0, 1, 0}, projection} {
        view.map = screen_map(camera, drag_picture);
        view.dome = sun_dome(centre, {centre - 1.0f, centre + 1.0f}, view.map);
    }
    [[nodiscard]] ProjectedPoint handle(const Light& light) const {
        return project(view.map, handle_of(light, view.dome, view.map));
    }
};

std::vector<Case> cases() {
    return {{{0, 0, 6}, Perspective{45, 0.1f, 100}},
            {{3, 4, -2}, Perspective{30, 0.1f, 100}, {1, -0.5f, 0.5f}},
            {{-4, 1, 3}, Orthographic{6, 0.1f, 100}}};
}

/// A light at a position in the world, expressed in `space`.
Light light_at(const Case& c, LightKind kind, LightSpace space, glm::vec3 place) {
    Light light;
    light.kind = kind;
    light.position = {place, kind == LightKind::Directional ? 0 : 1};
    return in_space(light, space, c.camera);
}

std::vector<Light> lights(const Case& c) {
    std::vector<Light> all;
    for (const auto kind : {LightKind::Point, LightKind::Spot, LightKind::Area, LightKind::Directional})
        for (const auto space : {LightSpace::World, LightSpace::Camera})
            all.push_back(light_at(c, kind, space, {0.4f, 1.1f, 0.7f}));
    return all;
}

}  // namespace

TEST_CASE("a dragged handle keeps its offset from the cursor to within half a pixel", "[ui][property]") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(300, 700), y(200, 500), grip(-8, 8);
    for (const Case& c : cases())
        for (const Light& light : lights(c))
            for (int i = 0; i < 50; ++i) {
                const glm::dvec2 offset{grip(random), grip(random)}, to{x(random), y(random)};
                const glm::dvec2 grabbed = c.handle(light).pixel + offset;
                const Light after =
                    dragged({light, DragAlong::ViewPlane, grabbed}, c.view, to + offset, false);
                CHECK(glm::length(c.handle(after).pixel - to) < 0.5);
                if (light.kind != LightKind::Directional)
                    CHECK(c.handle(after).depth == Approx(c.handle(light).depth));
            }
}

TEST_CASE("a drag of length zero changes nothing beyond rounding", "[ui]") {
    for (const Case& c : cases())
        for (const Light& light : lights(c))
            for (const auto along : {DragAlong::ViewPlane, DragAlong::Depth, DragAlong::X, DragAlong::Z}) {
                const glm::dvec2 at = c.handle(light).pixel;
                const Light after = dragged({light, along, at}, c.view, at, false);
                const glm::dvec3 moved = handle_of(after, c.view.dome, c.view.map);
                CHECK(glm::length(moved - handle_of(light, c.view.dome, c.view.map)) < 1e-4);
            }
}

TEST_CASE("a drag in depth keeps the handle at its pixel, dragging up moves the light away", "[ui]") {
    for (const Case& c : cases())
        for (const Light& light : lights(c)) {
            if (light.kind == LightKind::Directional) continue;
            const ProjectedPoint at = c.handle(light);
            const Light after = dragged({light, DragAlong::Depth, {500, 350}}, c.view, {520, 300}, false);
            CHECK(glm::length(c.handle(after).pixel - at.pixel) < 0.5);
            CHECK(c.handle(after).depth > at.depth * 1.1);
        }
}

TEST_CASE("an axis drag changes one coordinate, to the point nearest to the cursor", "[ui][property]") {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> x(350, 650), y(250, 450);
    const Case c = cases()[1];
    const Light light = light_at(c, LightKind::Point, LightSpace::World, {0.4f, 1.1f, 0.7f});
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 50; ++i) {
            const auto along = static_cast<DragAlong>(static_cast<int>(DragAlong::X) + axis);
            const glm::dvec2 to{x(random), y(random)};
            const Light after = dragged({light, along, c.handle(light).pixel}, c.view, to, false);
            const double reached = glm::length(c.handle(after).pixel - to);
            for (int k = 0; k < 3; ++k)
                if (k != axis) CHECK(after.position[k] == Approx(light.position[k]));
            for (const float step : {-0.1f, -0.01f, 0.01f, 0.1f}) {
                Light other = after;
                other.position[axis] += step;
                CHECK(glm::length(c.handle(other).pixel - to) > reached - 0.01);
            }
        }
}

TEST_CASE("a drag along an axis seen end on does not move the light", "[ui]") {
    const Case c = cases()[0];  // looks down -z
    const Light light = light_at(c, LightKind::Point, LightSpace::World, {0, 0, 1});
    CHECK(dragged({light, DragAlong::Z, {500, 350}}, c.view, {600, 200}, false).position == light.position);
}

TEST_CASE("a directional light turns about an axis and keeps its component along the axis", "[ui]") {
    const Case c = cases()[1];
    const Light light = light_at(c, LightKind::Directional, LightSpace::World, {0.6f, 0.5f, 0.4f});
    const glm::dvec2 at = c.handle(light).pixel;
    const Light after = dragged({light, DragAlong::Y, at}, c.view, at + glm::dvec2(40, 0), false);
    CHECK(after.position.y == Approx(direction_of(light, c.view.map).y));
    CHECK(glm::length(glm::dvec3(after.position) - direction_of(light, c.view.map)) > 0.05);
    CHECK(after.position.w == 0);
}

TEST_CASE("snapping rounds positions to the grid and directions to multiples of 15 degrees", "[ui]") {
    const Case c = cases()[0];
    const Light bulb = light_at(c, LightKind::Point, LightSpace::World, {0.4f, 1.1f, 0.7f});
    const Light after = dragged({bulb, DragAlong::ViewPlane, {500, 350}}, c.view, {571, 288}, true);
    CHECK(after.position.x / 0.25f == Approx(std::round(after.position.x / 0.25f)));
    CHECK(after.position.y / 0.25f == Approx(std::round(after.position.y / 0.25f)));
    CHECK(after.position.z == Approx(0.7f));
    const Light sun = light_at(c, LightKind::Directional, LightSpace::World, {0.2f, 0.9f, 0.4f});
    const Light turned = dragged({sun, DragAlong::ViewPlane, {500, 350}}, c.view, {540, 420}, true);
    const double height = std::asin(turned.position.y) * 180 / 3.14159265358979;
    CHECK(height / 15 == Approx(std::round(height / 15)).margin(1e-4));
}

TEST_CASE("the grid step is 1, 2 or 5 times a power of ten", "[ui]") {
    CHECK(snap_step_for({{-1, -1, -1}, {1, 1, 1}}) == Approx(0.2));         // diagonal 3.46
    CHECK(snap_step_for({{0, 0, 0}, {100, 0, 0}}) == Approx(5));            // 100 / 20
    CHECK(snap_step_for({{0, 0, 0}, {0.0004f, 0, 0}}) == Approx(0.00002));  // 0.0004 / 20
}

TEST_CASE("a light whose coordinate system is changed stays where it is", "[ui]") {
    for (const Case& c : cases())
        for (const Light& light : lights(c)) {
            const auto other = light.space == LightSpace::World ? LightSpace::Camera : LightSpace::World;
            const Light moved = in_space(light, other, c.camera);
            CHECK(glm::length(c.handle(moved).pixel - c.handle(light).pixel) < 0.01);
            const glm::dvec3 axis = to_world(light, light.spot.direction, 0, c.view.map);
            CHECK(glm::length(to_world(moved, moved.spot.direction, 0, c.view.map) - axis) < 1e-5);
            CHECK(moved.position.w == light.position.w);
        }
}

TEST_CASE("a world light stays when the camera turns, a camera light moves with it", "[ui]") {
    const Case front({0, 0, 6}, Perspective{}), side({6, 0, 0}, Perspective{});
    const Light world = light_at(front, LightKind::Point, LightSpace::World, {1, 2, 0.5f});
    const Light camera = in_space(world, LightSpace::Camera, front.camera);
    CHECK(glm::length(handle_of(world, side.view.dome, side.view.map) - glm::dvec3(1, 2, 0.5)) < 1e-6);
    CHECK(glm::length(side.handle(camera).pixel - front.handle(world).pixel) < 0.01);
}

TEST_CASE("a light changed to another kind and back shines from the same side", "[ui]") {
    const Case c = cases()[0];
    const Light bulb = light_at(c, LightKind::Point, LightSpace::World, {0.3f, 0.8f, -0.4f});
    const Light sun = as_kind(bulb, LightKind::Directional, c.view.dome, c.view.map);
    CHECK(sun.position.w == 0);
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.3, 0.8, -0.4));
    CHECK(glm::length(direction_of(sun, c.view.map) - towards) < 1e-6);
    const Light back = as_kind(sun, LightKind::Point, c.view.dome, c.view.map);
    CHECK(back.position.w == 1);
    CHECK(glm::length(glm::normalize(glm::dvec3(back.position)) - towards) < 1e-6);
}
