// Editing numbers: dragging, typing, and their menu.
#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "models/fields/scene_fields.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/lesson_window.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/document/document_actions.h"
#include "ui/widgets/numbers/number_input.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Indices in ImGui's io.KeysDown that this test assigns to keys.
constexpr int enter_key = 1, escape_key = 2, tab_key = 3, backspace_key = 4, paste_key = 5;

/// A window whose panel shows the selected light's intensity, with its own clipboard.
struct Bench : HeadlessWindow {
    Bench() {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyMap[ImGuiKey_Enter] = enter_key;
        io.KeyMap[ImGuiKey_Escape] = escape_key;
        io.KeyMap[ImGuiKey_Tab] = tab_key;
        io.KeyMap[ImGuiKey_Backspace] = backspace_key;
        test::use_clipboard(clipboard);
        SceneDocument document = first_scene();
        document.scene.lights[0].intensity = 0.5f;
        take_document(state.editor, std::move(document));
        state.editor.selection = {Selection::Kind::Light, 0};
        frames(2);
    }
    float& intensity() { return scene().lights[0].intensity; }
    ImVec2 field() { return control("/lights/0/intensity"); }
    void tap(int which) {
        ImGui::GetIO().KeysDown[which] = true;
        (void)frame();
        ImGui::GetIO().KeysDown[which] = false;
        frames(2);
    }
    void type(const char* letters) {
        for (; *letters != 0; ++letters) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(*letters));
        frames(2);
    }
    void right_click(ImVec2 at) {
        move(at);
        button(true, 1);
        button(false, 1);
        frames(2);
    }
    [[nodiscard]] std::string last_note() const {
        return state.notifications.list.empty() ? "" : state.notifications.list.back().text;
    }

    std::string clipboard;
};

/// A window whose panel shows the camera, with a near plane at 0.5 and a far plane at 80.
struct CameraBench : Bench {
    CameraBench() {
        scene().camera.projection = Perspective{45, 0.5f, 80};
        state.editor.selection = {Selection::Kind::Camera, 0};
        frames(2);
    }
    float near() { return near_of(scene().camera.projection); }
    ImVec2 near_field() { return control("/camera/projection/near"); }
};

double value_of(const char* text, double before = 10) {
    const Calculated found = calculated(text, before);
    INFO(text << ": " << found.problem);
    CHECK(found.problem.empty());
    return found.value;
}

}  // namespace

TEST_CASE("a calculation can be typed into a number", "[ui][numbers]") {
    CHECK(value_of("2*pi") == Approx(6.283185307));
    CHECK(value_of("45/2") == 22.5);
    CHECK(value_of("sqrt(2)/2") == Approx(0.7071067812));
    CHECK(value_of(" 2 + 3 * 4 ") == 14);
    CHECK(value_of("(2+3)*4") == 20);
    CHECK(value_of("2^3^2") == 512);  // 2^(3^2)
    CHECK(value_of("-2^2") == -4);
    CHECK(value_of("2^-1") == 0.5);
    CHECK(value_of("cos(60*deg)") == Approx(0.5));
    CHECK(value_of("1e-3") == 0.001);
    CHECK(value_of(".5") == 0.5);
    CHECK(value_of("0,25") == 0.25);
    CHECK(value_of("30°") == 30);
    CHECK(value_of("(30 + 5)° / 2") == 17.5);
    CHECK(value_of("cos(60°)") == Approx(0.5));
    CHECK(value_of("2 * sin((20 + 10)°) + 5°") == Approx(6));
    CHECK(value_of("−2 × 3") == -6);
    CHECK(value_of("π") == Approx(3.141592654));
}

TEST_CASE("a calculation that begins with a sign continues from the previous number", "[ui][numbers]") {
    CHECK(value_of("+0.1") == 10.1);
    CHECK(value_of("*2") == 20);
    CHECK(value_of("*2+1") == 21);
    CHECK(value_of("/4") == 2.5);
    CHECK(value_of("-=0.5") == 9.5);
    CHECK(value_of("+=0.5") == 10.5);
    CHECK(value_of("*=1+1") == 20);
    CHECK(value_of("+1", -3) == -2);
    CHECK(value_of("-0.5") == -0.5);  // a negative number, not a difference
}

