// The equation with its numbers: what is written is what was lit, what is dragged is the scene.
#include <random>
#include <set>

#include "renderer/inspect/explain/explain_format.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "ui/inspector/equation/equation_tab.h"
#include "ui/inspector/equation/factors.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

float product(const TermLine& line) {
    float p = 1;
    for (const Factor& f : line.factors)
        p *= f.exponent ? std::pow(f.value, *f.exponent->number.place) : f.value;
    return p;
}

/// What the picture's own renderer says of the probe, asked apart from the window.
Explanation asked_apart(HeadlessWindow& bench) {
    Renderer renderer(1);
    (void)renderer.render(bench.scene(), bench.state.rendered->size);
    return renderer.explain(bench.state.explanation->x, bench.state.explanation->y);
}

int lights_on(const Scene& scene) {
    int on = 0;
    for (const Light& light : scene.lights) on += light.enabled ? 1 : 0;
    return on;
}

}  // namespace

TEST_CASE("the factors written out multiply to the term that was lit, under every model", "[ui][why]") {
    HeadlessWindow bench;
    Light lamp;
    lamp.name = "Lamp";
    lamp.kind = LightKind::Spot;
    lamp.position = {0.5f, 1, 3, 1};
    lamp.spot = {{-0.5f, -1, -3}, 35, 5};
    lamp.falloff = {0.5f, 0.1f, 0.2f};
    lamp.intensity = 2;
    lamp.ambient = {0.1f, 0.2f, 0};
    bench.scene().lights.push_back(lamp);
    for (const Reflection model :
         {Reflection::Lambert, Reflection::Phong, Reflection::BlinnPhong, Reflection::OrenNayar}) {
        bench.frames(1);
        bench.scene().shading.reflection = model;
        for (const glm::dvec2 share : {glm::dvec2(0.5, 0.5), glm::dvec2(0.4, 0.3), glm::dvec2(0.6, 0.7)}) {
            test::ask(bench, InspectorTab::Equation, share);
            REQUIRE(bench.state.explanation->hit);
            const Explanation why = *bench.state.explanation;
            REQUIRE(why.at.lights.size() == 3);
            CHECK(why.at.lights.back().spot > 0);
            for (const ExplainedLight& light : why.at.lights)
                for (int channel = 0; channel < 3; ++channel)
                    for (const TermLine& line : term_lines({bench.scene(), why, light, channel}))
                        CHECK(product(line) == Approx(line.result).epsilon(1e-4).margin(2e-6));
            for (const TermLine& line : unlit_lines(bench.scene(), why, why.at, 1))
                CHECK(product(line) == Approx(line.result));
        }
    }
}

TEST_CASE("every number in the equation is dragged where it stands: one number changes, one step undoes it",
          "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});  // tall: nothing needs scrolling
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

TEST_CASE("pointing at a term shows it alone, at a light's name that light alone, and edits nothing",
          "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Equation);
    const Scene start = bench.scene();
    const Explanation before = *bench.state.explanation;
    (void)test::rest_on(bench, "s  specular");
    CHECK(bench.state.rendered_scene.shading.terms == Terms{false, false, false, true});
    CHECK(bench.scene() == start);
    CHECK(bench.state.explanation->sum == before.sum);
    (void)test::rest_on(bench, "Light");
    CHECK(lights_on(bench.state.rendered_scene) == 1);
    CHECK(bench.state.rendered_scene.lights.front().enabled);
    CHECK(bench.state.rendered_scene.global_ambient == glm::vec3(0));
    CHECK(bench.scene() == start);
    test::rest(bench);
    CHECK(bench.state.rendered_scene == start);
}

TEST_CASE("while the button is down nothing is shown alone", "[ui][window][why]") {
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

TEST_CASE("pointing at n·h lights up the arrow h of that light", "[ui][window][why]") {
    HeadlessWindow bench;
    bench.scene().shading.reflection = Reflection::BlinnPhong;
    test::ask(bench, InspectorTab::Equation);
    (void)test::rest_on(bench, "n·h");
    CHECK(bench.state.inspector.pointed_vector == Symbol::H);
    CHECK(bench.state.inspector.pointed_light == 0);
}

TEST_CASE("what is copied is what glint explain prints, in each format", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Equation, {0.42, 0.45});
    const Explanation why = asked_apart(bench);
    const Scene& scene = bench.scene();
    CHECK(explained_as(CopyAs::Text, *bench.state.explanation, scene) == explain_text(why, scene));
    CHECK(explained_as(CopyAs::Json, *bench.state.explanation, scene) == explain_json(why));
    CHECK(explained_as(CopyAs::Latex, *bench.state.explanation, scene) == explain_latex(why, scene));
}

TEST_CASE("the copy buttons fill the clipboard", "[ui][window][why]") {
    HeadlessWindow bench({1280, 1400});
    test::ask(bench, InspectorTab::Equation);
    ImGui::SetClipboardText("nothing");
    bench.click(test::in_column(bench, "text"));
    CHECK(ImGui::GetClipboardText() == explain_text(asked_apart(bench), bench.scene()));
}

TEST_CASE("the tabs of WHY stay where they are when a pixel is picked, and when it is forgotten",
          "[ui][why]") {
    HeadlessWindow bench;
    bench.frames(3);
    const auto tab_top = [] {
        const ImGuiWindow* tab = test::window_named("/Equation");
        REQUIRE(tab != nullptr);
        return tab->Pos.y;
    };
    const float before = tab_top();
    bench.click(bench.at_pixel({320, 240}));
    bench.frames(2);
    REQUIRE(bench.state.explanation);
    CHECK(tab_top() == before);
    bench.click(bench.at_pixel({3, 3}));
    bench.frames(2);
    REQUIRE_FALSE(bench.state.explanation->hit);
    CHECK(tab_top() == before);
    bench.state.viewport.probe.reset();
    bench.frames(2);
    REQUIRE_FALSE(bench.state.explanation);
    CHECK(tab_top() == before);
}
