// What each light contributes: its total and share in the equation, the brightest pixel, solo and mute.
#include <cstdio>
#include <glm/geometric.hpp>

#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "ui/features/inspector/inspector.h"
#include "ui/fields/panels.h"
#include "ui/picture/picture_notes.h"
#include "ui/picture/screen.h"

using namespace glint;
using namespace glint::test;

namespace {

/// The text of each light's total, from top to bottom.
std::vector<std::string> totals(const HeadlessWindow& bench) {
    std::vector<std::string> texts;
    for (const NamedControl& control : bench.controls())
        if (control.name == "light total") texts.push_back(control.key);
    return texts;
}

std::vector<std::string> notes(const HeadlessWindow& bench) {
    std::vector<std::string> names;
    for (const PictureNote& note : picture_notes(bench.state)) names.push_back(note.name);
    return names;
}

ImVec2 eye_of(const HeadlessWindow& bench, int light) {
    return bench.control("/lights/" + std::to_string(light) + "/enabled");
}

}  // namespace

TEST_CASE("a light's heading shows its total in the chosen channel and its share", "[ui][window][why]") {
    HeadlessWindow bench;
    ask(bench, InspectorTab::Equation, {0.52, 0.45});
    const ExplainedPoint& point = bench.state.on_screen.explanation->at;
    REQUIRE(point.lights.size() == 2);
    const std::vector<std::string> shown = totals(bench);
    REQUIRE(shown.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const ExplainedLight& light = point.lights[i];
        const float total = light.ambient.r + light.diffuse.r + light.specular.r;
        CAPTURE(shown[i], total, point.sum.r);
        float printed = 0, percent = 0;
        REQUIRE(std::sscanf(shown[i].c_str(), "%f %f %%", &printed, &percent) == 2);
        CHECK(printed == Approx(total).margin(0.002));
        const glm::vec3 all = light.ambient + light.diffuse + light.specular, white(1);
        CHECK(percent == Approx(100 * glm::dot(all, white) / glm::dot(point.sum, white)).margin(0.6));
    }
}

TEST_CASE("under Gouraud shading a light's total is the pixel's, not a corner's", "[ui][window][why]") {
    HeadlessWindow bench;
    bench.scene().shading.mode = ShadingMode::Gouraud;
    ask(bench, InspectorTab::Equation, {0.52, 0.45});
    const Explanation pixel = *bench.state.on_screen.explanation;
    Scene alone = bench.scene();
    alone.lights[1].enabled = false;
    alone.global_ambient = glm::vec3(0);
    Renderer renderer(1);
    const float adds = renderer.render(alone, bench.state.rendered->size, true).linear_at(pixel.x, pixel.y).r;
    for (int corner = 0; corner < 3; ++corner) {
        bench.state.get<InspectorState>().corner = corner;
        bench.frames(2);
        CHECK(std::stof(totals(bench).at(0)) == Approx(adds).margin(0.001));
    }
}

TEST_CASE("lights are sorted by their share on request", "[ui][window][why]") {
    HeadlessWindow bench;
    std::swap(bench.scene().lights[0], bench.scene().lights[1]);  // the weaker one first
    ask(bench, InspectorTab::Equation, {0.55, 0.45});
    const std::vector<std::string> before = totals(bench);
    REQUIRE(before.size() == 2);
    REQUIRE(std::stof(before[0]) < std::stof(before[1]));
    bench.click(in_column(bench, "Largest share first"));
    bench.frames(2);
    CHECK(totals(bench) == std::vector<std::string>{before[1], before[0]});
}

TEST_CASE("hovering over a highlight still shows the light's share in the status line",
          "[ui][window][picture]") {
    HeadlessWindow bench;
    bench.frames(2);
    ViewportState& view = bench.state.viewport;
    bool on_highlight = false;
    for (int y = 100; y < 500 && !on_highlight; y += 8)
        for (int x = 100; x < 600 && !on_highlight; x += 8) {
            bench.move(bench.at_pixel({x, y}));
            on_highlight = view.hovered_grip.kind == GripKind::Highlight;
        }
    REQUIRE(on_highlight);
    const std::string hint = tools_hint(bench.state);
    CHECK(hint.find("% of R + G + B here") != hint.npos);
    CHECK(hint.find("Drag the highlight") != hint.npos);
}

