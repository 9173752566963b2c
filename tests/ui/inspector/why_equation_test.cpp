// The equation's numbers are the ones that the lighting uses, and dragging them edits the scene.
#include <algorithm>
#include <glm/geometric.hpp>
#include <random>
#include <set>

#include "models/scene_file/scene_file.h"
#include "renderer/explain/equation_text.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/features/inspector/equation/text_line.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// The explanation of the picked pixel by a separate renderer.
Explanation asked_apart(HeadlessWindow& bench) {
    Renderer renderer(1);
    (void)renderer.render(bench.scene(), bench.state.rendered->size);
    return renderer.explain(bench.state.on_screen.explanation->x, bench.state.on_screen.explanation->y);
}

}  // namespace

TEST_CASE("a right click on a read-only number copies it or its line", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Equation, {0.4, 0.4});
    const Rect angle = bench.area_of("angle n·l", test::right_column(bench));
    const ImVec2 number{angle.high.x - 10, angle.middle().y};  // to the right of the letters
    const auto choose = [&](const char* item) {
        ImGui::SetClipboardText("nothing");
        bench.move(number);
        bench.button(true, 1);
        bench.button(false, 1);
        bench.frames(2);
        bench.click_on(item);
        return std::string(ImGui::GetClipboardText());
    };
    const Scene start = bench.scene();
    const float n_dot_l = bench.state.on_screen.explanation->at.lights.front().n_dot_l;
    CHECK(std::stof(choose("Copy")) == Approx(n_dot_l).margin(0.0005));
    CHECK(choose("Copy line").starts_with("n·l 0."));
    CHECK(bench.scene() == start);
}

TEST_CASE("a cosine with an unnormalized vector shows its length next to the true angle",
          "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    const auto length_shown = [&bench] {
        for (const NamedControl& control : bench.controls())
            if (control.name.starts_with("|n|")) return std::stof(control.name.substr(4));
        return 0.0f;
    };
    bench.scene().objects[0].transform.scale = glm::vec3(0.5f);
    test::ask(bench, InspectorTab::Equation, {0.49, 0.48});
    REQUIRE(bench.state.on_screen.explanation->hit);
    CHECK(length_shown() == 0);
    // The inverse transpose of a scale by 0.5 doubles a normal.
    bench.scene().shading.mistakes.unnormalized_normals = true;
    bench.frames(3);
    CHECK(length_shown() == Approx(2).epsilon(0.01));
    const ExplainedPoint& at = bench.state.on_screen.explanation->at;
    CHECK(at.lights[0].n_dot_l > 1);
    const glm::vec3 to_sun = glm::normalize(glm::vec3(bench.scene().lights[0].position));
    const double cosine = glm::dot(glm::normalize(at.normal.world), to_sun);
    const Rect angle = bench.area_of("angle n·l", test::right_column(bench));
    bench.move({angle.high.x - 10, angle.middle().y});
    bench.button(true, 1);
    bench.button(false, 1);
    bench.frames(2);
    bench.click(bench.control("Copy"));
    const std::string copied = ImGui::GetClipboardText();
    CHECK(std::stod(copied) == Approx(at.lights[0].n_dot_l).margin(0.0006));
    CHECK(std::stod(copied.substr(copied.find(' '))) ==
          Approx(std::acos(cosine) * 180 / 3.14159265358979).margin(0.06));
}

TEST_CASE("the sums of the terms can be copied", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Equation, {0.4, 0.4});
    const Rect row = bench.area_of("d  diffuse", test::right_column(bench));
    bench.move({row.high.x - 10, row.middle().y});
    bench.button(true, 1);
    bench.button(false, 1);
    bench.frames(2);
    bench.click_on("Copy");
    float blue = 0;
    for (const ExplainedLight& light : bench.state.on_screen.explanation->at.lights) blue += light.diffuse.z;
    CHECK(std::stof(ImGui::GetClipboardText()) == Approx(blue).margin(0.0005));
}

