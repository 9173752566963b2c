// Every number in the window, typed digit by digit: intermediate values reach the scene too.
#include <imgui.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "models/fields/scene_fields.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/scenes.h"
#include "ui/widgets/numbers/number_input.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

struct Shown {
    std::string name, key;
    ImVec2 at;
};

/// A window with a scene in which numbers are typed and reverted.
class Typist {
  public:
    explicit Typist(const Scene& scene) {
        SceneDocument document;
        document.scene = scene;
        take_document(bench_.state.editor, document);
        test::ask(bench_, InspectorTab::Equation, {0.5, 0.55});
        first_ = bench_.scene();
    }

    /// Types `letters`, one by one, into every number shown by the panel of `selection` and by `tab`.
    void type_into_all(const Selection& selection, InspectorTab tab, const std::string& letters = "0.5") {
        letters_ = letters;
        bench_.state.editor.selection = selection;
        bench_.state.get<InspectorState>().tab = tab;
        bench_.frames(3);
        for (const Shown& shown : in_sight()) {
            INFO(shown.name << " " << shown.key);
            if (type(shown.at)) check_and_take_back(shown);
        }
    }
    [[nodiscard]] int typed() const { return typed_; }

  private:
    /// Returns every control that shows a value of the scene and can be clicked.
    [[nodiscard]] std::vector<Shown> in_sight() const {
        std::vector<Shown> all;
        for (const NamedControl& control : bench_.controls())
            if (control.in_sight && control.key.starts_with('/'))
                all.push_back({control.name, control.key, HeadlessWindow::middle_of(control.at)});
        return all;
    }

    /// Returns false, and reverts the click, if it did not start typing a number.
    bool type(ImVec2 at) {
        bench_.state.notifications.list.clear();
        bench_.click(at);
        bench_.frames(2);
        const bool types = number_in_hand() && ImGui::GetIO().WantTextInput;
        if (types)
            for (const char letter : letters_) bench_.type(std::string(1, letter).c_str());
        bench_.click({2, height - 2});
        bench_.frames(2);
        bench_.wait_for_loads();
        if (!types) take_back();
        return types;
    }

    void check_and_take_back(const Shown& shown) {
        ++typed_;
        const auto read = parse_scene(scene_text(bench_.scene()), "typed.json");
        REQUIRE(problem_of(read) == nullptr);
        CHECK(same_description(std::get<Scene>(read), bench_.scene()));
        // A narrow picture's panel shows the field of view that is drawn; the Program tab shows the one in
        // the file.
        Scene drawn = bench_.scene();
        drawn.camera.projection = fitted(drawn.camera.projection, bench_.state.full_size);
        const bool is_told = !bench_.state.notifications.list.empty();
        const auto ends_in = [&](Scene& scene) {
            const auto number = number_at(scene, shown.key);
            return !number || number->count ||
                   static_cast<float>(number->value) ==
                       Approx(std::strtof(letters_.c_str(), nullptr)).epsilon(1e-5);
        };
        CHECK((is_told || ends_in(bench_.scene()) || ends_in(drawn)));
        while (undo(bench_.state.editor)) {
        }
        bench_.wait_for_loads();
        CHECK(same_description(bench_.scene(), first_));
        take_back();
    }

    void take_back() {
        (void)bench_.key(Key::Escape);
        bench_.state.viewport.probe = glm::dvec2{0.5, 0.55};
        bench_.scene() = first_;
        bench_.frames(2);
        bench_.wait_for_loads();
    }

    static constexpr float height = 1500;
    HeadlessWindow bench_{{1280, height}};
    Scene first_;
    std::string letters_;
    int typed_ = 0;
};

}  // namespace

TEST_CASE("each number typed digit by digit reaches the scene, or its rejection is reported",
          "[ui][window][numbers][release]") {
    Scene scene = test::busy_scene();
    for (Light& light : scene.lights) light.enabled = true;
    int typed = 0;
    for (const Projection& projection :
         {Projection(Perspective{}), Projection(Orthographic{}), Projection(Frustum{})}) {
        scene.camera.projection = projection;
        Typist typist(scene);
        typist.type_into_all({Selection::Kind::Camera, 0}, InspectorTab::Matrices);
        typed += typist.typed();
    }
    scene.camera.projection = Perspective{};
    Typist typist(scene);
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i)
        typist.type_into_all({Selection::Kind::Light, i}, InspectorTab::Equation);
    typist.type_into_all({Selection::Kind::Object, 0}, InspectorTab::Program);
    typist.type_into_all({Selection::Kind::Shading, 0}, InspectorTab::Models);
    typist.type_into_all({Selection::Kind::Display, 0}, InspectorTab::Vectors);
    typed += typist.typed();
    CHECK(typed > 120);
}

TEST_CASE("after any text typed into a number, the scene can be saved and opened again",
          "[ui][window][numbers][release]") {
    Scene scene = test::busy_scene();
    for (Light& light : scene.lights) light.enabled = true;
    scene.lights.resize(2);
    Typist typist(scene);
    for (const char* const letters : {"0", "1e8"}) {
        CAPTURE(letters);
        typist.type_into_all({Selection::Kind::Light, 1}, InspectorTab::Program, letters);
        typist.type_into_all({Selection::Kind::Object, 0}, InspectorTab::Program, letters);
    }
    CHECK(typist.typed() > 150);
}
