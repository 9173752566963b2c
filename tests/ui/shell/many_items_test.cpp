// Scenes and folders with a great many items: invisible items cost no frame time and remain reachable.
#include <algorithm>
#include <string>

#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/scenes.h"

using namespace glint;
using test::HeadlessWindow;

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

/// A window with that tab open, for the pixel in the middle of such a scene.
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
        CHECK(in_sight(neighbour));  // no farther than necessary
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
