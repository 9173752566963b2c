// Panels under random input: after any drag, typing or click, saved files reopen and undo restores the start.
#include <array>
#include <cmath>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/widgets/widgets.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

/// A scene with one item of every kind.
Scene rich_scene() {
    Scene scene = first_scene().scene;
    Selection selection;
    for (const LightKind kind : {LightKind::Spot, LightKind::Point}) add_light(scene, selection, kind);
    scene.lights.back().space = LightSpace::Camera;
    scene.objects.front().source = PrimitiveMesh{Primitive::Cube, 2};
    scene.objects.front().mesh = nullptr;
    return scene;
}

void use(HeadlessWindow& bench, const Scene& scene) {
    SceneDocument document;
    document.scene = scene;
    REQUIRE(problem_of(load_meshes(document.scene, "", "")) == nullptr);
    take_document(bench.state.editor, document);
    bench.frames(2);
}

void check_saves(const Scene& scene) {
    const Result<Scene> again = parse_scene(scene_text(scene), "saved");
    if (const Problem* problem = problem_of(again)) FAIL(problem->text());
    CHECK(same_description(std::get<Scene>(again), scene));
}

class Hand {
  public:
    explicit Hand(unsigned seed) : random_(seed) {}
    float number(float low, float high) { return low + (high - low) * float(random_() % 10'000) / 10'000; }
    bool one_in(unsigned n) { return random_() % n == 0; }
    unsigned any(unsigned n) { return static_cast<unsigned>(random_() % n); }

  private:
    std::mt19937 random_;
};

/// One random action in the left column: a click, a drag, a double-click, a scroll or a key press.
void act(HeadlessWindow& bench, Hand& hand) {
    const ImVec2 at{hand.number(4, 276), hand.number(40, 770)};
    ImGui::GetIO().KeyShift = hand.one_in(6);
    switch (hand.any(6)) {
    case 0:
        bench.click(at);
        break;
    case 1:
        bench.drag(at, {at.x + hand.number(-200, 200), at.y + hand.number(-30, 30)});
        break;
    case 2:
        bench.drag(at, {at.x + hand.number(-900, 900), at.y});
        break;
    case 3:
        bench.click(at);
        bench.click(at);
        break;
    case 4:
        bench.move(at);
        ImGui::GetIO().MouseWheel = hand.number(-3, 3);
        (void)bench.frame();
        break;
    case 5:
        bench.key(hand.one_in(2) ? Key::Escape : Key::Enter);
        break;
    }
    ImGui::GetIO().KeyShift = false;
    bench.state.files.open = false;  // folders of this machine are not part of the test
}

/// Keeps a random detail from building millions of faces.
void tame(HeadlessWindow& bench) {
    for (Object& object : bench.scene().objects) {
        std::visit(
            [&object](auto& source) {
                if (source.subdivide <= 1) return;
                source.subdivide = 1;
                object.mesh = nullptr;
            },
            object.source);
        if (auto* primitive = std::get_if<PrimitiveMesh>(&object.source);
            primitive != nullptr && primitive->detail > 12) {
            primitive->detail = 2;
            object.mesh = nullptr;
        }
    }
}

bool finite(const Scene& scene) {
    bool all = true;
    for (const Light& light : scene.lights)
        for (int i = 0; i < 4; ++i) all = all && std::isfinite(light.position[i]);
    for (int i = 0; i < 3; ++i)
        all = all && std::isfinite(scene.camera.eye[i]) && std::isfinite(scene.camera.target[i]);
    return all;
}

}  // namespace

TEST_CASE("after random input in the panels, the saved file opens again", "[ui][window][property]") {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        HeadlessWindow bench({760, 780});  // a narrow picture: quick to draw
        use(bench, rich_scene());
        const Scene start = bench.scene();
        Hand hand(seed);
        for (int i = 0; i < 120; ++i) {
            act(bench, hand);
            tame(bench);
            REQUIRE(finite(bench.scene()));
        }
        ImGui::GetIO().MousePos = {5, 5};
        bench.frames(3);
        check_saves(bench.scene());
        bench.state.pending = {};
        while (undo(bench.state.editor)) check_saves(bench.scene());
        CHECK(bench.scene() == start);
    }
}

TEST_CASE("every panel can be drawn for every kind of item", "[ui][window]") {
    HeadlessWindow bench;
    use(bench, rich_scene());
    const Scene start = bench.scene();
    for (const auto kind : {Selection::Kind::Camera, Selection::Kind::Shading, Selection::Kind::Display}) {
        bench.state.editor.selection = {kind, 0};
        bench.frames(2);
    }
    for (int i = 0; i < static_cast<int>(start.lights.size()); ++i) {
        bench.state.editor.selection = {Selection::Kind::Light, i};
        bench.frames(2);
    }
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    CHECK(bench.scene() == start);
}

TEST_CASE("L adds a visible light, Ctrl+D copies it, Delete removes it", "[ui][window]") {
    DrawnWindow bench;
    const Scene start = bench.scene();
    bench.key(Key::L, false, true);
    REQUIRE(bench.scene().lights.size() == start.lights.size() + 1);
    const PictureSize size = bench.state.rendered->size;
    const int added = static_cast<int>(start.lights.size());
    const glm::dvec2 at = bench.handle_pixel(added);
    CHECK(at.x > 0);
    CHECK(at.x < size.width);
    CHECK(at.y > 0);
    CHECK(at.y < size.height);
    bench.key(Key::D, true);
    CHECK(bench.scene().lights.size() == start.lights.size() + 2);
    CHECK(bench.scene().lights.back().name != bench.scene().lights[static_cast<std::size_t>(added)].name);
    check_saves(bench.scene());
    bench.key(Key::Delete);
    bench.key(Key::Delete);
    CHECK(bench.scene().lights.size() == start.lights.size());
    for (int i = 0; i < 4; ++i) bench.key(Key::Z, true);
    CHECK(bench.scene() == start);
}

TEST_CASE("the window stays usable when the lists are empty", "[ui][window]") {
    DrawnWindow bench;
    bench.state.editor.selection = {Selection::Kind::Light, 0};
    for (int i = 0; i < 5; ++i) bench.key(Key::Delete);
    CHECK(bench.scene().lights.empty());
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.key(Key::Delete);
    CHECK(bench.scene().objects.empty());
    bench.key(Key::F);
    bench.click(bench.at_pixel({200, 200}));
    REQUIRE(bench.state.on_screen.explanation);
    CHECK_FALSE(bench.state.on_screen.explanation->hit);
    check_saves(bench.scene());
}
