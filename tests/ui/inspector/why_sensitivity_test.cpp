// Sensitivities of a pixel: measured in the background, only after changes, and described in text.
#include <chrono>
#include <thread>

#include "models/json/json.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/memory_helpers.h"
#include "ui/document/document_actions.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/sensitivity.h"
#include "ui/fields/panels.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// Runs frames until the job is done. ImGui's clock counts frames; the job's clock measures real time.
bool wait_for_numbers(HeadlessWindow& bench) {
    for (int i = 0; i < 4000 && !bench.state.get<SensitivityState>().current; ++i) {
        bench.frames(1);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return bench.state.get<SensitivityState>().current;
}

/// A number or switch in the scene, as its file contains it. Precondition: the pointer has no "~".
Json value_at(const Scene& scene, std::string_view pointer) {
    const Json file = json_or_null(scene_text(scene));
    const Json* found = &file;
    while (!pointer.empty()) {
        const std::string token(pointer.substr(1, pointer.find('/', 1) - 1));
        pointer.remove_prefix(token.size() + 1);
        found = found->is_array() ? &elements_of(*found).at(std::stoul(token)) : find_member(*found, token);
        REQUIRE(found != nullptr);
    }
    return *found;
}

}  // namespace

TEST_CASE("the sensitivity shown matches glint explain --sensitivity", "[ui][window][why]") {
    HeadlessWindow bench({760, 400});
    bench.state.layout.left = true;
    bench.state.left_shows_inspector = true;
    test::ask(bench, InspectorTab::Sensitivity, {0.5, 0.45});
    REQUIRE(wait_for_numbers(bench));
    const auto made =
        sensitivities(bench.state.editor.document, bench.state.rendered->size,
                      bench.state.on_screen.explanation->x, bench.state.on_screen.explanation->y, 1);
    const auto& expected = std::get<Sensitivities>(made);
    REQUIRE(bench.state.get<SensitivityState>().shown);
    const Sensitivities& shown = *bench.state.get<SensitivityState>().shown;
    REQUIRE(shown.numbers.size() == expected.numbers.size());
    for (std::size_t i = 0; i < shown.numbers.size(); ++i) {
        CHECK(shown.numbers[i].pointer == expected.numbers[i].pointer);
        CHECK(shown.numbers[i].change == expected.numbers[i].change);
    }
    CHECK(shown.no_effect == expected.no_effect);
    // As long as nothing changes, no frame is requested and no job starts.
    bench.frames(30);
    CHECK_FALSE(bench.state.get<SensitivityState>().job);
    // After a change, the old numbers are marked as outdated.
    bench.scene().lights.front().intensity = 0.5f;
    bench.frames(2);
    CHECK_FALSE(bench.state.get<SensitivityState>().current);
    REQUIRE(wait_for_numbers(bench));
    CHECK(bench.state.get<SensitivityState>().shown->numbers.front().change !=
          expected.numbers.front().change);
}

TEST_CASE("the column reports that there are too many lights to measure", "[ui][window][why]") {
    HeadlessWindow bench({760, 400});
    bench.scene().lights.resize(max_sensitivity_lights + 1, bench.scene().lights.front());
    bench.state.layout.left = true;
    bench.state.left_shows_inspector = true;
    test::ask(bench, InspectorTab::Sensitivity, {0.5, 0.45});
    REQUIRE(wait_for_numbers(bench));
    CHECK_FALSE(bench.state.get<SensitivityState>().shown);
    CHECK(bench.state.get<SensitivityState>().why_none == "More than 64 lights take too long.");
}

