// The plots: each marked point agrees with the explanation and is on its curve.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/trigonometric.hpp>

#include "renderer/reflectance/highlight.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/person.h"
#include "tests/support/scenes.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/plots/plot.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// The busy scene at a pixel lit by its sun, its bulb and its spot.
Explanation lit_pixel(Renderer& renderer, const Scene& scene) {
    renderer.render(scene, {120, 90});
    for (int y = 20; y < 80; ++y)
        for (int x = 10; x < 110; ++x) {
            Explanation e = renderer.explain(x, y);
            if (!e.hit || e.at.lights.size() < 4) continue;
            bool all = true;
            for (int i = 0; i < 3; ++i) {
                const ExplainedLight& light = e.at.lights[static_cast<std::size_t>(i)];
                all = all && light.n_dot_l > 0.1f && light.spot > 0.05f;
            }
            if (all) return e;
        }
    FAIL("no pixel is reached by all three lights");
    return {};
}

Scene scene_for_plots() {
    Scene scene = test::busy_scene();
    scene.lights[2].spot.cutoff_deg = 60;
    scene.objects[0].material.shininess = 6;
    return scene;
}

}  // namespace

TEST_CASE("plots: the point marked for the falloff is exactly on the falloff curve", "[ui][plots]") {
    const Scene scene = scene_for_plots();
    Renderer renderer(1);
    const std::optional<Explanation> why = lit_pixel(renderer, scene);
    const PlotPoint point = plot_point(why, 1);
    REQUIRE(point.light != nullptr);
    const glm::dvec2 mark = falloff_mark(point);
    CHECK(mark.y < 0.9);
    CHECK(falloff_curve(scene, 1, mark.x, 1).back().y == mark.y);
    CHECK(falloff_curve(scene, 0, 5, 4).empty());
    CHECK(falloff_curve(scene, 3, 5, 4).empty());
}

TEST_CASE("plots: the point marked for the cone is on its curve, which ends at the cutoff", "[ui][plots]") {
    const Scene scene = scene_for_plots();
    Renderer renderer(1);
    const std::optional<Explanation> why = lit_pixel(renderer, scene);
    const glm::dvec2 mark = spot_mark(plot_point(why, 2));
    const auto curve = spot_curve(scene, 2, 180);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        if (curve[i - 1].x > mark.x || curve[i].x < mark.x) continue;
        const double share = (mark.x - curve[i - 1].x) / (curve[i].x - curve[i - 1].x);
        CHECK(mark.y == Approx(glm::mix(curve[i - 1].y, curve[i].y, share)).margin(1e-3));
    }
    for (const glm::dvec2 p : curve) {
        INFO(p.x << " degrees");
        CHECK((p.y > 0) == (std::abs(p.x) <= 60));
        if (std::abs(p.x) < 59) CHECK(p.y == Approx(std::pow(std::cos(glm::radians(p.x)), 4)).margin(1e-4));
    }
}

TEST_CASE("plots: the point marked for the highlight is on the curve of its model", "[ui][plots]") {
    Scene scene = scene_for_plots();
    for (const Reflection reflection : {Reflection::Phong, Reflection::BlinnPhong}) {
        scene.shading.reflection = reflection;
        Renderer renderer(1);
        const std::optional<Explanation> why = lit_pixel(renderer, scene);
        const glm::dvec2 mark = highlight_mark(plot_point(why, 0), reflection);
        const bool blinn = reflection == Reflection::BlinnPhong;
        const double cosine = std::cos(glm::radians(blinn ? mark.x / 2 : mark.x));
        CHECK(mark.y == Approx(std::pow(std::max(cosine, 0.0), why->material.shininess)).margin(1e-5));
        const auto curve = highlight_curve(reflection, why->material.shininess, 180);
        const auto near = static_cast<std::size_t>(std::lround(std::min(mark.x, 90.0) + 90));
        if (mark.x < 90) CHECK(curve[near].y == Approx(mark.y).margin(0.05));
    }
}

