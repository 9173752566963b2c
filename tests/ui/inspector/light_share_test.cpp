// What each light contributes: its total and share in the equation, the brightest pixel, solo and mute.
#include <cstdio>
#include <glm/geometric.hpp>

#include "tests/places.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "ui/commands/command.h"
#include "ui/features/inspector/inspector.h"
#include "ui/fields/panels.h"
#include "ui/picture/picture_notes.h"
#include "ui/picture/screen.h"
#include "ui/preferences/persistence.h"

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
    DrawnWindow bench;
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
    DrawnWindow bench;
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

TEST_CASE("Alt-clicking a light's eye icon shows that light alone, with a badge", "[ui][window][lights]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    ImGui::GetIO().KeyAlt = true;
    bench.click(eye_of(bench, 1));
    ImGui::GetIO().KeyAlt = false;
    bench.frames(2);
    CHECK(bench.scene() == before);
    CHECK_FALSE(bench.state.rendered_scene.lights[0].enabled);
    CHECK(bench.state.rendered_scene.lights[1].enabled);
    CHECK(notes(bench) == std::vector<std::string>{"Solo: Bulb"});
    bench.click_on("End: Solo: Bulb");
    CHECK(bench.state.rendered_scene == before);
}

TEST_CASE("S and M on a light's row toggle solo and mute, but not elsewhere", "[ui][window][lights]") {
    DrawnWindow bench;
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
    bench.click(eye_of(bench, 1));  // clicking a closed eye shows the light again
    bench.frames(2);
    CHECK(notes(bench).empty());
    bench.move(bench.at_pixel({300, 300}));
    (void)bench.key(Key::S);
    bench.frames(2);
    CHECK(notes(bench).empty());
}

TEST_CASE("solo ends when a light is deleted or another scene opens", "[ui][window][lights]") {
    DrawnWindow bench;
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

// Sets of lights: previewed, applied, saved and imported.
namespace {

void open_menu(HeadlessWindow& bench) {
    bench.frames(2);
    bench.click(bench.control("Light setups"));
    bench.frames(3);
}

}  // namespace

TEST_CASE("hovering over a light setup previews it, and a click applies it", "[ui][window][lights]") {
    HeadlessWindow bench;
    open_menu(bench);
    const Scene before = bench.scene();
    bench.move(bench.control("Three-point"));
    bench.frames(3);
    CHECK(bench.scene() == before);
    REQUIRE(bench.state.rendered_scene.lights.size() == 3);
    bench.move({5, 5});
    bench.frames(3);
    CHECK(bench.state.rendered_scene.lights == before.lights);
    bench.click(bench.control("Three-point"));
    bench.frames(3);
    const std::vector<Light>& lights = bench.scene().lights;
    REQUIRE(lights.size() == 3);
    // Seen from the eye: the key light is on the left and above, the fill on the right, the rim behind.
    const ScreenMap map = screen_map(bench.scene().camera, bench.state.rendered->size);
    const auto in_view = [&](const glm::vec4& at) {
        return glm::dvec3(map.view_from_world * glm::dvec4(at));
    };
    const glm::dvec3 target = in_view(glm::vec4(bench.scene().camera.target, 1));
    CHECK(in_view(lights[0].position).x < target.x);
    CHECK(in_view(lights[0].position).y > target.y);
    CHECK(in_view(lights[1].position).x > target.x);
    CHECK(in_view(lights[2].position).z < target.z);
    CHECK(lights[0].intensity > lights[1].intensity);
    (void)bench.key(Key::Z, true);
    bench.frames(2);
    CHECK(bench.scene().lights == before.lights);
}

TEST_CASE("the noon sun is overhead, and the headlight is at the eye in every view", "[ui][window][lights]") {
    DrawnWindow bench;
    const auto apply = [&](const char* name) {
        for (const PaletteEntry& entry : palette_entries(bench.state))
            if (entry.name == name) return entry.run(bench.state);
        FAIL("missing palette entry " << name);
    };
    apply("Light setup: Noon");
    REQUIRE(bench.scene().lights.size() == 1);
    CHECK(glm::distance(bench.scene().lights[0].position, glm::vec4(0, 1, 0, 0)) < 1e-6f);
    apply("Light setup: Headlight");
    CHECK(bench.scene().lights[0].space == LightSpace::Camera);
    CHECK(bench.scene().lights[0].position == glm::vec4(0, 0, 0, 1));
}

TEST_CASE("a user's light setups are saved with the settings and survive a reset", "[ui][window][lights]") {
    Json kept;
    std::vector<Light> saved;
    {
        DrawnWindow bench;
        bench.scene().lights[0].intensity = 0.625f;
        saved = bench.scene().lights;
        open_menu(bench);
        bench.click_on("Name of the preset");
        bench.type("Evening");
        bench.click_on("Save lights as preset");
        kept = features_to_remember(bench.state);
    }
    DrawnWindow bench;
    recall_features(bench.state, kept);
    recall_features(bench.state, Json::object());
    bench.scene().lights.clear();
    open_menu(bench);
    bench.click_on("Evening");
    CHECK(bench.scene().lights == saved);
    recall_features(bench.state, {{"light_setups", {{{"name", 3}}, {{"name", "x"}, {"lights", "y"}}, 5}}});
    open_menu(bench);
    CHECK(std::none_of(bench.controls().begin(), bench.controls().end(),
                       [](const NamedControl& control) { return control.name == "Evening"; }));
}

TEST_CASE("lights are imported from another scene", "[ui][window][lights]") {
    HeadlessWindow bench;
    open_menu(bench);
    bench.click_on("Import lights");
    REQUIRE(bench.state.files.open);
    const FilePurpose& purpose = *bench.state.files.purpose;
    bench.state.files.open = false;
    const std::string path = project_file("assets/scenes/bulb.json");
    const auto opened = open_document(path);
    REQUIRE(problem_of(opened) == nullptr);
    const std::vector<Light> expected = std::get<SceneDocument>(opened).scene.lights;
    const std::vector<Object> objects = bench.scene().objects;
    purpose.use(bench.state, path);
    for (int i = 0; i < 2000 && !(bench.scene().lights == expected); ++i) {
        bench.frames(1);
        std::this_thread::yield();
    }
    CHECK(bench.scene().lights == expected);
    CHECK(bench.scene().objects == objects);
}
