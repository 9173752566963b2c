#pragma once
// Small scenes for tests.

#include <bit>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "models/scene/scene.h"
#include "tests/support/mesh_helpers.h"

namespace glint::test {

/// Stricter than ==: 0 is not -0.
inline bool same_bits(glm::vec3 a, glm::vec3 b) {
    const auto bits = [](float f) { return std::bit_cast<std::uint32_t>(f); };
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

/// A mesh of polygons, given by indices into positions.
inline MeshPtr polygon_mesh(std::vector<glm::vec3> positions,
                            const std::vector<std::vector<std::uint32_t>>& faces) {
    return std::make_shared<const Mesh>(make_mesh(std::move(positions), faces));
}

inline MeshPtr primitive(Primitive kind, int detail) {
    return std::make_shared<const Mesh>(make_primitive(kind, detail));
}

inline Object object_of(MeshPtr mesh, const char* name = "Object") {
    Object o;
    o.name = name;
    o.mesh = std::move(mesh);
    return o;
}

/// Uniform in [low, high), from the generator's bits, because std:: distributions differ between libraries.
inline float uniform(std::mt19937& random, float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24f;
}
inline glm::vec3 uniform_vec3(std::mt19937& random, float low, float high) {
    const float x = uniform(random, low, high), y = uniform(random, low, high);
    return {x, y, uniform(random, low, high)};
}

/// One light of each kind, two of them in camera coordinates.
inline std::vector<Light> assorted_lights() {
    Light sun, bulb, lamp, window;
    sun.name = "Sun";
    sun.kind = LightKind::Directional;
    sun.position = {1, 2, 1, 0};
    sun.intensity = 0.4f;
    bulb.name = "Bulb";
    bulb.space = LightSpace::Camera;
    bulb.position = {-1, 1, 0, 1};
    bulb.falloff = {1, 0.1f, 0.05f};
    bulb.ambient = {0.05f, 0.02f, 0};
    bulb.diffuse = {0.9f, 0.5f, 0.2f};
    lamp.name = "Lamp";
    lamp.kind = LightKind::Spot;
    lamp.position = {0, 3, 1, 1};
    lamp.spot = {{0, -1, -0.3f}, 35, 4};
    lamp.diffuse = {0.2f, 0.4f, 1};
    window.name = "Window";
    window.kind = LightKind::Area;
    window.position = {-2, 1, 1, 1};
    window.area.edge_v = {0, 0.5f, 0};
    window.area.samples = 4;
    return {sun, bulb, lamp, window};
}

/// Two objects, one with a non-uniform and mirrored transform, under assorted lights.
inline Scene busy_scene() {
    Scene scene;
    scene.camera.eye = {1, 1.5f, 4};
    scene.lights = assorted_lights();
    Object ball = object_of(primitive(Primitive::Sphere, 12), "Ball");
    ball.transform.translate = {-0.7f, 0, 0};
    ball.material.diffuse = {0.8f, 0.3f, 0.3f};
    Object box = object_of(primitive(Primitive::Cube, 2), "Box");
    box.transform = {{0.9f, -0.1f, 0.3f}, {20, 35, 10}, {-0.6f, 0.8f, 0.5f}};
    box.material.emission = {0.02f, 0, 0.05f};
    box.material.shininess = 12;
    scene.objects = {ball, box};
    return scene;
}

}  // namespace glint::test