TEST_CASE("plots: the lobe's values for a light match the explanation", "[ui][plots]") {
    Scene scene = scene_for_plots();
    for (const Reflection reflection : {Reflection::Lambert, Reflection::Phong, Reflection::BlinnPhong,
                                        Reflection::Retro, Reflection::OrenNayar, Reflection::CookTorrance}) {
        scene.shading.reflection = reflection;
        Renderer renderer(1);
        const std::optional<Explanation> why = lit_pixel(renderer, scene);
        for (const int light : {0, 1, 2}) {
            const PlotPoint point = plot_point(why, light);
            const LocalDirections local = local_directions(point);
            CHECK(std::cos(glm::radians(local.light_deg)) == Approx(point.light->n_dot_l).margin(1e-5));
            const Reflected r = reflected({reflection, why->material, {}}, local.l, local.v);
            const glm::vec3 diffuse = point.light->diffuse_factor * why->material.diffuse;
            const glm::vec3 specular = point.light->specular_factor * why->material.specular;
            for (int c = 0; c < 3; ++c) {
                CHECK(r.diffuse[c] == Approx(diffuse[c]).margin(1e-4));
                CHECK(r.specular[c] == Approx(specular[c]).margin(1e-3));
            }
        }
    }
}

TEST_CASE("plots: the Blinn shininess closest to Phong's is about four times as large", "[plots]") {
    CHECK(blinn_shininess_like(32) == Approx(4 * 32).epsilon(0.03));
    CHECK(blinn_shininess_like(200) == Approx(4 * 200).epsilon(0.02));
    const double like = blinn_shininess_like(10);
    const auto misfit = [](double n) {
        double sum = 0;
        for (int deg = 0; deg <= 90; ++deg) {
            const double a = glm::radians(double(deg));
            sum += std::pow(std::pow(std::cos(a), 10) - std::pow(std::cos(a / 2), n), 2);
        }
        return sum;
    };
    CHECK(misfit(like) < misfit(like * 1.02));
    CHECK(misfit(like) < misfit(like / 1.02));
}

TEST_CASE("plots: fitting a curve drawn from a known power finds that power", "[plots][lecture]") {
    for (const double n : {0.0, 0.7, 5.0, 32.0, 400.0}) {
        HighlightSketch sketch;
        // As if by hand: from right to left, a few degrees at a time.
        const auto value = [n](double deg) { return std::pow(std::cos(glm::radians(deg)), n); };
        for (int deg = 88; deg > 0; deg -= 2)
            add_to_sketch(sketch, {deg, value(deg)}, {deg - 2, value(deg - 2)});
        const auto points = points_of(sketch);
        CHECK(points.size() == 89);
        const auto fit = fitted_highlight(Reflection::Phong, points);
        REQUIRE(fit);
        CHECK(fit->shininess == Approx(n).epsilon(0.02).margin(0.01));
        CHECK(fit->error < 0.02);
    }
    CHECK_FALSE(fitted_highlight(Reflection::Phong, {}));
    CHECK(points_of({}).empty());
}

TEST_CASE("plots: the bell, line and power curves reach half height at the same angle", "[plots][lecture]") {
    CHECK(half_angle_deg(1) == Approx(60));
    CHECK(half_angle_deg(0) == 90);
    for (const double n : {2.0, 20.0, 200.0}) {
        const double half = half_angle_deg(n);
        CHECK(std::pow(std::cos(glm::radians(half)), n) == Approx(0.5));
        for (const HighlightShape shape : {HighlightShape::Gaussian, HighlightShape::Linear}) {
            const auto curve = highlight_shape(shape, n, 9000);
            CHECK(curve.front().y == 1);
            CHECK(curve[static_cast<std::size_t>(std::lround(half * 100))].y == Approx(0.5).margin(2e-3));
            const double twice =
                curve[static_cast<std::size_t>(std::lround(std::min(2 * half, 90.0) * 100))].y;
            if (2 * half <= 90)
                CHECK(twice == Approx(shape == HighlightShape::Gaussian ? 1.0 / 16 : 0.0).margin(2e-3));
        }
    }
}

