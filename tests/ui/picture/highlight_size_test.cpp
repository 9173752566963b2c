// A highlight is resized by its rim, where the factor is half its peak by the models' own formulas.
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/scenes.h"
#include "ui/picture/handles/highlight_drag.h"
#include "ui/picture/handles/light_handles.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

const PictureSize size{240, 180};

Scene glossy_ball(Reflection reflection, LightKind kind, LightSpace space) {
    Scene scene;
    scene.camera.eye = {0, 0.6f, 4};
    scene.shading.reflection = reflection;
    scene.objects = {test::object_of(test::primitive(Primitive::Sphere, 64), "Ball")};
    scene.objects[0].material.f0 = glm::vec3(0.3f);
    Light light;
    light.kind = kind;
    light.position = {1.2f, 1.6f, 2.4f, kind == LightKind::Directional ? 0.0f : 1.0f};
    light.spot = {-glm::vec3(light.position), 60, 0};
    scene.lights = {in_space(light, space, scene.camera)};
    return scene;
}

/// D G F / (4 n.v) of GGX, height-correlated Smith and Schlick, implemented independently.
double microfacets(glm::dvec3 n, glm::dvec3 l, glm::dvec3 v, double roughness, double f0) {
    const glm::dvec3 h = glm::normalize(l + v);
    const double a = std::max(roughness * roughness, 0.001), c = glm::dot(n, h);
    const double d = a * a / (std::acos(-1.0) * std::pow(c * c * (a * a - 1) + 1, 2));
    const auto lambda = [a](double x) { return (std::sqrt(1 + a * a * (1 / (x * x) - 1)) - 1) / 2; };
    const double g = 1 / (1 + lambda(glm::dot(n, l)) + lambda(glm::dot(n, v)));
    const double f = f0 + (1 - f0) * std::pow(1 - glm::dot(v, h), 5);
    return d * g * f / (4 * glm::dot(n, v));
}

/// The factor at the pixel, as a fraction of that in the mirror direction.
double share_by_hand(const Explanation& e, const Material& material) {
    const ExplainedLight& light = e.at.lights.at(0);
    const glm::dvec3 n(e.at.normal.camera), v(e.at.view.camera), l(light.l.camera);
    switch (e.reflection) {
    case Reflection::Phong:
        return std::pow(glm::dot(2 * glm::dot(n, l) * n - l, v), double(material.shininess));
    case Reflection::BlinnPhong:
        return std::pow(glm::dot(n, glm::normalize(l + v)), double(material.shininess));
    case Reflection::Retro:
        return std::pow(glm::dot(l, v), double(material.shininess));
    default:
        return microfacets(n, l, v, double(material.roughness), double(material.f0.x)) /
               microfacets(n, 2 * glm::dot(n, v) * n - v, v, double(material.roughness),
                           double(material.f0.x));
    }
}

}  // namespace

TEST_CASE("a highlight's rim under the cursor has half its peak, for every light kind",
          "[ui][hands][property]") {
    for (const Reflection reflection :
         {Reflection::Phong, Reflection::BlinnPhong, Reflection::Retro, Reflection::CookTorrance})
        for (const LightKind kind : {LightKind::Directional, LightKind::Point, LightKind::Spot})
            for (const LightSpace space : {LightSpace::World, LightSpace::Camera}) {
                CAPTURE(static_cast<int>(reflection), static_cast<int>(kind), static_cast<int>(space));
                Scene scene = glossy_ball(reflection, kind, space);
                Renderer renderer(1);
                (void)renderer.render(scene, size);
                const ScreenMap map = screen_map(scene.camera, size);
                const Dome dome = sun_dome(scene.camera.target, scene_bounds(scene), map);
                const SizeDrag drag{scene.lights[0], 0, scene.objects[0].material};
                int sized = 0;
                for (int y = 5; y < size.height; y += 9)
                    for (int x = 5; x < size.width; x += 9) {
                        const Explanation e = renderer.explain(x, y);
                        const auto material =
                            sized_highlight(drag, {scene, renderer, map, dome}, {x + 0.5, y + 0.5});
                        if (!e.hit) CHECK_FALSE(material);
                        if (!material) continue;
                        const bool at_end = material->shininess > 9000 || material->shininess < 0.11f ||
                                            material->roughness < 0.021f || material->roughness > 0.99f;
                        if (at_end) continue;
                        ++sized;
                        CHECK(share_by_hand(e, *material) == Approx(0.5).margin(2e-3));
                    }
                CHECK(sized > 20);
            }
}