TEST_CASE("the brightest, darkest and first clipped pixels are found", "[ui][window][commands]") {
    HeadlessWindow bench;
    bench.frames(2);
    const auto picked = [&](const char* name) {
        run_command(bench.state, command_named(name));
        bench.frames(4);
        REQUIRE(bench.state.on_screen.explanation);
        const Explanation& found = *bench.state.on_screen.explanation;
        CHECK(found.hit);
        return glm::dot(found.sum, glm::vec3(0.2126f, 0.7152f, 0.0722f));
    };
    const float bright = picked("Go to the brightest pixel");
    const float dark = picked("Go to the darkest pixel");
    const PictureSize size = bench.state.rendered->size;
    for (int y = 3; y < size.height; y += 40)
        for (int x = 3; x < size.width; x += 40) {
            const Explanation each = bench.state.renderer->explain(x, y);
            if (!each.hit) continue;
            const float luminance = glm::dot(each.sum, glm::vec3(0.2126f, 0.7152f, 0.0722f));
            CHECK(luminance <= bright + 1e-5f);
            CHECK(luminance >= dark - 1e-5f);
        }
    bench.scene().display.exposure = 0.01f;
    bench.frames(2);
    run_command(bench.state, command_named("Go to the first clipped pixel"));
    bench.frames(3);
    CHECK(bench.notes_with("No pixel is clipped") == 1);
    bench.scene().display.exposure = 20;
    bench.frames(2);
    picked("Go to the first clipped pixel");
    CHECK(20 * glm::max(bench.state.on_screen.explanation->sum.r, bench.state.on_screen.explanation->sum.b) >
          1);
}

TEST_CASE("Alt-clicking a light's eye shows that light alone, with a badge", "[ui][window][lights]") {
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    ImGui::GetIO().KeyAlt = true;
    bench.click(eye_of(bench, 1));
    ImGui::GetIO().KeyAlt = false;
    bench.frames(2);
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.rendered_scene.lights[0].enabled);
    CHECK(bench.state.rendered_scene.lights[1].enabled);
    CHECK(notes(bench) == std::vector<std::string>{"Solo: Bulb"});
    bench.click(bench.control("End: Solo: Bulb"));
    bench.frames(2);
    CHECK(bench.state.rendered_scene == before);
}

TEST_CASE("S and M on a light's row toggle solo and mute, but not elsewhere", "[ui][window][lights]") {
    HeadlessWindow bench;
    bench.frames(2);
    const Scene before = bench.scene();
    bench.move(eye_of(bench, 0) - ImVec2(120, 0));
    bench.frames(1);
    (void)bench.key(Key::M);
    bench.frames(2);
    CHECK(notes(bench) == std::vector<std::string>{"Muted: Sun"});
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.rendered_scene.lights[0].enabled);
    (void)bench.key(Key::S);
    bench.frames(2);
    CHECK(notes(bench) == std::vector<std::string>{"Solo: Sun"});
    bench.click(eye_of(bench, 1));  // a closed eye: it shows the light again
    bench.frames(2);
    CHECK(notes(bench).empty());
    bench.move(bench.at_pixel({300, 300}));
    (void)bench.key(Key::S);
    bench.frames(2);
    CHECK(notes(bench).empty());
}

TEST_CASE("solo ends when a light is deleted or another scene opens", "[ui][window][lights]") {
    HeadlessWindow bench;
    bench.frames(2);
    bench.state.editor.selection = {Selection::Kind::Light, 1};
    run_command(bench.state, command_named("Solo the selected light"));
    bench.frames(2);
    REQUIRE(notes(bench) == std::vector<std::string>{"Solo: Bulb"});
    (void)bench.key(Key::Delete);
    bench.frames(2);
    CHECK(notes(bench).empty());
    run_command(bench.state, command_named("Solo the selected light"));
    bench.frames(2);
    take_scene(bench.state, first_scene());
    bench.frames(2);
    CHECK(notes(bench).empty());
}