TEST_CASE("invalid text is rejected with exactly one reason", "[ui][numbers]") {
    for (const char* text : {"", " ", "2*(3", "2+", "foo", "1 2", "sqrt 2", "sqrt(2", "1/0", "sqrt(-1)",
                             "inf", "nan", "-=", "*", ")", "2**3"}) {
        INFO(text);
        CHECK_FALSE(calculated(text, 10).problem.empty());
    }
    for (const char* text : {"1e999", "-1e999", "2^9999"})
        CHECK(calculated(text, 10).problem == "it has no finite value");
    CHECK(value_of("1e-999") == 0);
    CHECK_FALSE(calculated(std::string(100'000, '('), 0).problem.empty());  // and does not exhaust the stack
}

TEST_CASE("a number too long for its field is shown in scientific notation", "[ui][numbers]") {
    Real kind;
    kind.format = "%.2f";
    CHECK(shown_text(-3.25f, kind) == "-3.25");
    CHECK(shown_text(-123456.5f, kind) == "-123456.50");
    CHECK(shown_text(-1234567.5f, kind) == "-1.23457e+06");
    CHECK(shown_text(1e30f, kind) == "1e+30");
}

TEST_CASE("a field shows at least two significant digits, and no negative zero", "[ui][numbers]") {
    Real kind;  // "%.3f"
    CHECK(shown_text(0.00012f, kind) == "0.00012");
    CHECK(shown_text(0.4f, kind) == "0.400");
    CHECK(shown_text(-0.0f, kind) == "0.000");
    CHECK(shown_text(1.25e-9f, kind) == "1.2e-09");
    kind.format = "%.2f";
    CHECK(shown_text(0.05f, kind) == "0.05");
    CHECK(shown_text(0.055f, kind) == "0.055");
    CHECK(shown_text(-0.001f, kind) == "-0.001");
    kind.format = "%.1f°";
    CHECK(shown_text(0.04f, kind) == "0.04°");
    CHECK(shown_text(30, kind) == "30.0°");
    kind.format = "all";
    CHECK(shown_text(0.001f, kind) == "all");
}

TEST_CASE("a plain click on a number starts typing, which is one undo step", "[ui][window][numbers]") {
    Bench bench;
    bench.click(bench.field());
    bench.frames(1);
    CHECK(ImGui::GetIO().WantTextInput);
    bench.type("45/2/10");
    CHECK(bench.intensity() == 2.25f);
    bench.tap(enter_key);
    CHECK(bench.intensity() == 2.25f);
    CHECK_FALSE(number_in_hand());
    undo(bench.state.editor);
    CHECK(bench.intensity() == 0.5f);
    CHECK_FALSE(bench.state.editor.history.can_undo());
}

TEST_CASE("a click elsewhere commits the typed number", "[ui][window][numbers]") {
    Bench bench;
    bench.click(bench.field());
    bench.type("0.75");
    bench.click({5, 795});
    bench.frames(2);
    CHECK(bench.intensity() == 0.75f);
    CHECK_FALSE(ImGui::GetIO().WantTextInput);
}

TEST_CASE("pending input for one scene changes nothing in the next one", "[ui][window][numbers]") {
    const TemporaryDirectory folder;
    Scene other = first_scene().scene;
    other.lights[0].name = "Moon";
    other.lights[0].intensity = 0.85f;
    const std::string path = folder.file("other.json", scene_text(other));
    for (const char* const field : {"Name", "/lights/0/intensity"})
        for (const bool drags : {false, true}) {
            INFO(field << drags);
            Bench bench;
            const ImVec2 at = bench.control(field);
            bench.click(at);
            if (drags) bench.button(true);
            if (drags) bench.move({at.x + 30, at.y});
            bench.state.editor.saved = bench.scene();  // so that no question appears
            test::drop(bench, path);
            CHECK(bench.scene().lights[0].name == "Moon");
            CHECK(bench.intensity() == 0.85f);
            bench.move({at.x + 60, at.y});
            bench.button(false);
            bench.click({5, 795});
            bench.frames(2);
            CHECK(bench.scene().lights[0].name == "Moon");
            CHECK(bench.intensity() == 0.85f);
            CHECK_FALSE(bench.state.editor.unsaved());
        }
}

TEST_CASE("a value that conflicts with another number is reverted with a message", "[ui][window][numbers]") {
    CameraBench bench;
    const auto type_near = [&bench](std::initializer_list<const char*> parts, int key) {
        bench.click(bench.near_field());
        for (const char* const part : parts) bench.type(part);
        bench.tap(key);
        bench.frames(2);
    };
    const std::string why = "near 200 is not less than far 80; expected 0 < near < far. The field keeps 0.5";
    for (const auto& parts : {std::initializer_list<const char*>{"2", "0", "0"}, {"200"}, {"20", "0"}}) {
        bench.state.notifications.list.clear();
        type_near(parts, enter_key);
        CHECK(bench.near() == 0.5f);
        CHECK(bench.last_note() == "200 is not possible: " + why);
    }
    bench.state.notifications.list.clear();
    type_near({"2", "0"}, enter_key);
    CHECK(bench.near() == 20);
    CHECK(bench.state.notifications.list.empty());
    type_near({"90"}, escape_key);
    CHECK(bench.near() == 20);
    CHECK(bench.state.notifications.list.empty());
    bench.clipboard = "200";
    bench.right_click(bench.near_field());
    bench.click_on("Paste");
    CHECK(bench.near() == 20);
    CHECK(bench.last_note() == "Not possible: near 200 is not less than far 80; expected 0 < near < far");
}

TEST_CASE("a pasted number out of range is clamped and reported", "[ui][window][numbers]") {
    Bench bench;
    bench.clipboard = "-3";
    bench.right_click(bench.field());
    bench.click_on("Paste");
    CHECK(bench.intensity() == 0);
    CHECK(bench.last_note().find("-3 is out of range") == 0);
}

TEST_CASE("an integer field rejects any other number, typed or pasted, with a message",
          "[ui][window][numbers]") {
    Bench bench;
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    const auto detail = [&bench] { return std::get<PrimitiveMesh>(bench.scene().objects[0].source).detail; };
    const ImVec2 field = bench.control("/objects/0/mesh/detail");
    const int before = detail();
    bench.clipboard = "2.1";
    bench.right_click(field);
    bench.click_on("Paste");
    CHECK(detail() == before);
    CHECK(bench.last_note() == "Not possible: the field accepts only whole numbers");
    bench.click(field);
    for (const char* const letter : {"2", ".", "5"}) bench.type(letter);
    bench.tap(enter_key);
    CHECK(detail() == before);
    CHECK(
        bench.last_note() ==
        fmt::format("2.5 is not possible: the field accepts only whole numbers. The field keeps {}", before));
    bench.click(field);
    for (const char* const letter : {"2", ".", "5", "*", "2"}) bench.type(letter);
    bench.tap(enter_key);
    CHECK(detail() == 5);
}

TEST_CASE("Tab commits the entry and moves to the next number", "[ui][window][numbers]") {
    Bench bench;
    bench.click(bench.field());
    bench.type("0.75");
    bench.tap(tab_key);
    bench.type("1/4");
    bench.tap(enter_key);
    CHECK(bench.intensity() == 0.75f);
    CHECK(bench.scene().lights[0].diffuse.x == 0.25f);
}

TEST_CASE("invalid text leaves the number unchanged and is reported in one line", "[ui][window][numbers]") {
    Bench bench;
    bench.click(bench.field());
    bench.type("3*(");
    bench.tap(enter_key);
    CHECK(bench.intensity() == 0.5f);
    CHECK(bench.last_note().find("3*(") != std::string::npos);
    CHECK(bench.last_note().find('\n') == std::string::npos);
}

TEST_CASE("an emptied field keeps its number and reports that it is unchanged", "[ui][window][numbers]") {
    Bench bench;
    bench.click(bench.field());
    bench.tap(backspace_key);  // all of its text is selected
    bench.tap(enter_key);
    CHECK(bench.intensity() == 0.5f);
    CHECK(bench.last_note() == "The field is empty. The field keeps 0.5");
}

TEST_CASE("Escape reverts a typed number and keeps the picked pixel", "[ui][window][numbers]") {
    Bench bench;
    bench.intensity() = 0.1f + 0.2f;  // must not be replaced by its rounded text
    const float before = bench.intensity();
    test::ask(bench, InspectorTab::Equation);
    bench.click(bench.field());
    bench.type("7");
    CHECK(bench.intensity() == 7);
    ImGui::GetIO().KeysDown[escape_key] = true;
    (void)bench.key(Key::Escape);
    ImGui::GetIO().KeysDown[escape_key] = false;
    bench.frames(2);
    CHECK(bench.intensity() == before);
    CHECK(bench.state.viewport.probe);
}

TEST_CASE("Escape reverts a drag and keeps the picked pixel", "[ui][window][numbers]") {
    Bench bench;
    test::ask(bench, InspectorTab::Equation);
    const ImVec2 at = bench.field();
    bench.move(at);
    bench.button(true);
    bench.move({at.x + 40, at.y});
    CHECK(bench.intensity() != 0.5f);
    ImGui::GetIO().KeysDown[escape_key] = true;
    (void)bench.key(Key::Escape);
    ImGui::GetIO().KeysDown[escape_key] = false;
    bench.move({at.x + 60, at.y});
    bench.button(false);
    CHECK(bench.intensity() == 0.5f);
    CHECK_FALSE(ImGui::GetIO().WantTextInput);
    CHECK(bench.state.viewport.probe);
}

TEST_CASE("a slider's fill follows the cursor pixel by pixel", "[ui][window][numbers]") {
    Bench bench;
    const Rect field = bench.area_of("/lights/0/intensity");
    const ImVec2 at = bench.field();
    const auto filled = [&] { return bench.intensity() / 4 * field.size().x; };  // its usual range is 0 to 4
    const float before = filled();
    bench.move(at);
    bench.button(true);
    for (const float moved : {10.0f, 33.0f, -7.0f}) {
        bench.move({at.x + moved, at.y});
        CHECK(filled() - before == Approx(moved).margin(0.1));
    }
    bench.button(false);
    CHECK_FALSE(ImGui::GetIO().WantTextInput);  // that was not a click
}

TEST_CASE("with Shift a drag is ten times finer, with Ctrl it moves in round steps",
          "[ui][window][numbers]") {
    Bench bench;
    const ImVec2 at = bench.control("/lights/0/diffuse/0");
    float& red = bench.scene().lights[0].diffuse.x;
    const auto dragged = [&](bool shift, bool ctrl) {
        red = 0.5f;
        ImGui::GetIO().KeyShift = shift, ImGui::GetIO().KeyCtrl = ctrl;
        bench.drag(at, {at.x + 50, at.y});
        ImGui::GetIO().KeyShift = ImGui::GetIO().KeyCtrl = false;
        return red - 0.5f;
    };
    const float plain = dragged(false, false);
    CHECK(plain == Approx(0.2).margin(0.011));  // 50 pixels at the row's 0.004 per pixel
    CHECK(dragged(true, false) == Approx(plain / 10).margin(0.011));
    const float stepped = dragged(false, true) + 0.5f;
    CHECK(std::abs(stepped / 0.05f - std::round(stepped / 0.05f)) < 1e-3f);
    CHECK(drag_step({.step = 0.5f}, 0) == 5);  // degrees
    CHECK(drag_step({.step = 0.01f}, 0) == Approx(0.1));
}

TEST_CASE("a right-click changes no number: it opens a menu, which reports what it does",
          "[ui][window][numbers]") {
    Bench bench;
    bench.right_click(bench.field());
    CHECK(bench.intensity() == 0.5f);
    bench.click(bench.control("Copy"));
    CHECK(bench.clipboard == "0.5");
    CHECK(bench.last_note().find("0.5") != std::string::npos);

    bench.right_click(bench.field());
    bench.move(bench.control("Advanced"));
    bench.frames(20);  // the submenu opens
    bench.click(bench.control("Copy pointer"));
    CHECK(bench.clipboard == "/lights/0/intensity");

    bench.clipboard = "3/4";
    bench.right_click(bench.field());
    bench.click(bench.control("Paste"));
    CHECK(bench.intensity() == 0.75f);
    bench.clipboard = "a word";
    bench.right_click(bench.field());
    bench.click(bench.control("Paste"));
    CHECK(bench.intensity() == 0.75f);
    CHECK(bench.last_note().find("does not contain a number") != std::string::npos);

    bench.right_click(bench.field());
    bench.click(bench.control("Reset to default"));
    CHECK(bench.intensity() == Light{}.intensity);
    bench.frames(2);
    undo(bench.state.editor);
    CHECK(bench.intensity() == 0.75f);
}

TEST_CASE("a number in the equation behaves like one in a panel", "[ui][window][numbers]") {
    Bench bench;
    test::ask(bench, InspectorTab::Equation);
    const std::string pointer = "/objects/0/material/diffuse/0";
    float& red = bench.scene().objects[0].material.diffuse.x;
    red = 0.25f;
    bench.frames(2);
    bench.right_click(test::in_column(bench, pointer));
    bench.move(bench.control("Advanced"));
    bench.frames(20);  // the submenu opens
    bench.click(bench.control("Copy pointer"));
    CHECK(bench.clipboard == pointer);
    CHECK(red == 0.25f);
    bench.click(test::in_column(bench, pointer));
    bench.type("*2");
    bench.tap(enter_key);
    CHECK(red == 0.5f);
}

// Every number in the window, typed digit by digit: intermediate values reach the scene too.
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
