#include "tests/golden/sheet.h"

#include <algorithm>
#include <array>
#include <memory>

#include "models/scene/scene.h"
#include "renderer/renderer.h"

namespace glint::golden {
namespace {

constexpr std::array modes{ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Gouraud, ShadingMode::Phong};
constexpr std::array reflections{Reflection::None,        Reflection::Lambert, Reflection::Phong,
                                 Reflection::BlinnPhong,  Reflection::Retro,   Reflection::OrenNayar,
                                 Reflection::CookTorrance};

std::vector<Light> one_of_each_kind() {
    Light sun, bulb, lamp, window;
    sun.kind = LightKind::Directional;
    sun.position = {-1, 2, 2, 0};
    sun.diffuse = sun.specular = {0.5f, 0.45f, 0.4f};
    bulb.space = LightSpace::Camera;
    bulb.position = {0.5f, 0.4f, 0, 1};  // near the eye, where retro-reflection is visible
    bulb.diffuse = bulb.specular = {0.3f, 0.5f, 0.9f};
    bulb.falloff = {1, 0.1f, 0.05f};
    lamp.kind = LightKind::Spot;
    lamp.position = {-0.5f, 3, 1.5f, 1};
    lamp.diffuse = {0.7f, 0.4f, 0.1f};
    lamp.spot = {{0.2f, -1, -0.4f}, 16, 4};
    window.kind = LightKind::Area;
    window.position = {-2.5f, 0, 1, 1};
    window.diffuse = {0.2f, 0.8f, 0.5f};
    window.area = {{0, 0.6f, 0}, {0.3f, 0, 0.5f}, 4};
    return {sun, bulb, lamp, window};
}

Scene scene_of(const Subject& subject) {
    Scene scene;
    scene.camera.eye = {1.2f, 1.6f, 4.6f};
    scene.camera.projection = Perspective{30, 0.1f, 100};
    scene.lights = one_of_each_kind();
    Object object;
    object.source = PrimitiveMesh{subject.primitive, subject.detail};
    object.mesh = std::make_shared<const Mesh>(make_primitive(subject.primitive, subject.detail));
    object.transform = subject.transform;
    object.material.diffuse = {0.75f, 0.6f, 0.5f};
    object.material.specular = glm::vec3(0.6f);
    object.material.shininess = 24;
    object.material.roughness = 0.4f;
    object.material.f0 = {0.5f, 0.4f, 0.3f};
    scene.objects.push_back(object);
    return scene;
}

Picture empty_sheet(std::size_t columns, std::size_t rows) {
    Picture sheet;
    sheet.size = {cell.width * static_cast<int>(columns), cell.height * static_cast<int>(rows)};
    sheet.rgba.resize(4 * sheet.size.pixels());
    return sheet;
}

void paste(const Picture& from, Picture& into, std::size_t column, std::size_t row) {
    const int left = cell.width * static_cast<int>(column), top = cell.height * static_cast<int>(row);
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(from.size.width);
    for (int y = 0; y < from.size.height; ++y)
        std::copy_n(&from.rgba[4 * from.pixel(0, y)], row_bytes, &into.rgba[4 * into.pixel(left, top + y)]);
}

}  // namespace

std::span<const Subject> subjects() {
    static const std::array<Subject, 6> all{{
        {"sphere", Primitive::Sphere, 12, {}},
        {"teapot", Primitive::Teapot, 3, {{-0.1f, 0, 0}, {0, -25, 0}, {0.5f, 0.5f, 0.5f}}},
        {"cube", Primitive::Cube, 2, {{}, {10, 20, 0}, {0.72f, 0.72f, 0.72f}}},
        {"torus", Primitive::Torus, 12, {{}, {50, 0, 15}, {0.85f, 0.85f, 0.85f}}},
        {"knot", Primitive::Knot, 64, {{}, {20, 10, 0}, {0.75f, 0.75f, 0.75f}}},
        {"skew-quad", Primitive::SkewQuad, 1, {{}, {-10, 15, 5}, {0.4f, 0.4f, 0.4f}}},
    }};
    return all;
}

Picture make_sheet(const Subject& subject) {
    Scene scene = scene_of(subject);
    Renderer renderer(1);
    Picture sheet = empty_sheet(reflections.size(), modes.size());
    for (std::size_t row = 0; row < modes.size(); ++row)
        for (std::size_t column = 0; column < reflections.size(); ++column) {
            scene.shading.mode = modes[row];
            scene.shading.reflection = reflections[column];
            paste(renderer.render(scene, cell), sheet, column, row);
        }
    return sheet;
}

Picture make_drawn_sheet() {
    Picture sheet = empty_sheet(subjects().size(), 4);
    for (std::size_t column = 0; column < subjects().size(); ++column) {
        Scene scene = scene_of(subjects()[column]);
        scene.display.background = {0.8f, 0.8f, 0.75f};
        Renderer renderer(1);
        for (std::size_t row = 0; row < 4; ++row) {
            scene.npr.cool_to_warm = row == 0 || row == 3;
            scene.npr.silhouettes = row == 1 || row == 3;
            scene.npr.creases = row == 2 || row == 3;
            paste(renderer.render(scene, cell), sheet, column, row);
        }
    }
    return sheet;
}

}  // namespace glint::golden