TEST_CASE("plots: under Gouraud shading the corner with the largest weight is marked", "[ui][plots]") {
    Scene scene = scene_for_plots();
    scene.shading.mode = ShadingMode::Gouraud;
    Renderer renderer(1);
    renderer.render(scene, {120, 90});
    std::optional<Explanation> why = renderer.explain(45, 45);
    REQUIRE(why->hit);
    const PlotPoint point = plot_point(why, 0);
    for (const ExplainedCorner& corner : why->corners) {
        if (&corner.at == point.at) continue;
        float marked = 0;
        for (const ExplainedCorner& c : why->corners)
            if (&c.at == point.at) marked = c.weight;
        CHECK(corner.weight <= marked);
    }
}

TEST_CASE("plots: the curves are those of the selected light", "[ui][window][plots]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Plots, {0.5, 0.5});
    bench.state.editor.selection = {Selection::Kind::Light, 1};
    CHECK(plotted_light(bench.state) == 1);
    bench.state.editor.selection = {Selection::Kind::Light, 0};
    CHECK(plotted_light(bench.state) == 0);
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    const ExplainedLight* brightest = asked_light(bench.state, bench.state.on_screen.explanation->at);
    REQUIRE(brightest != nullptr);
    CHECK(plotted_light(bench.state) == brightest->index);
    bench.state.viewport.probe.reset();
    bench.frames(2);
    CHECK(plotted_light(bench.state) == 0);
}

TEST_CASE("plots: inverse square agrees at the marked point, twice as far it is a quarter", "[ui][plots]") {
    const Scene scene = scene_for_plots();
    Renderer renderer(1);
    const std::optional<Explanation> why = lit_pixel(renderer, scene);
    const PlotPoint point = plot_point(why, 1);
    const glm::dvec2 mark = falloff_mark(point);
    const auto law = inverse_square({{0, 1}, mark, {2 * mark.x, 0}}, point);
    REQUIRE(law.size() == 2);
    CHECK(law[0].y == Approx(mark.y));
    CHECK(law[1].y == Approx(mark.y / 4));
    CHECK(inverse_square({{2, 0}}, {})[0].y == Approx(0.25));
}

TEST_CASE("plots: the tab can be drawn for every shipped scene and without lights", "[ui][window][plots]") {
    namespace fs = std::filesystem;
    HeadlessWindow bench({1024, 640});
    for (const auto& entry : fs::directory_iterator(fs::path(project_folder) / "assets" / "scenes")) {
        if (entry.path().extension() != ".json") continue;
        INFO(entry.path());
        const Result<SceneDocument> opened = open_document(entry.path().string());
        REQUIRE(problem_of(opened) == nullptr);
        take_document(bench.state.editor, std::get<SceneDocument>(opened));
        bench.state.left_shows_inspector = true;
        test::ask(bench, InspectorTab::Plots);
        for (int light = 0; light < int(bench.scene().lights.size()); ++light) {
            bench.state.editor.selection = {Selection::Kind::Light, light};
            bench.frames(1);
        }
    }
    bench.scene().lights.clear();
    bench.frames(2);
    CHECK(bench.state.get<InspectorState>().tab == InspectorTab::Plots);
}

TEST_CASE("plots: the BRDF's slice matches Phong's closed form, forwards and backwards", "[ui][plots]") {
    Material material;
    material.diffuse = glm::vec3(0.5f);
    material.specular = glm::vec3(0.3f);
    material.shininess = 10;
    const double light_deg = 30, pi = 3.14159265358979;
    const BrdfCurves curves = brdf_curves({Reflection::Phong, material, {}}, light_deg);
    REQUIRE(curves.forwards.size() == curves.backwards.size());
    int compared = 0;
    for (std::size_t i = 0; i < curves.forwards.size(); ++i) {
        const double v = curves.forwards[i].x;
        if (std::abs(v) > 89) continue;
        const double lobe = 0.3 * std::pow(std::max(std::cos(glm::radians(v - light_deg)), 0.0), 10);
        // (k_d n.l + k_s (r.v)^n) / (pi n.l); backwards, the light is at v.
        CHECK(curves.forwards[i].y ==
              Approx((0.5 + lobe / std::cos(glm::radians(light_deg))) / pi).epsilon(1e-4));
        CHECK(curves.backwards[i].y == Approx((0.5 + lobe / std::cos(glm::radians(v))) / pi).epsilon(1e-4));
        ++compared;
    }
    CHECK(compared > 150);
}