TEST_CASE("numbers are ranked by the effect of a typical change, not by their units", "[ui][why]") {
    Sensitivities measured;
    const auto number = [](const char* pointer, double change, double effect) {
        Sensitivity s;
        s.pointer = pointer, s.change = glm::dvec3(change), s.effect = glm::dvec3(0, effect, 0);
        return s;
    };
    measured.numbers = {number("/lights/0/position/3", 9, 9), number("/lights/0/intensity", 0.5, 0.2),
                        number("/objects/0/material/shininess", 0.02, -0.3)};
    measured.numbers[0].is_w = true;
    const auto rank = ranked(measured);
    REQUIRE(rank.size() == 2);
    CHECK(rank[0].pointer == "/objects/0/material/shininess");
    CHECK(rank[1].pointer == "/lights/0/intensity");
}

TEST_CASE("a number's pointer is shown as its name and the panel that contains it", "[ui][why]") {
    const Scene scene = first_scene().scene;
    const NamedNumber bulb = named_number("/lights/1/position/1", scene);
    CHECK(bulb.owner == "Bulb");
    CHECK(bulb.what == "position y");
    CHECK(bulb.selection == Selection{Selection::Kind::Light, 1});
    CHECK(named_number("/objects/0/material/diffuse/0", scene).what == "diffuse red");
    CHECK(named_number("/camera/projection/fov_y_deg", scene).what == "view angle");
    CHECK(named_number("/global_ambient/2", scene).what == "ambient blue");
    CHECK(named_number("/objects/0", scene).owner == "Ball");
    CHECK(named_number("/objects/0", scene).what.empty());
    CHECK(named_number("/camera/eye", scene).what == "eye");
    CHECK(named_number("/lights/1/position", scene).what == "position");
    CHECK(named_number("/lights/7/position/0", scene).owner == "Scene");
    CHECK(named_number("", scene).what.empty());
}

TEST_CASE("each control in the strokes and tones panel sets its key in one undo step", "[ui][window][why]") {
    DrawnWindow bench({1280, 1600});
    bench.state.editor.selection = {Selection::Kind::Shading, 0};
    bench.frames(2);
    for (const char* folded : {"Cool to warm", "Strokes"}) bench.click(bench.control(folded));
    bench.frames(1);
    const Scene start = bench.scene();
    for (const char* key :
         {"/npr/cool_to_warm", "/npr/cool/0", "/npr/warm/0", "/npr/alpha", "/npr/beta", "/npr/silhouettes",
          "/npr/creases", "/npr/crease_deg", "/npr/stroke/0", "/npr/stroke_width_px"}) {
        INFO(key);
        const ImVec2 at = bench.control(key);
        bench.drag(at, {at.x + 6, at.y});
        bench.frames(1);
        CHECK(bench.state.editor.history.undo_name() == "Strokes and tones");
        CHECK(value_at(bench.scene(), key) != value_at(start, key));
        REQUIRE(undo(bench.state.editor));
        CHECK_FALSE(undo(bench.state.editor));  // it was one step
        bench.frames(1);
        REQUIRE(bench.scene() == start);
    }
}

TEST_CASE("in a comparison's part, sensitivities are those of the part's picture", "[ui][window][compare]") {
    DrawnWindow bench;
    bench.compare({variant_of(ShadingMode::Flat), variant_of(ShadingMode::Phong)});
    test::ask(bench, InspectorTab::Sensitivity, {0.4, 0.5});
    REQUIRE(wait_for_numbers(bench));
    CHECK(bench.state.on_screen.explanation->mode == ShadingMode::Flat);
    Scene flat = bench.scene();
    flat.shading.mode = ShadingMode::Flat;
    CHECK(bench.state.get<SensitivityState>().shown_scene == flat);
    // Exposure multiplies the pixel, so its effect equals the pixel's sum.
    const auto exposure = std::find_if(bench.state.get<SensitivityState>().rank.begin(),
                                       bench.state.get<SensitivityState>().rank.end(),
                                       [](const Sensitivity& s) { return s.pointer == "/display/exposure"; });
    REQUIRE(exposure != bench.state.get<SensitivityState>().rank.end());
    const glm::vec3 sum = bench.state.on_screen.explanation->sum;
    CHECK(exposure->effect.x == Approx(sum.x).epsilon(1e-3));
}
