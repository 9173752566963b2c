// Windows and displays of every size: ImGui never gets an empty area, and the scale stays within its range.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "models/utf8.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"
#include "ui/features/inspector/inspector.h"
#include "ui/widgets/theme.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

WindowExtent extent(glm::ivec2 size, glm::ivec2 dots, float content = 1) {
    return {size, size, dots, content};
}

/// Draws the window at every size, from empty to wide and low.
void draw_all_sizes(HeadlessWindow& bench) {
    constexpr std::array widths{0.0f, 1.0f, 2.0f, 9.0f, 30.0f, 63.0f, 130.0f, 320.0f, 700.0f, 1300.0f};
    constexpr std::array heights{0.0f, 1.0f, 2.0f, 9.0f, 30.0f, 63.0f, 130.0f, 240.0f};
    for (std::size_t w = 0; w < widths.size(); ++w)
        for (std::size_t h = test::sanitized ? w % 2 : 0; h < heights.size(); h += test::sanitized ? 2 : 1) {
            INFO(widths[w] << " x " << heights[h]);
            ImGui::GetIO().DisplaySize = {widths[w], heights[h]};
            bench.frames(2);
            CHECK(bench.state.rendered->size.width >= 1);
            CHECK(bench.state.rendered->size.width <= 1300);
        }
}

void open_everything(UiState& state) {
    state.get<ScopeState>().open = true;
    state.get<WedgeState>().open = state.get<PenState>().on = state.get<AnimateState>().open = true;
    state.shows_shortcuts = state.get<InspectorState>().shows_vectors = true;
    state.viewport.probe = glm::dvec2(0.5, 0.5);
    state.notifications.add(Tone::Warning, "A warning that is longer than the window is wide");
}

}  // namespace

TEST_CASE("Phong shading and Phong's model have different labels in a wide window", "[ui][window]") {
    DrawnWindow bench({1920, 1080});
    for (const char* label : {"Phong", "Phong model"}) {
        CAPTURE(label);
        CHECK(std::count_if(bench.controls().begin(), bench.controls().end(),
                            [&](const NamedControl& control) { return control.name == label; }) == 1);
    }
}

TEST_CASE("ImGui accepts the theme at every display scale", "[ui][small]") {
    for (const float scale : {0.25f, 0.5f, 0.75f, 0.78125f, 0.9375f, 0.99f, 1.0f, 1.1f, 3.125f, 5.6f}) {
        HeadlessWindow bench({400, 300});
        apply_theme(light_theme(), scale);
        INFO("scale " << scale);
        // ImGui's requirements for every frame (ErrorCheckNewFrameSanityChecks).
        REQUIRE(ImGui::GetStyle().WindowMinSize.x >= 1);
        REQUIRE(ImGui::GetStyle().WindowMinSize.y >= 1);
        bench.frames(2);
    }
}

TEST_CASE("a window of any size, down to zero, can be drawn with everything open in it", "[ui][small]") {
    for (const float scale : {0.75f, 4.0f}) {
        HeadlessWindow bench({800, 600});
        apply_theme(dark_theme(), scale);
        bench.frames(1);
        open_everything(bench.state);
        for (const InspectorTabInfo& info : inspector_tabs()) {
            INFO("tab " << info.label);
            bench.state.get<InspectorState>().tab = info.tab;
            draw_all_sizes(bench);
        }
        for (const Key key : {Key::C, Key::M, Key::I, Key::K, Key::O, Key::E}) {
            bench.key(key, key == Key::K || key == Key::O || key == Key::E);
            draw_all_sizes(bench);
            bench.key(Key::Escape);
        }
    }
}

TEST_CASE("during a resize the dots per unit stay constant", "[ui][small]") {
    const DisplayScale one;
    // The framebuffer already has the new size.
    WindowExtent resized{{100, 80}, {1600, 1200}, {1600, 1200}, 1};
    CHECK(display_scale(resized, one) == one);
    // Twice as wide, but not twice as high: no display has such units.
    CHECK(display_scale(extent({100, 80}, {200, 90}), one) == one);
    const DisplayScale two{1, 2};
    CHECK(display_scale(resized, two).dots_per_unit == 2);
    CHECK(display_scale(extent({0, 0}, {0, 0}), one) == one);
    CHECK(display_scale(extent({0, 50}, {1000, 50}), one) == one);
    CHECK(display_scale(extent({50, 50}, {0, 0}, 2), two) == two);
}

TEST_CASE("a display measured in points has several dots per unit", "[ui][small]") {
    CHECK(display_scale(extent({640, 480}, {1280, 960}, 2), {}) == DisplayScale{1, 2});
    CHECK(display_scale(extent({640, 480}, {640, 480}, 2), {}) == DisplayScale{2, 1});
    CHECK(display_scale(extent({640, 480}, {640, 480}, 0.78125f), {}) == DisplayScale{0.78125f, 1});
}

TEST_CASE("no display makes type too small to read or too large for a texture", "[ui][small]") {
    for (const float content : {0.0f, -3.0f, 0.01f, 1.0f, 17.0f, 1e9f, std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::quiet_NaN()})
        for (const int dots : {100, 150, 200, 5000}) {
            const DisplayScale scale = display_scale(extent({100, 100}, {dots, dots}, content), {});
            INFO("content scale " << content << ", " << dots << " dots");
            CHECK(scale.design * scale.dots_per_unit >= Approx(0.75f));
            CHECK(scale.design * scale.dots_per_unit <= Approx(4));
            CHECK(scale.dots_per_unit <= 4);
        }
    HeadlessWindow bench;
    load_fonts(find_fonts(), 4 * projector_scale, 1);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    CHECK(width <= 16384);  // the limit of current OpenGL drivers
    CHECK(height <= 16384);
}