TEST_CASE("dragging a distance in the equation moves the light along its direction", "[ui][window][why]") {
    for (const LightSpace space : {LightSpace::World, LightSpace::Camera}) {
        HeadlessWindow bench({1280, 1400});
        bench.scene().lights[1].space = space;
        bench.scene().lights[1].falloff.quadratic = 0.5f;
        if (space == LightSpace::Camera) bench.scene().lights[1].position = {0.5f, 1, 1, 1};
        test::ask(bench, InspectorTab::Equation, {0.4, 0.4});
        const ExplainedLight before = bench.state.on_screen.explanation->at.lights[1];
        REQUIRE(before.distance > 0.5f);
        const ImVec2 at = test::in_column(bench, "Distance of Bulb");
        bench.drag(at, {at.x + 40, at.y});
        bench.frames(2);
        const ExplainedLight& after = bench.state.on_screen.explanation->at.lights[1];
        CHECK(after.distance > before.distance * 1.05f);
        CHECK(glm::dot(after.l.world, before.l.world) == Approx(1).margin(1e-5));
        CHECK(after.falloff != before.falloff);
        bench.key(Key::Z, true);
        bench.frames(2);
        CHECK(bench.state.on_screen.explanation->at.lights[1].distance == before.distance);
    }
}

TEST_CASE("a distance that is typed digit by digit keeps the direction to the light", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    Light third = bench.scene().lights[1];
    third.name = "Third";
    bench.scene().lights.push_back(third);
    test::ask(bench, InspectorTab::Equation, {0.4, 0.4});
    const ExplainedLight before = bench.state.on_screen.explanation->at.lights[1];
    bench.click(test::in_column(bench, "Distance of Bulb"));
    for (const char* const digit : {"0", ".", "5"}) bench.type(digit);
    bench.frames(2);
    const ExplainedLight& after = bench.state.on_screen.explanation->at.lights[1];
    CHECK(after.distance == Approx(0.5));
    CHECK(glm::dot(after.l.world, before.l.world) == Approx(1).margin(1e-5));
}

TEST_CASE("Gouraud's loss between corners is shown even if the colours are clipped", "[ui][window][why]") {
    // A plate of two triangles, and a light so close to its centre that the corners are barely lit.
    Scene scene = first_scene().scene;
    scene.objects.resize(1);
    scene.objects[0].source = PrimitiveMesh{Primitive::Plane, 1};
    scene.camera.eye = {0, 4, 1};
    scene.shading.mode = ShadingMode::Gouraud;
    scene.lights.resize(1);
    scene.lights[0].position = {0, 0.3f, 0, 1};
    (void)load_meshes(scene, "", "");
    for (const float intensity : {100.0f, 0.0f}) {
        scene.lights[0].intensity = intensity;
        HeadlessWindow bench({1280, 1400});
        take_document(bench.state.editor, SceneDocument{scene, "", "", {}});
        test::ask(bench, InspectorTab::Equation);
        REQUIRE(bench.state.on_screen.explanation->lit_per_corner);
        REQUIRE((bench.state.on_screen.explanation->byte[0] == 255) == (intensity > 0));
        const bool says = std::any_of(bench.controls().begin(), bench.controls().end(),
                                      [](const NamedControl& control) { return control.name == "lost"; });
        CHECK(says == (intensity > 0));
    }
}

TEST_CASE("an object seen from behind is noted in amber above the equation", "[ui][window][why]") {
    HeadlessWindow bench;
    bench.scene().objects[0].source = PrimitiveMesh{Primitive::Plane, 1};
    bench.scene().objects[0].mesh = nullptr;
    (void)load_meshes(bench.scene(), "", "");
    bench.scene().camera.eye = {0, 4, 1};
    test::ask(bench, InspectorTab::Equation);
    REQUIRE(bench.state.on_screen.explanation->hit);
    CHECK(side_words(*bench.state.on_screen.explanation) == "front side");
    bench.scene().shading.mistakes.normals_flipped = true;
    bench.frames(3);
    CHECK(side_words(*bench.state.on_screen.explanation) == "front side, n points away from the eye");
    bench.scene().shading.mistakes.normals_flipped = false;
    bench.scene().camera.eye = {0, -4, 1};
    bench.frames(3);
    CHECK(side_words(*bench.state.on_screen.explanation) == "back side");
    bench.scene().shading.two_sided = true;
    bench.frames(3);
    CHECK(side_words(*bench.state.on_screen.explanation) == "back side, n turned towards the eye");
}