TEST_CASE("a highlight can be grabbed where it is bright, whether by intensity or by colour", "[ui][hands]") {
    Scene scene = glossy_ball(Reflection::Phong, LightKind::Point, LightSpace::World);
    Renderer renderer(1);
    (void)renderer.render(scene, size);
    const ScreenMap map = screen_map(scene.camera, size);
    const Dome dome = sun_dome(scene.camera.target, scene_bounds(scene), map);
    const auto grabbed_pixels = [&](float intensity, float colour) {
        scene.lights[0].intensity = intensity;
        scene.lights[0].specular = glm::vec3(colour);
        int count = 0;
        for (int y = 0; y < size.height; y += 3)
            for (int x = 0; x < size.width; x += 3) {
                const SurfaceView view{scene, renderer, map, dome};
                count += highlight_under(view, {x + 0.5, y + 0.5}) ? 1 : 0;
                count += highlight_rim_under(view, {x + 0.5, y + 0.5}, 2) ? 1'000 : 0;
            }
        return count;
    };
    const int bright = grabbed_pixels(1, 1);
    CHECK(bright > 1'000);
    CHECK(grabbed_pixels(4, 0.25f) == bright);
    CHECK(grabbed_pixels(0.25f, 4) == bright);
    CHECK(grabbed_pixels(0.01f, 1) == 0);
}

TEST_CASE("enlarging a highlight by its rim is one step, and Escape reverts it", "[ui][hands][window]") {
    HeadlessWindow bench;
    bench.scene().lights.resize(1);
    bench.scene().shading.reflection = Reflection::Phong;
    bench.scene().objects[0].material.shininess = 20;
    take_document(bench.state.editor, bench.state.editor.document);
    bench.frames(2);
    const Scene before = bench.scene();
    // From the peak to the left, until (r·v)^20 is one half.
    const PictureSize whole = bench.state.rendered->size;
    const auto cosine = [&](int x, int y) {
        const Explanation e = bench.state.renderer->explain(x, y);
        return e.hit ? double(e.at.lights.at(0).r_dot_v) : -1.0;
    };
    glm::ivec2 peak(0), rim;
    for (int y = 0; y < whole.height; y += 2)
        for (int x = 0; x < whole.width; x += 2)
            if (cosine(x, y) > cosine(peak.x, peak.y)) peak = {x, y};
    for (rim = peak; std::pow(cosine(rim.x, rim.y), 20) > 0.5;) --rim.x;
    const glm::dvec2 from = glm::dvec2(rim) + 0.5, to = from - glm::dvec2(25, 0);
    bench.move(bench.at_pixel(glm::dvec2(peak) + 0.5));
    CHECK(bench.state.viewport.hovered_grip.kind == GripKind::Highlight);
    bench.move(bench.at_pixel(from));
    CHECK(bench.state.viewport.hovered_grip == Grip{.kind = GripKind::HighlightRim, .item = 0});
    bench.drag(bench.at_pixel(from), bench.at_pixel(to));
    CHECK(bench.scene().lights == before.lights);
    const float shininess = bench.scene().objects[0].material.shininess;
    CHECK(double(shininess) == Approx(std::log(0.5) / std::log(cosine(rim.x - 25, rim.y))).epsilon(1e-3));
    CHECK(shininess < 20);
    CHECK(bench.state.editor.history.undo_name() == "Material of Ball");
    bench.key(Key::Z, true);
    CHECK(bench.scene() == before);
    bench.move(bench.at_pixel(from));
    bench.button(true);
    bench.move(bench.at_pixel(to));
    CHECK_FALSE(bench.scene() == before);
    bench.move(bench.at_pixel({3, 3}));
    CHECK(bench.state.viewport.held.no_solution);
    bench.key(Key::Escape);
    bench.button(false);
    CHECK(bench.scene() == before);
}