TEST_CASE("rounding to whole dots does not count as a change of scale", "[ui][small]") {
    DisplayScale scale = display_scale(extent({1000, 800}, {1250, 1000}, 1.25f), {});
    const DisplayScale first = scale;
    for (int width = 300; width < 2000; ++width) {
        const auto dots = [](int units) { return static_cast<int>(static_cast<float>(units) * 1.25f); };
        scale = display_scale(extent({width, width / 2}, {dots(width), dots(width / 2)}, 1.25f), scale);
        REQUIRE(scale == first);
    }
}

TEST_CASE("a notification stays within the window however long its text is", "[ui][small][notifications]") {
    for (const ImVec2 size : {ImVec2(1280, 800), ImVec2(480, 300)}) {
        DrawnWindow bench(size);
        bench.state.notifications.add(Tone::Error,
                                      "no such file: " + std::string(4000, 'x') + "; expected a mesh");
        bench.frames(3);
        const ImGuiWindow& note = *test::window_named("##note0");
        CHECK(note.Pos.y >= 0);  // its close button is at the top
        CHECK(note.Pos.y + note.Size.y <= size.y);
        const std::string& shown = bench.state.notifications.list.back().text;
        CHECK(shown.size() < 500);
        CHECK(shown.starts_with("no such file: "));
        CHECK(shown.ends_with("; expected a mesh"));
        std::string euros;  // three bytes per character
        for (int i = 0; i < 2000; ++i) euros += "€";
        bench.state.notifications.add(Tone::Warning, euros);
        const std::string& cut = bench.state.notifications.list.back().text;
        CHECK(cut.size() < 500);
        CHECK(first_invalid_utf8(cut) == cut.size());
    }
}

// Scenes and folders with a great many items: invisible items cost no frame time and remain reachable.
namespace {

constexpr int many = 300;

/// `count` lights on one triangle, each with its own name.
Scene scene_of_lights(int count) {
    Scene scene;
    scene.camera.eye = {0, 0, 4};
    scene.objects = {test::object_of(test::primitive(Primitive::Cube, 1))};
    scene.shading.mode = ShadingMode::Flat;
    for (int i = 0; i < count; ++i) {
        Light light;
        light.name = "Lamp " + std::to_string(i);
        light.position = {0, 0, 5, 1};
        scene.lights.push_back(light);
    }
    return scene;
}

/// A window with that tab open, for the centre pixel of such a scene.
struct ManyWindow : HeadlessWindow {
    ManyWindow(const Scene& shown, InspectorTab tab) {
        state.editor.history.reset(shown);
        scene() = shown;
        test::ask(*this, tab);
    }
    [[nodiscard]] auto controls_named(const std::string& name) const {
        return std::count_if(controls().begin(), controls().end(),
                             [&](const NamedControl& control) { return control.name == name; });
    }
    void scroll_to_end() {
        move(test::right_column(*this).middle());
        for (int i = 0; i < 3; ++i) {  // afterwards, all estimated heights are known
            ImGui::GetIO().MouseWheel = -1e5f;
            (void)frame();
            ImGui::GetIO().MouseWheel = 0;
            frames(2);
        }
    }
};

int corners_drawn() { return ImGui::GetDrawData()->TotalVtxCount; }

}  // namespace

TEST_CASE("a folder of thirty thousand files draws only its visible rows", "[ui][window][many]") {
    HeadlessWindow bench;
    bench.state.files.ask(mesh_purpose, "");
    bench.state.files.entries.clear();
    bench.frames(2);
    const int empty = corners_drawn();
    for (int i = 0; i < 30'000; ++i)
        bench.state.files.entries.push_back({"mesh" + std::to_string(i) + ".obj", false});
    bench.frames(2);
    CHECK(corners_drawn() < empty + 20'000);
    const ImGuiWindow* list = test::window_named("##entries");
    REQUIRE(list != nullptr);
    bench.move({list->Pos.x + 40, list->Pos.y + 40});
    ImGui::GetIO().MouseWheel = -1e6f;
    (void)bench.frame();
    ImGui::GetIO().MouseWheel = 0;
    bench.frames(1);
    bench.click({list->Pos.x + 40, list->Pos.y + list->Size.y - ImGui::GetStyle().WindowPadding.y - 6});
    CHECK(bench.state.files.name == "mesh29999.obj");
}

TEST_CASE("the scene list scrolls once to an item selected by keys or in the picture", "[ui][window][many]") {
    ManyWindow bench(scene_of_lights(many), InspectorTab::Equation);
    const auto in_sight = [&bench](int light) {
        const std::string key = "/lights/" + std::to_string(light) + "/enabled";
        const auto& all = bench.controls();
        return std::any_of(all.begin(), all.end(),
                           [&](const NamedControl& c) { return c.key == key && c.in_sight; });
    };
    // The panel also has the switch of the selected light, so its neighbours' are checked.
    for (const auto& [selected, neighbour] : {std::pair{299, 298}, {0, 1}, {150, 149}, {151, 149}}) {
        bench.state.editor.selection = {Selection::Kind::Light, selected};
        bench.frames(3);
        INFO(selected);
        CHECK(in_sight(neighbour));  // the list scrolls no farther than necessary
    }
    bench.state.editor.selection = {Selection::Kind::Light, 0};
    bench.frames(3);
    bench.move(bench.control("/lights/1/enabled"));
    ImGui::GetIO().MouseWheel = -1e5f;
    (void)bench.frame();
    ImGui::GetIO().MouseWheel = 0;
    bench.frames(3);
    CHECK_FALSE(in_sight(1));
}