TEST_CASE("an area light's samples unfold below its terms", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    bench.scene().lights[1].kind = LightKind::Area;
    bench.scene().lights[1].area.samples = 9;
    test::ask(bench, InspectorTab::Equation, {0.45, 0.4});
    const ExplainedLight& area = bench.state.on_screen.explanation->at.lights[1];
    REQUIRE(area.samples.size() == 9);
    const auto rows = [&] {
        return std::count_if(bench.controls().begin(), bench.controls().end(),
                             [](const NamedControl& control) { return control.name == "form"; });
    };
    const auto before = rows();
    bench.click(test::in_column(bench, sample_words(area, bench.scene().lights[1])));
    bench.frames(1);
    CHECK(rows() == before + 9);
}

TEST_CASE("every number in the equation can be dragged: one change, one undo step", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});  // tall enough that nothing needs scrolling
    test::ask(bench, InspectorTab::Equation, {0.4, 0.4});
    const Scene start = bench.scene();
    const Rect column = test::right_column(bench);
    std::set<std::string> changed;
    for (const NamedControl& number : std::vector<NamedControl>(bench.controls())) {
        if (number.at.low.x < column.low.x || number.at.low.y < column.low.y || !number.key.starts_with("/"))
            continue;
        INFO(number.name);
        REQUIRE(number.in_sight);
        const ImVec2 at = HeadlessWindow::middle_of(number.at);
        bench.drag(at, {at.x + 12, at.y});
        bench.frames(1);
        CHECK_FALSE(bench.scene() == start);
        changed.insert(bench.state.editor.history.undo_name());
        REQUIRE(bench.state.editor.history.can_undo());
        bench.key(Key::Z, true);
        REQUIRE(bench.scene() == start);
    }
    CHECK(changed.count("Material of Ball") == 1);
    CHECK(changed.count("Brightness of Sun") == 1);
    CHECK(changed.count("Colour of Sun") == 1);
    CHECK(changed.count("Falloff of Bulb") == 1);
    CHECK(changed.count("Global ambient") == 1);
}

TEST_CASE("there are no previews while a button is down", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Equation);
    const ImVec2 at = test::rest_on(bench, "s  specular");
    CHECK(bench.state.rendered_scene.shading.terms == Terms{false, false, false, true});
    test::rest(bench);
    ImGui::GetIO().MouseDown[0] = true;
    bench.move(at);
    bench.frames(2);
    CHECK(bench.state.rendered_scene == bench.scene());
    ImGui::GetIO().MouseDown[0] = false;
    bench.frames(1);
}

TEST_CASE("hovering over n·h highlights the arrow h of that light", "[ui][window][why]") {
    HeadlessWindow bench;
    bench.scene().shading.reflection = Reflection::BlinnPhong;
    test::ask(bench, InspectorTab::Equation);
    (void)test::rest_on(bench, "angle n·h");
    CHECK(bench.state.get<InspectorState>().pointed_vector == Symbol::H);
    CHECK(bench.state.get<InspectorState>().pointed_light == 0);
}

TEST_CASE("the copied text equals the output of glint explain in each format", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Equation, {0.42, 0.45});
    const Explanation why = asked_apart(bench);
    const Scene& scene = bench.scene();
    CHECK(explained_as(CopyAs::Text, *bench.state.on_screen.explanation, scene) == explain_text(why, scene));
    CHECK(explained_as(CopyAs::Json, *bench.state.on_screen.explanation, scene) == explain_json(why));
    CHECK(explained_as(CopyAs::Latex, *bench.state.on_screen.explanation, scene) ==
          explain_latex(why, scene));
}

TEST_CASE("the copy buttons fill the clipboard", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Equation);
    ImGui::SetClipboardText("nothing");
    bench.click(test::in_column(bench, "text"));
    CHECK(ImGui::GetClipboardText() == explain_text(asked_apart(bench), bench.scene()));
}