TEST_CASE("plots: a light tried as a different kind stays put, and a spot aims at the point", "[ui][plots]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Plots, {0.5, 0.5});
    REQUIRE(bench.state.on_screen.explanation);
    const ScreenMap map = screen_map(bench.scene().camera, bench.state.rendered->size);
    PictureView view;
    view.map = map;
    view.dome = sun_dome(bench.scene().camera.target, scene_bounds(bench.scene()), map);
    const Light& bulb = bench.scene().lights[1];
    const glm::dvec3 place = handle_of(bulb, view.dome, map);
    const ExplainedPoint& at = bench.state.on_screen.explanation->at;
    CHECK(of_kind_at(bulb, LightKind::Point, at, view) == bulb);
    for (const LightKind kind : {LightKind::Spot, LightKind::Area}) {
        const Light other = of_kind_at(bulb, kind, at, view);
        CHECK(other.kind == kind);
        CHECK(glm::length(handle_of(other, view.dome, map) - place) < 1e-4);
    }
    const Light lamp = of_kind_at(bulb, LightKind::Spot, at, view);
    const glm::dvec3 way = glm::normalize(glm::dvec3(at.point.world) - place);
    CHECK(glm::dot(to_world(lamp, lamp.spot.direction, 0, map), way) == Approx(1).margin(1e-5));
}

TEST_CASE("plots: each section shows the numbers of the picked point", "[ui][window][plots]") {
    test::Person student({1280, 2600});
    student.scene().shading.reflection = Reflection::Phong;
    test::ask(student, InspectorTab::Plots);
    for (const char* section :
         {"Lambert's cosine: a slanting beam spreads", "The lobe at the picked point",
          "Intensity by direction, light at 60°, 25° and 0°", "What each kind of light depends on",
          "Draw your own highlight", "The BRDF f_r(l, v), a slice",
          "Microfacets: a rough surface is many mirrors"})
        student.clicks(section);
    const Explanation& e = *student.state.on_screen.explanation;
    const ExplainedLight& light = *asked_light(student.state, e.at);
    CHECK(student.sees(fmt::format("= {:.2f} d", 1 / light.n_dot_l)));  // a slanting beam covers more
    const glm::vec3 sent =
        light.diffuse_factor * e.material.diffuse + light.specular_factor * e.material.specular;
    CHECK(student.sees(fmt::format("{:.3f} of the light's intensity", intensity_of(sent))));
    student.waits_until([&] { return student.sees("Not reciprocal"); });  // Phong's highlight, divided by n·l
    CHECK(student.sees("Directional none specular* both"));  // what the light, the viewer, a turn change
    student.scene().shading.reflection = Reflection::Lambert;
    student.waits_until([&] { return student.sees("reciprocal (Helmholtz)"); });
    CHECK(student.sees("Directional none none diffuse"));
}

TEST_CASE("plots: a highlight drawn with the mouse gives the object the power that fits it",
          "[ui][window][plots]") {
    test::Person student({1280, 2600});
    student.scene().shading.reflection = Reflection::Phong;
    test::ask(student, InspectorTab::Plots);
    student.clicks("Draw your own highlight");
    const Rect area = student.area_of("Sketch");
    for (int deg = 0; deg <= 90; deg += 3) {
        const double value = std::pow(std::cos(glm::radians(double(deg))), 20);
        student.move(area.low +
                     ImVec2(area.size().x * float(deg) / 90, area.size().y * float(1 - value / 1.1)));
        student.button(true);
    }
    student.button(false);
    student.frames(2);
    const auto object = std::size_t(student.state.on_screen.explanation->object_index);
    student.clicks("Use this n");
    CHECK(student.scene().objects[object].material.shininess == Approx(20).epsilon(0.05));
}
